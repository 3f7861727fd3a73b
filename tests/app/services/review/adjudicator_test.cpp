// SPDX-License-Identifier: GPL-3.0-or-later
// Administrators' tasks when physicians disagree, and before they start: an adjudicator, and the reference
// runs of rater calibration.
#include "app/services/review/adjudicator.h"

#include <gtest/gtest.h>

#include "app/services/review/case_sheet.h"
#include "app/services/review/discrepancy_review.h"
#include "app/services/review/rater_calibration.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/desk_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "tests/app/support/audit_entries.h"
#include "tests/app/support/review_centre.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

using testing::refusalCode;

constexpr std::int64_t kLater_us = 1'000'000;

WatchLog wholeLog() {
  WatchLog log(2'000'000);
  log.played(0, 2'000'000, 1.0);
  return log;
}

/// Two physicians who disagree about trainee 0, a third one not assigned, and one of another class.
class Disagreement : public ::testing::Test {
 protected:
  ReviewCentre centre_{ReviewCentre::Setup{}};
  CohortId cohortId_ = StudyRepository(centre_.connection()).cohorts().front().id;
  std::string chiefId_ = addRater("CH-900", "chief");
  std::string internId_ = addRater("IN-900", "intern");

  void SetUp() override {
    submitSheet(*centre_.physician(0), centre_.caseAbout(0, 0), reviewSheet(2, 2, 2), wholeLog());
    submitSheet(*centre_.physician(1), centre_.caseAbout(1, 0), reviewSheet(8, 8, 8), wholeLog());
    centre_.passTime_us(kLater_us);
  }

  std::string addRater(const std::string& code, const std::string& classCode) {
    PeopleRepository people(centre_.connection());
    if (classCode != "chief") {
      people.addRaterClasses(std::vector<SeniorityClass>{{classCode, classCode, 2}});
    }
    Rater rater;
    rater.person.id = "rater-" + code;
    rater.person.code = code;
    rater.person.createdUtc_us = kReviewTime_us;
    rater.classCode = classCode;
    people.addRaters(std::span(&rater, 1));
    return rater.person.id;
  }
};

TEST_F(Disagreement, IsListedOncePerCaseAndOffersRatersNotAssignedBefore) {
  EXPECT_TRUE(adjudicatorRequests(*centre_.administrator(), cohortId_).empty());
  askForAdjudicator(*centre_.physician(0), centre_.caseAbout(0, 0), "I cannot explain the distance");
  centre_.passTime_us(kLater_us);
  askForAdjudicator(*centre_.physician(1), centre_.caseAbout(1, 0), "nor can I");

  const std::vector<AdjudicatorRequest> requests = adjudicatorRequests(*centre_.administrator(), cohortId_);

  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].traineeCode, "TR-4100");
  EXPECT_EQ(requests[0].occasion.code, "mid");
  EXPECT_FALSE(requests[0].live);
  EXPECT_EQ(requests[0].marks, 2U);
  EXPECT_EQ(requests[0].askedBy, (std::vector<std::string>{"CH-100", "CH-101"}));
  EXPECT_EQ(requests[0].reasons, (std::vector<std::string>{"I cannot explain the distance", "nor can I"}));
  ASSERT_EQ(requests[0].free.size(), 2U);
  EXPECT_EQ(requests[0].free[0].code, "CH-900");  // same class first
  EXPECT_EQ(requests[0].free[1].code, "IN-900");
}

TEST_F(Disagreement, IsAssignedToAnAdjudicatorUnderAnotherLabelAndIsThenDone) {
  const std::string asked = centre_.caseAbout(0, 0);
  askForAdjudicator(*centre_.physician(0), asked, "I cannot explain the distance");
  centre_.passTime_us(kLater_us);
  const auto office = centre_.administrator();
  EXPECT_EQ(refusalCode([&] { assignAdjudicator(*office, cohortId_, asked, centre_.raterId(1)); }),
            ErrorCode::kBadData);

  std::string made;
  expectAudited(centre_.connection(), office->actor().userId, "assignment.third",
                [&] { made = assignAdjudicator(*office, cohortId_, asked, chiefId_); });

  DeskRepository desk(centre_.connection());
  const Assignment before = desk.assignment(asked).value();
  const Assignment third = desk.assignment(made).value();
  EXPECT_EQ(third.raterId, chiefId_);
  EXPECT_EQ(third.trialId, before.trialId);
  EXPECT_EQ(third.rubricRevisionId, before.rubricRevisionId);
  EXPECT_NE(third.caseLabel, before.caseLabel);
  EXPECT_TRUE(adjudicatorRequests(*office, cohortId_).empty());
  EXPECT_EQ(refusalCode([&] { assignAdjudicator(*office, cohortId_, asked, internId_); }),
            ErrorCode::kBadData);
  // Until the third one has submitted, the others' marks are hidden again.
  EXPECT_TRUE(discrepancyCases(*centre_.physician(0)).empty());
}

TEST_F(Disagreement, IsNoLongerARequestOnceThePhysicianDecidesOtherwise) {
  askForAdjudicator(*centre_.physician(0), centre_.caseAbout(0, 0), "far apart");
  keepMark(*centre_.physician(0), centre_.caseAbout(0, 0), "");

  EXPECT_TRUE(adjudicatorRequests(*centre_.administrator(), cohortId_).empty());
}

TEST_F(Disagreement, IsForTheAdministratorOnly) {
  const auto rater = centre_.physician(0);
  EXPECT_EQ(refusalCode([&] { static_cast<void>(adjudicatorRequests(*rater, cohortId_)); }),
            ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { assignAdjudicator(*rater, cohortId_, centre_.caseAbout(0, 0), chiefId_); }),
            ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { static_cast<void>(referenceCandidates(*rater)); }), ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { static_cast<void>(referenceRows(*rater)); }), ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { addReferenceRuns(*rater, {}); }), ErrorCode::kPermission);
}

TEST(ReferenceRuns, AreOfferedFromRecordingsThatNobodyScores) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto office = centre.administrator();
  EXPECT_TRUE(referenceCandidates(*office).empty());  // every recording is a case
  const std::string assignment = centre.caseAbout(0, 0);
  const TrialId trialId = centre.trialIds()[0];
  // The same recording again, without a case.
  Trial copy = TrialRepository(centre.connection()).load(trialId);
  const std::string free = "11111111-2222-4333-8444-555555555555";
  copy.header.trialId = free;
  TrialRepository repository(centre.connection(), {.station = "station-7"});
  repository.begin(copy.header);
  for (const TrialChunk& chunk : copy.chunks) {
    repository.append(chunk);
  }
  repository.finish(copy.summary);

  const std::vector<ReferenceCandidate> candidates = referenceCandidates(*office);
  ASSERT_EQ(candidates.size(), 1U);
  EXPECT_EQ(candidates[0].trialId, free);
  EXPECT_EQ(candidates[0].length_us, 2'000'000);
  addReferenceRuns(*office, {{free, centre.rubricRevisionId(), 6.2, 8, false}});

  EXPECT_TRUE(referenceCandidates(*office).empty());
  const std::vector<ReferenceRow> rows = referenceRows(*office);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].number, 1U);
  EXPECT_DOUBLE_EQ(rows[0].panel_points, 6.2);
  EXPECT_EQ(rows[0].panelRaters, 8);
}

TEST(ReferenceRuns, AreRejectedIfTheyCannotBeScored) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto office = centre.administrator();
  const auto add = [&](const std::string& trial, const std::string& rubric, double points,
                       std::int64_t raters) {
    return refusalCode([&] { addReferenceRuns(*office, {{trial, rubric, points, raters, false}}); });
  };
  const std::string trial = centre.trialIds()[0];
  EXPECT_EQ(add("no such", centre.rubricRevisionId(), 6.0, 5), ErrorCode::kBadData);
  EXPECT_EQ(add(trial, "no such", 6.0, 5), ErrorCode::kBadData);
  EXPECT_EQ(add(trial, centre.rubricRevisionId(), 10.5, 5), ErrorCode::kBadParameter);
  EXPECT_EQ(add(trial, centre.rubricRevisionId(), 6.0, 0), ErrorCode::kBadParameter);
  addReferenceRuns(*office, {{trial, centre.rubricRevisionId(), 6.0, 5, false}});
  EXPECT_EQ(add(trial, centre.rubricRevisionId(), 6.0, 5), ErrorCode::kBadData);
}

}  // namespace
}  // namespace torsio
