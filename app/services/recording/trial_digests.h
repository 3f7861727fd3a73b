// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "app/services/recording/kept_digests.h"
#include "assessment/domain/ids.h"
#include "assessment/results/cohort_report.h"

namespace torsio {

class Connection;

/// What recorded trials come down to. It is measured once, usually when the run ends, and kept in the record
/// (kept_digests.h); what an older version of the program recorded is measured and kept here. One thread at a
/// time.
class TrialDigests {
 public:
  /// `assets`: where the tolerances of exercises without a curriculum are read.
  explicit TrialDigests(std::filesystem::path assets) : rules_(std::move(assets)) {}

  /// Digests of the finished trials of a cohort in the order in which they were recorded (at one time: by
  /// phase, group and number in the group, whatever their ids); groups are positions among the cohort's
  /// groups, trials of people without a group are left out. Those that nobody has measured by the present
  /// formulas are read and measured, which takes a second for twenty minutes; `progress` is told and
  /// may throw to give up; most of what was measured until then is kept. kResultsCompute.
  /// Throws Error, DbError.
  [[nodiscard]] std::vector<TrialSummaryRow> ofCohort(SessionContext& session, const CohortId& cohortId,
                                                      const ProgressCallback& progress = {});

  /// Verdicts about everybody at every exercise of a curriculum version
  /// (app/services/recording/competence.h). kResultsCompute.
  [[nodiscard]] std::vector<CohortCompetence> competenceOf(SessionContext& session,
                                                           const CurriculumVersionId& versionId,
                                                           const std::vector<CohortTrainee>& trainees);

  /// Both without a right, for whoever owns the file of the record.
  [[nodiscard]] std::vector<CohortCompetence> readCompetence(Connection& connection,
                                                             const CurriculumVersionId& versionId,
                                                             const std::vector<CohortTrainee>& trainees,
                                                             std::int64_t now_us);
  [[nodiscard]] std::vector<TrialSummaryRow> read(Connection& connection, const CohortId& cohortId,
                                                  std::int64_t now_us, const ProgressCallback& progress = {});

  /// Recordings that had to be read since this was made.
  [[nodiscard]] std::size_t measured() const noexcept { return measured_; }

 private:
  ExerciseRules rules_;
  std::size_t measured_ = 0;
};

}  // namespace torsio
