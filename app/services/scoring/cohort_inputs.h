// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/services/scoring/scoring_service.h"
#include "assessment/domain/ids.h"
#include "assessment/results/cohort_report.h"

namespace torsio {

class Connection;

/// Sheets that raters were asked for in a cohort. One that was withdrawn counts as asked while nobody else
/// was asked in its place and its trainee still takes part.
struct SheetCount {
  std::int64_t asked = 0;
  std::int64_t submitted = 0;
  std::int64_t dropped = 0;  ///< of those asked: withdrawn, and nobody else was asked
  [[nodiscard]] bool complete() const noexcept { return submitted >= asked; }
};
/// Returns "898 of 900 sheets that raters were asked for are in", and how many were dropped.
[[nodiscard]] Text sentenceOf(const SheetCount& sheets);
[[nodiscard]] SheetCount countSheets(Connection& connection, const CohortId& cohortId);

/// Collects people, groups, allocation and scores of a cohort report from the record. Replays the allocation
/// from its seed to verify it; the caller adds trials, facts and title.
[[nodiscard]] CohortInputs cohortInputs(Connection& connection, const CohortId& cohortId,
                                        const CampaignResult& campaign, const TrainingResult& training);

}  // namespace torsio
