// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"

namespace torsio {

/// The pseudonymous record of a person with the attributes used to balance groups; never a name. Code and
/// demonstration flag are frozen once stored. Empty texts mean "not known".
struct Person {
  PersonId id{};       ///< UUID
  std::string code{};  ///< pseudonym, unique: "T-07"
  std::string sex{};   ///< "female", "male", "other" or empty
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

/// A person who trains.
struct Trainee {
  Person person{};
  std::string handedness{};  ///< "left", "right" or empty
};

/// A class of raters by seniority.
struct SeniorityClass {
  std::string code{};  ///< "intern", "deputy_chief", "chief"
  std::string label{};
  std::int64_t position = 0;
};

/// A person who scores.
struct Rater {
  Person person{};
  std::string classCode{};
};

}  // namespace torsio
