// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

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

}  // namespace torsio
