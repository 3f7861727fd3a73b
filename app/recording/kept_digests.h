// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "assessment/report/cohort_report.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/trial/digest_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/base/live_types.h"
#include "sim/record/trial.h"

namespace torsio {

/// Of trialDigest (trial_summary.h). Change it whenever a number that it gives changes: digests of the older
/// version stay where they are, and recordings are measured anew.
inline constexpr const char* kTrialDigestVersion = "twist-digest 1";

/// Which error still counts as on target: that of the module, else that of the scene's pattern in `assets`,
/// else two degrees. One thread at a time.
class DigestTolerances {
 public:
  explicit DigestTolerances(std::filesystem::path assets) : assets_(std::move(assets)) {}

  [[nodiscard]] double of(const std::string& sceneId, const std::string& patternId,
                          const std::string& moduleId,
                          const std::optional<StoredCurriculumVersion>& curriculum);

 private:
  std::filesystem::path assets_;
  std::map<std::pair<std::string, std::string>, double> patterns_;  // by scene and pattern
};

/// The curriculum that a cohort follows, if any.
[[nodiscard]] std::optional<StoredCurriculumVersion> curriculumOfCohort(Connection& connection,
                                                                        const std::string& cohortId);

/// Name of the twist model as reports say it, out of the recorded parameters.
[[nodiscard]] std::string modelName(const std::string& parametersJson);

/// As it is stored.
[[nodiscard]] StoredTrialDigest keptDigest(const TrialDigest& digest, double tolerance_rad,
                                           std::int64_t now_us);
/// As reports use it: what the trial's own rows say comes from `listing`. Group and model aside, the same as
/// trialDigest gave.
[[nodiscard]] TrialDigest digestFrom(const StoredTrialDigest& kept, const TrialListing& listing);

/// Measures a finished recording of an enrolled trainee and keeps the digest beside it, if it is not there
/// yet: right after a run and when a station puts its recordings in order. `samples`: decoded. Does nothing
/// for free practice and for recordings without an end.
void keepDigestOf(Connection& connection, const Trial& trial, std::span<const Sample> samples,
                  const TrialContext& context, DigestTolerances& tolerances, std::int64_t now_us);

}  // namespace torsio
