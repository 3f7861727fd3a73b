// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of a day: slots at stations and rooms, swapped with turns, overdue on the board.
#include "app/services/study/day_plan.h"

#include <algorithm>
#include <functional>

#include <gtest/gtest.h>

#include "app/services/study/cohort_service.h"
#include "app/services/study/day_board.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

using testing::kStudyTime_us;
using testing::StudyCentre;

class DayPlan : public ::testing::Test {
 protected:
  void SetUp() override {
    const std::vector<TraineeId> trainees = centre.addTrainees(5);
    const std::string version = centre.runPaperCurriculum();
    cohort = addCohort(centre.session(), {.name = "Study", .curriculumVersionId = version});
    enrolled = enrolTrainees(centre.session(), cohort, trainees);
  }
  SessionContext& office() { return centre.as("administrator"); }
  DayPlanRequest request() const {
    return {cohort,          enrolled,       {"Station 1", "Room B"}, kStudyTime_us + 30 * kMinute_us,
            40 * kMinute_us, 10 * kMinute_us};
  }
  DayBoardRow rowOf(std::size_t trainee) {
    for (DayBoardRow& row : dayBoard(office(), cohort).rows) {
      if (row.enrolmentId == enrolled[trainee]) {
        return std::move(row);
      }
    }
    return {};
  }
  std::int64_t overdue() {
    const std::vector<DayAlert> alerts = dayAlerts(dayBoard(office(), cohort));
    return std::count_if(alerts.begin(), alerts.end(),
                         [](const DayAlert& alert) { return alert.kind == DayAlert::Kind::kSlotOverdue; });
  }

  StudyCentre centre;
  CohortId cohort;
  std::vector<EnrolmentId> enrolled;
};

TEST_F(DayPlan, SchedulesAsManyTraineesAtATimeAsThereArePlaces) {
  const std::vector<DaySlot> slots = planDay(office(), request());

  ASSERT_EQ(slots.size(), 5U);
  EXPECT_EQ(slots[0].place, "Station 1");
  EXPECT_EQ(slots[1].place, "Room B");
  EXPECT_EQ(slots[1].startsUtc_us, slots[0].startsUtc_us) << "several rooms at once";
  EXPECT_EQ(slots[2].startsUtc_us, slots[0].startsUtc_us + 50 * kMinute_us);
  EXPECT_EQ(slots[4].startsUtc_us, slots[0].startsUtc_us + 100 * kMinute_us);
  EXPECT_EQ(centre.audited("slot.plan"), 5);
  EXPECT_EQ(daySlots(office(), cohort, kStudyTime_us, kStudyTime_us + 60 * kMinute_us).size(), 2U);
  EXPECT_EQ(rowOf(1).slot->place, "Room B");
}

TEST_F(DayPlan, NoPlaceOrTraineeIsBookedTwiceAtATime) {
  (void)planDay(office(), request());
  DayPlanRequest other = request();
  other.enrolmentIds = {enrolled[4]};
  other.places = {"Room B"};
  other.firstUtc_us += 39 * kMinute_us;  // the last minute of the previous slot
  EXPECT_THROW((void)planDay(office(), other), Error);
  other.places = {"Room C"};
  other.firstUtc_us = request().firstUtc_us + 120 * kMinute_us;  // while the fifth one has a slot elsewhere
  EXPECT_THROW((void)planDay(office(), other), Error);
  EXPECT_EQ(centre.audited("slot.plan"), 5) << "all or nothing";
  other.firstUtc_us = request().firstUtc_us + 140 * kMinute_us;
  EXPECT_EQ(planDay(office(), other).size(), 1U);

  for (const auto& spoil : std::vector<std::function<void(DayPlanRequest&)>>{
           [](DayPlanRequest& bad) { bad.places.clear(); },
           [](DayPlanRequest& bad) {
             bad.places = {"Room B", "Room B"};
           },
           [](DayPlanRequest& bad) { bad.duration_us = 0; },
           [](DayPlanRequest& bad) { bad.enrolmentIds.clear(); },
           [](DayPlanRequest& bad) { bad.enrolmentIds = {"nobody"}; }}) {
    DayPlanRequest bad = request();
    bad.firstUtc_us += 600 * kMinute_us;
    spoil(bad);
    EXPECT_THROW((void)planDay(office(), bad), Error);
  }
}

TEST_F(DayPlan, SwappedTurnsSwapTheSlots) {
  const std::vector<DaySlot> slots = planDay(office(), request());

  swapTurns(office(), cohort, enrolled[0], enrolled[3], "is late");

  EXPECT_EQ(rowOf(0).slot->startsUtc_us, slots[3].startsUtc_us);
  EXPECT_EQ(rowOf(0).slot->place, slots[3].place);
  EXPECT_EQ(rowOf(3).slot->startsUtc_us, slots[0].startsUtc_us);
  EXPECT_EQ(centre.audited("slot.plan"), 7) << "who moved stands in the trail";
  EXPECT_EQ(rowOf(0).deviations, 1U);
}

TEST_F(DayPlan, ATraineeWhoHasNotBegunFiveMinutesAfterTheStartIsOverdue) {
  (void)planDay(office(), request());
  centre.passTime_us(34 * kMinute_us);
  EXPECT_EQ(overdue(), 0) << "four minutes late";

  centre.passTime_us(2 * kMinute_us);
  EXPECT_EQ(overdue(), 2);
  EXPECT_TRUE(rowOf(0).overdue);
  EXPECT_FALSE(rowOf(2).overdue) << "comes later";

  recordExposure(office(), {cohort, enrolled[0], "", ExposureKind::kVirtual, kStudyTime_us + 31 * kMinute_us,
                            5 * kMinute_us});
  EXPECT_FALSE(rowOf(0).overdue) << "trains";
  setEnrolmentState(office(), cohort, enrolled[1], EnrolmentState::kWithdrawn, "ill");
  EXPECT_EQ(overdue(), 0) << "whoever withdrew is not awaited";
}

TEST_F(DayPlan, ASlotCanBeRemovedFromThePlan) {
  const std::vector<DaySlot> slots = planDay(office(), request());
  const std::vector<DaySlotId> gone{slots[1].id, slots[2].id};

  removeSlots(office(), cohort, gone);

  EXPECT_EQ(daySlots(office(), cohort, 0, kStudyTime_us + 1000 * kMinute_us).size(), 3U);
  EXPECT_FALSE(rowOf(1).slot.has_value());
  EXPECT_EQ(centre.audited("slot.remove"), 2);
  EXPECT_THROW(removeSlots(office(), cohort, gone), Error);
}

}  // namespace
}  // namespace torsio
