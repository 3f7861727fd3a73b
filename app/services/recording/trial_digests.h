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

/// Digests of recorded trials. Each is measured once, usually at the end of the run, and stored
/// (kept_digests.h); recordings of older program versions are measured and stored here. One thread at a time.
class TrialDigests {
 public:
  /// `assets`: source of tolerances for exercises without a curriculum.
  explicit TrialDigests(std::filesystem::path assets) : rules_(std::move(assets)) {}

  /// Returns digests of a cohort's finished trials in the order of recording (at equal times: by phase, group
  /// and number in the group, never by id); groups are positions in the cohort, trials of people without a
  /// group are omitted. Reads and measures recordings that have no digest with the current formulas, at about
  /// a second per twenty minutes; `progress` may throw to cancel; most of what was measured until then is
  /// stored. kResultsCompute. Throws Error, DbError.
  [[nodiscard]] std::vector<TrialSummaryRow> ofCohort(SessionContext& session, const CohortId& cohortId,
                                                      const ProgressCallback& progress = {});

  /// Returns verdicts on everybody at every exercise of a curriculum version
  /// (app/services/recording/competence.h). kResultsCompute.
  [[nodiscard]] std::vector<CohortCompetence> competenceOf(SessionContext& session,
                                                           const CurriculumVersionId& versionId,
                                                           const std::vector<CohortTrainee>& trainees);

  /// Like the functions above without a right, for the owner of the record's file.
  [[nodiscard]] std::vector<CohortCompetence> readCompetence(Connection& connection,
                                                             const CurriculumVersionId& versionId,
                                                             const std::vector<CohortTrainee>& trainees,
                                                             std::int64_t now_us);
  [[nodiscard]] std::vector<TrialSummaryRow> read(Connection& connection, const CohortId& cohortId,
                                                  std::int64_t now_us, const ProgressCallback& progress = {});

  /// Returns the number of recordings measured since construction.
  [[nodiscard]] std::size_t measured() const noexcept { return measured_; }

 private:
  ExerciseRules rules_;
  std::size_t measured_ = 0;
};

}  // namespace torsio
