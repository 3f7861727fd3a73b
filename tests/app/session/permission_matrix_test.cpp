// SPDX-License-Identifier: GPL-3.0-or-later
// Every role x every operation, asked by really calling the services: who has no row in role_operation is
// refused.
#include <array>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/session/access/access_service.h"
#include "app/session/access/audit_service.h"
#include "app/session/access/settings_service.h"
#include "app/session/care/database_care.h"
#include "app/session/care/person_package.h"
#include "app/session/care/retention.h"
#include "app/session/people/consent_service.h"
#include "app/session/people/people_service.h"
#include "app/session/people/roster_import.h"
#include "app/session/review/alignment.h"
#include "app/session/review/blinded_case.h"
#include "app/session/review/case_sheet.h"
#include "app/session/review/evaluation_form.h"
#include "app/session/review/review_queue.h"
#include "app/session/study/allocation_service.h"
#include "app/session/study/campaign_service.h"
#include "app/session/study/coded_records.h"
#include "app/session/study/cohort_service.h"
#include "app/session/study/curriculum_service.h"
#include "app/session/study/frozen_data.h"
#include "app/session/study/rubric_service.h"
#include "app/session/study/run_day.h"
#include "app/session/study/scoring_plan.h"
#include "app/session/training/attempts.h"
#include "app/session/training/remarks.h"
#include "app/session/training/run_session.h"
#include "db/repository/access_repository.h"
#include "sim/base/error.h"
#include "tests/app/session/office_centre.h"

namespace torsio {
namespace {

using testing::OfficeCentre;

/// One service function and the operation that it must ask for. Its arguments name nothing that exists:
/// whoever may do it gets an empty answer or is told that there is no such thing, and nothing changes.
struct Call {
  Operation operation;
  const char* name;
  std::function<void(Workplace&, const std::filesystem::path& folder)> run;
};

const std::string kNone = "none";

const std::vector<Call>& calls() {
  using O = Operation;
  using Path = const std::filesystem::path&;
  static const std::vector<Call> kCalls{
      {O::kPractice, "setOwnPin", [](Workplace& w, Path) { setOwnPin(w, "1"); }},
      {O::kTrialRecordOwn, "recoverInterrupted", [](Workplace& w, Path) { (void)recoverInterrupted(w); }},
      {O::kTrialViewOwn, "attemptsOf", [](Workplace& w, Path) { (void)attemptsOf(w, kNone); }},
      {O::kTrialViewOwn, "attemptOf", [](Workplace& w, Path) { (void)attemptOf(w, kNone); }},
      {O::kTrialViewAssigned, "loadBlindedRecording",
       [](Workplace& w, Path) { (void)loadBlindedRecording(w, kNone); }},
      {O::kTrialViewCoded, "codedTrials", [](Workplace& w, Path) { (void)codedTrials(w); }},
      {O::kMarkViewOwn, "scoreGap", [](Workplace& w, Path) { (void)scoreGap(w, kNone); }},
      {O::kMarkSubmit, "reviewQueue", [](Workplace& w, Path) { (void)reviewQueue(w); }},
      {O::kMarkSubmit, "openSheet", [](Workplace& w, Path) { (void)openSheet(w, kNone); }},
      {O::kMarkSubmit, "submitSheet", [](Workplace& w, Path) { submitSheet(w, kNone, {}, {}); }},
      {O::kMarkSubmit, "amendSheet", [](Workplace& w, Path) { amendSheet(w, kNone, {}, "because"); }},
      {O::kMarkSubmit, "alignmentCases", [](Workplace& w, Path) { (void)alignmentCases(w); }},
      {O::kMarkViewCoded, "codedMarks", [](Workplace& w, Path) { (void)codedMarks(w, kNone); }},
      {O::kMarkRelease, "releaseStates", [](Workplace& w, Path) { (void)releaseStates(w, kNone); }},
      {O::kMarkRelease, "releaseMarks", [](Workplace& w, Path) { releaseMarks(w, kNone, "never"); }},
      {O::kMarkRelease, "retractMarks", [](Workplace& w, Path) { retractMarks(w, kNone, "pre", "why"); }},
      {O::kEvaluationSubmit, "evaluationForms", [](Workplace& w, Path) { (void)evaluationForms(w); }},
      {O::kEvaluationSubmit, "submitEvaluation", [](Workplace& w, Path) { submitEvaluation(w, kNone, "X"); }},
      {O::kEvaluationSetup, "campaigns", [](Workplace& w, Path) { (void)campaigns(w); }},
      {O::kEvaluationSetup, "addCampaign", [](Workplace& w, Path) { (void)addCampaign(w, {}); }},
      {O::kPersonViewCoded, "people", [](Workplace& w, Path) { (void)people(w); }},
      {O::kPersonViewCoded, "cohorts", [](Workplace& w, Path) { (void)cohorts(w); }},
      {O::kPersonViewCoded, "curricula", [](Workplace& w, Path) { (void)curricula(w); }},
      {O::kPersonViewCoded, "consentStates", [](Workplace& w, Path) { (void)consentStates(w, kNone); }},
      {O::kPersonViewIdentity, "namedPeople", [](Workplace& w, Path) { (void)namedPeople(w); }},
      {O::kPersonViewIdentity, "identityOf", [](Workplace& w, Path) { (void)identityOf(w, kNone); }},
      {O::kPersonEdit, "addPerson", [](Workplace& w, Path) { (void)addPerson(w, {}); }},
      {O::kPersonEdit, "changePerson", [](Workplace& w, Path) { changePerson(w, kNone, {}, ""); }},
      {O::kPersonEdit, "setPersonState", [](Workplace& w, Path) { setPersonState(w, kNone, "left", ""); }},
      {O::kPersonEdit, "importRoster",
       [](Workplace& w, Path) {
         (void)importRoster(w, {}, RosterKind::kTrainees, {}, "", RosterMode::kDryRun);
       }},
      {O::kPersonExport, "exportPersonPackage",
       [](Workplace& w, Path folder) { (void)exportPersonPackage(w, kNone, folder / "package", "asked"); }},
      {O::kPersonErase, "erasePersonRecord", [](Workplace& w, Path) { erasePersonRecord(w, kNone, ""); }},
      {O::kConsentRecord, "recordConsent",
       [](Workplace& w, Path) { recordConsent(w, kNone, "nothing", true, "1"); }},
      {O::kCurriculumEdit, "addCurriculum", [](Workplace& w, Path) { (void)addCurriculum(w, "", ""); }},
      {O::kCurriculumEdit, "publishCurriculum",
       [](Workplace& w, Path) { (void)publishCurriculum(w, kNone, "", {}); }},
      {O::kCurriculumEdit, "runCurriculum", [](Workplace& w, Path) { runCurriculum(w, kNone); }},
      {O::kCurriculumEdit, "addRubric", [](Workplace& w, Path) { (void)addRubric(w, "", {}); }},
      {O::kStudySetup, "addCohort", [](Workplace& w, Path) { (void)addCohort(w, {}); }},
      {O::kStudySetup, "assignCurriculum", [](Workplace& w, Path) { assignCurriculum(w, kNone, kNone); }},
      {O::kStudySetup, "createAssignments", [](Workplace& w, Path) { (void)createAssignments(w, {}); }},
      {O::kStudySetup, "scoringMatrix", [](Workplace& w, Path) { (void)scoringMatrix(w, kNone); }},
      {O::kStudySetup, "reassign", [](Workplace& w, Path) { (void)reassign(w, kNone, kNone, "why"); }},
      {O::kStudySetup, "reportDeviation", [](Workplace& w, Path) { (void)reportDeviation(w, {}); }},
      {O::kStudySetup, "runDayBoard", [](Workplace& w, Path) { (void)runDayBoard(w, kNone); }},
      {O::kStudyEnrol, "enrolTrainees", [](Workplace& w, Path) { (void)enrolTrainees(w, kNone, {}); }},
      {O::kStudyEnrol, "setEnrolmentState",
       [](Workplace& w, Path) { setEnrolmentState(w, kNone, kNone, "completed", ""); }},
      {O::kAllocationRun, "previewBalance", [](Workplace& w, Path) { (void)previewBalance(w, {}); }},
      {O::kAllocationRun, "lockAllocation", [](Workplace& w, Path) { (void)lockAllocation(w, {}); }},
      {O::kAllocationRun, "allocateOne", [](Workplace& w, Path) { (void)allocateOne(w, kNone, kNone); }},
      {O::kAllocationRun, "allocateAll", [](Workplace& w, Path) { (void)allocateAll(w, kNone); }},
      {O::kAllocationRun, "overrideAllocation",
       [](Workplace& w, Path) { (void)overrideAllocation(w, kNone, kNone, kNone, "why"); }},
      {O::kAllocationView, "allocationDesigns",
       [](Workplace& w, Path) { (void)allocationDesigns(w, kNone); }},
      {O::kAllocationView, "checkAllocation", [](Workplace& w, Path) { (void)checkAllocation(w, kNone); }},
      {O::kAllocationReveal, "revealSeed", [](Workplace& w, Path) { (void)revealSeed(w, kNone); }},
      {O::kResultsCompute, "freezeData", [](Workplace& w, Path) { (void)freezeData(w, kNone, ""); }},
      {O::kResultsCompute, "frozenData", [](Workplace& w, Path) { (void)frozenData(w, kNone); }},
      {O::kReportExportCoded, "exportPeople, coded",
       [](Workplace& w, Path folder) { (void)exportPeople(w, folder / "coded.csv", false); }},
      {O::kReportExportNamed, "exportPeople, named",
       [](Workplace& w, Path folder) { (void)exportPeople(w, folder / "named.csv", true); }},
      {O::kUserManage, "users", [](Workplace& w, Path) { (void)users(w); }},
      {O::kUserManage, "addUser", [](Workplace& w, Path) { (void)addUser(w, {}); }},
      {O::kUserManage, "setUserActive", [](Workplace& w, Path) { setUserActive(w, kNone, false, ""); }},
      {O::kUserManage, "resetPassword", [](Workplace& w, Path) { resetPassword(w, kNone, "short", ""); }},
      {O::kAuditView, "auditEntries", [](Workplace& w, Path) { (void)auditEntries(w); }},
      {O::kAuditView, "verifyAudit", [](Workplace& w, Path) { (void)verifyAudit(w); }},
      {O::kDatabaseBackup, "checkDatabase", [](Workplace& w, Path) { (void)checkDatabase(w); }},
      // Restoring has no service yet that works for a signed-in user: the gate itself is asked.
      {O::kDatabaseRestore, "require", [](Workplace& w, Path) { w.require(O::kDatabaseRestore); }},
      {O::kRetentionManage, "retentionQueue", [](Workplace& w, Path) { (void)retentionQueue(w); }},
      {O::kRetentionManage, "lockRecord", [](Workplace& w, Path) { lockRecord(w, kNone, ""); }},
      {O::kSettingsEdit, "centreSettings", [](Workplace& w, Path) { (void)centreSettings(w); }},
      {O::kSettingsEdit, "setCentreSetting", [](Workplace& w, Path) { setCentreSetting(w, "", ""); }},
  };
  return kCalls;
}

/// Whether the matrix refused: not that there is no such thing, nor that it belongs to somebody else.
bool refused(const Call& call, Workplace& workplace, const std::filesystem::path& folder) {
  try {
    call.run(workplace, folder);
  } catch (const Error& error) {
    return error.code() == ErrorCode::kPermission && error.where() == operationCode(call.operation) &&
           error.happened() != "this belongs to somebody else";
  }
  return false;
}

TEST(PermissionMatrix, EveryOperationIsAskedForByAServiceThatIsCalledHere) {
  OfficeCentre centre;
  std::set<std::string> covered;
  for (const Call& call : calls()) covered.emplace(operationCode(call.operation));

  for (const std::string& operation : AccessRepository(centre.connection()).operations()) {
    EXPECT_TRUE(covered.contains(operation)) << operation;
  }
  EXPECT_EQ(covered.size(), kOperationCodes.size());
}

TEST(PermissionMatrix, EveryRoleMayExactlyWhatTheDatabaseSays) {
  OfficeCentre centre;
  AccessRepository access(centre.connection());
  const auto allowed = access.permissions();

  for (const std::string& role : access.roles()) {
    for (const Call& call : calls()) {
      const bool may = allowed.contains({role, std::string(operationCode(call.operation))});
      EXPECT_EQ(refused(call, centre.as(role), centre.folder()), !may)
          << role << " calls " << call.name << " (" << operationCode(call.operation) << ")";
    }
  }
}

TEST(PermissionMatrix, ARefusedCallLeavesTheRecordAsItIs) {
  OfficeCentre centre;
  AccessRepository access(centre.connection());
  const auto allowed = access.permissions();
  const auto before = centre.rowCounts();

  for (const std::string& role : access.roles()) {
    for (const Call& call : calls()) {
      if (allowed.contains({role, std::string(operationCode(call.operation))})) continue;
      (void)refused(call, centre.as(role), centre.folder());
      ASSERT_EQ(centre.rowCounts(), before) << role << " calls " << call.name;
    }
  }
}

TEST(PermissionMatrix, NobodyUnknownDisabledAndPracticeOnlyUsersAreRefusedEverything) {
  OfficeCentre centre;
  const std::string administrator = centre.as("administrator").actor().userId;
  const std::string allocator = centre.as("allocator").actor().userId;
  setUserActive(centre.as("administrator"), allocator, false, "left");
  const Actor nobody;
  const Actor unknown{"00000000-0000-4000-8000-000000000000", "ghost", "", {"administrator"}, false};
  const Actor disabled{allocator, "allocator", "", {"allocator"}, false};
  const Actor practiceOnly{administrator, "administrator", "", {"administrator"}, true};
  const auto before = centre.rowCounts();

  for (const Actor& actor : {nobody, unknown, disabled, practiceOnly}) {
    for (const Call& call : calls()) {
      if (actor.practiceOnly && call.operation == Operation::kPractice) continue;  // all that a PIN opens
      Workplace& workplace = centre.workplace();
      workplace.setActor(actor);
      EXPECT_TRUE(refused(call, workplace, centre.folder())) << actor.login << " calls " << call.name;
    }
  }
  EXPECT_EQ(centre.rowCounts(), before);
}

TEST(PermissionMatrix, ClaimedRolesDoNotCount) {
  OfficeCentre centre;
  Actor actor = centre.as("trainee").actor();
  actor.roles = {"administrator", "allocator"};
  centre.workplace().setActor(actor);

  EXPECT_THROW((void)users(centre.workplace()), Error);
  EXPECT_THROW((void)previewBalance(centre.workplace(), {}), Error);
}

TEST(PermissionMatrix, TimeOfOthersIsLoggedByTheOfficeOnly) {
  OfficeCentre centre;
  const std::string person = centre.addTrainees(2).front();
  const std::string cohort = addCohort(centre.workplace(), {.name = "C", .groups = {{"G1", "one"}}});
  const std::string enrolment = enrolTrainees(centre.workplace(), cohort, {person}).front();
  const NewExposure minute{cohort, enrolment, "", "virtual", 0, 60'000'000};

  recordExposure(centre.as("administrator"), minute);
  EXPECT_THROW(recordExposure(centre.as("trainee"), minute), Error);  // a trainee, but another one
  Actor self = centre.as("trainee").actor();
  self.personId = person;
  centre.workplace().setActor(self);
  recordExposure(centre.workplace(), minute);
  EXPECT_THROW(recordExposure(centre.as("rater"), minute), Error);
  EXPECT_EQ(centre.audited("exposure.record"), 2);
}

}  // namespace
}  // namespace torsio
