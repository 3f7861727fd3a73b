// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/connectors/mail/mail_message.h"
#include "app/services/base/progress.h"
#include "sim/core/text.h"

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
  int patience_ms = 30'000;  ///< the longest wait for one answer
};

/// Refuses a server elsewhere without encryption: throws Error{kBadParameter}.
void requireProtectedWay(const MailServer& server);

/// Told of a message that the server took: its index.
using MailTaken = std::function<void(std::size_t index)>;

/// Hands messages over, one connection for all (SMTP, RFC 5321; PLAIN or LOGIN). Certificates are checked,
/// and nothing but the greeting is said before the encryption stands. Returns for each what speaks against
/// it, empty: taken; `taken` is told at once. A message that another one follows is not held up by it; when
/// the connection is lost on the way, the rest says so. Throws Error: {kBadParameter} for an address that is
/// none, or a server elsewhere without encryption; {kFileUnreadable} when the server does not answer, cannot
/// be trusted, offers no encryption, or refuses the sign-in: then nothing was sent. What `taken` and
/// `progress` throw goes through. A worker thread.
[[nodiscard]] std::vector<Text> sendMail(const MailServer& server, std::span<const MailMessage> messages,
                                         std::int64_t utc_us, const ProgressCallback& progress = {},
                                         const MailTaken& taken = {});

}  // namespace torsio
