// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace torsio {

/// What a time stamp of an authority says (RFC 3161): a text existed at this time.
struct TimeStamp {
  std::int64_t utc_us = 0;  ///< by the authority's clock
  std::string authority{};  ///< name in its certificate, on one line
};

/// Returns the bytes to send to an authority: SHA-256 of `text`, a fresh random nonce, and the wish for its
/// certificate. OpenSSL writes and reads these formats.
[[nodiscard]] std::string stampQuery(const std::string& text);
/// Checks the bytes that an authority answered to `query`. `certificates`: PEM of the authority's root, as
/// the centre trusts it; they must have been valid at the time of the stamp. Throws Error (kVerifyFailed)
/// that says what is wrong: a refusal, other bytes, another nonce or text, another or no certificate.
[[nodiscard]] TimeStamp stampIn(const std::string& answer, const std::string& query,
                                const std::string& certificates);
/// Like stampIn(), for an answer that was kept with its text.
[[nodiscard]] TimeStamp keptStamp(const std::string& answer, const std::string& text,
                                  const std::string& certificates);
/// Returns SHA-256 of a text, 64 hexadecimal digits: what the authority is sent.
[[nodiscard]] std::string stampedHash(const std::string& text);
/// Returns whether these bytes are a whole answer of an authority, whatever it says.
[[nodiscard]] bool isStampAnswer(const std::string& bytes);
/// Throws Error (kBadData, naming `where`) unless `pem` holds at least one certificate.
void requireCertificates(const std::string& pem, const std::string& where);

}  // namespace torsio
