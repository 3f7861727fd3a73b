// SPDX-License-Identifier: GPL-3.0-or-later
// A run and its haptic device: waiting for it, cancelling, and losing it during the run.
#include <algorithm>
#include <atomic>
#include <memory>
#include <semaphore>
#include <utility>
#include <vector>

#include <QApplication>
#include <QMessageBox>
#include <QTimer>

#include "app/gui/widgets/child.h"
#include "assessment/attempt/trial_listing.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "tests/app/gui/support/trainee_station.h"

namespace torsio::gui {
namespace {

using torsio::testing::kMinute_us;
using torsio::testing::kSecond_us;
using torsio::testing::TrainingCentre;

/// Controls the haptic device in a test, and observes it.
struct Wire {
  std::atomic<bool> unplugged{false};
  Vec3 lastForce_N{1.0, 1.0, 1.0};
};

/// The practised hand as a device that can be unplugged.
class Wired final : public HapticDevice {
 public:
  Wired(std::shared_ptr<Wire> wire, const ScriptedHandOptions& hand)
      : wire_(std::move(wire)), hand_(std::make_unique<ScriptedHand>(hand)) {}
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override {
    return hand_->capabilities();
  }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override {
    DeviceSample sample = hand_->read(time_us);
    if (wire_->unplugged) {
      sample.status |= kDeviceLost;
    }
    return sample;
  }
  void write(const ForceCommand& command) noexcept override {
    wire_->lastForce_N = command.force_N;
    hand_->write(command);
  }

 private:
  std::shared_ptr<Wire> wire_;
  std::unique_ptr<ScriptedHand> hand_;
};

/// Unplugs the device, and lets everybody notice.
void unplug(Station& station, Wire& wire) {
  wire.unplugged = true;
  child<LiveScene>(station.run(), "scene").controller().run()->step(20);
  child<LiveScene>(station.run(), "scene").frame(0.016);
}

/// Returns the outcomes of stored trials, in any order.
std::vector<TrialOutcome> outcomes(TrainingCentre& centre) {
  std::vector<TrialOutcome> all;
  for (const TrialListing& trial : TrialRepository(centre.connection()).list()) {
    if (trial.summary) {
      all.push_back(trial.summary->outcome);
    }
  }
  return all;
}

/// A station without an open run.
class DeviceAtTheStation : public ::testing::Test {
 protected:
  /// Trains for five seconds with a device whose cable can be pulled.
  std::shared_ptr<Wire> trainWired(bool graded) {
    auto wire = std::make_shared<Wire>();
    station.openRun(graded, [wire](const Scene& scene, double target_rad) {
      return std::make_unique<Wired>(wire, practised(scene, target_rad));
    });
    EXPECT_TRUE(testing::eventually([this] { return station.run().busy(); }));
    station.train(5 * kSecond_us);
    return wire;
  }
  TrainingCentre centre;
  Station station{centre};
};

TEST_F(DeviceAtTheStation, ARefusedRunShowsNothingOfThePreviousRun) {
  station.openRun(false, nullptr);
  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
  const std::unique_ptr<Page> kept = std::move(station.page);  // the desk keeps its pages
  auto& run = static_cast<RunPage&>(*kept);
  QTimer::singleShot(0, qApp, [] {
    if (auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
      question->buttons().front()->click();  // end the run
    }
  });
  child<QPushButton>(run, "stop").click();
  ASSERT_FALSE(run.busy());

  station.desk().graded = true;
  station.desk().readiness = torsio::testing::deviceWith(Light::kAmber);
  run.enter({});

  EXPECT_FALSE(station.problems.isEmpty()) << "good enough for practice only";
  const QList<QLabel*> labels = run.findChildren<QLabel*>();
  EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [](const QLabel* label) {
    return label->text() == QStringLiteral("No run in progress");
  }));
  EXPECT_FALSE(child<QPushButton>(run, "stop").isEnabled());
}

TEST_F(DeviceAtTheStation, AGradedRunThatLosesItsDeviceEndsWithoutForceAndCostsNoAttempt) {
  const auto wire = trainWired(true);

  unplug(station, *wire);

  EXPECT_EQ(norm(wire->lastForce_N), 0.0);
  EXPECT_EQ(station.run().runSession(), nullptr);
  EXPECT_FALSE(station.run().busy());
  ASSERT_EQ(station.problems.size(), 1);
  EXPECT_EQ(station.problems[0],
            QStringLiteral("The haptic device was disconnected: the graded run has ended"));
  EXPECT_TRUE(station.allText().contains(QStringLiteral("No run in progress")));
  EXPECT_EQ(outcomes(centre), std::vector<TrialOutcome>{TrialOutcome::kInterrupted});
  EXPECT_FALSE(station.desk().readiness.has_value());  // needs another check
  const NextSteps steps = nextSteps(centre.session(), centre.person());
  EXPECT_EQ(stepOf(steps, centre.module("first")).attempts, 0);
}

TEST_F(DeviceAtTheStation, PracticeThatLosesItsDeviceContinuesWithTheMouse) {
  const auto wire = trainWired(false);

  unplug(station, *wire);

  EXPECT_EQ(norm(wire->lastForce_N), 0.0);
  ASSERT_FALSE(station.notices.empty());
  EXPECT_EQ(station.notices.back(),
            QStringLiteral("The haptic device was disconnected. Continue with mouse and keyboard"));
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
  EXPECT_TRUE(station.run().busy());
  station.train(2 * kSecond_us);
  EXPECT_EQ(child<LiveScene>(station.run(), "scene").controller().mode(),
            SimulationController::Mode::kRecording);
  EXPECT_EQ(outcomes(centre), std::vector<TrialOutcome>{TrialOutcome::kInterrupted});
}

TEST(RunDevice, TheClockWaitsForTheDeviceButTheWindowDoesNot) {
  TrainingCentre centre(
      {.phases = {{.kind = PhaseKind::kVirtual, .label = "virtual 1 min", .duration_us = kMinute_us}},
       .restAllowance_us = 30 * kSecond_us});
  Station station(centre);
  auto gate = std::make_shared<std::binary_semaphore>(0);
  station.openRun(true, [gate](const Scene& scene, double target_rad) {
    gate->acquire();  // a slow driver
    return std::make_unique<ScriptedHand>(practised(scene, target_rad));
  });
  ASSERT_TRUE(testing::eventually([&] { return station.run().fetchesDevice(); }));
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Getting the haptic device ready")));
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Your time has not begun yet")));
  EXPECT_FALSE(station.run().busy());
  station.clock->advance_us(5 * kSecond_us);
  gate->release();
  ASSERT_TRUE(testing::eventually([&] { return station.run().busy(); }));
  EXPECT_EQ(station.find<QLabel>("countdown")->text(), QStringLiteral("1:00"));
  station.train(10 * kSecond_us);

  // After a rest it is reopened, which takes no training time either.
  station.press("rest");
  station.train(5 * kSecond_us);
  station.press("goOn");
  ASSERT_TRUE(station.run().fetchesDevice());
  EXPECT_TRUE(station.allText().contains(QStringLiteral("Your training clock is paused")));
  for (int i = 0; i < 4; ++i) {
    station.clock->advance_us(kSecond_us);
    station.run().tick();
  }
  gate->release();
  station.train(kSecond_us);

  EXPECT_EQ(station.find<QLabel>("countdown")->text(), QStringLiteral("0:49"));
  EXPECT_EQ(child<LiveScene>(station.run(), "scene").controller().mode(),
            SimulationController::Mode::kRecording);
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

TEST_F(DeviceAtTheStation, WaitingForTheDeviceCanBeCancelled) {
  auto gate = std::make_shared<std::binary_semaphore>(0);
  auto given = std::make_shared<std::atomic<int>>(0);
  station.openRun(true, [gate, given](const Scene& scene, double target_rad) {
    gate->acquire();
    ++*given;
    return std::make_unique<ScriptedHand>(practised(scene, target_rad));
  });
  ASSERT_TRUE(testing::eventually([&] { return station.run().fetchesDevice(); }));

  gate->release();  // arrives when nobody waits any more
  station.press("goOn");

  EXPECT_EQ(station.pageId, PageId::kNextStep);
  EXPECT_TRUE(testing::eventually([&] { return given->load() == 1; }));
  EXPECT_TRUE(outcomes(centre).empty());
  EXPECT_TRUE(station.problems.empty()) << station.problems.join('\n').toStdString();
}

TEST_F(DeviceAtTheStation, AGradedRunDoesNotStartWithADeviceThatCannotBeOpened) {
  station.openRun(true, [](const Scene&, double) -> std::unique_ptr<HapticDevice> {
    throw Error(ErrorCode::kDevice, Text::verbatim("the device does not answer"), Text::verbatim("port 1"),
                Text::verbatim("Check its cable"));
  });

  ASSERT_TRUE(testing::eventually([&] { return !station.problems.empty(); }));

  EXPECT_EQ(station.problems[0],
            QStringLiteral("The haptic device is not ready: the graded run did not begin"));
  EXPECT_EQ(station.run().runSession(), nullptr);
  EXPECT_TRUE(outcomes(centre).empty());
  EXPECT_FALSE(station.desk().readiness.has_value());
}

}  // namespace
}  // namespace torsio::gui
