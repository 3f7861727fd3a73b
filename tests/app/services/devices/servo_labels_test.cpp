// SPDX-License-Identifier: GPL-3.0-or-later
// Texts about the servo's timing.
#include <gtest/gtest.h>

#include "app/services/devices/device_readiness.h"

namespace torsio {
namespace {

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
