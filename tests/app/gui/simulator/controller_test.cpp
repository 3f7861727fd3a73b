// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "app/gui/simulator/simulation_controller.h"
#include "sim/core/error.h"
#include "sim/record/trial.h"
#include "tests/app/gui/support/bar_view.h"

namespace torsio::gui {
namespace {

using testing::eventually;
using testing::loadBar;
using testing::requestFor;
using Mode = SimulationController::Mode;

/// Stores all trials in memory.
struct Shelf {
  struct Sink final : TrialSink {
    explicit Sink(std::shared_ptr<MemoryTrialSink> to) : kept(std::move(to)) {}
    void begin(const TrialHeader& header) override { kept->begin(header); }
    void append(const TrialChunk& chunk) override { kept->append(chunk); }
    void finish(const TrialSummary& summary) override { kept->finish(summary); }
    std::shared_ptr<MemoryTrialSink> kept;
  };
  std::vector<std::shared_ptr<MemoryTrialSink>> trials;

  TrialRecording recording() {
    TrialRecording result;
    result.place = "memory";
    result.open = [this](const RecordingSpec&) {
      trials.push_back(std::make_shared<MemoryTrialSink>());
      return std::make_unique<Sink>(trials.back());
    };
    return result;
  }
};

class Controller : public ::testing::Test {
 protected:
  Shelf shelf_;
  SimulationController controller_{loadBar, shelf_.recording()};
  int failures_ = 0;
  QString happened_;

  void SetUp() override {
    controller_.setRealTime(false);
    QObject::connect(&controller_, &SimulationController::failed, &controller_,
                     [this](const QString& happened) {
                       ++failures_;
                       happened_ = happened;
                     });
  }
  void load(const SceneRequest& request) {
    controller_.load(request);
    ASSERT_TRUE(eventually([this] { return !controller_.loading(); }));
  }
  void tick(int ticks) { controller_.run()->step(ticks); }
  Trial record(int ticks) {
    controller_.startRecording();
    tick(ticks);
    controller_.stopRecording();
    return shelf_.trials.back()->trial();
  }
};

TEST_F(Controller, IsEmptyUntilTheFirstSceneIsLoaded) {
  EXPECT_EQ(controller_.mode(), Mode::kEmpty);
  EXPECT_EQ(controller_.scene(), nullptr);
  EXPECT_EQ(controller_.state().tick, 0);

  load(requestFor("bar"));

  EXPECT_EQ(controller_.mode(), Mode::kPractice);
  ASSERT_NE(controller_.scene(), nullptr);
  EXPECT_EQ(controller_.scene()->id, "bar");
  EXPECT_DOUBLE_EQ(controller_.target_rad(), controller_.scene()->pattern.targetAngle_rad);
}

TEST_F(Controller, ShowsTheNewestOfSeveralLoads) {
  for (const char* id : {"first", "second", "third"}) {
    controller_.load(requestFor(id));
  }
  ASSERT_TRUE(eventually([this] { return !controller_.loading(); }));

  EXPECT_EQ(controller_.scene()->id, "third");
  EXPECT_EQ(failures_, 0);
}

TEST_F(Controller, AFailedLoadIsReportedAndTheOldSceneStays) {
  std::atomic<bool> broken{false};
  SimulationController controller(
      [&broken](const SceneRequest& request) {
        if (broken) {
          throw Error(ErrorCode::kBadMesh, Text::verbatim("the mesh is open"), Text::verbatim("x.obj"),
                      Text::verbatim("Close it"));
        }
        return loadBar(request);
      },
      {});
  controller.setRealTime(false);
  QString happened;
  QObject::connect(&controller, &SimulationController::failed, &controller,
                   [&happened](const QString& what) { happened = what; });
  controller.load(requestFor("good"));
  ASSERT_TRUE(eventually([&] { return !controller.loading(); }));

  broken = true;
  controller.load(requestFor("bad"));
  ASSERT_TRUE(eventually([&] { return !controller.loading(); }));

  EXPECT_EQ(happened, QStringLiteral("The mesh is open"));
  EXPECT_EQ(controller.scene()->id, "good");
  EXPECT_EQ(controller.mode(), Mode::kPractice);
}

TEST_F(Controller, ParksTheTipInFrontOfTheSectionToGrasp) {
  load(requestFor("bar"));

  const Vec3 tip = controller_.parkingPoint_m();

  EXPECT_LT(tip.y, -kBarRadius_m);  // on the viewer's side
  EXPECT_NEAR(controller_.scene()->collision.closest(tip).distance_m, 0.020, 0.003);
  tick(1);
  EXPECT_NEAR(controller_.nearby(controller_.state())->distance_m, 0.020 - 0.0025, 0.003);
}

TEST(ControllerOfAnUntwisting, ParksTheTipClearOfTheTwistedOrgan) {
  SimulationController controller(loadSceneForView, {});
  controller.setRealTime(false);
  SceneRequest request;
  request.assets = TORSIO_SOURCE_DIR "/assets";
  request.id = "gastric-mesentero-axial";  // its free end is turned towards the viewer
  request.pattern = "detorse";
  controller.load(request);
  ASSERT_TRUE(eventually([&] { return !controller.loading(); }));

  controller.run()->step(1);

  const LiveState state = controller.state();
  EXPECT_EQ(state.phase, ExercisePhase::kTracking);
  EXPECT_GT(std::abs(state.response.angle_rad), 1.0);
  EXPECT_GT(controller.nearby(state)->distance_m, 0.015);
}

TEST_F(Controller, RecordsATrialFromItsFirstTick) {
  load(requestFor("bar"));
  QString said;
  QObject::connect(&controller_, &SimulationController::noticed, &controller_,
                   [&said](const QString& sentence) { said = sentence; });
  const Trial trial = record(1200);

  EXPECT_EQ(trial.summary.samples, 1200);
  EXPECT_EQ(trial.summary.outcome, TrialOutcome::kCompleted);
  EXPECT_EQ(trial.header.sceneId, "bar");
  EXPECT_EQ(trial.header.organHash, controller_.scene()->organHash);
  EXPECT_EQ(trial.header.trialId.text().size(), 36U);
  EXPECT_EQ(controller_.mode(), Mode::kPractice);
  EXPECT_EQ(said, QStringLiteral("Recorded: 0:01.2. Replay shows it again")) << "its length, and no path";
}

TEST_F(Controller, RefusesAnotherSceneWhileRecording) {
  load(requestFor("bar"));
  QString said;
  QObject::connect(&controller_, &SimulationController::noticed, &controller_,
                   [&said](const QString& sentence) { said = sentence; });
  controller_.startRecording();

  controller_.load(requestFor("other"));

  EXPECT_FALSE(controller_.loading());
  EXPECT_FALSE(said.isEmpty());
  EXPECT_EQ(controller_.mode(), Mode::kRecording);
  controller_.stopRecording();
}

TEST_F(Controller, ReportsThatThereIsNoPlaceForARecording) {
  SimulationController controller(loadBar, {});
  controller.setRealTime(false);
  QString said;
  QObject::connect(&controller, &SimulationController::noticed, &controller,
                   [&said](const QString& sentence) { said = sentence; });
  controller.load(requestFor("bar"));
  ASSERT_TRUE(eventually([&] { return !controller.loading(); }));

  controller.startRecording();

  EXPECT_EQ(controller.mode(), Mode::kPractice);
  EXPECT_FALSE(said.isEmpty());
}

TEST_F(Controller, ClosingTheWindowStoresARunningTrialAsInterrupted) {
  load(requestFor("bar"));
  controller_.startRecording();
  tick(700);

  controller_.shutDown();

  EXPECT_EQ(shelf_.trials.back()->trial().summary.outcome, TrialOutcome::kInterrupted);
  EXPECT_EQ(shelf_.trials.back()->trial().summary.samples, 700);
}

TEST_F(Controller, ReplaysARecordingAndReturnsToPractice) {
  load(requestFor("bar"));
  const Trial trial = record(1500);

  controller_.openReplay(trial);
  ASSERT_TRUE(eventually([this] { return !controller_.loading(); }));

  ASSERT_EQ(controller_.mode(), Mode::kReplay);
  ASSERT_NE(controller_.playback(), nullptr);
  EXPECT_TRUE(controller_.playback()->playing());
  controller_.advance(0.25);
  EXPECT_EQ(controller_.state().tick, 250);
  controller_.closeReplay();
  EXPECT_EQ(controller_.mode(), Mode::kPractice);
  EXPECT_EQ(controller_.playback(), nullptr);
}

TEST_F(Controller, RefusesARecordingOfAnotherOrgan) {
  load(requestFor("bar"));
  Trial trial = record(1000);
  trial.header.organHash = "another organ";

  controller_.openReplay(trial);
  ASSERT_TRUE(eventually([this] { return !controller_.loading(); }));

  EXPECT_EQ(failures_, 1);
  EXPECT_TRUE(happened_.contains(QStringLiteral("not those of the recording")));
  EXPECT_EQ(controller_.mode(), Mode::kPractice);
}

TEST_F(Controller, ATargetReachesTheServoAndStays) {
  load(requestFor("bar"));

  controller_.setTarget(0.4);
  tick(1);

  EXPECT_EQ(controller_.state().targetAngle_rad, 0.4);
  EXPECT_EQ(controller_.target_rad(), 0.4);
}

}  // namespace
}  // namespace torsio::gui
