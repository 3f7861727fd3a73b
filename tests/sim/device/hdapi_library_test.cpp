// SPDX-License-Identifier: GPL-3.0-or-later
// Cases L1 to L4 of the haptics plan: looking for the vendor's library.
#include "sim/device/hdapi/hdapi_library.h"

#include <algorithm>
#include <cstdlib>

#include <gtest/gtest.h>

#include "sim/device/hdapi/dynamic_library.h"
#include "sim/device/hdapi/hdapi_device.h"
#include "tests/sim/device/hdapi_bench.h"

namespace torsio {
namespace {

using testing::FakeHd;
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

}  // namespace
}  // namespace torsio
