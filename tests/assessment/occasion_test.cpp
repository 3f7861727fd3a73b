// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/study/occasion.h"

#include <gtest/gtest.h>

#include "sim/core/error.h"

namespace torsio {
namespace {

TEST(OccasionNames, ComeFromTheTrainingTimeOrElseTheLabel) {
  const Occasions occasions({{"pre", "before training", 0},
                             {"late", "later", 750'000'000},      // 12.5 x 60e6 us
                             {"mid", "half-way", 1'200'000'000},  // 20 x 60e6 us
                             {"free", "six months later", {}}});

  const std::vector<Text> names = occasionTexts(occasions);

  EXPECT_EQ(names, (std::vector<Text>{Text::verbatim("before"), Text::verbatim("after 12.5 min"),
                                      Text::verbatim("after 20 min"), Text::verbatim("six months later")}));
}

TEST(OccasionNames, AreUniqueAfterEqualTraining) {
  const Occasions occasions({{"post", "after training", 2'400'000'000},
                             {"weeks", "six weeks later", 2'400'000'000},
                             {"months", "six months later", 2'400'000'000}});

  const std::vector<Text> names = occasionTexts(occasions);

  ASSERT_EQ(names.size(), 3U);
  EXPECT_EQ(names[0].str(), "after 40 min");  // 2,400e6 us / 60e6
  EXPECT_EQ(names[1].str(), "after 40 min (six weeks later)");
  EXPECT_EQ(names[2].str(), "after 40 min (six months later)");
}

TEST(OccasionLists, FindByCodeAndKeepTheirOrder) {
  const Occasions two({{"pre", "before", {}}, {"post", "after", {}}});

  EXPECT_EQ(two.positionOf("post"), 1U);
  EXPECT_FALSE(two.positionOf("mid").has_value());
  EXPECT_EQ(two.named("post").label, "after");
  EXPECT_EQ(two.named("mid").label, "mid");  // unknown: labelled with its code
}

TEST(OccasionLists, RejectAnEmptyOrDuplicateCode) {
  EXPECT_THROW(Occasions(std::vector<Occasion>{{"pre", "a", {}}, {"pre", "b", {}}}), Error);
  EXPECT_THROW(Occasions(std::vector<Occasion>{{"", "a", {}}}), Error);
}

}  // namespace
}  // namespace torsio
