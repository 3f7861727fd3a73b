// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

enum class Sex : std::uint8_t { kFemale, kMale, kOther };
inline constexpr std::array<Term<Sex>, 3> kSexes{{
    {Sex::kFemale, "female", Text::tr("female")},
    {Sex::kMale, "male", Text::tr("male")},
    {Sex::kOther, "other", Text::tr("other")},
}};
[[nodiscard]] constexpr const auto& termsOf(Sex) noexcept {
  return kSexes;
}

enum class Handedness : std::uint8_t { kRight, kLeft };
inline constexpr std::array<Term<Handedness>, 2> kHandednesses{{
    {Handedness::kRight, "right", Text::tr("right-handed")},
    {Handedness::kLeft, "left", Text::tr("left-handed")},
}};
[[nodiscard]] constexpr const auto& termsOf(Handedness) noexcept {
  return kHandednesses;
}

/// The classes of raters of the paper, in ascending order; a centre may add others.
enum class Seniority : std::uint8_t { kIntern, kDeputyChief, kChief };
inline constexpr std::array<Term<Seniority>, 3> kSeniorities{{
    {Seniority::kIntern, "intern", Text::tr("intern")},
    {Seniority::kDeputyChief, "deputy_chief", Text::tr("deputy chief physician")},
    {Seniority::kChief, "chief", Text::tr("chief physician")},
}};
[[nodiscard]] constexpr const auto& termsOf(Seniority) noexcept {
  return kSeniorities;
}

/// The pseudonymous record of a person with the attributes used to balance groups; never a name. Code and
/// demonstration flag are frozen once stored. Empty texts mean "not known".
struct Person {
  PersonId id{};       ///< UUID
  std::string code{};  ///< pseudonym, unique: "T-07"
  std::string sex{};   ///< stored text of a Sex, or empty
  std::string level{};
  std::string experience{};
  std::optional<std::int64_t> age_years{};
  PersonState state = PersonState::kActive;
  std::int64_t createdUtc_us = 0;
  bool demonstration = false;
};

/// Link from code to name, kept in a table of its own.
struct Identity {
  PersonId personId{};
  std::string fullName{};
  std::string email{};
  std::string externalId{};  ///< staff or student number; unique
};

struct Trainee {
  Person person{};
  std::string handedness{};  ///< stored text of a Handedness, or empty
};

/// A class of raters by seniority.
struct SeniorityClass {
  std::string code{};  ///< stored text of a Seniority, or the centre's own
  std::string label{};
  std::int64_t position = 0;
};

struct Rater {
  Person person{};
  std::string classCode{};
};

}  // namespace torsio
