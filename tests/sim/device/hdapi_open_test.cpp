// SPDX-License-Identifier: GPL-3.0-or-later
// Cases A1 to A7 of the haptics plan: opening a device and believing what it says.
#include <algorithm>
#include <limits>

#include "sim/core/error.h"
#include "tests/sim/device/hdapi_bench.h"

namespace torsio {
namespace {

class HdapiOpen : public testing::HdapiBench {
 protected:
  /// The refusal, or "" when the device opened.
  std::string refusal() {
    try {
      open();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kDevice);
      return error.what();
    }
    return "";
  }
  bool assumed(const std::string& what) {
    const std::vector<Text>& list = device->identity().assumed;
    return std::find(list.begin(), list.end(), what) != list.end();
  }
};

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(HdapiOpen, A1_SaysOnceThatThereIsNoDeviceAndLeavesNoErrorBehind) {
  fake.set_present(0);

  const std::string text = refusal();

  EXPECT_TRUE(mentions(text, "no haptic device could be opened")) << text;
  EXPECT_TRUE(mentions(text, "does not answer")) << text;
  EXPECT_TRUE(mentions(text, "cable")) << text;
  EXPECT_EQ(fake.errors_pending(), 0);
}

TEST_F(HdapiOpen, A2_RejectsAHandleWithoutMeaningThatCameWithoutAnError) {
  for (const std::int64_t handle : {std::int64_t{0xFFFFFFFF}, std::int64_t{70'000}, std::int64_t{1'025}}) {
    fake.set_garbage_handle(handle);
    EXPECT_NE(refusal(), "") << handle;
  }
}

TEST_F(HdapiOpen, A3_AcceptsHandleZero) {
  EXPECT_EQ(refusal(), "");
  EXPECT_EQ(device->identity().model, "Touch");
  EXPECT_EQ(device->identity().serial, "000123");
}

TEST_F(HdapiOpen, A3_RefusesADeviceWhoseForceCannotBeSwitchedOff) {
  fake.set_stuck_force(1);

  EXPECT_TRUE(mentions(refusal(), "force cannot be switched off"));
  EXPECT_EQ(fake.calls("hdDisableDevice"), 1);
}

TEST_F(HdapiOpen, A4_LetsGoOfADeviceThatIsInitiatedAlreadyAndTriesAgain) {
  fake.fault("hdInitDevice", 0, 1, hd::kDeviceAlreadyInitiated, 0);

  EXPECT_EQ(refusal(), "");
  EXPECT_EQ(fake.calls("hdInitDevice"), 2);
  EXPECT_EQ(fake.calls("hdDisableDevice"), 1);
}

TEST_F(HdapiOpen, A4_GivesUpAfterAFewTriesWithAClearMessage) {
  fake.fault("hdInitDevice", 0, -1, hd::kDeviceAlreadyInitiated, 0);

  const std::string text = refusal();

  EXPECT_TRUE(mentions(text, "in use already")) << text;
  EXPECT_TRUE(mentions(text, "Close every other program")) << text;
  EXPECT_LE(fake.calls("hdInitDevice"), 9);  // three names, three tries each
}

TEST_F(HdapiOpen, A5_FallsBackFromAConfiguredNameToTheDefaultDevice) {
  fake.set_only_name("");
  options.deviceName = "Left station";

  EXPECT_EQ(refusal(), "");
  EXPECT_EQ(device->identity().openedAs, "default device");
}

TEST_F(HdapiOpen, A5_PrefersTheConfiguredName) {
  fake.set_only_name("Left station");
  options.deviceName = "Left station";

  EXPECT_EQ(refusal(), "");
  EXPECT_EQ(device->identity().openedAs, "Left station");
}

TEST_F(HdapiOpen, A5_TriesTheCustomaryNamesWhenTheDefaultDeviceDoesNotOpen) {
  for (const char* name : {"Default Device", "Default PHANToM"}) {
    fake.reset();
    fake.set_only_name(name);

    EXPECT_EQ(refusal(), "");
    EXPECT_EQ(device->identity().openedAs, name);
    device.reset();
  }
}

TEST_F(HdapiOpen, A6_SpeaksOfTheLicenceWhenThatIsWhatIsMissing) {
  fake.fault("hdInitDevice", 0, -1, hd::kInvalidLicense, 0);

  const std::string text = refusal();

  EXPECT_TRUE(mentions(text, "no valid licence")) << text;
  EXPECT_TRUE(mentions(text, "OH_SDK_LICENSE_PATH")) << text;
  EXPECT_EQ(fake.calls("hdInitDevice"), 1);
}

TEST_F(HdapiOpen, A7_TakesTheFiguresThatTheDeviceReports) {
  ASSERT_EQ(refusal(), "");

  const DeviceCapabilities& capabilities = device->capabilities();
  EXPECT_EQ(capabilities.maxForce_N, 3.3);
  EXPECT_EQ(capabilities.continuousForce_N, 0.88);
  EXPECT_EQ(capabilities.maxStiffness_N_per_m, 500.0);  // 0.5 N/mm
  EXPECT_TRUE(capabilities.rendersForce);
  EXPECT_TRUE(device->identity().assumed.empty());
  // 160 x 70 x 120 mm: the device's height is the world's z, its depth the world's y; and the stylus around.
  EXPECT_NEAR(capabilities.workspaceMax_m.x, 0.080 + kStylusTip_m, 1e-12);
  EXPECT_NEAR(capabilities.workspaceMax_m.y, 0.035 + kStylusTip_m, 1e-12);
  EXPECT_NEAR(capabilities.workspaceMax_m.z, 0.060 + kStylusTip_m, 1e-12);
}

TEST_F(HdapiOpen, A7_AssumesCautiousLimitsForADeviceThatClaimsSixForceAxes) {
  const double six = 6.0;
  const double strong_N = 30.0;
  fake.set_number(hd::kOutputDof, &six, 1);
  fake.set_number(hd::kNominalMaxForce, &strong_N, 1);

  ASSERT_EQ(refusal(), "");

  EXPECT_EQ(device->capabilities().maxForce_N, 3.3);
  EXPECT_TRUE(assumed("maximum force"));
  EXPECT_TRUE(assumed("three force axes"));
  ASSERT_FALSE(device->identity().notes.empty());
  EXPECT_TRUE(mentions(device->identity().notes[0].str(), "6 axes"));
}

TEST_F(HdapiOpen, A7_AssumesWhatIsReportedAsZeroOrNotANumber) {
  for (const double nonsense : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const std::vector<double> box(6, nonsense);
    fake.set_number(hd::kNominalMaxForce, &nonsense, 1);
    fake.set_number(hd::kNominalMaxContinuousForce, &nonsense, 1);
    fake.set_number(hd::kNominalMaxStiffness, &nonsense, 1);
    fake.set_number(hd::kUsableWorkspaceDimensions, box.data(), 6);

    ASSERT_EQ(refusal(), "");

    EXPECT_EQ(device->capabilities().maxForce_N, 3.3);
    EXPECT_EQ(device->capabilities().continuousForce_N, 0.88);
    EXPECT_EQ(device->capabilities().maxStiffness_N_per_m, 500.0);
    EXPECT_TRUE(assumed("maximum force") && assumed("continuous force") && assumed("stiffness") &&
                assumed("usable workspace"));
    device.reset();
  }
}

}  // namespace
}  // namespace torsio
