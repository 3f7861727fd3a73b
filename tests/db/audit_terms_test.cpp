// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/people/audit_terms.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <gtest/gtest.h>

namespace torsio {
namespace {

template <typename TermValue>
class AuditTerms : public ::testing::Test {};
using Kinds = ::testing::Types<AuditAction, AuditObject>;
TYPED_TEST_SUITE(AuditTerms, Kinds);

TYPED_TEST(AuditTerms, ConvertToTheirTextAndBack) {
  for (const Term<TypeParam>& term : termsOf(TypeParam{})) {
    EXPECT_EQ(storedText(term.value), term.stored);
    EXPECT_EQ(fromStoredText<TypeParam>(term.stored), term.value);
  }
  EXPECT_EQ(fromStoredText<TypeParam>(""), std::nullopt);
  EXPECT_EQ(fromStoredText<TypeParam>("mark.polish"), std::nullopt);
}

TYPED_TEST(AuditTerms, HaveUniqueTextsAndLabels) {
  std::set<std::string_view> texts;
  std::set<std::string_view> labels;
  for (const Term<TypeParam>& term : termsOf(TypeParam{})) {
    EXPECT_TRUE(texts.insert(term.stored).second) << term.stored;
    EXPECT_TRUE(labels.insert(term.label.english()).second) << term.label.english();
    EXPECT_EQ(term.label.english().find_first_of("._"), std::string_view::npos) << term.label.english();
  }
}

TYPED_TEST(AuditTerms, AreIncompleteWithoutOneOfThem) {
  constexpr auto& kWhole = termsOf(TypeParam{});
  std::array<Term<TypeParam>, kWhole.size() - 1> tooShort{};
  std::copy(kWhole.begin(), kWhole.end() - 1, tooShort.begin());
  std::array<Term<TypeParam>, kWhole.size()> swapped = kWhole;
  std::swap(swapped[0], swapped[1]);

  EXPECT_TRUE(isWholeTable(kWhole, TypeParam::kEnd));
  EXPECT_FALSE(isWholeTable(tooShort, TypeParam::kEnd));
  EXPECT_FALSE(isWholeTable(swapped, TypeParam::kEnd));
}

// Frozen: records of the first release contain them.
TEST(AuditTermTexts, OfTheFirstReleaseAreFrozen) {
  EXPECT_EQ(storedText(AuditAction::kMarkSubmit), "mark.submit");
  EXPECT_EQ(storedText(AuditAction::kUserSignInFailed), "user.sign_in_failed");
  EXPECT_EQ(storedText(AuditAction::kRetentionExtend), "retention.extend");
  EXPECT_EQ(storedText(AuditAction::kDiscrepancyAdjudicator), "alignment.third");
  EXPECT_EQ(storedText(AuditAction::kCurriculumClosed), "curriculum.closed");
  EXPECT_EQ(storedText(AuditAction::kDatabaseRestore), "database.restore");
  EXPECT_EQ(storedText(AuditAction::kDemonstrationRemove), "demonstration.remove");
  EXPECT_EQ(storedText(AuditObject::kTrainingMark), "training_mark");
  EXPECT_EQ(storedText(AuditObject::kEvaluationMark), "evaluation_mark");
  EXPECT_EQ(storedText(AuditObject::kTrial), "trial");
}

TEST(AuditLabels, DescribeActionAndObject) {
  EXPECT_EQ(labelOfStored<AuditAction>("mark.submit").str(), "Mark submitted");
  EXPECT_EQ(labelOfStored<AuditObject>("training_mark").str(), "mark");
}

TEST(AuditLabels, KeepCodesOfOtherVersions) {
  EXPECT_EQ(labelOfStored<AuditAction>("mark.polish").str(), "mark.polish");
  EXPECT_EQ(labelOfStored<AuditObject>("polish").str(), "polish");
}

}  // namespace
}  // namespace torsio
