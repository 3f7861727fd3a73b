// SPDX-License-Identifier: GPL-3.0-or-later
// A trainee's station with the fake vendor library instead of a Touch.
#include "app/services/devices/haptic_station.h"

#include <SDL.h>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/base/assets.h"
#include "app/services/devices/device_monitor.h"
#include "app/services/devices/device_readiness.h"
#include "sim/core/error.h"
#include "sim/servo/hand_task.h"

namespace torsio {
namespace {

const DeviceChoice kFake{.library = TORSIO_FAKEHD};
Scene arm() {
  SceneRequest request;
  request.assets = assetsFolder();
  request.id = "forearm";
  return loadScene(request);
}

const DeviceChoice kNone{.library = "/nowhere/libHD.so"};

const ReadinessFinding* find(const DeviceReadiness& readiness, const std::string& code) {
  for (const ReadinessFinding& finding : readiness.findings) {
    if (finding.code == code) {
      return &finding;
    }
  }
  return nullptr;
}

/// The device process of this build loads the library.
class HapticStation : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    setenv("TORSIO_DEVICE_PROGRAM", TORSIO_DEVICE_PROGRAM, 1);
    // Keep the test's settings apart from those of the machine's user.
    settings() = ::testing::TempDir() + "torsio_station_" + std::to_string(getpid());
    setenv("XDG_CONFIG_HOME", settings().c_str(), 1);
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(settings()); }
  static std::string& settings() {
    static std::string folder;
    return folder;
  }
};

TEST_F(HapticStation, KnowsWhetherTheVendorLibraryIsInstalled) {
  EXPECT_TRUE(deviceInstalled(kFake));
  EXPECT_FALSE(deviceInstalled(kNone));
}

TEST_F(HapticStation, RemembersTheChosenDevice) {
  rememberDevice({.driver = "hdapi", .name = "left"});

  const DeviceChoice kept = rememberedDevice();

  EXPECT_EQ(kept.driver, "hdapi");
  EXPECT_EQ(kept.name, "left");
  EXPECT_EQ(stationChoice().driver, "hdapi");
  EXPECT_EQ(stationChoice().name, "left");
  rememberDevice({});
  EXPECT_EQ(rememberedDevice().driver, "");
}

TEST_F(HapticStation, RejectsADeviceOfNoDriver) {
  EXPECT_THROW(rememberDevice({.driver = "scripted"}), Error);
  EXPECT_THROW(rememberDevice({.driver = "glove"}), Error);
}

TEST_F(HapticStation, ADeviceWithoutForceIsForPracticeOnlyUnlessTheCentreGradesIt) {
  DeviceReadiness checked;
  checked.findings.push_back({"connected", Light::kGreen, Text::verbatim("found"), ""});

  const DeviceReadiness practice = judgedByForce(checked, false);
  const DeviceReadiness graded = judgedByForce(checked, true);
  checked.haptic = true;
  const DeviceReadiness felt = judgedByForce(checked, false);

  EXPECT_EQ(practice.light(), Light::kAmber);
  EXPECT_EQ(graded.light(), Light::kGreen);
  EXPECT_EQ(felt.light(), Light::kGreen);
  EXPECT_EQ(find(felt, "force"), nullptr);
}

TEST_F(HapticStation, IsRedWithoutALibraryAndExplainsTheRemedy) {
  const DeviceReadiness readiness = hapticProbe(kNone)();

  EXPECT_EQ(readiness.light(), Light::kRed);
  ASSERT_NE(find(readiness, "connected"), nullptr);
  EXPECT_FALSE(find(readiness, "connected")->remedy.empty());
}

TEST_F(HapticStation, TheWorstFindingOfASubjectSetsItsLight) {
  DeviceCheckResult check;
  check.findings = {
      {"Library", FindingGrade::kGood, Text::verbatim("found"), ""},
      {"Device", FindingGrade::kNote, Text::verbatim("a value is assumed"), Text::verbatim("none")},
      {"Rate", FindingGrade::kGood, Text::verbatim("1000 Hz"), ""},
      {"Jitter", FindingGrade::kBad, Text::verbatim("uneven"), Text::verbatim("close other programs")}};

  const DeviceReadiness readiness = hapticReadiness(check);

  ASSERT_EQ(readiness.findings.size(), 2U);
  EXPECT_EQ(find(readiness, "connected")->light, Light::kAmber);
  EXPECT_EQ(find(readiness, "rate")->light, Light::kRed);
  EXPECT_EQ(find(readiness, "rate")->remedy, "close other programs");
}

TEST_F(HapticStation, OpensTheDeviceWithItsWorkspaceCentredOnTheGrasp) {
  const Scene scene = arm();

  const std::unique_ptr<HapticDevice> device = openHapticDevice(scene, kFake);

  ASSERT_NE(device, nullptr);
  EXPECT_TRUE(device->capabilities().rendersForce);
  const Vec3 grasp_m = handTask(scene).graspPoint_m;
  const Vec3 middle_m = (device->capabilities().workspaceMin_m + device->capabilities().workspaceMax_m) * 0.5;
  constexpr double kSameBox_m = 0.1;  // the usable box is not symmetric about the vendor's origin
  EXPECT_LT(norm(middle_m - grasp_m), kSameBox_m);
}

/// A virtual game controller of SDL, connected in this process.
class ControllerStation : public HapticStation {
 protected:
  static constexpr const char* kName = "Torsio station controller";
  const DeviceChoice choice_{.driver = "controller", .name = kName};
  SDL_Joystick* joystick_ = nullptr;

  void SetUp() override {
    ASSERT_EQ(SDL_InitSubSystem(SDL_INIT_GAMECONTROLLER), 0) << SDL_GetError();
    SDL_VirtualJoystickDesc plugged{};
    plugged.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
    plugged.type = SDL_JOYSTICK_TYPE_GAMECONTROLLER;
    plugged.naxes = SDL_CONTROLLER_AXIS_MAX;
    plugged.nbuttons = SDL_CONTROLLER_BUTTON_MAX;
    plugged.name = kName;
    joystick_ = SDL_JoystickOpen(SDL_JoystickAttachVirtualEx(&plugged));
    ASSERT_NE(joystick_, nullptr) << SDL_GetError();
  }
  void TearDown() override {
    SDL_JoystickClose(joystick_);
    SDL_QuitSubSystem(SDL_INIT_GAMECONTROLLER);
  }
};

TEST_F(ControllerStation, ItsCheckFindsAWorkingDeviceWithoutForce) {
  DeviceCheckRequest request;
  request.choice = choice_;
  request.seconds = 0.7;  // the rate is known after half a second
  request.forceTest = true;

  const DeviceCheckResult check = checkDevice(request);
  const DeviceReadiness readiness = hapticReadiness(check);

  EXPECT_TRUE(check.usable()) << (check.usable() ? "" : check.worst()->sentence.str());
  EXPECT_EQ(readiness.device.str(), kName);
  EXPECT_FALSE(readiness.haptic);
  EXPECT_EQ(readiness.light(), Light::kAmber);
  ASSERT_NE(find(readiness, "force"), nullptr);
  EXPECT_NE(find(readiness, "force")->detail.str().find("not felt"), std::string::npos);
  EXPECT_EQ(find(readiness, "docked"), nullptr) << "there is nothing to dock";
  EXPECT_NE(check.findings.front().sentence.str().find("not confirmed on hardware"), std::string::npos);
  const DeviceReadiness graded = judgedByForce(readiness, true);
  EXPECT_EQ(graded.light(), find(graded, "rate")->light)
      << "nothing but the rate of this machine may be short";
}

TEST_F(ControllerStation, ItCanBeMonitoredAndOpenedForAScene) {
  const Scene scene = arm();
  std::vector<DeviceReadout> seen;
  DeviceMonitorRequest request;
  request.choice = choice_;
  request.seconds = 0.3;
  request.interval_s = 0.1;
  request.show = [&](const DeviceReadout& readout) { seen.push_back(readout); };

  monitorDevice(request);
  const std::unique_ptr<HapticDevice> device = openHapticDevice(scene, choice_);

  ASSERT_FALSE(seen.empty());
  EXPECT_EQ(seen.back().state, "ready, force off");
  ASSERT_NE(device, nullptr);
  const Vec3 middle_m = (device->capabilities().workspaceMin_m + device->capabilities().workspaceMax_m) * 0.5;
  EXPECT_NEAR(norm(middle_m - handTask(scene).graspPoint_m), 0.0, 1e-12);
}

TEST_F(HapticStation, ReportsWhatIsMissingIfNoDeviceCanBeOpened) {
  const Scene scene = arm();

  EXPECT_THROW(static_cast<void>(openHapticDevice(scene, kNone)), Error);
}

// Texts about the servo's timing.

TEST(ServoWords, NothingIsReportedForARunWithGoodTimingWhateverTheSystemDenied) {
  EXPECT_TRUE(servoTrouble({true, true, 0, 0}, 60'000).empty());
  EXPECT_TRUE(servoTrouble({false, false, 0, 0}, 60'000).empty());
  EXPECT_TRUE(servoTrouble({true, true, 60, 0}, 60'000).empty()) << "one in a thousand";
}

TEST(ServoWords, ForceCutsOrManySkippedTicksAreReportedWithWhatTheSystemDenied) {
  const Text cut = servoTrouble({true, true, 0, 1}, 60'000);
  const Text skipped = servoTrouble({false, true, 61, 0}, 60'000);

  EXPECT_NE(cut.str().find("cut 1 time, 0 of 60000 ticks"), std::string::npos) << cut.str();
  EXPECT_NE(skipped.str().find("cut 0 times, 61 of 60061 ticks"), std::string::npos) << skipped.str();
  EXPECT_EQ(cut.str().find("refuses"), std::string::npos);
  EXPECT_NE(skipped.str().find("; the system refuses real-time priority"), std::string::npos);
}

TEST(ServoWords, TheRemedyIsTheLimitsFileUntilTheSystemGrantsEverything) {
  EXPECT_NE(servoRemedy({false, true, 0, 9}).str().find("torsio-limits.conf"), std::string::npos);
  EXPECT_NE(servoRemedy({true, false, 0, 9}).str().find("torsio-limits.conf"), std::string::npos);
  EXPECT_NE(servoRemedy({true, true, 0, 9}).str().find("Close other programs"), std::string::npos);
}

TEST(ServoWords, EachDeniedPrivilegeHasItsOwnSentence) {
  EXPECT_TRUE(refusedToServo(true, true).empty());
  EXPECT_EQ(refusedToServo(true, false).str(), "the system refuses to keep the servo in memory");
  EXPECT_EQ(refusedToServo(false, true).str(), "the system refuses real-time priority");
  EXPECT_EQ(refusedToServo(false, false).str(),
            "the system refuses real-time priority and to keep the servo in memory");
}

}  // namespace
}  // namespace torsio
