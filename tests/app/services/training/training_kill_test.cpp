// SPDX-License-Identifier: GPL-3.0-or-later
// A station is killed during a run: what was recorded and trained must be there at the next start. The killed
// program is this one, started with --train.
#include <cstring>
#include <iostream>

#include <QCoreApplication>
#include <QProcess>
#include <gtest/gtest.h>

#include "app/services/recording/recorded_run.h"
#include "app/services/recording/unstored_trials.h"
#include "app/services/training/run_session.h"
#include "assessment/domain/study/cohort.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/time_units.h"
#include "sim/device/virtual/scripted_hand.h"
#include "sim/servo/hand_task.h"
#include "tests/app/support/training_centre.h"

namespace torsio {
namespace {

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
