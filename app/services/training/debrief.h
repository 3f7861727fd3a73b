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
#include "assessment/attempt/competence.h"
#include "assessment/attempt/run_verdict.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/protocol_terms.h"
#include "sim/core/text.h"
#include "sim/scene/scene.h"

namespace torsio {

/// A stretch of the recording.
struct Seconds {
  double from_s = 0.0;
  double to_s = 0.0;
};

/// One twist of the run.
struct TwistResult {
  Seconds when{};
  double target_rad = 0.0;
  double released_rad = 0.0;
  double held_s = 0.0;  ///< on target until let go
  bool passed = false;  ///< released on target
};

/// Something that was done well or badly, and where.
struct DebriefFinding {
  Quantity quantity{};
  double value = 0.0;   ///< of that twist, SI
  double expert = 0.0;  ///< of the expert run
  double merit = 0.0;   ///< logarithm of how much better than the expert; negative: worse
  std::size_t twist = 0;
  Seconds when{};         ///< where to look
  bool strength = false;  ///< false: a weakness

  /// What was good or bad, in one sentence.
  [[nodiscard]] Text text() const;
  /// What to try next; empty for a strength.
  [[nodiscard]] Text advice() const;
};

/// A curve for the window, thinned for drawing.
struct DebriefTrace {
  std::vector<double> time_s{};
  std::vector<double> angle_rad{};
  std::vector<double> torque_Nm{};
  std::vector<double> force_N{};  ///< on the tissue; of what is thinned the largest
  [[nodiscard]] bool empty() const noexcept { return time_s.empty(); }
};

struct DebriefBookmark {
  RemarkId id{};
  double at_s = 0.0;
  std::string text{};
};

/// The same run as an older version of the definitions measured it, where that says otherwise: kept beside,
/// judged no more.
struct EarlierMeasure {
  std::int64_t version = 0;  ///< of the definitions (kMetricsVersion)
  std::optional<double> peakForce_N{};
  bool withinLimits = false;  ///< force and torque lay within the limits, by that version
};

/// What a trainee is told right after a run.
struct Debrief {
  TrialId trialId{};
  ModuleId moduleId{};
  std::string moduleTitle{};
  std::string phaseLabel{};
  std::optional<AttemptMode> mode{};
  std::int64_t startedUtc_us = 0;
  double duration_s = 0.0;
  bool demonstration = false;
  bool forceFelt = true;  ///< false: computed and shown; its measures are marked
  Text servoTrouble{};    ///< app/services/devices/device_readiness.h; empty: none
  Text servoRemedy{};     ///< what to do about it
  RunVerdict verdict{};
  CompetenceVerdict competence{};  ///< of all runs at the module; no attempts in its errors: there is none
  double target_rad = 0.0;
  double tolerance_rad = 0.0;
  double forceLimit_N = 0.0;
  std::optional<double> deviceForce_N{};     ///< largest that the device was told to give; never judged
  std::optional<EarlierMeasure> earlier{};   ///< what an older version of the definitions had said
  std::vector<TwistResult> twists{};         ///< completed ones
  std::int64_t unfinishedTwists = 0;         ///< not completed, counted apart
  std::vector<DebriefFinding> strengths{};   ///< two, best first; fewer when fewer are defined
  std::vector<DebriefFinding> weaknesses{};  ///< two, worst first
  DebriefTrace own{};
  /// One twist of the expert, its time from the grip; empty: the scene is not there any more.
  DebriefTrace expert{};
  std::shared_ptr<const Trial> recording{};        ///< the run itself; null without a database
  std::shared_ptr<const Trial> expertRecording{};  ///< of which `expert` is a part; null: none
  double expertGrip_s = 0.0;                       ///< where in it `expert` begins
  std::vector<double> grips_s{};  ///< when each twist of the run began: where the expert's curve is laid
  std::vector<DebriefBookmark> bookmarks{};
  std::optional<DetorsionStory> detorsion{};  ///< of an organ that came twisted; else empty
};

/// The part that needs no database. `expert` may be null: then strengths and weaknesses are missing, too.
[[nodiscard]] Debrief makeDebrief(const TrialHeader& header, std::span<const Sample> samples,
                                  const AttemptRules& rules, const Trial* expert);
/// Does the same with twists that measureTwists has measured already, of the same samples by the same rules.
[[nodiscard]] Debrief makeDebrief(const TrialHeader& header, std::span<const Sample> samples,
                                  const MeasuredTrial& measured, const AttemptRules& rules,
                                  const Trial* expert);

/// The debrief of a stored trial. kTrialViewOwn, own trials only. `scene`: that of the trial when it is
/// loaded already; else it is loaded from `assets` for the expert run or, of an untwisting, for its mishaps.
/// Seconds: call it off the GUI thread.
[[nodiscard]] Debrief debrief(SessionContext& session, const TrialId& trialId,
                              const std::filesystem::path& assets, const Scene* scene = nullptr);

/// A bookmark of one's own in a trial of one's own. Audited. kTrialViewOwn.
void addBookmark(SessionContext& session, const TrialId& trialId, double at_s, const std::string& text);

}  // namespace torsio
