// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <utility>

#include "assessment/attempt/attempt_measures.h"
#include "assessment/attempt/trial_digest.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/results/cohort_report.h"
#include "sim/core/live_types.h"
#include "sim/record/trial.h"

namespace torsio {

class Connection;

/// Returns the rule as it is judged by.
[[nodiscard]] MasteryRule masteryRule(const MasteryCriterion& stored);

/// Everything that a module asks of a run.
[[nodiscard]] AttemptRules rulesOf(const TrainingModule& module);

/// By what each recording is judged: what its module asks for, else the tolerance of the
/// scene's pattern in the assets, else kDefaultTolerance_rad. Who looks, and when, changes nothing. One
/// thread at a time.
class ExerciseRules {
 public:
  /// `assets`: where patterns are read; empty: assetsFolder().
  explicit ExerciseRules(std::filesystem::path assets = {}) : assets_(std::move(assets)) {}

  /// Finds the rules of a recording in `connection`; `moduleId` is empty for one that belongs to no module.
  /// Throws DbError.
  [[nodiscard]] AttemptRules of(Connection& connection, const SceneId& sceneId, const PatternId& patternId,
                                const ModuleId& moduleId);

  /// Finds the rules of a recording that belongs to no module.
  [[nodiscard]] AttemptRules ofPattern(const SceneId& sceneId, const PatternId& patternId);

 private:
  [[nodiscard]] double patternTolerance_rad(const SceneId& sceneId, const PatternId& patternId);

  std::filesystem::path assets_;
  std::map<std::string, AttemptRules> modules_;                     // by id; they never change
  std::map<std::pair<std::string, std::string>, double> patterns_;  // tolerance by scene and pattern
};

/// Name of the twist model as reports say it, out of the recorded parameters.
[[nodiscard]] std::string modelName(const std::string& parametersJson);

/// Turns what was measured into what is stored, with the version of the formulas.
[[nodiscard]] TrialDigest keptDigest(const Trial& trial, const AttemptMeasures& measures,
                                     const AttemptRules& rules, std::int64_t now_us);
/// Turns what is stored back into what was measured, to the last bit.
[[nodiscard]] AttemptMeasures measuresFrom(const TrialDigest& kept);
/// Finds the digest of this very recording, judged by these very rules; null: there is none.
[[nodiscard]] const TrialDigest* findDigest(std::span<const TrialDigest> kept, const std::string& contentHash,
                                            const AttemptRules& rules);

/// The line of the report for a finished recording: what the trial's own rows say, and what was measured. The
/// caller fills in the group.
[[nodiscard]] TrialSummaryRow summaryRow(const TrialListing& listing, const TrialDigest& digest);

/// Returns the digest of a finished recording by the rules of its exercise. One of the present version is
/// read; otherwise the recording is read, measured, and its digest kept beside it, unless the record is
/// read-only or the recording has no content hash. Slow in that case. Throws Error, DbError.
[[nodiscard]] TrialDigest digestOf(Connection& connection, const TrialListing& listing, ExerciseRules& rules,
                                   std::int64_t now_us);

/// Keeps what was measured of a finished recording, unless it is there already, the record is read-only or
/// the recording has no content hash.
void keepDigest(Connection& connection, const Trial& trial, const AttemptMeasures& measures,
                const AttemptRules& rules, std::int64_t now_us);

}  // namespace torsio
