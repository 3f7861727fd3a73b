// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/gui/simulator/simulation_controller.h"
#include "app/gui/simulator/simulation_stage.h"
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

// Permitted actions at each stage, and their effects.

using Kind = StageKind;

constexpr std::array kKinds{Kind::kEmpty,    Kind::kPractising, Kind::kRecording,
                            Kind::kTraining, Kind::kStill,      Kind::kReplaying};

const char* nameOf(Kind kind) {
  constexpr std::array<const char*, kStageKinds> kNames{"empty",    "practising", "recording",
                                                        "training", "still",      "replaying"};
  return kNames[static_cast<std::size_t>(kind)];
}

/// The bar, built once for all simulators.
LoadedScene bar(const SceneRequest& /*wanted*/) {
  static const LoadedScene kBar = loadBar(requestFor("bar"));
  return kBar;
}

/// A simulator with the bar that stores recordings in memory.
class Simulator {
 public:
  explicit Simulator(Kind at) {
    controller_.setRealTime(false);
    if (at == Kind::kEmpty) {
      return;
    }
    load();
    if (at == Kind::kRecording) {
      controller_.startRecording();
    }
    if (at == Kind::kTraining) {
      train();
    }
    if (at == Kind::kStill) {
      controller_.freeze({});
    }
    if (at == Kind::kReplaying) {
      replay();
    }
  }
  void load() {
    controller_.load(requestFor("bar"));
    EXPECT_TRUE(eventually([this] { return !controller_.loading(); }));
  }
  void train() { static_cast<void>(controller_.startTraining({.trialId = "run"}, sink(), nullptr)); }
  void replay() {
    controller_.openReplay(recordedBar());
    EXPECT_TRUE(eventually([this] { return !controller_.loading(); }));
  }
  [[nodiscard]] Kind stage() const { return controller_.stage(); }
  SimulationController& controller() { return controller_; }

 private:
  static std::unique_ptr<TrialSink> sink() { return std::make_unique<MemoryTrialSink>(); }
  static TrialRecording recording() {
    TrialRecording keep;
    keep.open = [](const RecordingSpec&) { return sink(); };
    return keep;
  }
  static const Trial& recordedBar() {
    static const Trial kTrial = [] {
      MemoryTrialSink kept;
      RecordedRun run(bar({}).scene, std::make_unique<PointerDevice>(Pose{}), {}, borrowed<TrialSink>(kept));
      run.step(100);
      static_cast<void>(run.finish(TrialOutcome::kCompleted));
      return kept.trial();
    }();
    return kTrial;
  }

  SimulationController controller_{bar, recording()};
};

struct Event {
  const char* name;
  std::function<void(Simulator&)> happens;
  /// The resulting stage, from each stage in the order of kKinds.
  std::array<Kind, kStageKinds> leadsTo;
};

const std::vector<Event>& events() {
  constexpr Kind kE = Kind::kEmpty;
  constexpr Kind kP = Kind::kPractising;
  constexpr Kind kR = Kind::kRecording;
  constexpr Kind kT = Kind::kTraining;
  constexpr Kind kS = Kind::kStill;
  constexpr Kind kX = Kind::kReplaying;
  static const std::vector<Event> kEvents{
      {"a scene is chosen", [](Simulator& s) { s.load(); }, {kP, kP, kR, kT, kP, kP}},
      {"a recording is opened", [](Simulator& s) { s.replay(); }, {kX, kX, kR, kT, kX, kX}},
      {"the replay is closed", [](Simulator& s) { s.controller().closeReplay(); }, {kE, kP, kR, kT, kS, kP}},
      {"recording begins", [](Simulator& s) { s.controller().startRecording(); }, {kE, kR, kR, kT, kS, kX}},
      {"recording ends", [](Simulator& s) { s.controller().stopRecording(); }, {kE, kP, kP, kT, kS, kX}},
      {"a trainee's run begins", [](Simulator& s) { s.train(); }, {kE, kT, kR, kT, kT, kX}},
      {"a trainee's run ends",
       [](Simulator& s) { static_cast<void>(s.controller().endTraining(TrialOutcome::kCompleted)); },
       {kE, kP, kR, kS, kS, kX}},
      {"the window closes", [](Simulator& s) { s.controller().shutDown(); }, {kE, kS, kS, kS, kS, kS}},
  };
  return kEvents;
}

TEST(SimulationStage, EveryEventLeadsFromEveryStageToTheRightOne) {
  for (const Event& event : events()) {
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
      SCOPED_TRACE(std::string(event.name) + " while " + nameOf(kKinds[i]));
      Simulator simulator(kKinds[i]);
      ASSERT_EQ(simulator.stage(), kKinds[i]);

      event.happens(simulator);

      EXPECT_STREQ(nameOf(simulator.stage()), nameOf(event.leadsTo[i]));
    }
  }
}

TEST(SimulationStage, TheTransitionTableContainsExactlyWhatHappens) {
  std::array<std::array<bool, kStageKinds>, kStageKinds> seen{};
  for (const Event& event : events()) {
    for (std::size_t i = 0; i < kKinds.size(); ++i) {
      const auto to = static_cast<std::size_t>(event.leadsTo[i]);
      // An event that is refused or has no effect keeps the stage.
      if (event.leadsTo[i] != kKinds[i]) {
        seen[i][to] = true;
      }
    }
  }
  seen[static_cast<std::size_t>(Kind::kPractising)][static_cast<std::size_t>(Kind::kPractising)] = true;
  seen[static_cast<std::size_t>(Kind::kStill)][static_cast<std::size_t>(Kind::kStill)] = true;
  seen[static_cast<std::size_t>(Kind::kReplaying)][static_cast<std::size_t>(Kind::kReplaying)] = true;

  for (const Kind before : kKinds) {
    for (const Kind after : kKinds) {
      EXPECT_EQ(mayFollow(before, after),
                seen[static_cast<std::size_t>(before)][static_cast<std::size_t>(after)])
          << nameOf(after) << " after " << nameOf(before);
    }
  }
}

TEST(SimulationStage, TheWindowsModeFollowsFromTheStage) {
  constexpr std::array<Mode, kStageKinds> kModes{Mode::kEmpty,     Mode::kPractice, Mode::kRecording,
                                                 Mode::kRecording, Mode::kPractice, Mode::kReplay};
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    SCOPED_TRACE(nameOf(kKinds[i]));
    Simulator simulator(kKinds[i]);

    EXPECT_EQ(simulator.controller().mode(), kModes[i]);
    EXPECT_EQ(simulator.controller().run() != nullptr,
              kKinds[i] == Kind::kPractising || kModes[i] == Mode::kRecording);
    EXPECT_EQ(simulator.controller().playback() != nullptr, kKinds[i] == Kind::kReplaying);
    EXPECT_EQ(simulator.controller().frozen(), kKinds[i] == Kind::kStill);
  }
}

}  // namespace

}  // namespace torsio::gui
