// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "assessment/attempt/attempt_measures.h"
#include "assessment/attempt/measured_trial.h"
#include "assessment/attempt/run_verdict.h"
#include "assessment/attempt/trial_digest.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/metrics/detorsion.h"
#include "assessment/results/cohort_report.h"
#include "sim/core/live_types.h"
#include "sim/record/trial.h"

namespace torsio {

class Connection;

/// Converts a stored criterion to the domain's rule.
[[nodiscard]] MasteryRule masteryRule(const MasteryCriterion& stored);

/// Returns all requirements of a module on a run.
[[nodiscard]] AttemptRules rulesOf(const TrainingModule& module);

/// Rules for judging each recording: its module's requirements; else the tolerance of the scene's pattern in
/// the assets; else kDefaultTolerance_rad. Independent of who looks and when. One thread at a time.
class ExerciseRules {
 public:
  /// `assets`: folder with the patterns; empty: assetsFolder().
  explicit ExerciseRules(std::filesystem::path assets = {}) : assets_(std::move(assets)) {}

  /// Finds the rules of a recording in `connection`; `moduleId` is empty if it belongs to no module. Throws
  /// DbError.
  [[nodiscard]] AttemptRules of(Connection& connection, const SceneId& sceneId, const PatternId& patternId,
                                const ModuleId& moduleId);

  /// Finds the rules of a recording that belongs to no module.
  [[nodiscard]] AttemptRules ofPattern(const SceneId& sceneId, const PatternId& patternId);

 private:
  [[nodiscard]] double patternTolerance_rad(const SceneId& sceneId, const PatternId& patternId);

  std::filesystem::path assets_;
  std::map<std::string, AttemptRules> modules_;                     // by id; immutable
  std::map<std::pair<std::string, std::string>, double> patterns_;  // tolerance by scene and pattern
};

/// Returns the twist model's name as used in reports, from the recorded parameters.
[[nodiscard]] std::string modelName(const std::string& parametersJson);

/// Decodes a recording and measures it by the rules of its exercise.
[[nodiscard]] AttemptMeasures measureRecording(const Trial& trial, const AttemptRules& rules);
/// Converts measures to their stored form, with the version of the formulas.
[[nodiscard]] TrialDigest keptDigest(const Trial& trial, const AttemptMeasures& measures,
                                     const AttemptRules& rules, std::int64_t now_us);
/// Finds the digest of exactly this recording and these rules; null if there is none.
[[nodiscard]] const TrialDigest* findDigest(std::span<const TrialDigest> kept, const std::string& contentHash,
                                            const AttemptRules& rules);

/// Returns the verdict on a finished recording by its exercise's rules.
[[nodiscard]] RunVerdict verdictOn(const TrialSummary& summary, const AttemptMeasures& measures,
                                   const AttemptRules& rules);

/// Returns the report's row for a finished recording, from the trial's own data, its measures and its
/// exercise's rules. The caller fills in the group.
[[nodiscard]] TrialSummaryRow summaryRow(const TrialListing& listing, const TrialDigest& digest,
                                         const AttemptRules& rules);

/// Returns the digest of a finished recording by its exercise's rules. Reads one of the current version if
/// stored; otherwise reads and measures the recording, which is slow, and stores the digest unless the record
/// is read-only or the recording has no content hash. Throws Error, DbError.
[[nodiscard]] TrialDigest digestOf(Connection& connection, const TrialListing& listing, ExerciseRules& rules,
                                   std::int64_t now_us);

/// Stores the measures of a finished recording, unless they are stored already, the record is read-only or
/// the recording has no content hash.
void keepDigest(Connection& connection, const Trial& trial, const AttemptMeasures& measures,
                const AttemptRules& rules, std::int64_t now_us);

/// Reads the rules for judging an untwisting from TrialHeader::parametersJson; empty for a recording of
/// twists, or parameters unknown to this version.
[[nodiscard]] std::optional<DetorsionRules> detorsionRulesOf(const std::string& parametersJson);

/// Adds the recording's own judging parameters to the rules of an exercise.
[[nodiscard]] AttemptRules recordedRules(AttemptRules exercise, const TrialHeader& header);

}  // namespace torsio
