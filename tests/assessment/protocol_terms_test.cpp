// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/study/protocol_terms.h"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "assessment/domain/study/curriculum.h"

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
}  // namespace torsio
