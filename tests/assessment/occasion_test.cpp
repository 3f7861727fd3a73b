// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/study/occasion.h"

#include <gtest/gtest.h>

#include "sim/base/error.h"

namespace torsio {
namespace {

TEST(OccasionNames, FollowTheTimeOfTrainingOrElseTheLabel) {
  EXPECT_EQ(occasionText({"pre", "before training", 0}).str(), "before");
  EXPECT_EQ(occasionText({"mid", "half-way", 1'200'000'000}).str(), "after 20 min");  // 20 x 60e6 us
  EXPECT_EQ(occasionText({"late", "later", 750'000'000}).str(), "after 12.5 min");    // 12.5 x 60e6 us
  EXPECT_EQ(occasionText({"late", "six months later", {}}).str(), "six months later");
}

TEST(OccasionLists, FindByCodeAndKeepTheirOrder) {
  const Occasions two({{"pre", "before", {}}, {"post", "after", {}}});

  EXPECT_EQ(two.positionOf("post"), 1U);
  EXPECT_FALSE(two.positionOf("mid").has_value());
  EXPECT_EQ(two.named("post").label, "after");
  EXPECT_EQ(two.named("mid").label, "mid");  // unknown: called by its code
}

TEST(OccasionLists, RefuseACodeThatIsEmptyOrStandsTwice) {
  EXPECT_THROW(Occasions(std::vector<Occasion>{{"pre", "a", {}}, {"pre", "b", {}}}), Error);
  EXPECT_THROW(Occasions(std::vector<Occasion>{{"", "a", {}}}), Error);
}

}  // namespace
}  // namespace torsio
