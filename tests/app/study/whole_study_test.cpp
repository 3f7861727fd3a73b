// SPDX-License-Identifier: GPL-3.0-or-later
// A study from the roster to the frozen data set, through the services alone.
#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "app/access/access_service.h"
#include "app/base/csv_table.h"
#include "app/devices/station_device.h"
#include "app/people/consent_service.h"
#include "app/people/people_service.h"
#include "app/reporting/coded_tables.h"
#include "app/study/allocation_service.h"
#include "app/study/campaign_service.h"
#include "app/study/cohort_service.h"
#include "app/study/curriculum_service.h"
#include "app/study/frozen_data.h"
#include "app/study/reassignment.h"
#include "app/study/run_day.h"
#include "app/study/scoring_plan.h"
#include "assessment/people/audit_entry.h"
#include "assessment/rating/assignment.h"
#include "assessment/rating/campaign.h"
#include "assessment/rating/rubric.h"
#include "assessment/rating/sheet.h"
#include "assessment/study/cohort.h"
#include "assessment/study/curriculum.h"
#include "assessment/study/station_state.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/station_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/base/error.h"
#include "sim/base/ids.h"
#include "sim/base/time_units.h"
#include "sim/record/content_hash.h"
#include "sim/record/sample_codec.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

using testing::StudyCentre;

/// Six trainees in three groups who follow the paper's curriculum, three chiefs, the shipped rubric.
struct Study {
  StudyCentre centre;
  std::vector<RaterId> chiefs;
  std::string rubric;
  CohortId cohortId;
  std::vector<EnrolmentId> enrolmentIds;

  Study() {
    const std::vector<TraineeId> trainees = centre.addTrainees(6);
    chiefs = centre.addChiefs(3);
    rubric = centre.addPaperRubric();
    const std::string version = centre.runPaperCurriculum();
    cohortId = addCohort(centre.session(), {.name = "Study", .curriculumVersionId = version});
    enrolmentIds = enrolTrainees(centre.session(), cohortId, trainees);
  }
  void allocate() {
    SessionContext& allocator = centre.as("allocator");
    AllocationPlan plan;
    plan.cohortId = cohortId;
    lockAllocation(allocator, plan);
    allocateAll(allocator, cohortId);
  }
  [[nodiscard]] ScoringPlan plan() const {
    return {.cohortId = cohortId,
            .occasionCodes = {"pre", "mid", "post"},
            .raterIds = chiefs,
            .rubricRevisionId = rubric,
            .seed = 3};
  }
  [[nodiscard]] StudyArm armOf(const EnrolmentId& enrolmentId) {
    SessionContext& session = centre.as("administrator");
    const CohortRow cohort = cohorts(session).at(0);
    const auto version =
        CurriculumRepository(session.connectionWithoutRight()).version(cohort.cohort.curriculumVersionId);
    for (const Enrolment& enrolment : enrolments(session, cohortId)) {
      if (enrolment.id != enrolmentId) {
        continue;
      }
      for (const StudyGroup& group : cohort.groups) {
        for (const StudyArm& arm : version->arms) {
          if (group.id == enrolment.groupId && arm.id == group.armId) {
            return arm;
          }
        }
      }
    }
    return {};
  }
  /// Fills in and submits every open sheet as the raters would.
  void submitAll(const std::string& occasionCode) {
    SheetRepository sheets(centre.connection());
    const RubricRevision revision = sheets.revision(rubric).value();
    for (const AssignmentStatus& status : sheets.assignments(cohortId)) {
      if (status.assignment.occasionCode != occasionCode || status.state != SheetState::kOpen) {
        continue;
      }
      Sheet sheet{.overall_steps = 70};
      for (const RubricLine& row : revision.rows) {
        sheet.rows.push_back({row.code, 70, ""});
      }
      sheets.submit(status.assignment.id, centre.session().ids().newUuid(), sheet, "",
                    centre.session().now_us());
    }
  }
};

TEST(ScoringPlan, EveryRaterScoresEveryTraineeAtEveryPointOnce) {
  Study study;
  study.allocate();
  SessionContext& session = study.centre.as("administrator");

  const ScoringPlanOutcome first = createAssignments(session, study.plan());
  const ScoringPlanOutcome again = createAssignments(session, study.plan());

  EXPECT_EQ(first.created, 3U * 6U * 3U);
  EXPECT_EQ(again.created, 0U);
  EXPECT_EQ(again.already, 3U * 6U * 3U);
  const ScoringMatrix matrix = scoringMatrix(session, study.cohortId);
  ASSERT_EQ(matrix.raters.size(), 3U);
  ASSERT_EQ(matrix.lines.size(), 18U);
  for (const ScoringMatrix::Line& line : matrix.lines) {
    EXPECT_EQ(line.missing, 3U);
  }
}

TEST(ScoringPlan, LiveCasesHaveOneLabelForAllAndOrdersDiffer) {
  Study study;
  study.allocate();
  createAssignments(study.centre.as("administrator"), study.plan());

  SheetRepository sheets(study.centre.connection());
  std::map<std::string, std::set<std::string>> labelsOfCase;
  std::vector<std::vector<std::string>> orders;
  for (const std::string& chief : study.chiefs) {
    orders.emplace_back();
    for (const Assignment& one : sheets.assignmentsOf(chief)) {
      labelsOfCase[one.enrolmentId + one.occasionCode].insert(one.caseLabel);
      orders.back().push_back(one.enrolmentId + one.occasionCode);
    }
  }
  for (const auto& [key, labels] : labelsOfCase) {
    EXPECT_EQ(labels.size(), 1U);
  }
  EXPECT_NE(orders[0], orders[1]);
  EXPECT_NE(orders[1], orders[2]);
}

TEST(ScoringPlan, LabelsDoNotFollowStageOrGroup) {
  Study study;
  study.allocate();
  createAssignments(study.centre.as("administrator"), study.plan());

  // Cases of a stage, sorted by label, would stand together if labels followed the stage.
  std::vector<std::pair<std::string, std::string>> byLabel;
  for (const Assignment& one : SheetRepository(study.centre.connection()).assignmentsOf(study.chiefs[0])) {
    byLabel.emplace_back(one.caseLabel, one.occasionCode);
  }
  std::sort(byLabel.begin(), byLabel.end());
  std::size_t changes = 0;
  for (std::size_t i = 1; i < byLabel.size(); ++i) {
    changes += byLabel[i].second != byLabel[i - 1].second ? 1 : 0;
  }

  EXPECT_GT(changes, 6U);  // two if sorted by stage; about twelve of seventeen at random
}

TEST(ScoringPlan, ReassigningNeedsAReasonAndAnUnaskedRater) {
  Study study;
  SessionContext& session = study.centre.as("administrator");
  ScoringPlan plan = study.plan();
  plan.occasionCodes = {"pre"};
  plan.raterIds.pop_back();
  createAssignments(session, plan);
  const ScoringCell cell = scoringMatrix(session, study.cohortId).lines.at(0).cells.at(0);

  const std::array sheets{cell.assignmentId};
  EXPECT_THROW(reassignAll(session, sheets, study.chiefs[2], ""), Error);
  EXPECT_THROW(reassignAll(session, sheets, study.chiefs[1], "ill"), Error);

  EXPECT_EQ(reassignAll(session, sheets, study.chiefs[2], "ill").moved, 1U);

  const ScoringMatrix matrix = scoringMatrix(session, study.cohortId);
  EXPECT_EQ(matrix.raters.size(), 3U);
  EXPECT_EQ(matrix.lines.at(0).cells.at(0).state, SheetState::kWithdrawn);
  EXPECT_EQ(matrix.lines.at(0).cells.at(2).caseLabel, cell.caseLabel);
  EXPECT_EQ(study.centre.audited("assignment.reassign"), 1);
}

TEST(ScoringPlan, MarksAreReleasedWhenAllAreInOrWithAReason) {
  Study study;
  SessionContext& session = study.centre.as("administrator");
  createAssignments(session, study.plan());
  study.submitAll("pre");

  releaseMarks(session, study.cohortId, "pre");
  EXPECT_THROW(releaseMarks(session, study.cohortId, "mid"), Error);
  releaseMarks(session, study.cohortId, "mid", "two raters are ill");
  EXPECT_THROW(retractMarks(session, study.cohortId, "mid", ""), Error);
  retractMarks(session, study.cohortId, "mid", "they are back");

  const std::vector<ReleaseState> states = releaseStates(session, study.cohortId);
  ASSERT_EQ(states.size(), 3U);
  EXPECT_TRUE(states[0].released);
  EXPECT_EQ(states[0].missing, 0U);
  EXPECT_FALSE(states[1].released);
  EXPECT_EQ(states[1].missing, 18U);
  EXPECT_EQ(study.centre.audited("mark.release"), 2);
  EXPECT_EQ(study.centre.audited("mark.retract"), 1);
}

/// A recording of free practice, as the station stores it.
void storeRecording(Connection& connection, const char* id, TissueModel model) {
  TrialRepository trials(connection, {.station = "station-1"});
  Trial trial;
  trial.header.trialId = id;
  trial.header.model = model;
  trials.begin(trial.header);
  std::vector<Sample> samples(3);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].tick = static_cast<std::int64_t>(i);
  }
  trial.chunks.push_back(encodeChunk(0, samples));
  trials.append(trial.chunks.front());
  trial.summary.samples = 3;
  trial.summary.contentHash = contentHash(trial);
  trials.finish(trial.summary);
}

TEST(CampaignService, TakesOneFinishedRecordingOfEachModel) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  storeRecording(centre.connection(), "with-twist", TissueModel::kTwist);
  storeRecording(centre.connection(), "with-elements", TissueModel::kFiniteElements);
  storeRecording(centre.connection(), "with-springs", TissueModel::kMassSpring);
  CampaignPlan plan;
  plan.name = "Recorded models";
  plan.instrument = paperEvaluationInstrument();
  for (const char* raterClass : {"intern", "deputy_chief", "chief"}) {
    plan.raterIds.push_back(addPerson(
        session,
        {.fullName = "Rater", .externalId = raterClass, .trainee = false, .raterClass = raterClass}));
  }
  const auto refused = [&](std::vector<NewModel> models) {
    plan.models = std::move(models);
    try {
      addCampaign(session, plan);
    } catch (const Error& error) {
      return error.code() == ErrorCode::kBadParameter;
    }
    return false;
  };

  EXPECT_EQ(evaluationRecordings(session).size(), 3U);
  EXPECT_TRUE(refused({{"PM", "proposed", "with-twist"}, {"FEM", "finite elements"}}));
  EXPECT_TRUE(refused({{"PM", "proposed", "with-twist"}, {"FEM", "finite elements", "with-twist"}}));
  plan.models = {{"PM", "proposed", "with-twist"},
                 {"FEM", "finite elements", "with-elements"},
                 {"MSM", "mass-spring", "with-springs"}};
  addCampaign(session, plan);

  const CampaignRow row = campaigns(session).at(0);
  EXPECT_EQ(row.campaign.models[1].trialId, "with-elements");
  EXPECT_EQ(TrialRepository(centre.connection()).load("with-springs").header.model, TissueModel::kMassSpring);
}

TEST(CampaignService, OrdersAreCounterbalancedWithinEachClass) {
  StudyCentre centre;
  SessionContext& session = centre.as("administrator");
  CampaignPlan plan;
  plan.name = "Models";
  plan.instrument = paperEvaluationInstrument();
  plan.models = {{"PM", "proposed"}, {"FEM", "finite elements"}, {"MSM", "mass-spring"}};
  for (const char* raterClass : {"intern", "deputy_chief", "chief"}) {
    for (int i = 0; i < 6; ++i) {
      plan.raterIds.push_back(addPerson(session, {.fullName = "Rater",
                                                  .externalId = std::string(raterClass) + std::to_string(i),
                                                  .trainee = false,
                                                  .raterClass = raterClass}));
    }
  }

  addCampaign(session, plan);

  const CampaignRow row = campaigns(session).at(0);
  std::map<std::string, std::set<std::string>> orders;
  for (const CampaignRater& rater : row.campaign.raters) {
    orders[rater.classCode].insert(rater.modelOrder);
  }
  for (const auto& [code, seen] : orders) {
    EXPECT_EQ(seen.size(), 6U) << code;  // 3! orders, six raters
  }
  EXPECT_EQ(row.marksExpected, 18U * 3U * 9U);
  std::set<std::string> hidden;
  for (const CampaignModel& model : row.campaign.models) {
    hidden.insert(model.hiddenLabel);
  }
  EXPECT_EQ(hidden, (std::set<std::string>{"X", "Y", "Z"}));
}

TEST(CampaignService, RefusesAClassWithAWeightAndNobodyInIt) {
  StudyCentre centre;
  CampaignPlan plan;
  plan.name = "Models";
  plan.instrument = paperEvaluationInstrument();
  plan.models = {{"PM", "proposed"}, {"FEM", "finite elements"}};
  plan.raterIds = centre.addChiefs(2);

  EXPECT_THROW(addCampaign(centre.session(), plan), Error);
  plan.instrument.classes[2].weight_milli = 600;
  EXPECT_THROW(addCampaign(centre.session(), plan), Error);
  EXPECT_TRUE(campaigns(centre.session()).empty());
}

TEST(PhaseProgress, CountsNamedUnnamedAndRestTime) {
  const StudyArm arm{.restAllowance_us = 5 * kMinute_us,
                     .phases = {{"p1", PhaseKind::kVirtual, "first", 20 * kMinute_us, ""},
                                {"p2", PhaseKind::kReal, "second", 20 * kMinute_us, ""}}};
  const auto spent = [](ExposureKind kind, const char* phase, std::int64_t minutes) {
    return Exposure{.phaseId = phase, .kind = kind, .duration_us = minutes * kMinute_us};
  };
  const std::vector<Exposure> exposures{
      spent(ExposureKind::kVirtual, "p1", 12), spent(ExposureKind::kRest, "p1", 3),
      spent(ExposureKind::kVirtual, "", 8), spent(ExposureKind::kReal, "p2", 5)};

  const PhaseProgress progress = phaseProgress(arm, exposures);

  EXPECT_EQ(progress.phase, 1U);
  EXPECT_EQ(progress.inPhase_us, 5 * kMinute_us);
  EXPECT_EQ(progress.left_us, 15 * kMinute_us);
  EXPECT_EQ(progress.virtual_us, 20 * kMinute_us);
  EXPECT_EQ(progress.restUsed_us, 3 * kMinute_us);
  EXPECT_EQ(progress.restLeft_us, 0);  // the allowance may not be split
}

TEST(RunDayBoard, ShowsPhaseExposureRestAndMissingSheets) {
  Study study;
  study.allocate();
  SessionContext& session = study.centre.as("administrator");
  createAssignments(session, study.plan());
  const std::string id = study.enrolmentIds[0];
  const StudyArm arm = study.armOf(id);
  recordExposure(session,
                 {study.cohortId, id, arm.phases[0].id, exposureIn(arm.phases[0].kind), 0, 20 * kMinute_us});
  recordExposure(session, {study.cohortId, id, "", ExposureKind::kRest, 0, 2 * kMinute_us});
  reportDeviation(session, {.cohortId = study.cohortId, .enrolmentId = id, .kind = "late"});

  const RunDayBoard board = runDayBoard(session, study.cohortId);

  ASSERT_EQ(board.rows.size(), 6U);
  const auto row = std::find_if(board.rows.begin(), board.rows.end(),
                                [&](const RunDayRow& r) { return r.enrolmentId == id; });
  EXPECT_EQ(row->phaseLabel, arm.phases[1].label);
  EXPECT_EQ(row->progress.virtual_us + row->progress.real_us, 20 * kMinute_us);
  EXPECT_EQ(row->progress.restUsed_us, 2 * kMinute_us);
  EXPECT_EQ(row->occasionDue.code, "mid");
  EXPECT_EQ(row->sheetsMissing, 3U);
  EXPECT_EQ(row->deviations, 2U) << "late, and trained before the sheets of before were in";
  EXPECT_TRUE(row->runningTrialId.empty());
  EXPECT_TRUE(board.stations.empty());
}

TEST(RunDayBoard, ShowsWhoRunsAtWhichStation) {
  Study study;
  study.allocate();
  SessionContext& session = study.centre.as("administrator");
  const TrialId trialId = session.ids().newUuid();
  TrialHeader header;
  header.trialId = trialId;
  header.traineeCode = "T-01";
  header.startedUtc_us = testing::kStudyTime_us;
  TrialRepository(study.centre.connection(), {.station = "station 2", .enrolmentId = study.enrolmentIds[0]})
      .begin(header);
  StationRepository(study.centre.connection())
      .heartbeat({.station = "station 2", .trialId = trialId, .heartbeatUtc_us = testing::kStudyTime_us});

  const RunDayBoard board = runDayBoard(session, study.cohortId);

  std::size_t running = 0;
  for (const RunDayRow& row : board.rows) {
    if (row.runningTrialId.empty()) {
      continue;
    }
    ++running;
    EXPECT_EQ(row.traineeCode, "T-01");
    EXPECT_EQ(row.station, "station 2");
    EXPECT_EQ(row.runningSinceUtc_us, testing::kStudyTime_us);
  }
  EXPECT_EQ(running, 1U);
  ASSERT_EQ(board.stations.size(), 1U);
  EXPECT_EQ(board.stations[0].traineeCode, "T-01");
  const std::filesystem::path file = study.centre.folder() / "recordings.csv";
  EXPECT_EQ(exportRecordings(study.centre.as("statistician"), study.cohortId, file), 1U);
  const CsvTable table = CsvTable::read(file, {"trainee", "station", "started_utc", "end"});
  ASSERT_EQ(table.rows(), 1U);
  EXPECT_EQ(table.cell(0, "trainee"), "T-01");
  EXPECT_EQ(table.cell(0, "station"), "station 2");
  EXPECT_EQ(table.cell(0, "end"), "open");
  EXPECT_EQ(study.centre.audited("trial.export_coded"), 1);
}

TEST(RunDayBoard, WarnsOfSilentStationsFirstThenOfWhatIsMissing) {
  Study study;
  SessionContext& session = study.centre.as("administrator");
  const TrialId trialId = session.ids().newUuid();
  TrialHeader header;
  header.trialId = trialId;
  header.traineeCode = "T-01";
  header.startedUtc_us = testing::kStudyTime_us;
  TrialRepository(study.centre.connection(), {.station = "room 2", .enrolmentId = study.enrolmentIds[0]})
      .begin(header);
  StationRepository stations(study.centre.connection());
  stations.heartbeat({.station = "room 1", .heartbeatUtc_us = testing::kStudyTime_us});
  stations.heartbeat({.station = "room 2", .trialId = trialId, .heartbeatUtc_us = testing::kStudyTime_us});

  RunDayBoard board = runDayBoard(session, study.cohortId);
  board.asOfUtc_us = testing::kStudyTime_us + kStationSilence_us;
  EXPECT_EQ(runDayAlerts(board).front().kind, RunDayAlert::Kind::kNoGroup);  // both still answer
  board.asOfUtc_us += 1;
  const std::vector<RunDayAlert> alerts = runDayAlerts(board);

  ASSERT_GE(alerts.size(), 3U);
  EXPECT_EQ(alerts[0].kind, RunDayAlert::Kind::kTrialOpen);
  EXPECT_EQ(alerts[0].subject, "T-01");
  EXPECT_EQ(alerts[0].station, "room 2");
  EXPECT_EQ(alerts[1].kind, RunDayAlert::Kind::kStationSilent);
  EXPECT_EQ(alerts[1].subject, "room 1");
  EXPECT_EQ(alerts.back().kind, RunDayAlert::Kind::kNoGroup);
  EXPECT_EQ(alerts.back().count, board.rows.size());
}

TEST(RunDayBoard, TellsOfADeviceThatIsNotFitWhileItsStationAnswers) {
  Study study;
  SessionContext& session = study.centre.as("administrator");
  const DeviceReadiness unfit{
      .device = Text::verbatim("Touch"),
      .haptic = true,
      .findings = {
          {"connected", Light::kGreen, "", ""},
          {"rate", Light::kRed, Text::verbatim("%1; below %2 Hz", Text::verbatim("700 Hz"), 800), ""}}};
  StationState state{.station = "room 1", .heartbeatUtc_us = testing::kStudyTime_us};
  storeDevice(stationDevice(unfit, testing::kStudyTime_us - 1), state);
  StationRepository(study.centre.connection()).heartbeat(state);

  RunDayBoard board = runDayBoard(session, study.cohortId);
  board.asOfUtc_us = testing::kStudyTime_us;
  const std::vector<RunDayAlert> alerts = runDayAlerts(board);

  ASSERT_EQ(storedDevice(board.stations.at(0)), stationDevice(unfit, testing::kStudyTime_us - 1));
  EXPECT_EQ(alerts.at(0).kind, RunDayAlert::Kind::kDeviceUnfit);
  EXPECT_EQ(alerts.at(0).subject, "room 1");
  EXPECT_EQ(alerts.at(0).reason.str(), "700 Hz; below 800 Hz");
  EXPECT_EQ(alerts.at(0).reason.arguments().size(), 2U);  // to be read in any language
  EXPECT_EQ(alerts.at(0).sinceUtc_us, testing::kStudyTime_us - 1);
  board.asOfUtc_us += kStationSilence_us + 1;
  EXPECT_EQ(runDayAlerts(board).at(0).kind, RunDayAlert::Kind::kStationSilent);
}

TEST(RunDayBoard, TellsOfAMachineThatCutTheForceInItsLastRunToday) {
  RunDayBoard board;
  board.asOfUtc_us = testing::kStudyTime_us;
  board.stations.push_back({.station = "room 1",
                            .heartbeatUtc_us = testing::kStudyTime_us,
                            .lastHealth = ServoHealth{.priority = false, .memory = true, .forceCuts = 2},
                            .lastTicks = 60'000,
                            .lastEndedUtc_us = testing::kStudyTime_us - 1});
  board.stations.push_back(board.stations.front());
  board.stations.back().lastHealth->forceCuts = 0;

  const std::vector<RunDayAlert> alerts = runDayAlerts(board);

  ASSERT_EQ(alerts.size(), 1U);
  EXPECT_EQ(alerts.at(0).kind, RunDayAlert::Kind::kServoUneven);
  EXPECT_NE(alerts.at(0).reason.str().find("cut 2 times"), std::string::npos);
  EXPECT_NE(alerts.at(0).reason.str().find("refuses real-time priority"), std::string::npos);
  EXPECT_NE(alerts.at(0).remedy.str().find("torsio-limits.conf"), std::string::npos);
  board.asOfUtc_us += 13LL * 3600 * 1'000'000;
  for (StationState& station : board.stations) {
    station.heartbeatUtc_us = board.asOfUtc_us;
  }
  EXPECT_TRUE(runDayAlerts(board).empty()) << "of another day";
}

TEST(RunDayBoard, NotesASwapForBothOrForNobody) {
  Study study;
  SessionContext& session = study.centre.as("administrator");
  const std::string& first = study.enrolmentIds[0];
  const std::string& second = study.enrolmentIds[1];

  EXPECT_THROW(swapTurns(session, study.cohortId, first, first, "late"), Error);
  EXPECT_THROW(swapTurns(session, study.cohortId, first, "nobody", "late"), Error);
  EXPECT_TRUE(deviations(session, study.cohortId).empty());
  swapTurns(session, study.cohortId, first, second, "on call");

  const std::vector<ProtocolDeviation> noted = deviations(session, study.cohortId);
  ASSERT_EQ(noted.size(), 2U);
  for (const ProtocolDeviation& deviation : noted) {
    EXPECT_EQ(deviation.kind, "swapped");
    EXPECT_NE(deviation.description.find("on call"), std::string::npos);
    EXPECT_EQ(deviation.description.find("T-"), std::string("turn swapped with ").size());
  }
  EXPECT_NE(noted[0].enrolmentId, noted[1].enrolmentId);
}

TEST(Allocation, CardsAreTakenOutWithATrace) {
  Study study;
  EXPECT_THROW((void)takeOutCards(study.centre.as("allocator"), study.cohortId), Error);
  study.allocate();

  const std::vector<SealedCard> cards = takeOutCards(study.centre.as("allocator"), study.cohortId);

  ASSERT_EQ(cards.size(), study.enrolmentIds.size());
  EXPECT_EQ(cards.front().sequence, 1);
  EXPECT_FALSE(cards.front().groupLabel.empty());
  EXPECT_EQ(study.centre.audited("allocation.cards"), 1);
}

TEST(CohortService, RefusesTimeInAPhaseOfAnotherArmOrKind) {
  Study study;
  study.allocate();
  SessionContext& session = study.centre.as("administrator");
  const std::string id = study.enrolmentIds[0];
  const StudyArm arm = study.armOf(id);
  const ExposureKind other =
      arm.phases[0].kind == PhaseKind::kVirtual ? ExposureKind::kReal : ExposureKind::kVirtual;

  EXPECT_THROW(recordExposure(session, {study.cohortId, id, arm.phases[0].id, other, 0, kMinute_us}), Error);
  EXPECT_THROW(recordExposure(session, {study.cohortId, id, "no phase", ExposureKind::kReal, 0, kMinute_us}),
               Error);
  EXPECT_THROW(recordExposure(session, {study.cohortId, id, "", ExposureKind::kReal, 0, 0}), Error);
}

TEST(CohortService, WhoMayNotSeeTheAllocationSeesNoGroups) {
  Study study;
  study.allocate();
  study.centre.connection().execute(
      "DELETE FROM role_operation WHERE role_code = 'statistician' AND operation_code = 'allocation.view'");

  for (const Enrolment& enrolment : enrolments(study.centre.as("statistician"), study.cohortId)) {
    EXPECT_TRUE(enrolment.groupCode.empty());
    EXPECT_EQ(enrolment.numberInGroup, 0);
  }
}

TEST(FrozenData, TellsLaterWhatIsDifferent) {
  Study study;
  study.allocate();
  SessionContext& session = study.centre.as("administrator");
  createAssignments(session, study.plan());
  study.submitAll("pre");

  const FrozenRow frozen = freezeData(session, study.cohortId, "interim");
  EXPECT_EQ(frozen.counts.enrolments, 6U);
  EXPECT_EQ(frozen.counts.allocations, 6U);
  EXPECT_EQ(frozen.counts.marks, 18U);
  EXPECT_TRUE(compareWithFrozen(session, frozen.id).same);
  EXPECT_THROW(freezeData(session, study.cohortId, "interim"), Error);
  study.submitAll("mid");

  const FrozenCheck later = compareWithFrozen(session, frozen.id);
  EXPECT_FALSE(later.same);
  ASSERT_EQ(later.differences.size(), 18U);
  EXPECT_NE(later.differences[0].str().find("was added"), std::string::npos);
  EXPECT_EQ(study.centre.audited("dataset.freeze"), 1);
}

TEST(Audit, AWholeStudyLeavesAnEntryForEveryChangeAndVerifies) {
  Study study;
  study.allocate();
  SessionContext& session = study.centre.as("administrator");
  const std::string version = shippedConsent(study.centre.assets()).id;
  recordConsent(session, people(session).at(3).person.id, "training_record", true, version);
  createAssignments(session, study.plan());
  for (const std::string& enrolment : study.enrolmentIds) {
    for (const TrainingPhase& phase : study.armOf(enrolment).phases) {
      recordExposure(session,
                     {study.cohortId, enrolment, phase.id, exposureIn(phase.kind), 0, phase.duration_us});
    }
    setEnrolmentState(session, study.cohortId, enrolment, EnrolmentState::kCompleted, "");
  }
  reportDeviation(session, {.cohortId = study.cohortId, .kind = "other", .description = "power cut"});
  for (const char* point : {"pre", "mid", "post"}) {
    study.submitAll(point);
    releaseMarks(session, study.cohortId, point);
  }
  freezeData(session, study.cohortId, "final");
  exportPeople(session, study.centre.folder() / "names.csv", true);
  addUser(session, {.login = "another", .roles = {"rater"}, .startPassword = "a first word to begin"});
  revealSeed(study.centre.as("allocator"),
             allocationDesigns(study.centre.as("allocator"), study.cohortId).at(0).stored.id);

  for (const AuditFinding& finding : verifyAuditTrail(study.centre.connection())) {
    ADD_FAILURE() << finding.objectKind << " " << finding.objectId << ": " << finding.what;
  }
  const std::map<std::string, std::int64_t> expected{{"person.add", 9},
                                                     {"rubric.add", 1},
                                                     {"curriculum.add", 1},
                                                     {"curriculum.publish", 1},
                                                     {"curriculum.running", 1},
                                                     {"cohort.add", 1},
                                                     {"enrolment.add", 6},
                                                     {"allocation.lock", 1},
                                                     {"allocation.draw", 6},
                                                     {"consent.grant", 1},
                                                     {"assignment.create", 3},
                                                     {"exposure.record", 12},
                                                     {"enrolment.set_state", 6},
                                                     {"deviation.report", 1},
                                                     {"mark.submit", 54},
                                                     {"mark.release", 3},
                                                     {"dataset.freeze", 1},
                                                     {"people.export_named", 1},
                                                     {"user.add", 1},
                                                     {"allocation.reveal", 1}};
  for (const auto& [action, count] : expected) {
    EXPECT_EQ(study.centre.audited(action), count) << action;
  }
  for (const AuditEntry& entry : AuditRepository(study.centre.connection()).entries({.limit = 10'000})) {
    const std::string text = entry.oldJson + entry.newJson + entry.reason;
    EXPECT_EQ(text.find("Trainee "), std::string::npos) << entry.action;
    EXPECT_EQ(text.find("Chief "), std::string::npos) << entry.action;
    EXPECT_FALSE(entry.actor.empty());
  }
  const std::filesystem::path file = study.centre.folder() / "marks.csv";
  EXPECT_EQ(exportMarks(study.centre.as("statistician"), study.cohortId, file), 54U);
  const CsvTable table = CsvTable::read(file, {"trainee", "rater", "occasion", "score"});
  EXPECT_EQ(table.rows(), 54U);
  EXPECT_EQ(table.cell(0, "trainee").substr(0, 2), "T-");
}

}  // namespace
}  // namespace torsio
