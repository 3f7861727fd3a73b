// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/account.h"

namespace torsio {

// Codes that change every thirty seconds (TOTP, RFC 6238: HMAC-SHA-1, six digits), and the secret that makes
// them. A secret is text in base32 (RFC 4648, without padding), as authenticator apps take it.

/// Returns a fresh secret of 160 bits.
[[nodiscard]] std::string newCodeSecret();
/// True for a secret of 160 bits as newCodeSecret() writes it.
[[nodiscard]] bool isCodeSecret(std::string_view secret);

/// Returns the step of thirty seconds at a time (microseconds since 1970 UTC).
[[nodiscard]] std::int64_t codeStepAt(std::int64_t utc_us);
/// Returns the six digits of a step. The secret must be isCodeSecret().
[[nodiscard]] std::string oneTimeCode(const std::string& secret, std::int64_t step);
/// Returns the step whose code this is: that of the time, or one before or after it, since clocks differ;
/// empty: none of them.
[[nodiscard]] std::optional<std::int64_t> stepOfCode(const std::string& secret, const std::string& code,
                                                     std::int64_t utc_us);

/// Encrypts a secret under a key that Argon2id makes of the password; it can be opened for this user only.
/// Slow, like hashPassword(). Throws Error (kInternal) without memory.
[[nodiscard]] std::string sealedCodeSecret(const std::string& secret, const std::string& password,
                                           const UserId& userId, PasswordCost cost);
/// Decrypts it; empty: another password or user, or damaged. Slow.
[[nodiscard]] std::string openedCodeSecret(const std::string& sealed, const std::string& password,
                                           const UserId& userId);

}  // namespace torsio
