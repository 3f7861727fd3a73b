// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/base/text.h"

#include <sstream>

#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace torsio {
namespace {

TEST(Text, PutsItsArgumentsInTheirPlaces) {
  const Text text("row %2 of %1 has %3 values", std::string("roster.csv"), 7, "no");

  EXPECT_EQ(text.str(), "row 7 of roster.csv has no values");
  EXPECT_EQ(text.pattern(), "row %2 of %1 has %3 values");
}

TEST(Text, TakesTextsAsArguments) {
  const Text place("module %1", "V2");
  const Text text("%1, mastery %2", place, "peak_force");

  EXPECT_EQ(text.str(), "module V2, mastery peak_force");
  EXPECT_EQ(text.arguments().front().pattern(), "module %1");
}

TEST(Text, NeverReadsAnArgumentAsAPattern) {
  EXPECT_EQ(Text("%1 and %2", "100 %2", "b").str(), "100 %2 and b");
}

TEST(Text, LeavesAPlainSentenceAlone) {
  const Text text = "only 40 % of %1";

  EXPECT_EQ(text.str(), "only 40 % of %1");
  EXPECT_TRUE(Text().empty());
}

TEST(Text, IsEqualToWhatSaysTheSame) {
  EXPECT_EQ(Text("trial %1", 4), Text("trial 4"));
  EXPECT_FALSE(Text("trial %1", 4) == Text("trial %1", 5));
  std::ostringstream out;
  out << Text("trial %1", 4);
  EXPECT_EQ(out.str(), "trial 4");
}

TEST(Error, SpeaksEnglishOnItsOwnAndKeepsItsPatterns) {
  const Error error(ErrorCode::kBadData, Text("row %1 is not answered", "C2"), Text("case %1", "7F"),
                    "Fill it in");

  EXPECT_STREQ(error.what(), "case 7F: row C2 is not answered. Fill it in");
  EXPECT_EQ(error.happened(), "row C2 is not answered");
  EXPECT_EQ(error.happenedText().pattern(), "row %1 is not answered");
  EXPECT_EQ(error.whereText().arguments().front().str(), "7F");
}

}  // namespace
}  // namespace torsio
