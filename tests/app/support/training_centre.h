// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/services/access/session_context.h"
#include "app/services/devices/device_readiness.h"
#include "app/services/recording/recording_spec.h"
#include "app/services/training/attempts.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/time_units.h"
#include "sim/scene/scene.h"
#include "tests/app/support/test_record.h"

namespace torsio {

inline constexpr std::int64_t kCentreTime_us = kRecordTime_us;

/// A small centre in a temporary SQLite file: trainees T-01 and T-02 with users, one chief, one cohort that
/// follows a running curriculum of three modules on the bar of the servo tests.
///
/// | module | mode     | needs | mastered by                       | attempts |
/// |--------|----------|-------|-----------------------------------|----------|
/// | first  | practice | -     | half the twists on target, twice  | any      |
/// | second | graded   | first | half the twists on target, once   | 3        |
/// | third  | graded   | second| half the twists on target, once   | any      |
class TrainingCentre : public TestRecord {
 public:
  struct Setup {
    /// Phases of the study's single arm; empty: no arm, modules at any time.
    std::vector<TrainingPhase> phases{};
    std::int64_t restAllowance_us = 0;
    bool restSplittable = false;
    bool consent = true;
    bool simulated = false;  ///< simulated trainees
    SceneId sceneId = "bar";
    PatternId patternId = "quarter";
    /// Rules of every module, replacing those of the table.
    std::vector<MasteryCriterion> mastery{};
    std::int64_t leastTwists = 1;  ///< of every module
    std::int64_t hold_us = 0;      ///< of every module
  };
  TrainingCentre() : TrainingCentre(Setup{}) {}
  explicit TrainingCentre(const Setup& setup);
  /// Opens an existing centre in `folder`, like another program.
  explicit TrainingCentre(const std::filesystem::path& folder);

  [[nodiscard]] SessionContext& session() {
    session_->beginCall();
    return *session_;
  }
  [[nodiscard]] std::string person() { return session_->actor().personId; }
  /// Returns the id of "first", "second" or "third".
  [[nodiscard]] std::string module(const std::string& code);
  /// Signs in "T-01", "T-02" or "chief".
  void become(const std::string& who);
  [[nodiscard]] Cohort cohort();
  [[nodiscard]] std::string enrolment(const std::string& traineeCode = "T-01");

  /// Records a finished attempt of the signed-in trainee by a scripted hand: 0 a beginner .. 1 an expert. A
  /// hand that plans for a longer time (planned_s) may be cut off during a twist.
  std::string attempt(const std::string& moduleCode, const std::string& mode, double skill,
                      double duration_s = 12.0, const PhaseId& phaseId = {}, double planned_s = 0.0,
                      TrialOutcome outcome = TrialOutcome::kCompleted);
  /// Records a finished attempt of the signed-in trainee at untwisting the shipped testis, which starts
  /// twisted by two to four turns of a hand; the hand is experienced and omits the last turns.
  std::string untwist(const std::string& moduleCode, const std::string& mode, std::size_t turnsLeftOut = 0);

 private:
  [[nodiscard]] RecordingSpec recording(const std::string& moduleCode, const std::string& mode,
                                        const PhaseId& phaseId = {});
  void fill(const Setup& setup);
  std::unique_ptr<SessionContext> session_ = sessionOf("station 1", {});
};

/// Returns the bar of the servo tests, created once: target 90 degrees.
[[nodiscard]] const Scene& trainingBar();

/// Returns a device with one finding of this light.
[[nodiscard]] DeviceReadiness deviceWith(Light light);

/// Returns one attempt of the trainee who is signed in, measured and stored like all of theirs. Throws
/// std::out_of_range for a trial that is not theirs.
[[nodiscard]] Attempt attemptOf(TrainingCentre& centre, const TrialId& trialId);

}  // namespace torsio

namespace torsio::testing {
using torsio::attemptOf;
using torsio::deviceWith;
using torsio::kCentreTime_us;
using torsio::kMinute_us;
using torsio::kSecond_us;
using torsio::trainingBar;
using torsio::TrainingCentre;
}  // namespace torsio::testing
