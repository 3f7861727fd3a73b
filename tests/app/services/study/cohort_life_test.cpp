// SPDX-License-Identifier: GPL-3.0-or-later
// A cohort from draft to archive, and what is allowed at each stage. The demonstration as seen by an
// office: a cohort that followed the paper's protocol from start to end.

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <string>
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
#include "app/services/scoring/scoring_service.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/curriculum_service.h"
#include "app/services/study/day_board.h"
#include "app/services/study/day_plan.h"
#include "app/services/study/open_sheets.h"
#include "app/services/study/scoring_plan.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/trend.h"
#include "assessment/attempt/trial_listing.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/results/cohort_csv.h"
#include "db/repository/base/id_source.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {

namespace {

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
  void allocate() { centre.allocate(cohortId); }
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
                                                   .startedUtc_us = kStudyTime_us,
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
  life.centre.allocate(small);
  EXPECT_EQ(shown(), "Autumn") << "it is the larger one";

  const std::vector<DaySlot> planned =
      planDay(life.centre.as("administrator"), {.cohortId = small,
                                                .enrolmentIds = one,
                                                .places = {"Room 1"},
                                                .firstUtc_us = kStudyTime_us + 2 * kHour_us,
                                                .duration_us = kHour_us});
  EXPECT_EQ(shown(), "Volvulus") << "somebody is expected today";
  removeSlots(life.centre.as("administrator"), small, std::array{planned[0].id, planned[1].id});
  EXPECT_EQ(shown(), "Autumn");
  createAssignments(life.centre.as("administrator"), {.cohortId = small,
                                                      .occasionCodes = {"pre"},
                                                      .raterIds = life.chiefs,
                                                      .rubricRevisionId = life.rubric,
                                                      .dueUtc_us = kStudyTime_us + kHour_us});
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
  EXPECT_THROW(addCohort(session, {.name = "spring\u00A0", .groups = {{"G1", "one"}}}), Error);
  EXPECT_THROW(addCohort(session, {.name = "Autumn", .groups = {{"G1", "one"}, {"g\uFF11", "two"}}}), Error);
  EXPECT_THROW(addCohort(session, {.name = "Autumn", .groups = {{"G1", "one\x07"}}}), Error);
  EXPECT_THROW(addCohort(session, {.name = "Spring", .groups = {{"G1", "one"}}}), Error);
  renameCohort(session, life.cohortId, "Autumn 2026");

  EXPECT_EQ(life.cohort().name, "Autumn 2026");
  EXPECT_EQ(life.centre.audited("cohort.rename"), 1);
}

// A study with four occasions, from the curriculum through the scoring plan to report and export.

/// Returns the paper's protocol with additional training in every arm and a fourth occasion after it.
CurriculumVersion longerPaperProtocol(StudyCentre& centre, const Occasion& fourth,
                                      std::int64_t longer_us = 20 * kMinute_us) {
  const auto templates = curriculumTemplates(centre.assets());
  const auto paper = std::find_if(templates.begin(), templates.end(),
                                  [](const CurriculumTemplate& one) { return one.id == "paper-three-arms"; });
  CurriculumVersion content = paper->content;
  for (StudyArm& arm : content.arms) {
    arm.phases.back().duration_us += longer_us;
  }
  content.plannedOccasions.push_back({fourth.code, 40 * kMinute_us + longer_us});
  return content;
}

/// Three trainees, two chiefs, a cohort that follows the longer protocol.
struct StudyOfFour {
  StudyCentre centre;
  Occasion fourth;
  std::vector<RaterId> chiefs;
  std::string rubric;
  CohortId cohortId;

  /// `longer_us`: training between the third and fourth occasion; 0: only time passes.
  explicit StudyOfFour(const std::string& label = "after another 20 minutes",
                       std::int64_t longer_us = 20 * kMinute_us) {
    const std::vector<TraineeId> trainees = centre.addTrainees(3);
    chiefs = centre.addChiefs(2);
    rubric = centre.addPaperRubric();
    SessionContext& office = centre.as("administrator");
    fourth = addOccasion(office, label);
    const CurriculumId curriculum =
        addCurriculum(office, "Longer", "", longerPaperProtocol(centre, fourth, longer_us));
    const CurriculumVersionId version = publishCurriculum(office, curriculum, "", centre.assets());
    runCurriculum(office, version);
    cohortId = addCohort(office, {.name = "Four", .curriculumVersionId = version});
    enrolTrainees(office, cohortId, trainees);
    centre.allocate(cohortId);
  }
  /// Assigns the chiefs a sheet of every trainee at every occasion.
  ScoringPlanOutcome askAll() {
    return createAssignments(centre.as("administrator"),
                             {.cohortId = cohortId,
                              .occasionCodes = {"pre", "mid", "post", fourth.code},
                              .raterIds = chiefs,
                              .rubricRevisionId = rubric,
                              .seed = 3});
  }
  /// Submits the sheets of an occasion, or of all: 5, 6, 7 and 8 points at the four occasions.
  void submitAll(const std::string& occasionCode = {}) {
    SheetRepository sheets(centre.connection());
    const RubricRevision revision = RubricRepository(centre.connection()).revision(rubric).value();
    const Occasions occasions = occasionsOfCohort(centre.connection(), cohortId);
    for (const AssignmentStatus& status : sheets.assignments(cohortId)) {
      if (!occasionCode.empty() && status.assignment.occasionCode != occasionCode) {
        continue;
      }
      const std::size_t at = occasions.positionOf(status.assignment.occasionCode).value();
      const std::int64_t steps = 50 + 10 * static_cast<std::int64_t>(at);
      const Sheet sheet = evenSheet(revision, steps, steps);
      sheets.submit(status.assignment.id, centre.session().ids().newUuid(), sheet, "",
                    centre.session().now_us());
    }
  }
};

TEST(Occasions, AFourthOneIsSupportedByPlanReleaseReportAndExport) {
  StudyOfFour study;
  SessionContext& office = study.centre.as("administrator");

  const ScoringPlanOutcome asked = study.askAll();
  study.submitAll();
  const ScoringMatrix matrix = scoringMatrix(office, study.cohortId);
  const std::vector<ReleaseState> releases = releaseStates(office, study.cohortId);
  releaseMarks(office, study.cohortId, study.fourth.code);
  TrialDigests digests(study.centre.assets());
  const CohortInputs inputs =
      reportInputs(study.centre.as("statistician"), {.cohortId = study.cohortId}, digests);
  std::set<std::string> exported;
  for (const CohortCsvRow& row : cohortCsvRows(inputs)) {
    exported.insert(row.occasion);
  }

  EXPECT_EQ(asked.created, 4U * 3U * 2U);  // occasions, trainees, chiefs
  ASSERT_EQ(matrix.lines.size(), 12U);
  EXPECT_EQ(matrix.lines.back().occasion.label, "after another 20 minutes");
  ASSERT_EQ(releases.size(), 4U);
  EXPECT_EQ(releases.back().occasion.code, study.fourth.code);
  EXPECT_EQ(releases.back().sheets, 6U);
  EXPECT_TRUE(SheetRepository(study.centre.connection()).isReleased(study.cohortId, study.fourth.code));
  EXPECT_EQ(inputs.occasions,
            (std::vector<Text>{Text::verbatim("before"), Text::verbatim("after 20 min"),
                               Text::verbatim("after 40 min"), Text::verbatim("after 60 min")}));
  ASSERT_EQ(inputs.scores.size(), 12U);
  for (const TraineeScore& score : inputs.scores) {
    EXPECT_DOUBLE_EQ(score.score, 5.0 + static_cast<double>(score.occasion));
  }
  EXPECT_TRUE(exported.contains("after 60 min"));
}

TEST(Occasions, AFollowUpAfterTheSameTrainingIsSeparateInReportAndExport) {
  StudyOfFour study("six weeks later", 0);
  study.askAll();
  study.submitAll();

  TrialDigests digests(study.centre.assets());
  const CohortInputs inputs =
      reportInputs(study.centre.as("statistician"), {.cohortId = study.cohortId}, digests);
  const std::vector<CohortCsvRow> exported = cohortCsvRows(inputs);

  EXPECT_EQ(inputs.occasions, (std::vector<Text>{Text::verbatim("before"), Text::verbatim("after 20 min"),
                                                 Text::verbatim("after 40 min"),
                                                 Text::verbatim("%1 (%2)", Text::verbatim("after %1 min", 40),
                                                                std::string("six weeks later"))}));
  const auto scoresAt = [&](const std::string& occasion) {
    return std::count_if(exported.begin(), exported.end(), [&](const CohortCsvRow& row) {
      return row.occasion == occasion && row.statistic == "score";
    });
  };
  EXPECT_EQ(scoresAt("after 40 min"), 3);  // one per trainee
  EXPECT_EQ(scoresAt("after 40 min (six weeks later)"), 3);
}

TEST(Occasions, AFollowUpIsDueWhenTheOccasionAfterTheSameTrainingIsComplete) {
  StudyOfFour study("six weeks later", 0);
  SessionContext& office = study.centre.as("administrator");
  study.askAll();
  const std::string first = dayBoard(office, study.cohortId).rows.front().enrolmentId;
  recordExposure(office, {study.cohortId, first, "", ExposureKind::kVirtual, 0, 40 * kMinute_us, "both"});
  recordExposure(office, {study.cohortId, first, "", ExposureKind::kReal, 0, 40 * kMinute_us, "both"});

  const DayBoardRow trained = dayBoard(office, study.cohortId).rows.front();
  study.submitAll("post");
  const DayBoardRow scored = dayBoard(office, study.cohortId).rows.front();

  EXPECT_EQ(trained.occasionDue.code, "post");
  EXPECT_EQ(trained.sheetsMissing, 2U);  // of two chiefs
  EXPECT_EQ(scored.occasionDue.code, study.fourth.code);
  EXPECT_EQ(scored.sheetsMissing, 2U);
}

TEST(Occasions, OfACurriculumKeepTheirOrderAfterTheSameTraining) {
  StudyOfFour study("six weeks later", 0);

  const auto version =
      CurriculumRepository(study.centre.connection())
          .version(StudyRepository(study.centre.connection()).cohort(study.cohortId).curriculumVersionId);

  // Sorted by code, "occasion-4" would come before "post".
  ASSERT_EQ(version->plannedOccasions.size(), 4U);
  EXPECT_EQ(version->plannedOccasions[2].code, "post");
  EXPECT_EQ(version->plannedOccasions[3].code, study.fourth.code);
}

TEST(Occasions, OfAnotherStudyAreNotRequiredByThePapersProtocol) {
  StudyCentre centre;
  centre.addTrainees(1);
  const std::string version = centre.runPaperCurriculum();
  SessionContext& office = centre.as("administrator");
  const CohortId cohort = addCohort(office, {.name = "Paper", .curriculumVersionId = version});

  addOccasion(office, "six months later");

  EXPECT_EQ(knownOccasions(office).size(), 4U);
  EXPECT_EQ(occasionsOfCohort(centre.connection(), cohort).size(), 3U);
  EXPECT_EQ(releaseStates(office, cohort).size(), 3U);
}

TEST(Occasions, NeedAUniqueNameAndAreAudited) {
  StudyCentre centre;
  SessionContext& office = centre.as("administrator");

  const Occasion added = addOccasion(office, "six months later");

  EXPECT_EQ(added.code, "occasion-4");
  EXPECT_EQ(centre.audited("occasion.add"), 1);
  EXPECT_THROW(addOccasion(office, "six months later"), Error);
  EXPECT_THROW(addOccasion(office, ""), Error);
  EXPECT_EQ(addOccasion(office, "a year later").code, "occasion-5");
}

TEST(Occasions, OfACurriculumMustExistInTheRecord) {
  StudyCentre centre;
  const Occasions known = OccasionRepository(centre.connection()).all();
  const CurriculumVersion content = longerPaperProtocol(centre, {"never heard of", "", {}});

  const std::vector<CurriculumProblem> problems = curriculumProblems(content, centre.assets(), known);

  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems.front().where, Text::verbatim("occasion \"%1\"", Text::verbatim("never heard of")));
}

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
