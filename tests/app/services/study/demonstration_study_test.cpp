// SPDX-License-Identifier: GPL-3.0-or-later
// The demonstration as seen by an office: a cohort that followed the paper's protocol from start to end.
#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "app/outputs/report/report_data.h"
#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/first_run.h"
#include "app/services/demonstration/demonstration.h"
#include "app/services/demonstration/demonstration_desk.h"
#include "app/services/demonstration/demonstration_people.h"
#include "app/services/recording/competence.h"
#include "app/services/recording/competence_service.h"
#include "app/services/recording/trial_digests.h"
#include "app/services/review/review_queue.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/curriculum_service.h"
#include "app/services/study/day_board.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/trend.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/person.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/time_units.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

DemonstrationOptions shortest(const StudyCentre& centre) {
  DemonstrationOptions options;
  options.shortening = 600;  // two seconds per phase
  options.training.assets = centre.assets();
  options.example.assets = centre.assets();
  options.example.id = "stomach";
  return options;
}

void everyTrialNamesItsExerciseAndItsPhase(StudyCentre& centre) {
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
      continue;  // the instructor's example and the untwistings of another cohort
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

TEST(DemonstrationDesk, LeavesThePhysicianTenCasesToScore) {
  StudyCentre centre;
  SeededIdSource ids(1);
  static_cast<void>(storeDemonstrationPeople(centre.connection(), ids, 1, 1));
  const Scene scene = loadScene(shortest(centre).training);
  const DemonstrationDesk desk =
      storeDemonstrationDesk(centre.connection(), ids, scene, {.seed = 1, .utc_us = 1, .trial_s = 0.5});
  addUser(centre.as("administrator"), {.login = "demo.physician",
                                       .personId = desk.raterIds.front(),
                                       .roles = {"rater"},
                                       .startPassword = kStudyPassword,
                                       .demonstration = true});
  const Actor physician = simulatedPerson(centre.as("administrator"), SimulatedRole::kPhysician);
  centre.session().setActor(physician);

  const ReviewQueue queue = reviewQueue(centre.session());

  EXPECT_EQ(queue.drafts, 1U);
  EXPECT_EQ(queue.drafts + queue.waiting, 10U);
  EXPECT_EQ(queue.submitted, 4U);
  std::set<std::string> labels;
  for (const QueueLine& line : queue.lines) {
    labels.insert(line.shown.label);
  }
  EXPECT_EQ(labels.size(), queue.lines.size());
}

TEST(DemonstrationStudy, FollowsTheProtocolShownOnItsBoardInEveryTrial) {
  StudyCentre centre;
  setCentreName(centre.as("administrator"), "Skills laboratory");
  fillDemonstration(shortest(centre), centre.connection());
  EXPECT_EQ(centreSign(centre.connection()).name, "Skills laboratory");  // a demonstration does not change
                                                                         // the name

  SessionContext& session = centre.as("administrator");
  const std::vector<CohortRow> all = cohorts(session);
  ASSERT_EQ(all.size(), 2U);  // the study, and a cohort with untwistings
  EXPECT_EQ(cohortShownFirst(all), 0U) << "pages open on the study";
  const DayBoard board = dayBoard(session, all.front().cohort.id);

  // Paper section 6: ten per group; 40 min virtual, 20 + 20 min, 40 min on the real arm.
  ASSERT_EQ(board.rows.size(), 30U);
  std::map<std::string, std::int64_t> virtual_us;
  std::size_t rests = 0;
  for (const DayBoardRow& row : board.rows) {
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

  everyTrialNamesItsExerciseAndItsPhase(centre);
}

/// Gives a trainee of the record an account and signs in.
SessionContext& asTrainee(StudyCentre& centre, const std::string& code) {
  AccessRepository access(centre.connection(), PasswordCost::kTest);
  for (const Trainee& trainee : PeopleRepository(centre.connection()).trainees()) {
    if (trainee.person.code != code) {
      continue;
    }
    const UserId id = "user of " + code;
    const auto known = access.users();
    if (std::none_of(known.begin(), known.end(), [&](const UserAccount& user) { return user.id == id; })) {
      access.addUser({.id = id, .login = code, .personId = trainee.person.id, .roles = {"trainee"}},
                     kStudyPassword);
    }
    centre.session().setActor(
        {.userId = id, .login = code, .personId = trainee.person.id, .roles = {"trainee"}});
  }
  return centre.session();
}

TEST(DemonstrationStudy, ReportAndTraineesScreenAgreeForEverybody) {
  StudyCentre centre;
  DemonstrationOptions options = shortest(centre);
  options.shortening = 60;  // twenty seconds per phase: two twists
  fillDemonstration(options, centre.connection());
  // Here two good twists are enough, so that levels of every kind occur.
  const CohortRow study = cohorts(centre.as("administrator")).front();
  const auto version = CurriculumRepository(centre.connection()).version(study.cohort.curriculumVersionId);
  CompetenceRepository(centre.connection())
      .add({.moduleId = version->modules.front().id,
            .registeredUtc_us = 1,
            .tolerance_rad = 0.1,
            .limit = 0.5});
  std::size_t compared = 0;
  std::set<std::string> levels;
  for (const CohortRow& row : cohorts(centre.as("administrator"))) {
    SessionContext& administrator = centre.as("administrator");
    TrialDigests digests(centre.assets());
    const CohortInputs inputs = reportInputs(
        administrator, {.cohortId = row.cohort.id, .identity = ReportIdentity::kCoded}, digests, {});
    EXPECT_FALSE(inputs.competence.empty()) << row.cohort.name;
    for (const CohortCompetence& shown : inputs.competence) {
      SessionContext& session = asTrainee(centre, shown.trainee);
      const PersonId person = session.actor().personId;
      const NextSteps steps = nextSteps(centre.session(), person);
      const auto step = std::find_if(steps.modules.begin(), steps.modules.end(), [&](const ModuleStep& one) {
        return Text(one.module.title) == shown.exercise;
      });
      if (step == steps.modules.end()) {
        continue;  // the screen shows the trainee's latest cohort
      }
      const CompetenceVerdict own = trend(centre.session(), person, step->module.id).competence;
      EXPECT_EQ(competenceLevelText(own), shown.level) << shown.trainee;
      EXPECT_EQ(own.attempts, static_cast<std::size_t>(shown.attempts)) << shown.trainee;
      EXPECT_EQ(own.errors.falsePass, shown.falsePass) << shown.trainee;
      EXPECT_EQ(own.errors.falseFail, shown.falseFail) << shown.trainee;
      EXPECT_EQ(competenceRuleText(own), shown.design) << shown.trainee;
      levels.insert(shown.level.str());
      ++compared;
    }
  }
  EXPECT_GE(compared, 16U);
  EXPECT_GE(levels.size(), 3U);

  // The people of a cohort as experts: the bound from their mean errors.
  TrialDigests digests(centre.assets());
  std::map<std::string, std::vector<double>> errors;
  for (const TrialSummaryRow& trial : digests.ofCohort(centre.as("administrator"), study.cohort.id)) {
    for (const JudgedTwist& twist : trial.attempts) {
      errors[trial.trainee].push_back(twist.error_deg);
    }
  }
  std::vector<double> means;
  for (const auto& [code, own] : errors) {
    means.push_back(std::accumulate(own.begin(), own.end(), 0.0) / static_cast<double>(own.size()));
  }
  const ProficiencyThreshold experts =
      expertTolerance_deg(centre.as("administrator"), version->modules.front().id, study.cohort.id);
  EXPECT_EQ(experts.experts, means.size());
  EXPECT_NEAR(experts.mean,
              std::accumulate(means.begin(), means.end(), 0.0) / static_cast<double>(means.size()), 1e-9);
  EXPECT_GT(experts.toleranceBound, experts.oneDeviation);
}

}  // namespace
}  // namespace torsio
