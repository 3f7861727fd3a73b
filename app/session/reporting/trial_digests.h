// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/session/access/workplace.h"
#include "app/session/progress.h"
#include "assessment/report/cohort_report.h"
#include "db/repository/curriculum_repository.h"

namespace torsio {

/// What recorded trials come down to, measured once: a recording never changes, so that its digest holds as
/// long as its content hash. One thread at a time.
class TrialDigests {
 public:
  /// `assets`: where the tolerances of exercises without a curriculum are read.
  explicit TrialDigests(std::filesystem::path assets) : assets_(std::move(assets)) {}

  /// Digests of the finished trials of a cohort, oldest first; groups are positions among the cohort's
  /// groups, trials of people without a group are left out. New ones are read and decoded, which takes a
  /// tenth of a second for twenty minutes; `progress` is told and may throw to give up. kResultsCompute.
  /// Throws Error, DbError.
  [[nodiscard]] std::vector<TrialDigest> ofCohort(Workplace& workplace, const std::string& cohortId,
                                                  const ProgressCallback& progress = {});

  /// Trials in the memory.
  [[nodiscard]] std::size_t size() const noexcept { return known_.size(); }

 private:
  [[nodiscard]] double tolerance_rad(const std::string& sceneId, const std::string& patternId,
                                     const std::string& moduleId,
                                     const std::optional<StoredCurriculumVersion>& curriculum);

  std::filesystem::path assets_;
  std::map<std::string, TrialDigest> known_;                                 // by content hash
  std::map<std::pair<std::string, std::string>, double> patternTolerances_;  // by scene and pattern
};

}  // namespace torsio
