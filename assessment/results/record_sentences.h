// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "assessment/results/cohort_report.h"

// Sentences of the report that claim something about the study: each is computed from the record.
namespace torsio {

/// Whether raters were blinded: from how each mark was given.
[[nodiscard]] std::vector<Text> blindingSentences(const CohortInputs& inputs);
/// What groups of the size at hand can detect. Empty with fewer than two groups.
[[nodiscard]] Text powerSentence(const CohortInputs& inputs);
/// What groups of the size at hand can detect, as a clause for the first page, with its full stop.
[[nodiscard]] Text detectableSentence(const CohortInputs& inputs);
/// When the seed was committed to, against enrolment and allocation.
[[nodiscard]] Text commitmentSentence(const CohortAllocation& allocation);
/// Whether the draw was repeated from its seed, and with what result.
[[nodiscard]] Text replaySentence(const CohortAllocation& allocation);
/// How many of the marks that could be there are there.
[[nodiscard]] Text marksSentence(const CohortInputs& inputs);

/// Whether every trainee has a mark of every rater at every occasion.
[[nodiscard]] bool allMarksGiven(const CohortInputs& inputs);

}  // namespace torsio
