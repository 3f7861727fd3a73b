// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/training_run.h"

#include <cstring>
#include <iostream>
#include <vector>

#include <QCoreApplication>
#include <QProcess>
#include <gtest/gtest.h>

#include "app/services/recording/recorded_run.h"
#include "app/services/recording/unstored_trials.h"
#include "app/services/training/run_session.h"
#include "assessment/domain/study/cohort.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"
#include "tests/app/support/training_centre.h"

namespace torsio {
namespace {

using Kind = RunEvent::Kind;

/// The second arm of the paper's study (section 6): 20 min virtual, 20 min on the real arm, 5 min of rest.
RunPlan paperArm() {
  RunPlan plan;
  plan.phases.push_back(
      {.phaseId = "p1", .label = "virtual", .arm = PhaseKind::kVirtual, .duration_us = 20 * kMinute_us});
  plan.phases.push_back(
      {.phaseId = "p2", .label = "real", .arm = PhaseKind::kReal, .duration_us = 20 * kMinute_us});
  plan.restAllowance_us = 5 * kMinute_us;
  return plan;
}

class TrainingRunTest : public ::testing::Test {
 protected:
  ManualClock clock_{7};
  TrainingRun run_{paperArm(), clock_};
  std::vector<RunEvent> events_;

  /// Lets time pass like a timer of the window.
  void pass(std::int64_t span_us, std::int64_t step_us = 200'000) {
    for (; span_us > 0; span_us -= step_us) {
      clock_.advance_us(std::min(span_us, step_us));
      for (const RunEvent& event : run_.advance()) {
        events_.push_back(event);
      }
    }
  }
  [[nodiscard]] std::vector<Kind> kinds() const {
    std::vector<Kind> kinds;
    for (const RunEvent& event : events_) {
      kinds.push_back(event.kind);
    }
    return kinds;
  }
  static std::int64_t sum(const std::vector<ExposurePiece>& pieces, ExposureKind kind) {
    std::int64_t total_us = 0;
    for (const ExposurePiece& piece : pieces) {
      if (piece.kind == kind) {
        total_us += piece.duration_us;
      }
    }
    return total_us;
  }
};

TEST_F(TrainingRunTest, ChangesFromTheVirtualToTheRealArmAndStopsHardAtTheEnd) {
  run_.start();
  pass(20 * kMinute_us);
  EXPECT_EQ(run_.state(), RunState::kHandOver);
  EXPECT_EQ(run_.phase().arm, PhaseKind::kReal);

  pass(kLongestHandOver_us);
  EXPECT_EQ(run_.state(), RunState::kRunning);
  EXPECT_EQ(run_.remainingInPhase_us(), 20 * kMinute_us);

  pass(20 * kMinute_us);
  EXPECT_EQ(run_.state(), RunState::kFinished);
  EXPECT_EQ(run_.remainingInPhase_us(), 0);
  EXPECT_EQ(kinds(), (std::vector<Kind>{Kind::kPhaseBegan, Kind::kPhaseEnded, Kind::kHandOver,
                                        Kind::kPhaseBegan, Kind::kPhaseEnded, Kind::kFinished}));
}

TEST_F(TrainingRunTest, PhaseBoundariesAreExactHoweverLateTheTimerIs) {
  run_.start();
  pass(20 * kMinute_us + 3 * kSecond_us, 7 * kSecond_us);

  ASSERT_EQ(run_.state(), RunState::kHandOver);
  EXPECT_EQ(events_[1].at_us, 7 + 20 * kMinute_us);
  EXPECT_EQ(run_.handOverLeft_us(), kLongestHandOver_us - 3 * kSecond_us);
}

TEST_F(TrainingRunTest, ATraineeWhoReachesTheRealArmEarlierStartsEarlier) {
  run_.start();
  pass(20 * kMinute_us + 4 * kSecond_us);
  run_.resume();

  EXPECT_EQ(run_.state(), RunState::kRunning);
  EXPECT_EQ(run_.remainingInPhase_us(), 20 * kMinute_us);
}

TEST_F(TrainingRunTest, RestStopsTheClockAndIsLoggedSeparately) {
  run_.start();
  pass(5 * kMinute_us);
  ASSERT_TRUE(run_.rest());
  pass(2 * kMinute_us);
  EXPECT_EQ(run_.remainingInPhase_us(), 15 * kMinute_us);
  EXPECT_EQ(run_.restLeft_us(), 3 * kMinute_us);

  run_.resume();
  pass(kMinute_us);

  const std::vector<ExposurePiece> pieces = run_.takeExposure(true);
  EXPECT_EQ(sum(pieces, ExposureKind::kVirtual), 6 * kMinute_us);
  EXPECT_EQ(sum(pieces, ExposureKind::kRest), 2 * kMinute_us);
}

TEST_F(TrainingRunTest, AnIndivisibleRestIsUsedUpByTheFirst) {
  run_.start();
  pass(kMinute_us);
  ASSERT_TRUE(run_.rest());
  pass(30 * kSecond_us);
  run_.resume();
  pass(kMinute_us);

  EXPECT_FALSE(run_.mayRest());
  EXPECT_FALSE(run_.rest());
  EXPECT_EQ(run_.restLeft_us(), 0);
}

TEST_F(TrainingRunTest, ADivisibleRestLastsAsLongAsTheAllowance) {
  RunPlan plan = paperArm();
  plan.restSplittable = true;
  run_ = TrainingRun(plan, clock_);
  run_.start();
  for (int i = 0; i < 2; ++i) {
    pass(kMinute_us);
    ASSERT_TRUE(run_.rest());
    pass(2 * kMinute_us);
    run_.resume();
  }
  EXPECT_EQ(run_.restLeft_us(), kMinute_us);
  EXPECT_TRUE(run_.mayRest());
}

TEST_F(TrainingRunTest, TrainingContinuesAutomaticallyWhenTheRestIsUsedUp) {
  run_.start();
  ASSERT_TRUE(run_.rest());
  pass(6 * kMinute_us);

  EXPECT_EQ(run_.state(), RunState::kRunning);
  EXPECT_EQ(run_.remainingInPhase_us(), 19 * kMinute_us);
  EXPECT_EQ(kinds(), (std::vector<Kind>{Kind::kPhaseBegan, Kind::kRestBegan, Kind::kRestUsedUp}));
}

TEST_F(TrainingRunTest, TimeOfASleepingMachineDoesNotCount) {
  run_.start();
  pass(kMinute_us);
  clock_.advance_us(45 * kMinute_us);  // the lid was closed
  for (const RunEvent& event : run_.advance()) {
    events_.push_back(event);
  }

  EXPECT_EQ(run_.remainingInPhase_us(), 19 * kMinute_us);
  EXPECT_EQ(kinds().back(), Kind::kPaused);
}

TEST_F(TrainingRunTest, WaitingForTheMachineDoesNotCount) {
  run_.start();
  pass(kMinute_us);
  for (int i = 0; i < 30; ++i) {
    clock_.advance_us(200'000);
    run_.hold();
  }
  pass(kMinute_us);

  EXPECT_EQ(run_.remainingInPhase_us(), 18 * kMinute_us);
  const std::vector<ExposurePiece> pieces = run_.takeExposure(true);
  std::int64_t sum_us = 0;
  for (const ExposurePiece& piece : pieces) {
    sum_us += piece.duration_us;
  }
  EXPECT_EQ(sum_us, 2 * kMinute_us);
  EXPECT_EQ(kinds(), std::vector<Kind>{Kind::kPhaseBegan});
}

TEST_F(TrainingRunTest, ContinuesWhereAnEarlierRunEnded) {
  RunPlan plan = paperArm();
  plan.phases[0].done_us = 20 * kMinute_us;
  plan.phases[1].done_us = 4 * kMinute_us;
  plan.restTaken_us = 5 * kMinute_us;
  run_ = TrainingRun(plan, clock_);

  EXPECT_EQ(run_.phaseIndex(), 1U);
  EXPECT_EQ(run_.remainingInPhase_us(), 16 * kMinute_us);
  EXPECT_EQ(run_.restLeft_us(), 0);
}

TEST_F(TrainingRunTest, TrainingTimeComesInPiecesAndAddsUp) {
  run_.start();
  pass(70 * kSecond_us);
  const std::vector<ExposurePiece> complete = run_.takeExposure(false);
  ASSERT_EQ(complete.size(), 2U);
  EXPECT_EQ(complete[0].duration_us, kExposurePiece_us);
  EXPECT_EQ(complete[0].phaseId, "p1");
  pass(5 * kSecond_us);
  run_.stop();

  const std::vector<ExposurePiece> rest = run_.takeExposure(true);
  ASSERT_EQ(rest.size(), 1U);
  EXPECT_EQ(rest[0].duration_us, 15 * kSecond_us);
  EXPECT_EQ(rest[0].begun_us, 7 + 60 * kSecond_us);
  EXPECT_TRUE(run_.over());
}

TEST_F(TrainingRunTest, RejectsAPlanWithNothingLeftToDo) {
  RunPlan plan = paperArm();
  for (RunPhase& phase : plan.phases) {
    phase.done_us = phase.duration_us;
  }
  EXPECT_THROW(TrainingRun(plan, clock_), Error);
  EXPECT_THROW(TrainingRun(RunPlan{}, clock_), Error);
  plan.phases[0].duration_us = 0;
  EXPECT_THROW(TrainingRun(plan, clock_), Error);
}

// A station is killed during a run: what was recorded and trained must be there at the next start. The killed
// program is this one, started with --train.

constexpr const char* kTrain = "--train";
constexpr int kPatience_ms = 60'000;

/// Trains endlessly; prints a line after each second that reached the database.
[[noreturn]] void trainForever(const std::filesystem::path& folder) {
  TrainingCentre centre(folder);
  centre.become("T-01");
  ManualClock clock;
  RunSession runSession(centre.session(), {centre.module("first"), true, deviceWith(Light::kGreen)}, clock);
  runSession.start();
  const RecordingSpec recording = runSession.newTrial();
  const Scene& scene = trainingBar();
  ScriptedHandOptions hand;
  hand.task = handTask(scene);
  hand.duration_s = 600.0;
  RecordedRun run(borrowed(scene), std::make_unique<ScriptedHand>(hand), recording,
                  recordingSink(centre.session().key().locator, recording.context));
  for (;;) {
    run.step(ticksIn(1.0));
    clock.advance_us(kSecond_us);
    static_cast<void>(runSession.advance());
    std::cout << "second\n" << std::flush;
  }
}

/// Runs the program until it has reported `seconds` of training, then kills it.
void trainAndKill(const TrainingCentre& centre, int seconds) {
  QProcess program;
  program.start(QCoreApplication::applicationFilePath(),
                {QString::fromLatin1(kTrain), QString::fromStdString(centre.folder().string())});
  QByteArray said;
  while (said.count('\n') < seconds && program.waitForReadyRead(kPatience_ms)) {
    said += program.readAllStandardOutput();
  }
  program.kill();
  ASSERT_TRUE(program.waitForFinished(kPatience_ms));
  ASSERT_GE(said.count('\n'), seconds) << program.readAllStandardError().toStdString();
}

std::int64_t logged_us(TrainingCentre& centre) {
  std::int64_t total_us = 0;
  for (const Exposure& exposure : StudyRepository(centre.connection()).exposures(centre.cohort().id)) {
    total_us += exposure.duration_us;
  }
  return total_us;
}

TEST(KilledRun, IsRecoveredAsInterruptedAndItsTimeCounts) {
  TrainingCentre::Setup setup;
  setup.phases = {{.kind = PhaseKind::kVirtual, .label = "virtual 10 min", .duration_us = 10 * kMinute_us}};
  TrainingCentre centre(setup);
  trainAndKill(centre, 33);  // one piece of training time was logged, three seconds were not
  centre.passTime_us(utcNow_us() - kCentreTime_us + kMinute_us);

  const std::vector<RecoveredTrial> found = recoverInterrupted(centre.session());

  ASSERT_EQ(found.size(), 1U);
  EXPECT_GE(found[0].recorded_s, 33.0);
  EXPECT_GT(found[0].exposureAdded_s, 0.0);
  EXPECT_EQ(found[0].phaseLabel, "virtual 10 min");
  EXPECT_EQ(logged_us(centre), static_cast<std::int64_t>(found[0].recorded_s * 1e6));
  const NextSteps steps = nextSteps(centre.session(), centre.person());
  ASSERT_EQ(steps.interrupted.size(), 1U);
  EXPECT_EQ(steps.interrupted[0].trialId, found[0].trialId);
  EXPECT_EQ(steps.plan.phases[0].done_us, logged_us(centre));
  EXPECT_EQ(steps.modules[0].attempts, 0);  // not counted, so that nobody loses an attempt by a power cut
}

TEST(KilledRun, IsFoundOnlyOnce) {
  TrainingCentre centre;
  trainAndKill(centre, 2);
  centre.passTime_us(utcNow_us() - kCentreTime_us + kMinute_us);
  EXPECT_EQ(recoverInterrupted(centre.session()).size(), 1U);
  const std::int64_t once_us = logged_us(centre);

  EXPECT_TRUE(recoverInterrupted(centre.session()).empty());
  EXPECT_EQ(logged_us(centre), once_us);
}

TEST(KilledRun, ARunWithARecentHeartbeatIsLeftAlone) {
  TrainingCentre centre;
  trainAndKill(centre, 2);
  centre.passTime_us(utcNow_us() - kCentreTime_us + kSecond_us);

  EXPECT_TRUE(recoverInterrupted(centre.session()).empty());
}

TEST(KilledRun, OfSomebodyElseIsClosedButNotShown) {
  TrainingCentre centre;
  trainAndKill(centre, 2);
  centre.passTime_us(utcNow_us() - kCentreTime_us + kMinute_us);
  centre.become("T-02");

  EXPECT_TRUE(recoverInterrupted(centre.session()).empty());
  centre.become("T-01");
  EXPECT_EQ(nextSteps(centre.session(), centre.person()).interrupted.size(), 1U);
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  if (argc == 3 && std::strcmp(argv[1], torsio::kTrain) == 0) {
    torsio::trainForever(argv[2]);
  }
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
