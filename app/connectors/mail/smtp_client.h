// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "app/services/base/progress.h"
#include "sim/core/text.h"

namespace torsio {

/// A plain-text message in UTF-8.
struct MailMessage {
  std::string from{};  ///< mail address
  std::string to{};    ///< one mail address
  std::string subject{};
  std::string body{};
};

/// Throws Error{kBadParameter} for anything but a plain ASCII address ("li@example.org") without spaces and
/// line breaks.
void checkAddress(const std::string& address);

/// The message on the wire (RFC 5322, MIME, body in base64), with CRLF. `id`: any unique word. Throws
/// Error{kBadParameter} for an invalid address.
[[nodiscard]] std::string written(const MailMessage& message, const std::string& id, std::int64_t utc_us);

/// How the connection to a mail server is encrypted.
enum class MailEncryption {
  kStartTls,  ///< starts in clear text, encrypted before anything is sent (port 587)
  kTls,       ///< from the first byte (port 465)
  kNone,      ///< only for a server on this computer
};

/// A mail server and how to sign in.
struct MailServer {
  std::string host{};
  std::uint16_t port = 587;
  MailEncryption encryption = MailEncryption::kStartTls;
  std::string user{};  ///< empty: no sign-in
  std::string password{};
  int patience_s = 30;                  ///< longest wait for an answer; four times that for a message
  std::filesystem::path authorities{};  ///< certificates (PEM) to trust; empty: those of this computer
};

/// Throws Error{kBadParameter} for a remote server without encryption.
void requireProtectedWay(const MailServer& server);

/// Called with the index of a message that the server took.
using MailTaken = std::function<void(std::size_t index)>;

/// Sends messages by SMTP (RFC 5321; PLAIN or LOGIN), reusing the connection until a message is refused. The
/// certificate and its name are checked, and only the greeting precedes encryption. Returns one entry per
/// message: empty when the server took it, otherwise its refusal; a refusal does not hold up the next
/// message. When the connection is lost, or the answers to a message are longer than
/// 64 KiB, the remaining entries say so. `taken` is called as soon as a message
/// is accepted. Throws Error before anything is sent: {kBadParameter} for an invalid address, or a server
/// elsewhere without encryption; {kFileUnreadable} when the server does not answer, cannot be trusted, offers
/// no encryption, or refuses the sign-in. Exceptions of `taken` and `progress` pass through. A worker thread.
[[nodiscard]] std::vector<Text> sendMail(const MailServer& server, std::span<const MailMessage> messages,
                                         std::int64_t utc_us, const ProgressCallback& progress = {},
                                         const MailTaken& taken = {});

}  // namespace torsio
