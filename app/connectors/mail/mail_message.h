// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace torsio {

/// A message in plain text. Texts are UTF-8.
struct MailMessage {
  std::string from{};  ///< an address
  std::string to{};    ///< one address
  std::string subject{};
  std::string body{};
};

/// Refuses what is no plain address ("li@example.org"): throws Error{kBadParameter}. Letters beyond ASCII,
/// blanks and line breaks are none.
void checkAddress(const std::string& address);

/// The message as it goes over the wire (RFC 5322, MIME, body in base64), with CRLF. `id`: any unique word.
/// Throws Error{kBadParameter} for an address that is none.
[[nodiscard]] std::string written(const MailMessage& message, const std::string& id, std::int64_t utc_us);

}  // namespace torsio
