// SPDX-License-Identifier: GPL-3.0-or-later
// A study from the roster to the frozen data set, through the services alone.
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/outputs/report/coded_tables.h"
#include "app/services/access/access_service.h"
#include "app/services/access/audit_service.h"
#include "app/services/base/csv_table.h"
#include "app/services/people/consent_service.h"
#include "app/services/people/people_service.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/day_board.h"
#include "app/services/study/frozen_data.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/system/audit_verification.h"
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

TEST(FrozenData, ShowsLaterDifferences) {
  SixTrainees study;
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

}  // namespace
}  // namespace torsio
