// SPDX-License-Identifier: GPL-3.0-or-later
// The demonstration as an office sees it: a cohort that followed the paper's protocol from end to end.
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "app/access/first_run.h"
#include "app/access/settings_service.h"
#include "app/demonstration/demonstration.h"
#include "app/study/cohort_service.h"
#include "app/study/curriculum_service.h"
#include "app/study/run_day.h"
#include "assessment/attempt/trial_listing.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

using testing::StudyCentre;

constexpr std::int64_t kMinute_us = 60'000'000;

DemonstrationOptions shortest(const StudyCentre& centre) {
  DemonstrationOptions options;
  options.shortening = 600;  // two seconds a phase
  options.training.assets = centre.assets();
  options.example.assets = centre.assets();
  options.example.id = "stomach";
  return options;
}

TEST(DemonstrationStudy, FollowsTheProtocolThatItsBoardShows) {
  StudyCentre centre;
  setCentreName(centre.as("administrator"), "Skills laboratory");
  fillDemonstration(shortest(centre), centre.connection());
  EXPECT_EQ(centreSign(centre.connection()).name, "Skills laboratory");  // a demonstration takes no name away

  SessionContext& session = centre.as("administrator");
  const std::vector<CohortRow> all = cohorts(session);
  ASSERT_EQ(all.size(), 2U);  // the study, and a cohort that undoes organs
  const RunDayBoard board = runDayBoard(session, all.front().cohort.id);

  // Paper section 6: ten a group; 40 min virtual, 20 + 20 min, 40 min on the real arm.
  ASSERT_EQ(board.rows.size(), 30U);
  std::map<std::string, std::int64_t> virtual_us;
  std::size_t rests = 0;
  for (const RunDayRow& row : board.rows) {
    EXPECT_TRUE(row.done) << row.traineeCode;
    EXPECT_EQ(row.occasionDue.code, "post");
    EXPECT_EQ(row.progress.virtual_us + row.progress.real_us, 40 * kMinute_us);
    virtual_us[row.groupCode] += row.progress.virtual_us;
    rests += row.progress.rests;
  }
  EXPECT_EQ(virtual_us["G1"], 400 * kMinute_us);
  EXPECT_EQ(virtual_us["G2"], 200 * kMinute_us);
  EXPECT_EQ(virtual_us["G3"], 0);
  EXPECT_EQ(rests, 15U);
}

TEST(DemonstrationStudy, EveryTrialNamesItsExerciseAndItsPhase) {
  StudyCentre centre;
  fillDemonstration(shortest(centre), centre.connection());

  const auto curriculum = curricula(centre.as("administrator"));
  ASSERT_EQ(curriculum.size(), 2U);
  for (const auto& one : curriculum) {
    EXPECT_EQ(one.versions.front().state, CurriculumState::kRunning);
    EXPECT_EQ(one.versions.front().cohorts.size(), 1U);
  }
  const Cohort study = cohorts(centre.session()).front().cohort;
  const auto version = CurriculumRepository(centre.connection()).version(study.curriculumVersionId);
  std::set<EnrolmentId> enrolled;
  for (const Enrolment& enrolment : StudyRepository(centre.connection()).enrolments(study.id)) {
    enrolled.insert(enrolment.id);
  }

  std::map<std::string, std::size_t> trials;
  for (const TrialListing& trial : TrialRepository(centre.connection()).list({})) {
    if (!enrolled.contains(trial.enrolmentId)) {
      continue;  // the instructor's example, and what another cohort undoes
    }
    EXPECT_EQ(trial.moduleId, version->modules.front().id);
    ++trials[trial.phaseId];
  }
  EXPECT_EQ(trials[version->arms[0].phases[0].id], 10U);
  EXPECT_EQ(trials[version->arms[0].phases[1].id], 10U);
  EXPECT_EQ(trials[version->arms[1].phases[0].id], 10U);
  EXPECT_TRUE(curriculumProblems(publishedContent(centre.session(), version->id), centre.assets(),
                                 OccasionRepository(centre.connection()).all())
                  .empty());
}

}  // namespace
}  // namespace torsio
