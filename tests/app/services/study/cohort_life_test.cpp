// SPDX-License-Identifier: GPL-3.0-or-later
// A cohort from draft to archive, and what is allowed at each stage.
#include <array>

#include <gtest/gtest.h>

#include "app/services/study/allocation_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/day_plan.h"
#include "app/services/study/reassignment.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/study/cohort.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

using testing::StudyCentre;

/// Three of four trainees in a cohort of three groups, with one chief to score them.
struct Life {
  StudyCentre centre;
  std::vector<TraineeId> trainees = centre.addTrainees(4);
  std::vector<RaterId> chiefs = centre.addChiefs(1);
  std::string rubric = centre.addPaperRubric();
  CohortId cohortId = addCohort(
      centre.session(), {.name = "Autumn", .groups = {{"G1", "one"}, {"G2", "two"}, {"G3", "three"}}});
  std::vector<EnrolmentId> enrolled =
      enrolTrainees(centre.session(), cohortId, {trainees.begin(), trainees.begin() + 3});

  [[nodiscard]] Cohort cohort() { return cohorts(centre.as("administrator")).at(0).cohort; }
  void allocate() {
    AllocationPlan plan;
    plan.cohortId = cohortId;
    lockAllocation(centre.as("allocator"), plan);
    allocateAll(centre.as("allocator"), cohortId);
  }
  void set(CohortState state) { setCohortState(centre.as("administrator"), cohortId, state, "as planned"); }
  ScoringPlanOutcome ask() {
    return createAssignments(
        centre.as("administrator"),
        {.cohortId = cohortId, .occasionCodes = {"pre"}, .raterIds = chiefs, .rubricRevisionId = rubric});
  }
};

TEST(CohortLife, IsADraftUntilItsPeopleAreAllocated) {
  Life life;
  EXPECT_EQ(life.cohort().state, CohortState::kDraft);
  EXPECT_THROW(life.set(CohortState::kClosed), Error) << "a draft is not closed";

  life.allocate();

  EXPECT_EQ(life.cohort().state, CohortState::kRunning);
  EXPECT_THROW(life.set(CohortState::kArchived), Error) << "what runs is closed first";
  EXPECT_THROW(life.set(CohortState::kRunning), Error) << "it runs already";
  EXPECT_THROW(life.set(CohortState::kDraft), Error);
}

TEST(CohortLife, RunsOnceSomebodyHasTrainedWithoutAGroup) {
  Life life;

  recordExposure(life.centre.as("administrator"), {.cohortId = life.cohortId,
                                                   .enrolmentId = life.enrolled.front(),
                                                   .startedUtc_us = testing::kStudyTime_us,
                                                   .duration_us = 1});

  EXPECT_EQ(life.cohort().state, CohortState::kRunning);
}

TEST(CohortLife, AllowsNothingNewOnceClosed) {
  Life life;
  life.allocate();

  life.set(CohortState::kClosed);

  EXPECT_EQ(life.cohort().state, CohortState::kClosed);
  SessionContext& session = life.centre.as("administrator");
  const auto rows = life.centre.rowCounts();
  EXPECT_THROW(enrolTrainees(session, life.cohortId, {life.trainees[3]}), Error);
  EXPECT_THROW(assignCurriculum(session, life.cohortId, life.centre.runPaperCurriculum()), Error);
  EXPECT_THROW(life.ask(), Error);
  EXPECT_EQ(life.centre.audited("cohort.set_state"), 1);
  AllocationPlan plan;
  plan.cohortId = life.cohortId;
  EXPECT_THROW(lockAllocation(life.centre.as("allocator"), plan, "again"), Error);
  EXPECT_EQ(life.centre.rowCounts().at("enrolment"), rows.at("enrolment"));
  EXPECT_EQ(life.centre.rowCounts().at("assignment"), rows.at("assignment"));

  life.set(CohortState::kRunning);

  EXPECT_EQ(enrolTrainees(life.centre.as("administrator"), life.cohortId, {life.trainees[3]}).size(), 1U);
}

TEST(CohortLife, IsArchivedOnlyWithoutOpenSheets) {
  Life life;
  life.allocate();
  EXPECT_EQ(life.ask().created, 3U);
  life.set(CohortState::kClosed);

  EXPECT_THROW(life.set(CohortState::kArchived), Error);
  for (const ScoringMatrix::Line& line :
       scoringMatrix(life.centre.as("administrator"), life.cohortId).lines) {
    reassignAll(life.centre.as("administrator"), std::array{line.cells.at(0).assignmentId}, {}, "not needed");
  }
  life.set(CohortState::kArchived);

  EXPECT_EQ(life.cohort().state, CohortState::kArchived);
  EXPECT_THROW(life.ask(), Error);
}

TEST(CohortShownFirst, IsTodaysElseTheRunningStudy) {
  Life life;
  const auto shown = [&life] {
    const std::vector<CohortRow> rows = cohorts(life.centre.as("administrator"));
    return rows.at(cohortShownFirst(rows)).cohort.name;
  };
  EXPECT_EQ(cohortShownFirst({}), 0U);
  const CohortId small = addCohort(life.centre.as("administrator"),
                                   {.name = "Volvulus", .groups = {{"G1", "one"}, {"G2", "two"}}});
  const std::vector<EnrolmentId> one =
      enrolTrainees(life.centre.as("administrator"), small, {life.trainees[3], life.trainees[0]});
  EXPECT_EQ(shown(), "Volvulus") << "the newest, while nobody is in a group";
  life.allocate();
  EXPECT_EQ(shown(), "Autumn") << "it runs";
  AllocationPlan plan;
  plan.cohortId = small;
  lockAllocation(life.centre.as("allocator"), plan);
  allocateAll(life.centre.as("allocator"), small);
  EXPECT_EQ(shown(), "Autumn") << "it is the larger one";

  const std::vector<DaySlot> planned =
      planDay(life.centre.as("administrator"), {.cohortId = small,
                                                .enrolmentIds = one,
                                                .places = {"Room 1"},
                                                .firstUtc_us = testing::kStudyTime_us + 2 * kHour_us,
                                                .duration_us = kHour_us});
  EXPECT_EQ(shown(), "Volvulus") << "somebody is expected today";
  removeSlots(life.centre.as("administrator"), small, std::array{planned[0].id, planned[1].id});
  EXPECT_EQ(shown(), "Autumn");
  createAssignments(life.centre.as("administrator"), {.cohortId = small,
                                                      .occasionCodes = {"pre"},
                                                      .raterIds = life.chiefs,
                                                      .rubricRevisionId = life.rubric,
                                                      .dueUtc_us = testing::kStudyTime_us + kHour_us});
  EXPECT_EQ(shown(), "Volvulus") << "sheets are due by the end of the day";
  for (const ScoringMatrix::Line& line : scoringMatrix(life.centre.as("administrator"), small).lines) {
    reassignAll(life.centre.as("administrator"), std::array{line.cells.at(0).assignmentId}, {}, "not needed");
  }
  EXPECT_EQ(shown(), "Autumn");
  life.set(CohortState::kClosed);
  life.set(CohortState::kArchived);
  EXPECT_EQ(shown(), "Volvulus");
}

TEST(CohortLife, ItsNameIsUnique) {
  Life life;
  SessionContext& session = life.centre.as("administrator");
  addCohort(session, {.name = "Spring", .groups = {{"G1", "one"}}});

  EXPECT_THROW(renameCohort(session, life.cohortId, ""), Error);
  EXPECT_THROW(renameCohort(session, life.cohortId, "Spring"), Error);
  EXPECT_THROW(addCohort(session, {.name = "Spring", .groups = {{"G1", "one"}}}), Error);
  renameCohort(session, life.cohortId, "Autumn 2026");

  EXPECT_EQ(life.cohort().name, "Autumn 2026");
  EXPECT_EQ(life.centre.audited("cohort.rename"), 1);
}

}  // namespace
}  // namespace torsio
