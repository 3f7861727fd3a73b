// SPDX-License-Identifier: GPL-3.0-or-later
// Viewing reports of a remote player and how much of them is accepted; length limits of texts.
#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "app/services/review/case_remarks.h"
#include "app/services/review/case_sheet.h"
#include "assessment/domain/rating/written_words.h"
#include "db/connection/connection.h"
#include "sim/core/error.h"
#include "tests/app/support/review_centre.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

constexpr std::int64_t kMinuteOfPlay_us = 60'000'000;

TEST(CreditedLog, AcceptsNoMoreThanTheElapsedTime) {
  const WatchLog all = creditedLog(WatchLog(kMinuteOfPlay_us), {{0, kMinuteOfPlay_us, 1.0}}, 10'000'000);

  EXPECT_NEAR(all.share(), 10.5 / 60.0, 1e-9);
  EXPECT_EQ(all.worked_us(), 10'000'000);
}

TEST(CreditedLog, ASlowerSpeedCoversLess) {
  const WatchLog half = creditedLog(WatchLog(kMinuteOfPlay_us), {{0, kMinuteOfPlay_us, 0.5}}, 19'500'000);
  const WatchLog twice = creditedLog(WatchLog(kMinuteOfPlay_us), {{0, kMinuteOfPlay_us, 2.0}}, 19'500'000);

  EXPECT_NEAR(half.share(), 10.0 / 60.0, 1e-9);
  EXPECT_NEAR(twice.share(), 40.0 / 60.0, 1e-9);
  EXPECT_EQ(half.slowest(), 0.5);
  EXPECT_EQ(twice.fastest(), 2.0);
}

TEST(CreditedLog, StretchesShareTheElapsedTime) {
  const WatchLog log = creditedLog(WatchLog(kMinuteOfPlay_us),
                                   {{0, 6'000'000, 1.0}, {30'000'000, 40'000'000, 1.0}}, 9'500'000);

  const auto spans = log.spans();
  ASSERT_EQ(spans.size(), 2U);
  EXPECT_EQ(spans[0].second - spans[0].first, 6'000'000);
  EXPECT_EQ(spans[1].second - spans[1].first, 4'000'000);
}

TEST(CreditedLog, AClockThatGoesBackAcceptsNothing) {
  const WatchLog log = creditedLog(WatchLog(kMinuteOfPlay_us), {{0, 30'000'000, 1.0}}, -5'000'000);

  EXPECT_LE(log.share(), 0.5 / 60.0 + 1e-9);
  EXPECT_EQ(log.worked_us(), 0);
}

TEST(WatchLog, MergesTheLogsOfTwoDesks) {
  WatchLog here(100'000);
  WatchLog there(100'000);
  here.played(0, 40'000, 1.0);
  here.worked(7);
  there.played(30'000, 60'000, 0.5);
  there.worked(9);

  here.join(there);

  EXPECT_NEAR(here.share(), 0.6, 1e-12);
  EXPECT_EQ(here.slowest(), 0.5);
  EXPECT_EQ(here.worked_us(), 9);
}

TEST(ReportViewing, IsAddedToTheDraftAndReadBack) {
  ReviewCentre centre({.trial_s = 2.0});
  const auto physician = centre.physician(0);
  const AssignmentId id = centre.cases(0).front();

  (void)reportViewing(*physician, id, {{0, 1'000'000, 1.0}}, 1'000'000);
  const WatchLog log = reportViewing(*physician, id, {{1'000'000, 2'000'000, 1.0}}, 1'000'000).watched;

  EXPECT_GT(log.share(), 0.99);
  EXPECT_NEAR(openSheet(*physician, id).watched.share(), log.share(), 0.01);
}

TEST(ReportViewing, TwoDesksLoseNothing) {
  ReviewCentre centre({.trial_s = 2.0});
  const auto desk = centre.physician(0);
  const auto browser = centre.physician(0);
  const AssignmentId id = centre.cases(0).front();
  const OpenedSheet atTheDesk = openSheet(*desk, id);

  (void)reportViewing(*browser, id, {{1'000'000, 2'000'000, 1.0}}, 1'000'000);
  WatchLog own = atTheDesk.watched;
  own.played(0, 1'000'000, 1.0);
  saveSheet(*desk, id, reviewSheet(7, 7, 7), own);

  EXPECT_GT(openSheet(*browser, id).watched.share(), 0.99)
      << "the desk wrote over what the browser had stored";
  submitSheet(*desk, id, reviewSheet(7, 7, 7), own);
}

TEST(ReportViewing, RejectsInvalidStretchesAndForbiddenSpeeds) {
  ReviewCentre centre({.trial_s = 2.0, .live = true});
  const auto physician = centre.physician(0);
  const AssignmentId id = centre.cases(0).front();
  const AssignmentId live = centre.cases(0, true).front();
  const auto refused = [&](const AssignmentId& of, const PlayedStretch& stretch) {
    return testing::refusalCode([&] { (void)reportViewing(*physician, of, {stretch}, 1'000'000); });
  };

  EXPECT_EQ(refused(id, {500'000, 0, 1.0}), ErrorCode::kBadParameter);
  EXPECT_EQ(refused(id, {-1, 10, 1.0}), ErrorCode::kBadParameter);
  EXPECT_EQ(refused(id, {0, 10, 3.0}), ErrorCode::kBadParameter);
  EXPECT_EQ(refused(id, {0, 10, std::nan("")}), ErrorCode::kBadParameter);
  EXPECT_EQ(refused(live, {0, 10, 1.0}), ErrorCode::kBadData);
  EXPECT_EQ(refused(centre.cases(1).front(), {0, 10, 1.0}), ErrorCode::kPermission);
  EXPECT_LT(openSheet(*physician, id).watched.share(), 1e-9);
}

TEST(WrittenWords, AreCountedInCharacters) {
  std::string chinese;
  for (std::size_t i = 0; i < kLongestReason; ++i) {
    chinese += "\u6276";
  }
  EXPECT_NO_THROW(requireWords(chinese, kLongestReason, ""));
  EXPECT_THROW(requireWords(chinese + "x", kLongestReason, ""), Error);
  EXPECT_NO_THROW(requireWords("line\nand\ttab", 20, ""));
  EXPECT_THROW(requireWords(std::string("zero\0", 5), 20, ""), Error);
  EXPECT_THROW(requireWords("cut \xE6\x89", 20, ""), Error);
  EXPECT_THROW(requireWords("\xC0\xAF", 20, ""), Error);
  EXPECT_THROW(requireWords("\xED\xA0\x80", 20, ""), Error);
}

TEST(WrittenWords, AreLimitedByTheServicesToo) {
  ReviewCentre centre({.trial_s = 1.0});
  const auto physician = centre.physician(0);
  const AssignmentId id = centre.cases(0).front();
  const std::string longRemark(kLongestRemark + 1, 'a');

  EXPECT_THROW(addCaseRemark(*physician, id, {.time_us = 0, .text = longRemark}), Error);
  Sheet sheet = reviewSheet(7, 7, 7);
  sheet.comment = std::string(kLongestComment + 1, 'a');
  EXPECT_THROW(saveSheet(*physician, id, sheet, WatchLog(1'000'000)), Error);
  EXPECT_EQ(openSheet(*physician, id).state, SheetState::kOpen);
}

}  // namespace
}  // namespace torsio
