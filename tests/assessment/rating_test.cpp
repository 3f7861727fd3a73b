// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include <gtest/gtest.h>

#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/sheet_check.h"

namespace torsio {
namespace {

constexpr ScoreScale kOneToTen{10, 100, 10};  // 1 to 10 points in tenths
constexpr ScoreScale kNoneToFour{0, 4, 1};    // 0 to 4 points, whole ones

/// Three rows on the scale 1 to 10 and an overall mark, all in steps.
std::vector<SheetLine> linesOf(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t overall) {
  return {{"a", kOneToTen, {a, {}}},
          {"b", kOneToTen, {b, {}}},
          {"c", kOneToTen, {c, {}}},
          {kOverallRow, kOneToTen, {overall, {}}}};
}

TEST(SheetStates, FollowFromThreeFactsAndWithdrawalTakesPrecedence) {
  EXPECT_EQ(sheetStateOf(false, false, false), SheetState::kOpen);
  EXPECT_EQ(sheetStateOf(false, false, true), SheetState::kDraft);
  EXPECT_EQ(sheetStateOf(false, true, false), SheetState::kSubmitted);
  EXPECT_EQ(sheetStateOf(false, true, true), SheetState::kSubmitted);
  EXPECT_EQ(sheetStateOf(true, true, true), SheetState::kWithdrawn);
  EXPECT_TRUE(isOutstanding(SheetState::kOpen));
  EXPECT_TRUE(isOutstanding(SheetState::kDraft));
  EXPECT_FALSE(isOutstanding(SheetState::kSubmitted));
  EXPECT_FALSE(isOutstanding(SheetState::kWithdrawn));
}

TEST(SheetAnswers, NeedEitherAScoreOnTheScaleOrAReason) {
  EXPECT_EQ(faultOf({}, kOneToTen), AnswerFault::kMissing);
  EXPECT_EQ(faultOf({std::nullopt, "hidden by the hand"}, kOneToTen), AnswerFault::kNone);
  EXPECT_EQ(faultOf({70, "hidden by the hand"}, kOneToTen), AnswerFault::kContradicts);
  EXPECT_EQ(faultOf({9, {}}, kOneToTen), AnswerFault::kOutsideScale);  // 0.9 points
  EXPECT_EQ(faultOf({10, {}}, kOneToTen), AnswerFault::kNone);         // the ends are included
  EXPECT_EQ(faultOf({100, {}}, kOneToTen), AnswerFault::kNone);
  EXPECT_EQ(faultOf({101, {}}, kOneToTen), AnswerFault::kOutsideScale);  // 10.1 points
}

TEST(SheetChecks, ListUnansweredRowsInTheOrderOfTheSheet) {
  std::vector<SheetLine> lines = linesOf(50, 60, 70, 60);
  lines[2].answer = {};
  lines[3].answer = {};

  const SheetCheck check = checkSheetLines(lines, std::nullopt, {});

  EXPECT_EQ(check.unanswered, (std::vector<std::string>{"c", kOverallRow}));
  EXPECT_FALSE(check.mayBeSubmitted());
  EXPECT_FALSE(check.allTheSame);  // two scores form no pattern
}

TEST(SheetChecks, AMarkOffItsScaleIsNoAnswer) {
  std::vector<SheetLine> lines = linesOf(50, 60, 999, 60);
  const SheetCheck check = checkSheetLines(lines, std::nullopt, {});
  EXPECT_EQ(check.unanswered, (std::vector<std::string>{"c"}));
  EXPECT_FALSE(check.mayBeSubmitted());
}

TEST(SheetChecks, FlagTheSameScoreEverywhereEvenOnTwoScales) {
  std::vector<SheetLine> lines = linesOf(55, 55, 55, 55);
  lines[1] = {"b", kNoneToFour, {2, {}}};  // 2 of 0..4 is a half; so is (55 - 10) / (100 - 10)

  const SheetCheck same = checkSheetLines(lines, std::nullopt, {});
  lines[1].answer.score_steps = 3;
  const SheetCheck different = checkSheetLines(lines, std::nullopt, {});

  EXPECT_TRUE(same.allTheSame);
  EXPECT_TRUE(same.mayBeSubmitted());  // slips are only advice
  EXPECT_FALSE(different.allTheSame);
}

TEST(SheetChecks, FlagRowsThatSpanSevenTenthsOfTheScale) {
  // 70 % of a scale of 90 steps is 63: 10 and 73 are far apart, 10 and 72 are not.
  EXPECT_TRUE(checkSheetLines(linesOf(10, 40, 73, 40), std::nullopt, {}).farApart);
  EXPECT_FALSE(checkSheetLines(linesOf(10, 40, 72, 40), std::nullopt, {}).farApart);
}

TEST(SheetChecks, FlagAnOverallMarkOutsideTheRows) {
  EXPECT_TRUE(checkSheetLines(linesOf(50, 60, 70, 71), std::nullopt, {}).overallOutside);
  EXPECT_TRUE(checkSheetLines(linesOf(50, 60, 70, 49), std::nullopt, {}).overallOutside);
  EXPECT_FALSE(checkSheetLines(linesOf(50, 60, 70, 70), std::nullopt, {}).overallOutside);
}

TEST(SheetChecks, RequireTheRecordingToBeWatchedAtAnAllowedSpeed) {
  const std::vector<SheetLine> lines = linesOf(50, 60, 70, 60);
  const ViewingRules rules{0.8, {0.5, 1.5}};

  const SheetCheck enough = checkSheetLines(lines, RecordingWatched{0.8, 0.5, 1.5}, rules);
  const SheetCheck tooLittle = checkSheetLines(lines, RecordingWatched{0.79, 1.0, 1.0}, rules);
  const SheetCheck tooFast = checkSheetLines(lines, RecordingWatched{1.0, 1.0, 2.0}, rules);
  const SheetCheck tooSlow = checkSheetLines(lines, RecordingWatched{1.0, 0.498, 1.0}, rules);
  const SheetCheck natural = checkSheetLines(lines, RecordingWatched{1.0, 1.0, 1.0}, {0.8, {2.0}});

  EXPECT_TRUE(enough.mayBeSubmitted());
  EXPECT_TRUE(tooLittle.watchedTooLittle);
  EXPECT_DOUBLE_EQ(tooLittle.watchedShare, 0.79);
  EXPECT_TRUE(tooFast.speedNotAllowed);
  EXPECT_TRUE(tooSlow.speedNotAllowed);  // further from 0.5 than the precision of 0.001
  EXPECT_FALSE(natural.speedNotAllowed);
  EXPECT_FALSE(tooLittle.mayBeSubmitted());
  EXPECT_FALSE(tooFast.mayBeSubmitted());
}

TEST(SheetChecks, ExcuseNotAssessableCasesFromWatching) {
  std::vector<SheetLine> lines = linesOf(50, 60, 70, 60);
  lines.back().answer = {std::nullopt, "the picture is black"};

  const SheetCheck check = checkSheetLines(lines, RecordingWatched{0.0, 1.0, 4.0}, {});

  EXPECT_FALSE(check.watchedTooLittle);
  EXPECT_FALSE(check.speedNotAllowed);
  EXPECT_TRUE(check.mayBeSubmitted());
}

}  // namespace
}  // namespace torsio
