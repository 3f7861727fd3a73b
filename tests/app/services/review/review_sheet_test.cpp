// SPDX-License-Identifier: GPL-3.0-or-later
// Sheets while they are filled in and afterwards: editor, drafts, checks, sealing, amending; first as
// values without a database. Viewing reports of a remote player and how much of them is accepted; length
// limits of texts.

#include <cstddef>
#include <limits>
#include <optional>
#include <random>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "app/services/access/centre_settings.h"
#include "app/services/review/blinded_case.h"
#include "app/services/review/case_remarks.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/discrepancy_review.h"
#include "app/services/review/range_pyramid.h"
#include "app/services/review/review_queue.h"
#include "app/services/review/sheet_editor.h"
#include "app/services/study/open_sheets.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/rating/written_words.h"
#include "db/connection/connection.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/system/audit_verification.h"
#include "sim/core/error.h"
#include "sim/core/random.h"
#include "tests/app/support/review_centre.h"
#include "tests/support/refusal.h"

namespace torsio {

namespace {

using testing::refusalCode;

RubricRevision twoRows() {
  RubricRevision rubric;
  rubric.overall = {10, 100, 10};
  rubric.rows = {{"time", "Time", {10, 100, 10}, {}}, {"care", "Care", {0, 5, 1}, {}}};
  return rubric;
}

WatchLog whole(std::int64_t length_us) {
  WatchLog log(length_us);
  log.played(0, length_us, 1.0);
  return log;
}

TEST(SheetEditor, UndoesToTheFirstMarkAndRedoesToTheLast) {
  SheetEditor editor(twoRows(), {});
  const Sheet empty = editor.sheet();
  editor.setScore("time", 70);
  editor.setScore("care", 3);
  editor.setNotAssessable("care", "hidden by the hand");
  editor.setScore(kOverallRow, 65);
  editor.clearAll();

  int undone = 0;
  while (editor.undo()) {
    ++undone;
  }

  EXPECT_EQ(undone, 5);
  EXPECT_FALSE(editor.answer("time").given());
  EXPECT_EQ(editor.sheet().rows.size(), empty.rows.size());
  while (editor.redo()) {
  }
  EXPECT_FALSE(editor.answer("time").given());
  editor.undo();
  EXPECT_EQ(editor.answer("time").score_steps, 70);
  EXPECT_EQ(editor.answer("care").notAssessableReason, "hidden by the hand");
  EXPECT_EQ(editor.answer(kOverallRow).score_steps, 65);
}

TEST(SheetEditor, TypingInOneTextIsOneNamedStep) {
  SheetEditor editor(twoRows(), {});
  editor.setScore("time", 70);
  for (const char* text : {"c", "ca", "cal", "calm"}) {
    editor.setComment(text);
  }

  ASSERT_TRUE(editor.undoable().has_value());
  EXPECT_EQ(editor.undoable()->kind, SheetChange::Kind::kComment);
  editor.undo();

  EXPECT_TRUE(editor.sheet().comment.empty());
  EXPECT_EQ(editor.answer("time").score_steps, 70);
  EXPECT_EQ(editor.redoable()->kind, SheetChange::Kind::kComment);
}

TEST(SheetEditor, ANewMarkClearsTheRedo) {
  SheetEditor editor(twoRows(), {});
  editor.setScore("time", 70);
  editor.undo();
  editor.setScore("time", 80);

  EXPECT_FALSE(editor.canRedo());
  EXPECT_EQ(editor.answer("time").score_steps, 80);
}

TEST(SheetEditor, RejectsValuesOutsideTheScale) {
  SheetEditor editor(twoRows(), {});

  EXPECT_FALSE(editor.setScore("care", 6));
  EXPECT_FALSE(editor.setScore("time", 9));
  EXPECT_FALSE(editor.canUndo());
}

TEST(Digits, ArePointsOfTheScale) {
  const ScoreScale oneToTen{10, 100, 10};
  const ScoreScale zeroToTen{0, 100, 10};
  const ScoreScale zeroToFive{0, 5, 1};

  EXPECT_EQ(stepsForDigit(oneToTen, 7, {}), 70);
  EXPECT_EQ(stepsForDigit(oneToTen, 0, {}), 100);  // no zero on this scale: ten
  EXPECT_EQ(stepsForDigit(oneToTen, 0, 1), 100);   // "1", "0"
  EXPECT_EQ(stepsForDigit(oneToTen, 5, 7), 50);    // 75 is invalid: a new score
  EXPECT_EQ(stepsForDigit(zeroToTen, 0, {}), 0);
  EXPECT_EQ(stepsForDigit(zeroToTen, 0, 1), 100);
  EXPECT_EQ(stepsForDigit(zeroToFive, 5, {}), 5);
  EXPECT_FALSE(stepsForDigit(zeroToFive, 6, {}).has_value());
  EXPECT_EQ(arrowSteps(oneToTen), 5);
  EXPECT_EQ(arrowSteps(zeroToFive), 1);
}

TEST(WatchLog, CountsPlayedStretchesOnceAndSurvivesStorage) {
  WatchLog log(10'000'000);
  log.played(0, 2'000'000, 1.0);
  log.played(1'000'000, 3'000'000, 1.0);
  log.played(8'000'000, 12'000'000, 1.5);
  EXPECT_DOUBLE_EQ(log.share(), 0.5);  // 0-3 s and 8-10 s of 10 s

  const WatchLog again(10'000'000, log.stored());

  EXPECT_DOUBLE_EQ(again.share(), 0.5);
  EXPECT_DOUBLE_EQ(again.fastest(), 1.5);
  EXPECT_EQ(log.stored().watched_permille, 500);
  SheetViewing broken;
  broken.watched = "x-3;;17";
  EXPECT_EQ(WatchLog(10'000'000, broken).share(), 0.0);
}

TEST(RangePyramid, MatchesALoopOverAllValues) {
  Random random(7);
  std::vector<float> values;
  for (int i = 0; i < 5'003; ++i) {
    values.push_back(static_cast<float>(random.uniform()));
  }
  const RangePyramid pyramid(values);
  for (int n = 0; n < 500; ++n) {
    auto first = static_cast<std::size_t>(random.uniform() * 5'002.0);
    auto last = first + 1 + static_cast<std::size_t>(random.uniform() * static_cast<double>(5'002 - first));
    float low = std::numeric_limits<float>::infinity();
    float high = -low;
    for (std::size_t i = first; i < last; ++i) {
      low = std::min(low, values[i]);
      high = std::max(high, values[i]);
    }

    const RangePyramid::Range range = pyramid.range(first, last);

    ASSERT_EQ(range.low, low) << first << " " << last;
    ASSERT_EQ(range.high, high) << first << " " << last;
  }
}

TEST(CaseSheet, ADraftIsStoredByEachSaveAlone) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto desk = centre.physician(0);
  const std::string id = centre.cases(0).front();
  SheetEditor editor(openSheet(*desk, id).rubric, {});
  editor.setScore("time", 70);
  editor.saved(saveSheet(*desk, id, editor.sheet(), WatchLog(2'000'000)));
  editor.setScore("accuracy", 55);
  static_cast<void>(saveSheet(*desk, id, editor.sheet(), WatchLog(2'000'000)));

  const ReviewCentre other(centre.folder());
  const auto again = const_cast<ReviewCentre&>(other).physician(0);
  const OpenedSheet opened = openSheet(*again, id);

  EXPECT_EQ(opened.state, SheetState::kDraft);
  const SheetEditor read(opened.rubric, opened.sheet);
  EXPECT_EQ(read.answer("time").score_steps, 70);
  EXPECT_EQ(read.answer("accuracy").score_steps, 55);
}

TEST(CaseSheet, SubmittingSealsTheMarkWithTheViewingData) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto desk = centre.physician(0);
  const std::string id = centre.cases(0).front();
  WatchLog watched = whole(2'000'000);
  watched.worked(90'000'000);

  submitSheet(*desk, id, reviewSheet(7, 6, 6.5), watched);

  EXPECT_EQ(openSheet(*desk, id).state, SheetState::kSubmitted);
  Statement sealed = centre.connection().prepare(
      "SELECT v.watched_permille, v.worked_us FROM mark_viewing v JOIN training_mark m ON m.id = v.mark_id"
      " WHERE m.assignment_id = ?");
  sealed.execute({id});
  ASSERT_TRUE(sealed.step());
  EXPECT_EQ(sealed.int64(0), 1000);
  EXPECT_EQ(sealed.int64(1), 90'000'000);
  EXPECT_THROW(saveSheet(*desk, id, reviewSheet(1, 1, 1), watched), Error);
  EXPECT_TRUE(verifyAuditTrail(centre.connection()).empty());
}

TEST(CaseSheet, ASealedSheetSubmittedAgainIsSaidToBeSealed) {
  ReviewCentre centre({.live = true});
  const auto desk = centre.physician(0);
  for (const bool live : {false, true}) {
    const AssignmentId id = centre.cases(0, live).front();
    const WatchLog watched = live ? WatchLog() : whole(2'000'000);
    submitSheet(*desk, id, reviewSheet(7, 6, 6.5), watched);

    EXPECT_THROW(submitSheet(*desk, id, reviewSheet(7, 6, 6.5), watched), SheetSealed) << live;
    EXPECT_THROW(submitSheet(*desk, id, reviewSheet(1, 1, 1), WatchLog()), SheetSealed) << live;
    EXPECT_THROW(saveSheet(*desk, id, reviewSheet(1, 1, 1), WatchLog()), SheetSealed) << live;
    EXPECT_EQ(sheetVersions(*desk, id).size(), 1U);
  }
}

TEST(CaseSheet, RequiresAnswersWatchingAndNormalSpeed) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto desk = centre.physician(0);
  const std::string id = centre.cases(0).front();
  WatchLog half(2'000'000);
  half.played(0, 1'000'000, 1.0);
  WatchLog fast(2'000'000);
  fast.played(0, 2'000'000, 2.0);
  Sheet gap = reviewSheet(7, 6, 6.5);
  gap.rows.pop_back();

  EXPECT_EQ(refusalCode([&] { submitSheet(*desk, id, reviewSheet(7, 6, 6.5), half); }), ErrorCode::kBadData);
  EXPECT_EQ(refusalCode([&] { submitSheet(*desk, id, reviewSheet(7, 6, 6.5), fast); }), ErrorCode::kBadData);
  EXPECT_EQ(refusalCode([&] { submitSheet(*desk, id, gap, whole(2'000'000)); }), ErrorCode::kBadData);
  EXPECT_EQ(openSheet(*desk, id).state, SheetState::kOpen);

  setCentreSetting<kPlaybackSpeeds>(*centre.administrator(), {1.0, 2.0});
  setCentreSetting<kMinimumWatched_percent>(*centre.administrator(), 50.0);
  submitSheet(*desk, id, reviewSheet(7, 6, 6.5), fast);
  submitSheet(*desk, centre.cases(0).back(), reviewSheet(7, 6, 6.5), half);
}

TEST(CaseSheet, NotAssessableNeedsAReasonAndNoWatching) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto desk = centre.physician(0);
  const std::string id = centre.cases(0).front();
  SheetEditor editor(openSheet(*desk, id).rubric, {});
  for (const std::string& row : editor.order()) {
    editor.setNotAssessable(row, "nothing to see");
  }

  submitSheet(*desk, id, editor.sheet(), WatchLog(2'000'000));

  const OpenedSheet sealed = openSheet(*desk, id);
  EXPECT_EQ(sealed.state, SheetState::kSubmitted);
  EXPECT_FALSE(sealed.sheet.overall_steps.has_value());
  EXPECT_EQ(sealed.sheet.notAssessableReason, "nothing to see");
}

TEST(CaseSheet, WarnsOfAnswersThatLookLikeMistakes) {
  RubricRevision rubric = twoRows();
  rubric.rows = {{"a", "A", {10, 100, 10}, {}}, {"b", "B", {10, 100, 10}, {}}, {"c", "C", {10, 100, 10}, {}}};
  Sheet flat;
  flat.rows = {{"a", 50, ""}, {"b", 50, ""}, {"c", 50, ""}};
  flat.overall_steps = 90;

  const SheetCheck check = checkSheet(rubric, flat, true, WatchLog(), {});

  EXPECT_TRUE(check.allTheSame);
  EXPECT_TRUE(check.overallOutside);
  EXPECT_TRUE(check.mayBeSubmitted());  // a warning does not block submission
}

TEST(CaseSheet, AnAmendmentKeepsBothVersionsAndNeedsAReason) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto desk = centre.physician(0);
  const std::string id = centre.cases(0).front();
  EXPECT_EQ(refusalCode([&] { amendSheet(*desk, id, changedSheet(1, 5, 5, 5), "looked again"); }),
            ErrorCode::kBadData);
  submitSheet(*desk, id, reviewSheet(7, 6, 6.5), whole(2'000'000));

  EXPECT_EQ(refusalCode([&] { amendSheet(*desk, id, changedSheet(1, 5, 5, 5), ""); }),
            ErrorCode::kBadParameter);
  amendSheet(*desk, id, changedSheet(1, 8, 6, 7), "looked again");

  const std::vector<SheetVersion> versions = sheetVersions(*desk, id);
  ASSERT_EQ(versions.size(), 2U);
  EXPECT_EQ(versions[0].overall_steps, 65);
  EXPECT_EQ(versions[1].overall_steps, 70);
  EXPECT_EQ(versions[1].amendReason, "looked again");
  EXPECT_EQ(openSheet(*desk, id).sheet.overall_steps, 70);
}

TEST(CaseSheet, OnceThePanelsMarksAreVisibleAChangeNeedsAReasonAndIsFlagged) {
  ReviewCentre centre({.trainees = 1});
  const auto desk = centre.physician(0);
  const std::string id = centre.caseAbout(0, 0);
  submitSheet(*desk, id, reviewSheet(3, 3, 3), whole(2'000'000));
  amendSheet(*desk, id, changedSheet(1, 4, 4, 4), "looked again");
  EXPECT_FALSE(openSheet(*desk, id).panelOpen);
  centre.passTime_us(1'000'000);
  submitSheet(*centre.physician(1), centre.caseAbout(1, 0), reviewSheet(8, 8, 8), whole(2'000'000));
  centre.passTime_us(1'000'000);

  EXPECT_TRUE(openSheet(*desk, id).panelOpen);
  EXPECT_EQ(refusalCode([&] { amendSheet(*desk, id, changedSheet(1, 8, 8, 8), "so do the others"); }),
            ErrorCode::kBadData);
  moveMark(*desk, id, changedSheet(2, 7, 7, 7), "missed the second grip");

  const std::vector<SheetVersion> versions = sheetVersions(*desk, id);
  ASSERT_EQ(versions.size(), 3U);
  EXPECT_FALSE(versions[0].afterPanel);
  EXPECT_FALSE(versions[1].afterPanel);
  EXPECT_TRUE(versions[2].afterPanel);
}

TEST(CaseSheet, IsOnlyForItsRater) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto own = centre.physician(0);
  const auto other = centre.physician(1);
  const auto office = centre.administrator();
  const std::string id = centre.cases(0).front();

  EXPECT_EQ(refusalCode([&] { static_cast<void>(openSheet(*other, id)); }), ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { saveSheet(*other, id, {}, WatchLog()); }), ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { submitSheet(*other, id, reviewSheet(5, 5, 5), WatchLog()); }),
            ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { static_cast<void>(openSheet(*office, id)); }), ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { static_cast<void>(openSheet(*own, "no such case")); }), ErrorCode::kPermission);
  SheetRepository(centre.connection()).withdraw(id, "on leave", "office", kReviewTime_us);
  EXPECT_EQ(refusalCode([&] { static_cast<void>(openSheet(*own, id)); }), ErrorCode::kPermission);
}

TEST(ReviewQueue, ShowsOneDeadlineForAllRecordedCases) {
  ReviewCentre centre({.trainees = 4, .dueByTrainee = true});
  const auto desk = centre.physician(0);
  const std::int64_t told_us = kReviewTime_us + 4 * kReviewDay_us;
  const auto deadlines = [&] {
    std::set<std::optional<std::int64_t>> seen;
    for (const QueueLine& line : reviewQueue(*desk).lines) {
      seen.insert(line.shown.dueUtc_us);
      seen.insert(blindedCase(*desk, line.shown.assignmentId).dueUtc_us);
    }
    return seen;
  };

  EXPECT_EQ(deadlines(), (std::set<std::optional<std::int64_t>>{told_us}));
  // The remaining cases do not reveal it after a sheet was submitted.
  WatchLog watched = whole(2'000'000);
  submitSheet(*desk, centre.cases(0).front(), reviewSheet(5, 5, 5), watched);
  EXPECT_EQ(deadlines(), (std::set<std::optional<std::int64_t>>{told_us}));
  // The first case's deadline has passed, but nothing shows which case it is.
  centre.passTime_us(2 * kReviewDay_us);
  EXPECT_EQ(reviewQueue(*desk).overdue, 0U);
  const auto office = centre.administrator();
  Statement cohorts = centre.connection().prepare("SELECT id FROM cohort");
  cohorts.execute({});
  ASSERT_TRUE(cohorts.step());
  const CohortId cohort(cohorts.text(0));
  for (const Reminder& reminder : reminders(*office, cohort)) {
    for (const SheetAwaited& sheet : reminder.sheets) {
      EXPECT_EQ(sheet.dueUtc_us, std::optional(told_us));
      EXPECT_FALSE(sheet.late);
    }
  }
}

TEST(ReviewQueue, EstimatesTimesAndKnowsTheNextCase) {
  ReviewCentre centre({.trainees = 5, .live = true});
  const auto desk = centre.physician(0);
  const std::vector<AssignmentId> ids = centre.cases(0);

  const ReviewQueue fresh = reviewQueue(*desk);
  EXPECT_EQ(fresh.waiting, 5U);
  EXPECT_EQ(fresh.liveCalled, 5U);
  EXPECT_EQ(fresh.liveWaiting, 0U);
  EXPECT_EQ(fresh.next, ids[0]);
  EXPECT_FALSE(fresh.fromOwnPace);
  EXPECT_NEAR(fresh.minutes, 5.0 * (2.0 / 60.0 + 1.0),
              1e-9);  // 2 s of recording and one minute for the sheet
  EXPECT_EQ(fresh.inTenMinutes, 5U);
  EXPECT_EQ(fresh.worked_us, 0);
  ASSERT_TRUE(fresh.nextDueUtc_us.has_value());
  EXPECT_EQ(*fresh.nextDueUtc_us, kReviewTime_us + 3 * kReviewDay_us);

  for (std::size_t i = 0; i < 3; ++i) {
    WatchLog watched = whole(2'000'000);
    watched.worked(360'000'000);
    submitSheet(*desk, ids[i], reviewSheet(5, 5, 5), watched);
  }
  static_cast<void>(saveSheet(*desk, ids[4], {}, WatchLog(2'000'000)));
  centre.passTime_us(4 * kReviewDay_us);
  const ReviewQueue later = reviewQueue(*desk);

  EXPECT_EQ(later.submitted, 3U);
  EXPECT_EQ(later.drafts, 1U);
  EXPECT_EQ(later.waiting, 1U);
  EXPECT_EQ(later.next, ids[4]);  // the draft first
  EXPECT_TRUE(later.fromOwnPace);
  EXPECT_DOUBLE_EQ(later.minutes, 12.0);  // two cases at the rater's pace of six minutes
  EXPECT_EQ(later.inTenMinutes, 1U);
  EXPECT_EQ(later.worked_us, 3 * 360'000'000);
  EXPECT_EQ(later.overdue, 7U);
  EXPECT_EQ(liveLines(*desk).size(), 5U);
}

constexpr std::int64_t kMinuteOfPlay_us = 60'000'000;

TEST(CreditedLog, AcceptsNoMoreThanTheBudget) {
  const CreditedLog all = creditedLog(WatchLog(kMinuteOfPlay_us), {{0, kMinuteOfPlay_us, 1.0}}, 10'500'000);

  EXPECT_NEAR(all.log.share(), 10.5 / 60.0, 1e-9);
  EXPECT_EQ(all.used_us, 10'500'000);
}

TEST(CreditedLog, ASlowerSpeedCoversLess) {
  const WatchLog half = creditedLog(WatchLog(kMinuteOfPlay_us), {{0, kMinuteOfPlay_us, 0.5}}, 20'000'000).log;
  const WatchLog twice =
      creditedLog(WatchLog(kMinuteOfPlay_us), {{0, kMinuteOfPlay_us, 2.0}}, 20'000'000).log;

  EXPECT_NEAR(half.share(), 10.0 / 60.0, 1e-9);
  EXPECT_NEAR(twice.share(), 40.0 / 60.0, 1e-9);
  EXPECT_EQ(half.slowest(), 0.5);
  EXPECT_EQ(twice.fastest(), 2.0);
}

TEST(CreditedLog, StretchesShareTheBudget) {
  const WatchLog log = creditedLog(WatchLog(kMinuteOfPlay_us),
                                   {{0, 6'000'000, 1.0}, {30'000'000, 40'000'000, 1.0}}, 10'000'000)
                           .log;

  const auto spans = log.spans();
  ASSERT_EQ(spans.size(), 2U);
  EXPECT_EQ(spans[0].second - spans[0].first, 6'000'000);
  EXPECT_EQ(spans[1].second - spans[1].first, 4'000'000);
}

TEST(CreditedLog, ABudgetBelowNothingAcceptsNothing) {
  EXPECT_EQ(creditedLog(WatchLog(kMinuteOfPlay_us), {{0, 30'000'000, 1.0}}, -5'000'000).log.share(), 0.0);
}

/// Whatever is reported in whatever order, a rater is credited with the time gone by and one slack.
TEST(WatchAccount, CreditedTimeNeverExceedsTheTimeGoneBy) {
  std::mt19937_64 random(20261130);
  const auto below = [&](std::int64_t most) {
    return static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(most));
  };
  for (int run = 0; run < 200; ++run) {
    WatchAccount account;
    std::int64_t now_us = 1'000'000'000;
    std::int64_t credited_us = 0;
    const std::int64_t begun_us = now_us;
    const std::int64_t pause_us = below(4'000'000) + 1;
    for (int report = 0; report < 300; ++report) {
      now_us += below(3) == 0 ? 0 : below(pause_us);
      const std::string recording = std::to_string(below(1 + run % 3));
      const std::int64_t budget = budget_us(account, recording, now_us);
      const double speed = std::array{0.5, 1.0, 2.0}[static_cast<std::size_t>(below(3))];
      const std::int64_t from_us = below(kMinuteOfPlay_us);
      const std::int64_t used_us = creditedLog(WatchLog(kMinuteOfPlay_us),
                                               {{from_us, from_us + below(kMinuteOfPlay_us), speed}}, budget)
                                       .used_us;
      account = charged(recording, "browser", now_us, budget - used_us);
      credited_us += used_us;
      ASSERT_LE(credited_us, now_us - begun_us + kWatchSlack_us) << run << ", report " << report;
    }
  }
}

/// Several desks of one rater: browsers, which report, and a window.
class WatchedTime : public ::testing::Test {
 protected:
  static constexpr std::int64_t kTrial_us = 20'000'000;

  void report(const AssignmentId& id, std::int64_t from_us, std::int64_t to_us) {
    (void)reportViewing(*centre_.physician(0), id, {{from_us, to_us, 1.0}});
  }
  [[nodiscard]] std::int64_t seen_us(const AssignmentId& id) {
    return std::llround(openSheet(*desk_, id).watched.share() * static_cast<double>(kTrial_us));
  }

  ReviewCentre centre_{{.trainees = 2, .trial_s = 20.0}};
  std::unique_ptr<SessionContext> desk_ = centre_.physician(0);
  AssignmentId first_ = centre_.cases(0).front();
  AssignmentId second_ = centre_.cases(0).back();
};

TEST_F(WatchedTime, ManySmallReportsAreCreditedWithOneSlack) {
  beginWatching(*desk_, first_.text());
  for (std::int64_t at = 0; at < kTrial_us; at += 400'000) {
    report(first_, at, at + 400'000);
  }
  EXPECT_LE(seen_us(first_), kWatchSlack_us + 10'000);

  beginWatching(*desk_, first_.text());
  centre_.passTime_us(2'000'000);
  report(first_, 0, kTrial_us);
  EXPECT_NEAR(static_cast<double>(seen_us(first_)), 2e6, 2e4) << "the slack is spent";
}

TEST_F(WatchedTime, TwoHalvesAtOnceTakeTheTimeOfBoth) {
  beginWatching(*desk_, first_.text());
  for (int s = 0; s < 5; ++s) {
    centre_.passTime_us(1'000'000);
    report(first_, s * 1'000'000, (s + 1) * 1'000'000);
    report(first_, 10'000'000 + s * 1'000'000, 11'000'000 + s * 1'000'000);
  }
  EXPECT_LE(seen_us(first_), 5'000'000 + kWatchSlack_us + 100'000);
}

TEST_F(WatchedTime, TwoRecordingsAreNeverWatchedAtOnce) {
  beginWatching(*desk_, first_.text());
  for (int s = 0; s < 5; ++s) {
    centre_.passTime_us(1'000'000);
    report(first_, s * 1'000'000, (s + 1) * 1'000'000);
    report(second_, s * 1'000'000, (s + 1) * 1'000'000);
  }
  EXPECT_LE(seen_us(first_) + seen_us(second_), 5'000'000 + kWatchSlack_us + 100'000);
}

TEST_F(WatchedTime, AWindowBesideABrowserSharesItsTime) {
  beginWatching(*desk_, first_.text());
  WatchLog kept(kTrial_us);
  for (int s = 1; s <= 5; ++s) {
    centre_.passTime_us(1'000'000);
    report(first_, (s - 1) * 1'000'000, s * 1'000'000);
    WatchLog played = kept;
    played.played(0, s * 1'000'000, 1.0);
    kept = watchedInWindow(*desk_, second_.text(), kept, played);
  }
  const auto window_us = std::llround(kept.share() * static_cast<double>(kTrial_us));
  EXPECT_LE(seen_us(first_) + window_us, 5'000'000 + kWatchSlack_us + 100'000);

  WatchLog played = kept;
  played.played(0, 10'000'000, 1.0);
  kept = watchedInWindow(*desk_, second_.text(), kept, played);
  EXPECT_NEAR(kept.share(), 0.5, 1e-9) << "alone again, its own player keeps the time";
}

TEST_F(WatchedTime, AnHonestBrowserLosesNothing) {
  beginWatching(*desk_, first_.text());
  std::int64_t at_us = 0;
  for (const std::int64_t late_us : {300'000, 0, 400'000, 100'000, 0, 200'000, 0, 0, 300'000, 0}) {
    centre_.passTime_us(2'000'000 + late_us - (at_us == 0 ? 0 : 100'000));
    report(first_, at_us, at_us + 1'900'000);
    at_us += 1'900'000;
  }
  EXPECT_GE(seen_us(first_), 18'500'000);
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

  beginWatching(*physician, id.text());
  centre.passTime_us(1'000'000);
  (void)reportViewing(*physician, id, {{0, 1'000'000, 1.0}});
  centre.passTime_us(1'000'000);
  const WatchLog log = reportViewing(*physician, id, {{1'000'000, 2'000'000, 1.0}}).watched;

  EXPECT_GT(log.share(), 0.99);
  EXPECT_NEAR(openSheet(*physician, id).watched.share(), log.share(), 0.01);
}

TEST(ReportViewing, TwoDesksLoseNothing) {
  ReviewCentre centre({.trial_s = 2.0});
  const auto desk = centre.physician(0);
  const auto browser = centre.physician(0);
  const AssignmentId id = centre.cases(0).front();
  const OpenedSheet atTheDesk = openSheet(*desk, id);

  beginWatching(*browser, id.text());
  centre.passTime_us(1'000'000);
  (void)reportViewing(*browser, id, {{1'000'000, 2'000'000, 1.0}});
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
    return testing::refusalCode([&] { (void)reportViewing(*physician, of, {stretch}); });
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
