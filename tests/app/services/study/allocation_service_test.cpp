// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/study/allocation_service.h"

#include <algorithm>
#include <map>

#include <gtest/gtest.h>

#include "app/services/demonstration/demonstration_people.h"
#include "app/services/people/people_service.h"
#include "app/services/scoring/cohort_inputs.h"
#include "app/services/study/cohort_service.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/study/allocation.h"
#include "assessment/domain/study/cohort.h"
#include "db/repository/study/study_repository.h"
#include "sim/core/error.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

/// Thirty trainees enrolled in a cohort of three groups.
struct AllocationStudy {
  StudyCentre centre;
  CohortId cohortId;
  std::vector<TraineeId> people;
  std::vector<EnrolmentId> enrolmentIds;

  explicit AllocationStudy(std::size_t trainees = 30, std::size_t enrolled = 30)
      : people(centre.addTrainees(trainees)) {
    cohortId = addCohort(centre.session(),
                         {.name = "Study", .groups = {{"G1", "one"}, {"G2", "two"}, {"G3", "three"}}});
    const std::size_t first = std::min(enrolled, trainees);
    enrolmentIds = enrolTrainees(centre.session(), cohortId,
                                 {people.begin(), people.begin() + static_cast<std::ptrdiff_t>(first)});
  }
  [[nodiscard]] AllocationPlan plan(AllocationMethod method) const {
    AllocationPlan plan;
    plan.cohortId = cohortId;
    plan.method = method;
    if (method == AllocationMethod::kPermutedBlocks || method == AllocationMethod::kStratifiedBlocks) {
      plan.blockSizes = {3};
    }
    if (method == AllocationMethod::kStratifiedBlocks || method == AllocationMethod::kMinimisation) {
      plan.factors = {"sex", "level"};
    }
    return plan;
  }
  [[nodiscard]] std::map<std::string, std::size_t> groupSizes() {
    std::map<std::string, std::size_t> sizes;
    for (const Enrolment& enrolment : enrolments(centre.as("allocator"), cohortId)) {
      ++sizes[enrolment.groupCode];
    }
    return sizes;
  }
};

TEST(AllocationService, EveryMethodAllocatesEvenlyAndCanBeReplayedFromTheSeed) {
  for (const AllocationMethod method :
       {AllocationMethod::kCompletePermutation, AllocationMethod::kPermutedBlocks,
        AllocationMethod::kStratifiedBlocks, AllocationMethod::kMinimisation}) {
    AllocationStudy study;
    SessionContext& allocator = study.centre.as("allocator");
    const AllocationDesignRow design = lockAllocation(allocator, study.plan(method));

    EXPECT_EQ(allocateAll(allocator, study.cohortId), 30U);

    const AllocationCheck check = checkAllocation(allocator, design.stored.id);
    EXPECT_TRUE(check.sound) << check.finding;
    EXPECT_EQ(check.records, 30U);
    if (method != AllocationMethod::kMinimisation) {
      EXPECT_EQ(study.groupSizes(), (std::map<std::string, std::size_t>{{"G1", 10}, {"G2", 10}, {"G3", 10}}));
    }
    EXPECT_EQ(study.centre.audited("allocation.draw"), 30);
  }
}

TEST(AllocationService, OneByOneGivesTheSameAsAllAtOnce) {
  std::vector<std::string> groups[2];
  for (const bool together : {true, false}) {
    AllocationStudy study(30, 6);  // a design is locked for the unallocated people, with their sexes and
                                   // levels
    AllocationPlan plan = study.plan(AllocationMethod::kStratifiedBlocks);
    plan.seed = 20240601;
    lockAllocation(study.centre.as("allocator"), plan);
    const std::vector<TraineeId> people(study.people.begin() + 6, study.people.end());
    if (together) {
      enrolTrainees(study.centre.as("administrator"), study.cohortId, people);
      allocateAll(study.centre.as("allocator"), study.cohortId);
    } else {
      allocateAll(study.centre.as("allocator"), study.cohortId);
      for (const std::string& person : people) {
        enrolTrainees(study.centre.as("administrator"), study.cohortId, {person});
        allocateAll(study.centre.as("allocator"), study.cohortId);
      }
    }
    SessionContext& allocator = study.centre.as("allocator");
    std::vector<Enrolment> list = enrolments(allocator, study.cohortId);
    std::sort(list.begin(), list.end(),
              [](const auto& a, const auto& b) { return a.traineeCode < b.traineeCode; });
    for (const Enrolment& enrolment : list) {
      groups[together ? 0 : 1].push_back(enrolment.groupCode);
    }
  }
  EXPECT_EQ(groups[0], groups[1]);
}

TEST(AllocationService, PermutationOfThePapersSizeMatchesTheReference) {
  AllocationStudy study;
  AllocationPlan plan = study.plan(AllocationMethod::kCompletePermutation);
  plan.seed = 20240601;
  SessionContext& allocator = study.centre.as("allocator");
  const AllocationDesignRow design = lockAllocation(allocator, plan);
  allocateAll(allocator, study.cohortId);

  std::map<std::string, std::string> groupOf;
  for (const Enrolment& e : enrolments(allocator, study.cohortId)) {
    groupOf[e.id] = e.groupCode.substr(1);
  }
  std::string arms;
  for (const AllocationEntry& record : allocations(allocator, design.stored.id)) {
    arms += groupOf[record.enrolmentId];
  }

  // Reference values of the allocation algorithm, seed 20240601, 30 persons, three arms.
  EXPECT_EQ(arms, "111223221333311211322231233321");
}

TEST(AllocationService, SeedStaysSealedUntilItIsRevealed) {
  AllocationStudy study(6);
  SessionContext& allocator = study.centre.as("allocator");
  const AllocationDesignRow design = lockAllocation(allocator, study.plan(AllocationMethod::kPermutedBlocks));

  EXPECT_TRUE(design.stored.seed.empty());
  EXPECT_EQ(design.stored.seedCommitment.size(), 64U);
  EXPECT_TRUE(allocationDesigns(allocator, study.cohortId).at(0).stored.seed.empty());
  EXPECT_THROW((void)revealSeed(allocator, design.stored.id), Error);  // there are unallocated people
  allocateAll(allocator, study.cohortId);
  const std::string seed = revealSeed(allocator, design.stored.id);

  EXPECT_EQ(allocationDesigns(allocator, study.cohortId).at(0).stored.seed, seed);
  EXPECT_EQ(study.centre.audited("allocation.reveal"), 1);
}

TEST(AllocationService, TheTrailSaysWhenTheSeedIsTakenOut) {
  AllocationStudy study(6);
  SessionContext& allocator = study.centre.as("allocator");
  const AllocationDesignRow design = lockAllocation(allocator, study.plan(AllocationMethod::kPermutedBlocks));
  EXPECT_EQ(study.centre.audited("allocation.take_seed"), 0);

  allocateAll(allocator, study.cohortId);
  EXPECT_EQ(study.centre.audited("allocation.take_seed"), 1);
  EXPECT_THROW((void)allocateAll(allocator, study.cohortId), Error);  // nobody waits
  EXPECT_EQ(study.centre.audited("allocation.take_seed"), 1);

  EXPECT_TRUE(checkAllocation(allocator, design.stored.id).sound);
  EXPECT_EQ(study.centre.audited("allocation.take_seed"), 2);
  EXPECT_EQ(study.centre.audited("allocation.check"), 1);
}

TEST(AllocationService, AReportReplaysTheAllocationOfEveryMethod) {
  for (const Term<AllocationMethod>& method : kAllocationMethods) {
    AllocationStudy study(12);
    SessionContext& allocator = study.centre.as("allocator");
    const AllocationDesignRow design = lockAllocation(allocator, study.plan(method.value));
    allocateAll(allocator, study.cohortId);
    (void)revealSeed(allocator, design.stored.id);

    const CohortInputs inputs = cohortInputs(study.centre.connection(), study.cohortId, {},
                                             readTraining(study.centre.connection(), study.cohortId));

    EXPECT_TRUE(inputs.allocation.replayed) << method.stored;
  }
}

TEST(AllocationService, TheReportKnowsWhenSomebodyWithdrew) {
  AllocationStudy study;
  SessionContext& allocator = study.centre.as("allocator");
  static_cast<void>(lockAllocation(allocator, study.plan(AllocationMethod::kStratifiedBlocks)));
  allocateAll(allocator, study.cohortId);
  const Enrolment gone = StudyRepository(study.centre.connection()).enrolments(study.cohortId).front();

  setEnrolmentState(study.centre.as("administrator"), study.cohortId, gone.id, EnrolmentState::kWithdrawn,
                    "moved away");

  const CohortInputs inputs = cohortInputs(study.centre.connection(), study.cohortId, {},
                                           readTraining(study.centre.connection(), study.cohortId));
  for (const CohortTrainee& trainee : inputs.trainees) {
    EXPECT_EQ(trainee.withdrew, trainee.code == gone.traineeCode) << trainee.code;
    EXPECT_EQ(trainee.withdrewUtc_us, trainee.withdrew ? study.centre.now_us() : 0) << trainee.code;
  }
}

TEST(AllocationService, PreviewShowsTheBalanceWithoutTheRealSeed) {
  AllocationStudy study;
  SessionContext& allocator = study.centre.as("allocator");
  const auto before = study.centre.rowCounts();

  const BalancePreview blocks = previewBalance(allocator, study.plan(AllocationMethod::kStratifiedBlocks));
  const BalancePreview simple = previewBalance(allocator, study.plan(AllocationMethod::kCompletePermutation));

  EXPECT_EQ(study.centre.rowCounts(), before);
  EXPECT_EQ(blocks.people, 30U);
  EXPECT_EQ(blocks.worstSizeDifference, 0U);
  ASSERT_EQ(blocks.levels.size(), 4U);  // two sexes, two levels
  for (std::size_t i = 0; i < blocks.levels.size(); ++i) {
    EXPECT_LT(blocks.levels[i].meanDifference, simple.levels[i].meanDifference) << blocks.levels[i].level;
  }
}

TEST(AllocationService, NamesPeopleWithMissingFactors) {
  AllocationStudy study(3);
  const PersonId extra =
      addPerson(study.centre.as("administrator"), {.fullName = "No Sex", .externalId = "X"});
  enrolTrainees(study.centre.session(), study.cohortId, {extra});
  SessionContext& allocator = study.centre.as("allocator");

  const BalancePreview preview = previewBalance(allocator, study.plan(AllocationMethod::kMinimisation));

  EXPECT_EQ(preview.missing, std::vector<std::string>{"T-04"});
  lockAllocation(allocator, study.plan(AllocationMethod::kMinimisation));
  EXPECT_THROW(allocateAll(allocator, study.cohortId), Error);
  EXPECT_EQ(study.groupSizes(), (std::map<std::string, std::size_t>{{"", 4}}));
}

TEST(AllocationService, AnOverrideIsARecordNextToTheDrawnOne) {
  AllocationStudy study(6);
  SessionContext& allocator = study.centre.as("allocator");
  const AllocationDesignRow design = lockAllocation(allocator, study.plan(AllocationMethod::kPermutedBlocks));
  allocateAll(allocator, study.cohortId);
  const AllocationEntry drawn = allocations(allocator, design.stored.id).at(0);
  std::string other;
  const CohortRow cohort = cohorts(allocator).at(0);
  for (const StudyGroup& group : cohort.groups) {
    if (group.id != drawn.groupId) {
      other = group.id;
    }
  }

  EXPECT_THROW(overrideAllocation(allocator, study.cohortId, drawn.enrolmentId, other, ""), Error);
  overrideAllocation(allocator, study.cohortId, drawn.enrolmentId, other, "allergic to the device's glove");

  const AllocationCheck check = checkAllocation(allocator, design.stored.id);
  EXPECT_TRUE(check.sound) << check.finding;
  EXPECT_EQ(check.overrides, 1U);
  EXPECT_EQ(check.records, 7U);
  for (const Enrolment& enrolment : enrolments(allocator, study.cohortId)) {
    if (enrolment.id == drawn.enrolmentId) {
      EXPECT_EQ(enrolment.groupId, other);
    }
  }
}

TEST(AllocationService, CheckDetectsAManipulatedGroup) {
  AllocationStudy study(6);
  SessionContext& allocator = study.centre.as("allocator");
  const AllocationDesignRow design = lockAllocation(allocator, study.plan(AllocationMethod::kPermutedBlocks));
  allocateAll(allocator, study.cohortId);
  const std::vector<Enrolment> list = enrolments(allocator, study.cohortId);

  study.centre.connection().execute("UPDATE enrolment SET group_id = ?, number_in_group = 99 WHERE id = ?",
                                    {list.back().groupId, list.front().id});

  EXPECT_FALSE(checkAllocation(allocator, design.stored.id).sound);
}

TEST(AllocationService, ReplaysTheAllocationOfTheDemonstrationToo) {
  StudyCentre centre;
  const DemonstrationStudy study =
      storeDemonstrationPeople(centre.connection(), centre.session().ids(), 1, kStudyTime_us);
  SessionContext& allocator = centre.as("allocator");

  const AllocationDesignRow design = allocationDesigns(allocator, study.cohortId).at(0);
  const AllocationCheck check = checkAllocation(allocator, design.stored.id);

  EXPECT_TRUE(check.sound) << check.finding;
  EXPECT_EQ(check.records, 30U);
}

TEST(AllocationService, ASecondDesignNeedsAReasonAndKeepsExistingGroups) {
  AllocationStudy study(6);
  SessionContext& allocator = study.centre.as("allocator");
  lockAllocation(allocator, study.plan(AllocationMethod::kCompletePermutation));
  allocateAll(allocator, study.cohortId);
  const std::vector<TraineeId> later = {
      addPerson(study.centre.as("administrator"), {.fullName = "A", .externalId = "L1"}),
      addPerson(study.centre.as("administrator"), {.fullName = "B", .externalId = "L2"}),
      addPerson(study.centre.as("administrator"), {.fullName = "C", .externalId = "L3"})};
  enrolTrainees(study.centre.session(), study.cohortId, later);
  study.centre.as("allocator");

  EXPECT_THROW(allocateAll(allocator, study.cohortId), Error);  // the list is used up
  EXPECT_THROW(lockAllocation(allocator, study.plan(AllocationMethod::kPermutedBlocks)), Error);
  lockAllocation(allocator, study.plan(AllocationMethod::kPermutedBlocks), "three more came");
  allocateAll(allocator, study.cohortId);

  EXPECT_EQ(study.groupSizes(), (std::map<std::string, std::size_t>{{"G1", 3}, {"G2", 3}, {"G3", 3}}));
  for (const AllocationDesignRow& design : allocationDesigns(allocator, study.cohortId)) {
    EXPECT_TRUE(checkAllocation(allocator, design.stored.id).sound);
  }
}

}  // namespace
}  // namespace torsio
