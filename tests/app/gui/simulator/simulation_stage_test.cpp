// SPDX-License-Identifier: GPL-3.0-or-later
// Permitted actions of the simulator at each stage, and their effects.
#include "app/gui/simulator/simulation_stage.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/gui/simulator/simulation_controller.h"
#include "sim/record/trial.h"
#include "tests/app/gui/support/bar_view.h"

namespace torsio::gui {
namespace {

using testing::eventually;
using testing::loadBar;
using testing::requestFor;
using Kind = StageKind;
using Mode = SimulationController::Mode;

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
