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
#include "db/connection/connection.h"
#include "db/repository/base/id_source.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/time_units.h"
#include "sim/scene/scene.h"

namespace torsio::testing {

using torsio::kMinute_us;
using torsio::kSecond_us;
inline constexpr std::int64_t kCentreTime_us = 1'763'712'000'000'000;  // 2025-11-21 08:00 UTC

/// A small centre in a temporary SQLite file: trainees T-01 and T-02 with users, one chief, one cohort that
/// follows a running curriculum of three modules on the bar of the servo tests.
///
/// | module | mode     | needs | mastered by                       | attempts |
/// |--------|----------|-------|-----------------------------------|----------|
/// | first  | practice | -     | half the twists on target, twice  | any      |
/// | second | graded   | first | half the twists on target, once   | 3        |
/// | third  | graded   | second| half the twists on target, once   | any      |
class TrainingCentre {
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
  ~TrainingCentre();
  TrainingCentre(const TrainingCentre&) = delete;
  TrainingCentre& operator=(const TrainingCentre&) = delete;

  [[nodiscard]] SessionContext& session() {
    session_->beginCall();
    return *session_;
  }
  [[nodiscard]] Connection& connection() { return *connection_; }
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] std::string locator() const { return (folder_ / "centre.sqlite").string(); }
  [[nodiscard]] std::string person() { return session_->actor().personId; }
  /// Returns the id of "first", "second" or "third".
  [[nodiscard]] std::string module(const std::string& code);
  /// Signs in "T-01", "T-02" or "chief".
  void become(const std::string& who);
  void passTime_us(std::int64_t span_us) { now_us_ += span_us; }
  [[nodiscard]] Cohort cohort();
  [[nodiscard]] std::string enrolment(const std::string& traineeCode = "T-01");

  /// Records a finished attempt of the signed-in trainee by a scripted hand: 0 a beginner .. 1 an expert. A
  /// hand that plans for a longer time (planned_s) may be cut off during a twist.
  std::string attempt(const std::string& moduleCode, const std::string& mode, double skill,
                      double duration_s = 12.0, const PhaseId& phaseId = {}, double planned_s = 0.0);
  /// Records a finished attempt of the signed-in trainee at untwisting the shipped testis, which starts
  /// twisted by two to four turns of a hand; the hand is experienced and omits the last turns.
  std::string untwist(const std::string& moduleCode, const std::string& mode, std::size_t turnsLeftOut = 0);

 private:
  [[nodiscard]] RecordingSpec recording(const std::string& moduleCode, const std::string& mode,
                                        const PhaseId& phaseId = {});
  void open();
  void fill(const Setup& setup);
  std::filesystem::path folder_;
  bool owner_ = true;
  std::int64_t now_us_ = kCentreTime_us;
  std::unique_ptr<IdSource> ids_;
  std::unique_ptr<Connection> connection_;
  std::unique_ptr<SessionContext> session_;
};

/// Returns the bar of the servo tests, created once: target 90 degrees.
[[nodiscard]] const Scene& trainingBar();

/// Returns a device with one finding of this light.
[[nodiscard]] DeviceReadiness deviceWith(Light light);

/// Returns one attempt of the trainee who is signed in, measured and stored like all of theirs. Throws
/// std::out_of_range for a trial that is not theirs.
[[nodiscard]] Attempt attemptOf(TrainingCentre& centre, const TrialId& trialId);

}  // namespace torsio::testing
