// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/training/attempts.h"
#include "app/services/training/detorsion_story.h"
#include "app/services/training/run_moments.h"
#include "assessment/attempt/competence.h"
#include "assessment/attempt/run_verdict.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"
#include "sim/core/text.h"
#include "sim/scene/scene.h"

namespace torsio {

/// One twist of the run.
struct TwistResult {
  Seconds when{};
  double target_rad = 0.0;
  double released_rad = 0.0;
  double held_s = 0.0;  ///< on target until the release
  bool passed = false;  ///< released on target
};

/// A strength or weakness of the run, with its place.
struct DebriefFinding {
  Quantity quantity{};
  double value = 0.0;   ///< of this twist, SI
  double expert = 0.0;  ///< of the expert run
  double merit = 0.0;   ///< logarithm of the ratio to the expert; negative: worse
  std::size_t twist = 0;
  Seconds when{};         ///< where to look
  bool strength = false;  ///< false: a weakness

  /// Describes a strength or weakness in one sentence.
  [[nodiscard]] Text text() const;
  /// Suggests what to try next; empty for a strength.
  [[nodiscard]] Text advice() const;
};

/// A curve, thinned for drawing.
struct DebriefTrace {
  std::vector<double> time_s{};
  std::vector<double> angle_rad{};
  std::vector<double> torque_Nm{};
  std::vector<double> force_N{};  ///< on the tissue; maximum of the samples that a point stands for
  [[nodiscard]] bool empty() const noexcept { return time_s.empty(); }
};

struct DebriefBookmark {
  RemarkId id{};
  double at_s = 0.0;
  std::string text{};
};

/// Different measures of the same run by an older version of the definitions: kept for information, not
/// judged.
struct EarlierMeasure {
  std::int64_t version = 0;  ///< of the definitions (kMetricsVersion)
  std::optional<double> peakForce_N{};
  bool withinLimits = false;  ///< force and torque were within the limits, by that version
};

/// A tracker's recording on the real arm.
struct RealArmStory {
  std::vector<Text> sentences{};  ///< foreignSentences()
  std::vector<Seconds> unseen{};  ///< where the instrument was out of view
};

/// Feedback for a trainee right after a run.
struct Debrief {
  TrialId trialId{};
  ModuleId moduleId{};
  std::string moduleTitle{};
  std::string phaseLabel{};
  std::optional<AttemptMode> mode{};
  std::int64_t startedUtc_us = 0;
  double duration_s = 0.0;
  bool demonstration = false;
  bool forceFelt = true;  ///< false: force was only computed and shown; its measures are marked
  Text servoTrouble{};    ///< app/services/devices/device_readiness.h; empty: none
  Text servoRemedy{};     ///< remedy
  RunVerdict verdict{};
  std::vector<std::optional<MissedTarget>> missed{};  ///< one for each of the verdict's checks
  CompetenceVerdict competence{};  ///< of all runs at the module; none if its errors have no attempts
  double target_rad = 0.0;
  double tolerance_rad = 0.0;
  double forceLimit_N = 0.0;
  std::optional<double> deviceForce_N{};     ///< largest force sent to the device; never judged
  std::optional<EarlierMeasure> earlier{};   ///< result of an older version of the definitions
  std::vector<TwistResult> twists{};         ///< completed ones
  std::int64_t unfinishedTwists = 0;         ///< not completed, counted separately
  std::vector<DebriefFinding> strengths{};   ///< two, best first; fewer if fewer metrics are defined
  std::vector<DebriefFinding> weaknesses{};  ///< two, worst first
  DebriefTrace own{};
  /// One twist of the expert, with time since the grip; empty if the scene is no longer available.
  DebriefTrace expert{};
  std::shared_ptr<const Trial> recording{};        ///< the run; null without a database
  std::shared_ptr<const Trial> expertRecording{};  ///< contains `expert`; null: none
  double expertGrip_s = 0.0;                       ///< start of `expert` within it
  std::vector<double> grips_s{};  ///< start of each twist in the run, for aligning the expert's curve
  std::vector<DebriefBookmark> bookmarks{};
  std::optional<DetorsionStory> detorsion{};  ///< only for an organ that starts twisted
  std::optional<RealArmStory> realArm{};      ///< only for a tracker's recording, which has no verdict
};

/// Computes the part that needs no database. `expert` may be null; strengths and weaknesses are then missing.
[[nodiscard]] Debrief makeDebrief(const TrialHeader& header, std::span<const Sample> samples,
                                  const AttemptRules& rules, const Trial* expert);
/// Like the overload above, for twists already measured by measureTwists() from the same samples and rules.
[[nodiscard]] Debrief makeDebrief(const TrialHeader& header, std::span<const Sample> samples,
                                  const MeasuredTrial& measured, const AttemptRules& rules,
                                  const Trial* expert);

/// Returns the debrief of a stored trial. kTrialViewOwn, the actor's trials. `scene`: the trial's scene if
/// already loaded; otherwise it is loaded from `assets` for the expert run or the mishaps of an untwisting.
/// Takes seconds: do not call it on the GUI thread.
[[nodiscard]] Debrief debrief(SessionContext& session, const TrialId& trialId,
                              const std::filesystem::path& assets, const Scene* scene = nullptr);

/// Adds a bookmark to the actor's trial. Audited. kTrialViewOwn.
void addBookmark(SessionContext& session, const TrialId& trialId, double at_s, const std::string& text);

}  // namespace torsio
