// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "sim/core/text.h"

namespace torsio {

/// What one person knows of a start password: if an account needs two people, each knows one half.
enum class PasswordPart : std::uint8_t { kWhole, kFirstHalf, kSecondHalf };

/// A new account, or one with a new start password. The random password must be changed at the first sign-in
/// and is shown once: only its hash is stored.
struct StartAccount {
  std::string login{};
  std::string role{};
  std::string personCode{};
  std::string startPassword{};  ///< the part of it, without the hyphen between the halves
  std::string personName{};     ///< empty: unknown, or not visible to who is shown this
  PasswordPart part = PasswordPart::kWhole;
  std::string askedBy{};  ///< kSecondHalf: sign-in name of the administrator who has the first half
};

/// Returns letters and digits that can be read aloud, from the system's random source.
[[nodiscard]] std::string legibleLetters(int count);
/// Returns twenty characters in groups that can be read aloud, from the system's random source.
[[nodiscard]] std::string randomStartPassword();
/// Returns one half of a start password: two of its groups.
[[nodiscard]] std::string randomHalfPassword();

/// The sentences about start passwords and their halves, for windows, cards and files. Pure functions.

/// Returns the password as it is written down: "abcde-fghij-…" for a first half.
[[nodiscard]] std::string writtenPassword(const StartAccount& account);
/// Returns which part it is and who has the other, for a list: "first half; the second comes from …".
[[nodiscard]] Text partWords(const StartAccount& account);
/// Returns what the administrator has to do with it.
[[nodiscard]] Text handOverWords(const StartAccount& account);
/// Returns the same for several, parts mixed in any way.
[[nodiscard]] Text handOverWords(std::span<const StartAccount> accounts);
/// Returns a line for the owner below the password.
[[nodiscard]] Text cardWords(const StartAccount& account);
/// Returns a line for the envelope: what is in it, without the person's name.
[[nodiscard]] Text envelopeWords(const StartAccount& account);

}  // namespace torsio
