// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"
#include "sim/core/text.h"

namespace torsio {

/// Source of the tolerance of a competence design.
enum class ToleranceSource : std::uint8_t { kExercise, kExperts, kChosen };
inline constexpr std::array<Term<ToleranceSource>, 3> kToleranceSources{{
    {ToleranceSource::kExercise, "exercise", Text::tr("of the exercise"),
     "what the exercise itself counts as on target"},
    {ToleranceSource::kExperts, "experts", Text::tr("from the centre's own experts"),
     "covers nine in ten experts with 95 % confidence"},
    {ToleranceSource::kChosen, "chosen", Text::tr("chosen by the centre"), "set by hand, with a reason"},
}};
static_assert(isWholeTable(kToleranceSources, ToleranceSource{3}));
[[nodiscard]] constexpr const auto& termsOf(ToleranceSource) noexcept {
  return kToleranceSources;
}

/// Criterion by which a trainee counts as competent in one exercise version: an LC-CUSUM over attempts. An
/// attempt is a completed twist released within the tolerance, or an untwisting that passes. Immutable once
/// registered.
struct CompetenceDesign {
  ModuleId moduleId{};
  std::int64_t version = 0;  ///< 0: the design shipped with every exercise; registered ones count from 1
  std::int64_t registeredUtc_us = 0;
  double tolerance_rad = 0.1;  ///< of the angle at release; unused for an untwisting
  ToleranceSource source = ToleranceSource::kExercise;
  std::int64_t experts = 0;     ///< number of experts for kExperts; otherwise 0
  double adequate = 0.1;        ///< failure rate of a competent trainee
  double inadequate = 0.3;      ///< failure rate of a trainee who is not competent; greater than `adequate`
  std::int64_t attempts = 50;   ///< number of attempts for which the two error rates hold
  double falsePassMost = 0.05;  ///< alpha: largest probability that an inadequate trainee passes
  double falseFailMost = 0.10;  ///< beta: largest probability that an adequate trainee does not pass
  double limit = 4.09;   ///< of the sum; follows from the other numbers (assessment/attempt/competence.h)
  std::string reason{};  ///< required for kChosen; optional otherwise
  friend bool operator==(const CompetenceDesign&, const CompetenceDesign&) = default;
};

}  // namespace torsio
