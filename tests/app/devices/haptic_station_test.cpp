// SPDX-License-Identifier: GPL-3.0-or-later
// A trainee's station with the fake vendor library in place of a Touch.
#include "app/devices/haptic_station.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "app/base/assets.h"
#include "sim/base/error.h"
#include "sim/servo/hand_task.h"

namespace torsio {
namespace {

const DeviceChoice kFake{.library = TORSIO_FAKEHD, .name = ""};
Scene arm() {
  SceneRequest request;
  request.assets = assetsFolder();
  request.id = "forearm";
  return loadScene(request);
}

const DeviceChoice kNone{.library = "/nowhere/libHD.so", .name = ""};

const ReadinessFinding* find(const DeviceReadiness& readiness, const std::string& code) {
  for (const ReadinessFinding& finding : readiness.findings) {
    if (finding.code == code) {
      return &finding;
    }
  }
  return nullptr;
}

/// The library is loaded by the device process of this build.
class HapticStation : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { setenv("TORSIO_DEVICE_PROGRAM", TORSIO_DEVICE_PROGRAM, 1); }
};

TEST_F(HapticStation, KnowsWhetherTheVendorLibraryIsThere) {
  EXPECT_TRUE(hapticLibraryInstalled(kFake));
  EXPECT_FALSE(hapticLibraryInstalled(kNone));
}

TEST_F(HapticStation, IsRedWithoutALibraryAndSaysWhatToDo) {
  const DeviceReadiness readiness = hapticProbe(kNone)();

  EXPECT_EQ(readiness.light(), Light::kRed);
  ASSERT_NE(find(readiness, "connected"), nullptr);
  EXPECT_FALSE(find(readiness, "connected")->remedy.empty());
}

TEST_F(HapticStation, TheWorstFindingOfASubjectIsItsLight) {
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

TEST_F(HapticStation, OpensTheDeviceWithItsWorkspaceAboutTheGrasp) {
  const Scene scene = arm();

  const std::unique_ptr<HapticDevice> device = openHapticDevice(scene, kFake);

  ASSERT_NE(device, nullptr);
  EXPECT_TRUE(device->capabilities().rendersForce);
  const Vec3 grasp_m = handTask(scene).graspPoint_m;
  const Vec3 middle_m = (device->capabilities().workspaceMin_m + device->capabilities().workspaceMax_m) * 0.5;
  constexpr double kSameBox_m = 0.1;  // the usable box is not symmetric about the vendor's origin
  EXPECT_LT(norm(middle_m - grasp_m), kSameBox_m);
}

TEST_F(HapticStation, SaysWhatIsMissingWhenNoDeviceCanBeOpened) {
  const Scene scene = arm();

  EXPECT_THROW(static_cast<void>(openHapticDevice(scene, kNone)), Error);
}

}  // namespace
}  // namespace torsio
