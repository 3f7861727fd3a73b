// SPDX-License-Identifier: GPL-3.0-or-later
// Free practice with the haptic device: found, missing, and lost during use.
#include <atomic>
#include <memory>

#include <gtest/gtest.h>

#include "app/gui/simulator/simulation_controller.h"
#include "app/services/devices/haptic_station.h"
#include "sim/core/error.h"
#include "sim/record/trial.h"
#include "tests/app/gui/support/bar_view.h"
#include "tests/support/fakehd/fakehd_control.h"

namespace torsio::gui {
namespace {

using testing::eventually;
using testing::loadBar;
using testing::requestFor;
using torsio::testing::FakeHd;
using Mode = SimulationController::Mode;

/// External events of a stylus.
struct Hand {
  std::atomic<bool> unplugged{false};
  std::atomic<int> opened{0};
  std::atomic<int> closed{0};
  bool rendersForce = true;
  Vec3 lastForce_N;
};

/// A device held still in front of the bar until it is unplugged.
class Stylus final : public HapticDevice {
 public:
  explicit Stylus(std::shared_ptr<Hand> hand) : hand_(std::move(hand)) {
    capabilities_.model = "Test stylus";
    capabilities_.rendersForce = hand_->rendersForce;
    ++hand_->opened;
  }
  ~Stylus() override { ++hand_->closed; }
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override {
    DeviceReading reading;
    reading.time_us = time_us;
    reading.pose.position_m = {0.0, -0.05, 0.0};
    if (hand_->unplugged) {
      reading.status = kDeviceLost;
    }
    last_ = quantize(reading, last_);
    return last_;
  }
  void write(const ForceCommand& command) noexcept override { hand_->lastForce_N = command.force_N; }

 private:
  std::shared_ptr<Hand> hand_;
  DeviceCapabilities capabilities_;
  DeviceSample last_;
};

class HapticPractice : public ::testing::Test {
 protected:
  std::shared_ptr<Hand> hand_ = std::make_shared<Hand>();
  std::shared_ptr<MemoryTrialSink> kept_ = std::make_shared<MemoryTrialSink>();
  SimulationController controller_{loadBar, recording()};
  QString said_;

  TrialRecording recording() {
    struct Sink final : TrialSink {
      explicit Sink(std::shared_ptr<MemoryTrialSink> where) : to(std::move(where)) {}
      void begin(const TrialHeader& header) override { to->begin(header); }
      void append(const TrialChunk& chunk) override { to->append(chunk); }
      void finish(const TrialSummary& summary) override { to->finish(summary); }
      std::shared_ptr<MemoryTrialSink> to;
    };
    TrialRecording keep;
    keep.open = [this](const RecordingSpec&) { return std::make_unique<Sink>(kept_); };
    return keep;
  }
  HapticOpener opener() {
    return [hand = hand_](const Scene&) { return std::make_unique<Stylus>(hand); };
  }
  void SetUp() override {
    controller_.setRealTime(false);
    QObject::connect(&controller_, &SimulationController::noticed, &controller_,
                     [this](const QString& sentence) { said_ = sentence; });
  }
  void load(const char* id) {
    controller_.load(requestFor(id));
    ASSERT_TRUE(eventually([this] { return !controller_.loading(); }));
  }
  void practiseWithStylus() {
    controller_.useHapticDevice(opener());
    load("bar");
    ASSERT_TRUE(eventually([this] { return !controller_.hapticModel().isEmpty(); }));
  }
  void tick(int ticks) { controller_.run()->step(ticks); }
};

TEST_F(HapticPractice, UsesTheDeviceOnceItIsOpen) {
  practiseWithStylus();
  tick(2);

  EXPECT_EQ(controller_.hapticModel(), QStringLiteral("Test stylus"));
  EXPECT_NEAR(controller_.state().tool.position_m.y, -0.05, 1e-6);  // position of the stylus, not the mouse
  EXPECT_FALSE(controller_.toolRidesOnTissue());                    // carried round, as in a run
  EXPECT_TRUE(said_.contains(QStringLiteral("Test stylus")));
  EXPECT_EQ(controller_.mode(), Mode::kPractice);
}

TEST_F(HapticPractice, ShowsWhetherTheDeviceRendersForce) {
  practiseWithStylus();
  const QString felt = said_;
  controller_.useHapticDevice({});
  hand_->rendersForce = false;
  controller_.useHapticDevice(opener());
  ASSERT_TRUE(eventually([this] { return !controller_.hapticModel().isEmpty(); }));

  EXPECT_TRUE(felt.contains(QStringLiteral("The force is felt")));
  EXPECT_TRUE(said_.contains(QStringLiteral("shown, not felt")));
}

TEST_F(HapticPractice, ContinuesWithTheMouseWithoutADeviceAndSaysSo) {
  controller_.useHapticDevice([](const Scene&) -> std::unique_ptr<HapticDevice> {
    throw Error(ErrorCode::kDevice, Text::verbatim("no device answers"), "", Text::verbatim("Plug it in"));
  });
  load("bar");
  ASSERT_TRUE(eventually([this] { return !said_.isEmpty(); }));

  EXPECT_TRUE(said_.contains(QStringLiteral("mouse and keyboard")));
  EXPECT_TRUE(said_.contains(QStringLiteral("No device answers. Plug it in")));
  EXPECT_TRUE(controller_.hapticModel().isEmpty());
  tick(2);
  EXPECT_TRUE(controller_.toolRidesOnTissue());
}

TEST_F(HapticPractice, ContinuesWithTheMouseWhenTheDeviceIsLost) {
  practiseWithStylus();
  tick(10);
  hand_->unplugged = true;
  tick(1);

  controller_.advance(0.016);

  EXPECT_TRUE(said_.contains(QStringLiteral("disconnected")));
  EXPECT_TRUE(controller_.hapticModel().isEmpty());
  EXPECT_EQ(controller_.mode(), Mode::kPractice);
  EXPECT_EQ(hand_->lastForce_N, Vec3{});
  EXPECT_TRUE(eventually([this] { return hand_->closed == 1; }));
  tick(5);
  EXPECT_EQ(controller_.state().tick, 4);  // the pointer's exercise runs
  EXPECT_TRUE(controller_.toolRidesOnTissue());
}

TEST_F(HapticPractice, ARecordingKeepsWhatCameBeforeTheLoss) {
  practiseWithStylus();
  controller_.startRecording();
  tick(700);
  hand_->unplugged = true;
  tick(1);

  controller_.advance(0.016);

  EXPECT_EQ(controller_.mode(), Mode::kPractice);
  EXPECT_EQ(kept_->trial().summary.outcome, TrialOutcome::kInterrupted);
  EXPECT_EQ(kept_->trial().summary.samples, 701);
  EXPECT_EQ(kept_->trial().header.drive, TwistDrive::kTangential);
  EXPECT_EQ(kept_->trial().header.deviceModel, "Test stylus");
}

TEST_F(HapticPractice, KeepsTheDeviceOpenBetweenTriesAndReopensItForAnotherScene) {
  practiseWithStylus();
  controller_.startRecording();
  tick(10);
  controller_.stopRecording();
  tick(10);
  EXPECT_EQ(hand_->opened, 1);
  EXPECT_NEAR(controller_.state().tool.position_m.y, -0.05, 1e-6);

  load("other");

  EXPECT_TRUE(eventually([this] { return hand_->opened == 2 && hand_->closed == 1; }));
}

TEST_F(HapticPractice, ReleasesTheDeviceImmediatelyForARun) {
  practiseWithStylus();

  controller_.useHapticDevice({});

  EXPECT_EQ(hand_->closed, 1);
  EXPECT_TRUE(controller_.hapticModel().isEmpty());
  EXPECT_EQ(controller_.mode(), Mode::kPractice);
}

TEST_F(HapticPractice, ATrainingRunReportsOnceThatItsDeviceIsLost) {
  load("bar");
  int lost = 0;
  QObject::connect(&controller_, &SimulationController::deviceLost, &controller_, [&lost] { ++lost; });
  const RecordingSpec run{.trialId = "run"};
  ASSERT_TRUE(controller_.startTraining(run, recording().open(run), std::make_unique<Stylus>(hand_)));
  tick(5);
  hand_->unplugged = true;
  tick(1);

  controller_.advance(0.016);
  controller_.advance(0.016);

  EXPECT_EQ(lost, 1);
  EXPECT_EQ(controller_.mode(), Mode::kRecording);  // its owner decides
  static_cast<void>(controller_.endTraining(TrialOutcome::kInterrupted));
}

TEST_F(HapticPractice, TheVendorsLibraryIsOpenedAndItsLossDetected) {
  FakeHd fake(TORSIO_FAKEHD);
  fake.reset();
  controller_.useHapticDevice([](const Scene& scene) {
    return openHapticDevice(scene, {.library = TORSIO_FAKEHD, .inThisProcess = true});
  });
  load("bar");
  ASSERT_TRUE(eventually([this] { return !controller_.hapticModel().isEmpty(); })) << said_.toStdString();
  tick(10);
  fake.unplug();

  tick(600);  // more than kReadingLost_us without a reading
  controller_.advance(0.016);

  EXPECT_TRUE(said_.contains(QStringLiteral("disconnected")));
  EXPECT_TRUE(controller_.hapticModel().isEmpty());
}

}  // namespace
}  // namespace torsio::gui
