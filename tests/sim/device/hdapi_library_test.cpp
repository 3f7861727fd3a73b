// SPDX-License-Identifier: GPL-3.0-or-later
// Cases L1 to L4 of the haptics plan: looking for the vendor's library.
// Cases A1 to A7 of the haptics plan: opening a device and believing what it says.
#include "sim/device/hdapi/hdapi_library.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/device/hdapi/hdapi_device.h"
#include "tests/sim/device/hdapi_bench.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

using testing::HdapiBench;

TEST(HdapiAbi, HasTheVendorsNumbers) {
  // Vendor's headers 3.0.66 and 3.30, identical.
  EXPECT_EQ(hd::kCurrentTransform, 0x2052U);
  EXPECT_EQ(hd::kCurrentForce, 0x2700U);
  EXPECT_EQ(hd::kNominalMaxForce, 0x2603U);
  EXPECT_EQ(hd::kNominalMaxContinuousForce, 0x2604U);
  EXPECT_EQ(hd::kInvalidOperation, 0x0102U);
  EXPECT_EQ(hd::kCommError, 0x0302U);
  EXPECT_EQ(hd::kCallbackDone, 0U);
  EXPECT_EQ(hd::kCallbackContinue, 1U);
  EXPECT_EQ(hd::kMaxPriority, 65535);
  EXPECT_EQ(sizeof(hd::ErrorInfo), 12U);
  EXPECT_EQ(sizeof(hd::ULong), sizeof(long));
}

TEST(HdapiLibrary, L1_SaysWhichNamesWereSearchedWhenNoneIsInstalled) {
  const HdapiLibrary library = loadHdapi("/nowhere/libHD.so");

  EXPECT_EQ(library.status, HdapiLoadStatus::kNotFound);
  EXPECT_EQ(library.searched, std::vector<std::string>{"/nowhere/libHD.so"});
  EXPECT_NE(library.sentence.str().find("/nowhere/libHD.so"), std::string::npos) << library.sentence;
  EXPECT_NE(library.remedy.str().find("Install"), std::string::npos);
}

TEST(HdapiLibrary, L1_TriesTheUsualNamesMostCurrentFirst) {
  const std::vector<std::string> names = hdapiLibraryNames();

  ASSERT_EQ(names.size(), 3U);
  EXPECT_EQ(names[0], "libHD.so");
  EXPECT_EQ(names[1], "libHD.so.3.4");
  EXPECT_EQ(names[2], "libHD.so.3.0");
}

TEST(HdapiLibrary, L1_TakesTheNameFromTheEnvironmentUnlessOneIsGiven) {
  ASSERT_EQ(setenv("TORSIO_HDAPI_LIBRARY", TORSIO_FAKEHD, 1), 0);
  const HdapiLibrary fromEnvironment = loadHdapi("");
  const HdapiLibrary given = loadHdapi("/nowhere/libHD.so");
  unsetenv("TORSIO_HDAPI_LIBRARY");

  EXPECT_EQ(fromEnvironment.status, HdapiLoadStatus::kLoaded);
  EXPECT_EQ(given.status, HdapiLoadStatus::kNotFound);
}

TEST(HdapiLibrary, L2_NamesTheDependencyThatIsMissing) {
  const HdapiLibrary library = loadHdapi(TORSIO_FAKEHD_DEPENDENCY);

  EXPECT_EQ(library.status, HdapiLoadStatus::kDependencyMissing);
  EXPECT_NE(library.sentence.str().find("libncurses_of_another_year.so.5"), std::string::npos)
      << library.sentence;
  EXPECT_NE(library.remedy.str().find("libncurses_of_another_year.so.5"), std::string::npos)
      << library.remedy;
}

TEST(HdapiLibrary, L2_PassesOnWhatTheLoaderSaysOfAFileThatIsNoLibrary) {
  const HdapiLibrary library = loadHdapi(TORSIO_SOURCE_DIR "/README.md");

  EXPECT_EQ(library.status, HdapiLoadStatus::kDependencyMissing);
  EXPECT_NE(library.sentence.str().find("README.md"), std::string::npos) << library.sentence;
}

TEST(HdapiLibrary, L3_RefusesALibraryWithoutAMandatoryFunctionAndNamesIt) {
  const HdapiLibrary library = loadHdapi(TORSIO_FAKEHD_INCOMPLETE);

  EXPECT_EQ(library.status, HdapiLoadStatus::kSymbolMissing);
  EXPECT_EQ(library.missingSymbols, std::vector<std::string>{"hdUnschedule"});
  EXPECT_NE(library.sentence.str().find("hdUnschedule"), std::string::npos) << library.sentence;
}

class HdapiLibraryBench : public HdapiBench {};

TEST_F(HdapiLibraryBench, L3_RunsWithoutTheOptionalFunctions) {
  const LoadedLibrary loaded = loadLibrary(TORSIO_FAKEHD);
  library = resolveHdapi([&loaded](const char* name) -> void* {
    const std::string symbol = name;
    const bool optional = symbol == "hdScheduleSynchronous" || symbol == "hdSetSchedulerRate";
    return optional ? nullptr : librarySymbol(loaded.handle, name);
  });
  ASSERT_EQ(library.status, HdapiLoadStatus::kLoaded);

  start();
  fake.run(10);
  const bool released = device->close();

  EXPECT_EQ(std::count(library.absentOptionals.begin(), library.absentOptionals.end(), "hdSetSchedulerRate"),
            1);
  EXPECT_EQ(loop.ticks, 10);
  EXPECT_TRUE(released);
}

TEST_F(HdapiLibraryBench, L4_OpensASecondSessionInOneProcessWithoutLoadingTwice) {
  for (int session = 0; session < 2; ++session) {
    library = loadHdapi(TORSIO_FAKEHD);
    loop.ticks = 0;
    start();
    fake.run(20);
    EXPECT_EQ(loop.ticks, 20);
    EXPECT_TRUE(device->close());
    device.reset();
  }

  EXPECT_EQ(fake.loads(), 1);
  // No frame stays scheduled. A let-go of the last session may, which a busy machine had no time to run
  // before the scheduler was stopped.
  EXPECT_LE(fake.callbacks(), 1);
  EXPECT_EQ(fake.errors_pending(), 0);
}

class HdapiOpen : public testing::HdapiBench {
 protected:
  /// The refusal, or "" when the device opened.
  std::string refusal() {
    const std::optional<Error> error = testing::errorOf([this] { open(); });
    EXPECT_TRUE(!error || error->code() == ErrorCode::kDevice);
    return error ? error->what() : "";
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
