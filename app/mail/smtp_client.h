// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "app/base/progress.h"
#include "app/mail/mail_message.h"

namespace torsio {

/// How the way to a mail server is protected.
enum class MailEncryption {
  kStartTls,  ///< begins in the clear and changes over before anything is said (port 587)
  kTls,       ///< from the first byte on (port 465)
  kNone,      ///< a server on this computer only
};

/// Where messages are handed over.
struct MailServer {
  std::string host{};
  std::uint16_t port = 587;
  MailEncryption encryption = MailEncryption::kStartTls;
  std::string user{};  ///< empty: the server asks for none
  std::string password{};
};

/// Refuses a server elsewhere without encryption: throws Error{kBadParameter}.
void requireProtectedWay(const MailServer& server);

/// Hands messages over, one connection for all (SMTP, RFC 5321; PLAIN or LOGIN). Certificates are checked.
/// Returns for each what the server said against it, empty: taken. A message that another one follows is not
/// held up by it. Throws Error: {kBadParameter} for an address that is none, or a server elsewhere without
/// encryption; {kFileUnreadable} when the server does not answer, cannot be trusted, or refuses the sign-in:
/// then nothing was sent after those that `progress` told of. A worker thread; takes up to half a minute a
/// step.
[[nodiscard]] std::vector<std::string> sendMail(const MailServer& server,
                                                std::span<const MailMessage> messages, std::int64_t utc_us,
                                                const ProgressCallback& progress = {});

}  // namespace torsio
