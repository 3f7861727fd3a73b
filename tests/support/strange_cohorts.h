// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "assessment/results/cohort_report.h"

namespace torsio::testing {

/// A cohort with something unusual about it, and what the first page of its report must and must not say.
struct StrangeCohort {
  std::string name;
  CohortInputs cohort;
  std::vector<std::string> says{};
  std::vector<std::string> neverSays{};
};

inline constexpr const char* kTwiceSaid = "more identical marks than chance gives two of equal skill";
inline constexpr const char* kNoPlanSaid = "No plan of the analysis is in the record";

/// Returns a cohort as it should be: drawn, trained as planned, with a plan of the analysis.
[[nodiscard]] CohortInputs soundCohort();
/// Returns it with a trainee of the first group who is also one of the third, with so many marks changed.
[[nodiscard]] CohortInputs enteredTwice(int changed);

// Forty cohorts and more, by what is unusual.
[[nodiscard]] std::vector<StrangeCohort> strangeAllocations();
[[nodiscard]] std::vector<StrangeCohort> strangeTrainings();
[[nodiscard]] std::vector<StrangeCohort> strangePeople();
[[nodiscard]] std::vector<StrangeCohort> strangeMarks();

}  // namespace torsio::testing
