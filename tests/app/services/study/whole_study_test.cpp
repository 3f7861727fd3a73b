// SPDX-License-Identifier: GPL-3.0-or-later
// A study from the roster to the frozen data set, through the services alone. The board of the day: phases,
// stations, alerts, swapped turns.

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/outputs/report/coded_tables.h"
#include "app/outputs/report/report_data.h"
#include "app/services/access/access_service.h"
#include "app/services/access/audit_service.h"
#include "app/services/base/csv_table.h"
#include "app/services/devices/device_readiness.h"
#include "app/services/people/consent_service.h"
#include "app/services/people/people_service.h"
#include "app/services/recording/trial_digests.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/day_board.h"
#include "app/services/study/day_plan.h"
#include "app/services/study/frozen_data.h"
#include "app/services/study/scoring_plan.h"
#include "app/services/study/study_statements.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "assessment/domain/study/station_state.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/station_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "tests/app/support/six_trainees.h"
#include "tests/app/support/study_centre.h"

namespace torsio {

namespace {

TEST(Allocation, ExportingCardsIsAudited) {
  SixTrainees study;
  EXPECT_THROW((void)takeOutCards(study.centre.as("allocator"), study.cohortId), Error);
  study.allocate();

  const std::vector<SealedCard> cards = takeOutCards(study.centre.as("allocator"), study.cohortId);

  ASSERT_EQ(cards.size(), study.enrolmentIds.size());
  EXPECT_EQ(cards.front().sequence, 1);
  EXPECT_FALSE(cards.front().groupLabel.empty());
  EXPECT_EQ(study.centre.audited("allocation.cards"), 1);
}

TEST(CohortService, RejectsTimeInAPhaseOfAnotherArmOrKind) {
  SixTrainees study;
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

TEST(CohortService, UnplannedTimeNeedsAReasonAndIsADeviation) {
  SixTrainees study;
  study.allocate();
  SessionContext& session = study.centre.as("administrator");
  int beside = 0;
  for (const EnrolmentId& id : study.enrolmentIds) {
    const StudyArm arm = study.armOf(id);
    for (const ExposureKind kind : {ExposureKind::kVirtual, ExposureKind::kReal}) {
      if (isPlanned(arm, kind)) {
        recordExposure(session, {study.cohortId, id, "", kind, 0, kMinute_us});
        continue;
      }
      ++beside;
      EXPECT_THROW(recordExposure(session, {study.cohortId, id, "", kind, 0, kMinute_us}), Error);
      recordExposure(session, {study.cohortId, id, "", kind, 0, kMinute_us, "the simulator failed"});
    }
    EXPECT_TRUE(isPlanned(arm, ExposureKind::kRest));
  }
  EXPECT_EQ(study.centre.audited("exposure.record"), 12);

  EXPECT_EQ(beside, 4) << "two of three groups train in one way only";
  const std::vector<ProtocolDeviation> noted = deviations(session, study.cohortId);
  ASSERT_EQ(noted.size(), 4U);
  for (const ProtocolDeviation& one : noted) {
    EXPECT_EQ(one.kind, "trained outside the plan");
    EXPECT_TRUE(one.description.starts_with("1 min on the ")) << one.description;
    EXPECT_TRUE(one.description.ends_with(": the simulator failed")) << one.description;
  }
  EXPECT_EQ(study.centre.audited("deviation.report"), 4);
  EXPECT_TRUE(isPlanned({}, ExposureKind::kReal)) << "no plan forbids nothing";
}

TEST(CohortService, UsersWithoutTheRightToAllocationsSeeNoGroups) {
  SixTrainees study;
  study.allocate();
  study.centre.connection().execute(
      "DELETE FROM role_operation WHERE role_code = 'statistician' AND operation_code = 'allocation.view'");

  for (const Enrolment& enrolment : enrolments(study.centre.as("statistician"), study.cohortId)) {
    EXPECT_TRUE(enrolment.groupCode.empty());
    EXPECT_EQ(enrolment.numberInGroup, 0);
  }
}

TEST(StudyStatements, AreKeptInEachVersionAndAudited) {
  SixTrainees study;
  SessionContext& session = study.centre.as("administrator");
  setStudyStatements(session, study.cohortId,
                     {{StudyItem::kEthics, "board of the house, 12/26"}, {StudyItem::kPlace, "Bern"}});
  setStudyStatements(session, study.cohortId, {{StudyItem::kEthics, "board of the house, 13/26"}});

  EXPECT_EQ(studyStatements(session, study.cohortId),
            (StudyStatements{{StudyItem::kEthics, "board of the house, 13/26"}}));
  EXPECT_EQ(study.centre.audited("cohort.statement"), 4);
  setStudyStatements(session, study.cohortId, {{StudyItem::kEthics, "board of the house, 13/26"}});
  EXPECT_EQ(study.centre.audited("cohort.statement"), 4) << "nothing changed";
  EXPECT_EQ(study.centre.rowCounts().at("study_statement"), 4);
  EXPECT_THROW(setStudyStatements(session, study.cohortId,
                                  {{StudyItem::kHarms, std::string(kLongestStatement + 1, 'x')}}),
               Error);
  EXPECT_TRUE(verifyAuditTrail(study.centre.connection()).empty());
  TrialDigests digests(study.centre.assets());
  EXPECT_EQ(reportInputs(session, {.cohortId = study.cohortId}, digests).statements.size(), 1U);
}

TEST(FrozenData, ShowsLaterDifferences) {
  SixTrainees study;
  study.allocate();
  SessionContext& session = study.centre.as("administrator");
  createAssignments(session, study.plan());
  study.submitAll("pre");

  EXPECT_EQ(sheetCount(session, study.cohortId).submitted, 18);
  try {
    freezeData(session, study.cohortId, "interim");
    ADD_FAILURE() << "18 of 54 sheets were frozen without a word";
  } catch (const Error& error) {
    EXPECT_EQ(error.happened(), "18 of 54 sheets that raters were asked for are in");
  }
  const FrozenRow frozen = freezeData(session, study.cohortId, "interim", {}, "the board meets");
  EXPECT_EQ(frozen.sheets.asked, 54);
  EXPECT_EQ(frozen.sheets.submitted, 18);
  EXPECT_EQ(frozen.whyIncomplete, "the board meets");
  EXPECT_EQ(frozenData(session, study.cohortId).front().sheets.submitted, 18);
  EXPECT_EQ(frozen.counts.enrolments, 6U);
  EXPECT_EQ(frozen.counts.allocations, 6U);
  EXPECT_EQ(frozen.counts.marks, 18U);
  EXPECT_TRUE(compareWithFrozen(session, frozen.id).same);
  EXPECT_THROW(freezeData(session, study.cohortId, "interim", {}, "again"), Error);
  study.submitAll("mid");

  const FrozenCheck later = compareWithFrozen(session, frozen.id);
  EXPECT_FALSE(later.same);
  ASSERT_EQ(later.differences.size(), 18U);
  EXPECT_NE(later.differences[0].str().find("was added"), std::string::npos);
  EXPECT_EQ(study.centre.audited("dataset.freeze"), 1);
}

TEST(Audit, AWholeStudyHasAnEntryForEveryChangeAndVerifies) {
  SixTrainees study;
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
  const std::map<std::string, std::string> codes = auditSubjectCodes(study.centre.as("administrator"), 0);
  for (const AuditEntry& entry : AuditRepository(study.centre.connection()).entries({.limit = 10'000})) {
    EXPECT_TRUE(codes.contains(entry.objectId) || entry.objectId.empty() || entry.objectKind == "setting" ||
                entry.objectKind == "rubric_revision" || entry.objectKind == "rater_class" ||
                entry.objectKind == "centre")
        << entry.action << ": nobody finds it by the code of a person or the name of a cohort";
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

/// Begins a trial of T-01 at this station.
TrialId begunTrial(SixTrainees& study, const std::string& station) {
  TrialHeader header;
  header.trialId = study.centre.session().ids().newUuid();
  header.traineeCode = "T-01";
  header.startedUtc_us = kStudyTime_us;
  TrialRepository(study.centre.connection(), {.station = station, .enrolmentId = study.enrolmentIds[0]})
      .begin(header);
  return header.trialId;
}

TEST(DayBoard, ShowsPhaseExposureRestAndMissingSheets) {
  SixTrainees study;
  study.allocate();
  SessionContext& session = study.centre.as("administrator");
  createAssignments(session, study.plan());
  const std::string id = study.enrolmentIds[0];
  const StudyArm arm = study.armOf(id);
  recordExposure(session,
                 {study.cohortId, id, arm.phases[0].id, exposureIn(arm.phases[0].kind), 0, 20 * kMinute_us});
  recordExposure(session, {study.cohortId, id, "", ExposureKind::kRest, 0, 2 * kMinute_us});
  reportDeviation(session, {.cohortId = study.cohortId, .enrolmentId = id, .kind = "late"});

  const DayBoard board = dayBoard(session, study.cohortId);

  ASSERT_EQ(board.rows.size(), 6U);
  const auto row = std::find_if(board.rows.begin(), board.rows.end(),
                                [&](const DayBoardRow& r) { return r.enrolmentId == id; });
  EXPECT_EQ(row->phaseLabel, arm.phases[1].label);
  EXPECT_EQ(row->progress.virtual_us + row->progress.real_us, 20 * kMinute_us);
  EXPECT_EQ(row->progress.restUsed_us, 2 * kMinute_us);
  EXPECT_EQ(row->occasionDue.code, "mid");
  EXPECT_EQ(row->sheetsMissing, 3U);
  EXPECT_EQ(row->deviations, 2U) << "late, and trained before the sheets of before were in";
  EXPECT_TRUE(row->runningTrialId.empty());
  EXPECT_TRUE(board.stations.empty());
}

TEST(DayBoard, SupportsACohortWithoutACurriculum) {
  SixTrainees study;
  SessionContext& session = study.centre.as("administrator");
  const CohortId bare = addCohort(session, {.name = "Bare", .groups = {{"G1", "one"}}});

  EXPECT_TRUE(dayBoard(session, study.cohortId).hasCurriculum);
  EXPECT_FALSE(dayBoard(session, bare).hasCurriculum);
}

TEST(DayBoard, ShowsWhoTrainsAtWhichStation) {
  SixTrainees study;
  study.allocate();
  SessionContext& session = study.centre.as("administrator");
  const TrialId trialId = begunTrial(study, "station 2");
  StationRepository(study.centre.connection())
      .heartbeat({.station = "station 2", .trialId = trialId, .heartbeatUtc_us = kStudyTime_us});

  const DayBoard board = dayBoard(session, study.cohortId);

  std::size_t running = 0;
  for (const DayBoardRow& row : board.rows) {
    if (row.runningTrialId.empty()) {
      continue;
    }
    ++running;
    EXPECT_EQ(row.traineeCode, "T-01");
    EXPECT_EQ(row.station, "station 2");
    EXPECT_EQ(row.runningSinceUtc_us, kStudyTime_us);
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

TEST(DayBoard, AlertsOfSilentStationsFirstThenOfWhatIsMissing) {
  SixTrainees study;
  SessionContext& session = study.centre.as("administrator");
  const TrialId trialId = begunTrial(study, "room 2");
  StationRepository stations(study.centre.connection());
  stations.heartbeat({.station = "room 1", .heartbeatUtc_us = kStudyTime_us});
  stations.heartbeat({.station = "room 2", .trialId = trialId, .heartbeatUtc_us = kStudyTime_us});

  DayBoard board = dayBoard(session, study.cohortId);
  board.asOfUtc_us = kStudyTime_us + kStationSilence_us;
  EXPECT_EQ(dayAlerts(board).front().kind, DayAlert::Kind::kNoGroup);  // both still answer
  board.asOfUtc_us += 1;
  const std::vector<DayAlert> alerts = dayAlerts(board);

  ASSERT_GE(alerts.size(), 3U);
  EXPECT_EQ(alerts[0].kind, DayAlert::Kind::kTrialOpen);
  EXPECT_EQ(alerts[0].subject, "T-01");
  EXPECT_EQ(alerts[0].station, "room 2");
  EXPECT_EQ(alerts[1].kind, DayAlert::Kind::kStationSilent);
  EXPECT_EQ(alerts[1].subject, "room 1");
  EXPECT_EQ(alerts.back().kind, DayAlert::Kind::kNoGroup);
  EXPECT_EQ(alerts.back().count, board.rows.size());
}

TEST(DayBoard, ReportsAnUnfitDeviceWhileItsStationAnswers) {
  SixTrainees study;
  SessionContext& session = study.centre.as("administrator");
  const DeviceReadiness unfit{
      .device = Text::verbatim("Touch"),
      .haptic = true,
      .findings = {
          {"connected", Light::kGreen, "", ""},
          {"rate", Light::kRed, Text::verbatim("%1; below %2 Hz", Text::verbatim("700 Hz"), 800), ""}}};
  StationState state{.station = "room 1", .heartbeatUtc_us = kStudyTime_us};
  storeDevice(stationDevice(unfit, kStudyTime_us - 1), state);
  StationRepository(study.centre.connection()).heartbeat(state);

  DayBoard board = dayBoard(session, study.cohortId);
  board.asOfUtc_us = kStudyTime_us;
  const std::vector<DayAlert> alerts = dayAlerts(board);

  ASSERT_EQ(storedDevice(board.stations.at(0)), stationDevice(unfit, kStudyTime_us - 1));
  EXPECT_EQ(alerts.at(0).kind, DayAlert::Kind::kDeviceUnfit);
  EXPECT_EQ(alerts.at(0).subject, "room 1");
  EXPECT_EQ(alerts.at(0).reason.str(), "700 Hz; below 800 Hz");
  EXPECT_EQ(alerts.at(0).reason.arguments().size(), 2U);  // translatable
  EXPECT_EQ(alerts.at(0).sinceUtc_us, kStudyTime_us - 1);
  board.asOfUtc_us += kStationSilence_us + 1;
  EXPECT_EQ(dayAlerts(board).at(0).kind, DayAlert::Kind::kStationSilent);
}

TEST(DayBoard, ReportsAMachineThatCutTheForceInItsLastRunToday) {
  DayBoard board;
  board.asOfUtc_us = kStudyTime_us;
  board.stations.push_back({.station = "room 1",
                            .heartbeatUtc_us = kStudyTime_us,
                            .lastHealth = ServoHealth{.priority = false, .memory = true, .forceCuts = 2},
                            .lastTicks = 60'000,
                            .lastEndedUtc_us = kStudyTime_us - 1});
  board.stations.push_back(board.stations.front());
  board.stations.back().lastHealth->forceCuts = 0;

  const std::vector<DayAlert> alerts = dayAlerts(board);

  ASSERT_EQ(alerts.size(), 1U);
  EXPECT_EQ(alerts.at(0).kind, DayAlert::Kind::kServoUneven);
  EXPECT_NE(alerts.at(0).reason.str().find("cut 2 times"), std::string::npos);
  EXPECT_NE(alerts.at(0).reason.str().find("refuses real-time priority"), std::string::npos);
  EXPECT_NE(alerts.at(0).remedy.str().find("torsio-limits.conf"), std::string::npos);
  board.asOfUtc_us += 13LL * 3600 * 1'000'000;
  for (StationState& station : board.stations) {
    station.heartbeatUtc_us = board.asOfUtc_us;
  }
  EXPECT_TRUE(dayAlerts(board).empty()) << "of another day";
}

TEST(DayBoard, RecordsASwapForBothOrForNobody) {
  SixTrainees study;
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

// The plan of a day: slots at stations and rooms, swapped with turns, overdue on the board.

class DayPlan : public ::testing::Test {
 protected:
  void SetUp() override {
    const PaperStudy study = centre.addStudy(5);
    cohort = study.cohortId;
    enrolled = study.enrolmentIds;
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
