// SPDX-License-Identifier: GPL-3.0-or-later

#include "assessment/domain/study/protocol_terms.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "assessment/domain/study/curriculum.h"
#include "assessment/domain/study/occasion.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

template <typename Value>
class ProtocolTerms : public ::testing::Test {};
using Terms = ::testing::Types<AttemptMode, PhaseKind, ExposureKind, PersonState, EnrolmentState,
                               CurriculumState, DiscrepancyChoice, ToleranceSource>;
TYPED_TEST_SUITE(ProtocolTerms, Terms);

TYPED_TEST(ProtocolTerms, ConvertToTheirTextAndBack) {
  std::set<std::string> texts;
  for (const Term<TypeParam>& term : termsOf(TypeParam{})) {
    EXPECT_EQ(storedText(term.value), term.stored);
    EXPECT_EQ(fromStoredText<TypeParam>(term.stored), term.value);
    EXPECT_FALSE(term.label.empty());
    EXPECT_FALSE(term.meaning.empty());
    texts.insert(std::string(term.stored));
  }
  EXPECT_EQ(texts.size(), termsOf(TypeParam{}).size());
}

TYPED_TEST(ProtocolTerms, RejectUnknownTexts) {
  for (const char* text : {"", "Practice", "virtual ", "enroled"}) {
    EXPECT_EQ(fromStoredText<TypeParam>(text), std::nullopt) << text;
  }
}

TEST(ProtocolTermsTexts, OfTheFirstReleaseAreFrozen) {
  EXPECT_EQ(storedText(AttemptMode::kPractice), "practice");
  EXPECT_EQ(storedText(AttemptMode::kGraded), "graded");
  EXPECT_EQ(storedText(PhaseKind::kVirtual), "virtual");
  EXPECT_EQ(storedText(PhaseKind::kReal), "real");
  EXPECT_EQ(storedText(ExposureKind::kVirtual), "virtual");
  EXPECT_EQ(storedText(ExposureKind::kReal), "real");
  EXPECT_EQ(storedText(ExposureKind::kRest), "rest");
  EXPECT_EQ(storedText(PersonState::kActive), "active");
  EXPECT_EQ(storedText(PersonState::kLeft), "left");
  EXPECT_EQ(storedText(PersonState::kErased), "erased");
  EXPECT_EQ(storedText(EnrolmentState::kEnrolled), "enrolled");
  EXPECT_EQ(storedText(EnrolmentState::kCompleted), "completed");
  EXPECT_EQ(storedText(EnrolmentState::kWithdrawn), "withdrawn");
  EXPECT_EQ(storedText(CurriculumState::kDraft), "draft");
  EXPECT_EQ(storedText(CurriculumState::kRunning), "running");
  EXPECT_EQ(storedText(CurriculumState::kClosed), "closed");
  EXPECT_EQ(storedText(DiscrepancyChoice::kKeep), "keep");
  EXPECT_EQ(storedText(DiscrepancyChoice::kMove), "move");
  EXPECT_EQ(storedText(DiscrepancyChoice::kThird), "third");
}

}  // namespace

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
