// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/services/access/permission_calls.h"

#include <string>

#include "app/outputs/dataset/cohort_exchange.h"
#include "app/outputs/report/cell_trace.h"
#include "app/outputs/report/coded_tables.h"
#include "app/outputs/report/report_data.h"
#include "app/outputs/report/report_export.h"
#include "app/services/access/access_service.h"
#include "app/services/access/audit_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/invitations.h"
#include "app/services/access/kiosk_codes.h"
#include "app/services/access/signing.h"
#include "app/services/access/two_people.h"
#include "app/services/maintenance/copies.h"
#include "app/services/maintenance/database_maintenance.h"
#include "app/services/maintenance/demonstration_removal.h"
#include "app/services/maintenance/person_package.h"
#include "app/services/maintenance/record_restore.h"
#include "app/services/maintenance/retention.h"
#include "app/services/maintenance/server_move.h"
#include "app/services/maintenance/station_anchor.h"
#include "app/services/people/consent_service.h"
#include "app/services/people/people_service.h"
#include "app/services/people/person_requests.h"
#include "app/services/people/roster_import.h"
#include "app/services/people/roster_undo.h"
#include "app/services/recording/competence_service.h"
#include "app/services/recording/trial_digests.h"
#include "app/services/review/adjudicator.h"
#include "app/services/review/blinded_case.h"
#include "app/services/review/case_remarks.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/discrepancy_review.h"
#include "app/services/review/evaluation_form.h"
#include "app/services/review/rater_calibration.h"
#include "app/services/review/review_queue.h"
#include "app/services/review/viewing_report.h"
#include "app/services/serving/review_desk.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/campaign_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/curriculum_service.h"
#include "app/services/study/day_board.h"
#include "app/services/study/day_plan.h"
#include "app/services/study/frozen_data.h"
#include "app/services/study/live_call.h"
#include "app/services/study/paper_sheets.h"
#include "app/services/study/reassignment.h"
#include "app/services/study/reminders.h"
#include "app/services/study/rubric_service.h"
#include "app/services/study/scoring_plan.h"
#include "app/services/training/attempts.h"
#include "app/services/training/debrief.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/questions.h"
#include "app/services/training/remarks.h"
#include "app/services/training/run_session.h"
#include "app/services/training/transcript.h"
#include "app/services/training/trend.h"
#include "sim/core/clock.h"

namespace torsio {

namespace {
using O = Operation;
using Path = const std::filesystem::path&;

void takeOut(SessionContext& session, ReportIdentity identity, Path folder) {
  CohortInputs inputs;
  inputs.identity = identity;
  exportReport(session, {.cohortId = kNoSuch, .identity = identity}, inputs, ReportFormat::kCsv,
               folder / (std::string(identityCode(identity)) + " report.csv"));
}

}  // namespace

std::vector<ServiceCall> administratorCalls() {
  return {
      {O::kPractice, "setOwnPin", [](SessionContext& w, Path) { setOwnPin(w, "1"); }},
      {O::kPersonViewCoded, "people", [](SessionContext& w, Path) { (void)people(w); }},
      {O::kPersonViewIdentity, "namedPeople", [](SessionContext& w, Path) { (void)namedPeople(w); }},
      {O::kPersonEdit, "addPerson", [](SessionContext& w, Path) { (void)addPerson(w, {}); }},
      {O::kPersonEdit, "changePerson", [](SessionContext& w, Path) { changePerson(w, kNoSuch, {}, ""); }},
      {O::kPersonEdit, "setPersonState",
       [](SessionContext& w, Path) { setPersonState(w, kNoSuch, PersonState::kLeft, ""); }},
      {O::kPersonEdit, "importRoster",
       [](SessionContext& w, Path) {
         (void)importRoster(w, {}, RosterKind::kTrainees, {}, "", RosterMode::kDryRun);
       }},
      {O::kPersonEdit, "importedRosters", [](SessionContext& w, Path) { (void)importedRosters(w); }},
      {O::kPersonEdit, "takeBackRosters",
       [](SessionContext& w, Path) {
         takeBackRosters(w, std::array{std::string(kNoSuch)}, "imported by mistake");
       }},
      {O::kPersonExport, "exportPersonPackage",
       [](SessionContext& w, Path folder) {
         (void)exportPersonPackage(w, kNoSuch, folder / "package", "asked");
       }},
      {O::kPersonErase, "copiesHolding", [](SessionContext& w, Path) { (void)copiesHolding(w, kNoSuch); }},
      {O::kPersonExport, "exportPersonPackages",
       [](SessionContext& w, Path folder) {
         (void)exportPersonPackages(w, std::array{PersonId(kNoSuch)}, folder / "packages", "asked");
       }},
      {O::kPersonErase, "erasePersonRecord",
       [](SessionContext& w, Path) { erasePersonRecord(w, kNoSuch, ""); }},
      {O::kConsentRecord, "recordConsent",
       [](SessionContext& w, Path) { recordConsent(w, kNoSuch, "nothing", true, "1"); }},
      {O::kPractice, "askedConsent", [](SessionContext& w, Path folder) { (void)askedConsent(w, folder); }},
      {O::kPersonViewCoded, "consentVersions",
       [](SessionContext& w, Path folder) { (void)consentVersions(w, folder); }},
      {O::kSettingsEdit, "publishConsent",
       [](SessionContext& w, Path folder) { (void)publishConsent(w, folder, {}, "why"); }},
      {O::kReportExportCoded, "exportPeople, coded",
       [](SessionContext& w, Path folder) { (void)exportPeople(w, folder / "coded.csv", false); }},
      {O::kReportExportNamed, "exportPeople, named",
       [](SessionContext& w, Path folder) { (void)exportPeople(w, folder / "named.csv", true); }},
      {O::kUserManage, "users", [](SessionContext& w, Path) { (void)users(w); }},
      {O::kUserManage, "addUser", [](SessionContext& w, Path) { (void)addUser(w, {}); }},
      {O::kUserManage, "peopleWithoutAccount",
       [](SessionContext& w, Path) { (void)peopleWithoutAccount(w); }},
      {O::kUserManage, "addAccounts",
       [](SessionContext& w, Path) {
         std::vector<StartAccount> made;
         addAccounts(w, {}, made);
       }},
      {O::kUserManage, "setUserActive",
       [](SessionContext& w, Path) { setUserActive(w, kNoSuch, false, ""); }},
      {O::kUserManage, "makeUser", [](SessionContext& w, Path) { (void)makeUser(w, {}); }},
      {O::kUserManage, "passwordNeedsTwo", [](SessionContext& w, Path) { (void)passwordNeedsTwo(w, {}); }},
      {O::kUserManage, "openRequests", [](SessionContext& w, Path) { (void)openRequests(w); },
       O::kAllocationReveal},
      {O::kUserManage, "declineRequest", [](SessionContext& w, Path) { declineRequest(w, kNoSuch, "why"); },
       O::kAllocationReveal},
      {O::kStudySetup, "askSecondPerson, to open the allocation",
       [](SessionContext& w, Path) { (void)askSecondPerson(w, {.act = DutyAct::kRevealAllocation}); },
       O::kAllocationReveal},
      {O::kUserManage, "confirmRequest", [](SessionContext& w, Path) { (void)confirmRequest(w, kNoSuch); }},
      {O::kUserManage, "askSecondPerson, for an account",
       [](SessionContext& w, Path) { (void)askSecondPerson(w, {.subject = kNoSuch, .reason = "why"}); }},
      {O::kPersonErase, "askSecondPerson, to erase",
       [](SessionContext& w, Path) { (void)askSecondPerson(w, {.act = DutyAct::kErase}); }},
      {O::kDatabaseRestore, "askSecondPerson, to restore",
       [](SessionContext& w, Path) { (void)askSecondPerson(w, {.act = DutyAct::kRestore}); }},
      {O::kSettingsEdit, "askSecondPerson, to be one",
       [](SessionContext& w, Path) { (void)askSecondPerson(w, {.act = DutyAct::kOnePerson}); }},
      {O::kDatabaseRestore, "mayRestoreNow", [](SessionContext& w, Path) { (void)mayRestoreNow(w, {}); }},
      {O::kDatabaseRestore, "noteRestore",
       [](SessionContext& w, Path folder) { noteRestore(w, folder / kNoSuch); }},
      {O::kDatabaseRestore, "prepareServer", [](SessionContext& w, Path) { prepareServer(w, "stations"); }},
      {O::kDatabaseRestore, "copyDatabase",
       [](SessionContext& w, Path folder) {
         (void)copyDatabase(w, (folder / kNoSuch / "a.sqlite").string());
       }},
      {O::kUserManage, "resetPassword",
       [](SessionContext& w, Path) { resetPassword(w, kNoSuch, "short", ""); }},
      {O::kAuditView, "auditEntries", [](SessionContext& w, Path) { (void)auditEntries(w); }},
      {O::kAuditView, "auditEntryCount", [](SessionContext& w, Path) { (void)auditEntryCount(w, 0); }},
      {O::kAuditView, "auditSubjectCodes", [](SessionContext& w, Path) { (void)auditSubjectCodes(w, 0); }},
      {O::kAuditView, "exportAuditTrail",
       [](SessionContext& w, Path folder) { (void)exportAuditTrail(w, {}, folder / "trail.csv"); }},
      {O::kAuditView, "verifyAudit", [](SessionContext& w, Path) { (void)verifyAudit(w); }},
      {O::kAuditView, "stationHeads", [](SessionContext& w, Path) { (void)stationHeads(w); }},
      {O::kAuditView, "headNow", [](SessionContext& w, Path) { (void)headNow(w); }},
      {O::kAuditView, "keepHeadNow", [](SessionContext& w, Path) { keepHeadNow(w); }},
      {O::kAuditView, "verifyHeads", [](SessionContext& w, Path) { (void)verifyHeads(w, {}, ""); }},
      {O::kSettingsEdit, "chooseWitness",
       [](SessionContext& w, Path folder) { chooseWitness(w, folder / kNoSuch / "witness"); }},
      {O::kSettingsEdit, "makeStationKey",
       [](SessionContext& w, Path folder) { makeStationKey(w, folder / kNoSuch / "key"); }},
      {O::kSettingsEdit, "chooseStationKey",
       [](SessionContext& w, Path folder) { chooseStationKey(w, folder / kNoSuch / "key"); }},
      {O::kDatabaseBackup, "checkDatabase", [](SessionContext& w, Path) { (void)checkDatabase(w); }},
      {O::kDatabaseRestore, "othersAtWork", [](SessionContext& w, Path) { (void)othersAtWork(w); }},
      {O::kDatabaseRestore, "requireNobodyAtWork", [](SessionContext& w, Path) { requireNobodyAtWork(w); }},
      {O::kDatabaseRestore, "planRestore",
       [](SessionContext& w, Path folder) { (void)planRestore(w, folder / kNoSuch); }},
      {O::kDatabaseRestore, "prepareRestore",
       [](SessionContext& w, Path folder) { (void)prepareRestore(w, {.backup = folder / kNoSuch}); }},
      {O::kDatabaseRestore, "checkServer", [](SessionContext& w, Path) { (void)checkServer(w, {}); }},
      {O::kDatabaseRestore, "moveToServer",
       [](SessionContext& w, Path folder) { (void)moveToServer(w, {}, {}, folder); }},
      {O::kDatabaseRestore, "joinServer",
       [](SessionContext& w, Path folder) { (void)joinServer(w, {}, folder); }},
      {O::kDatabaseRestore, "switchToServer",
       [](SessionContext& w, Path) { (void)switchToServer(w, {}, {}); }},
      {O::kRetentionManage, "retentionQueue", [](SessionContext& w, Path) { (void)retentionQueue(w); }},
      {O::kRetentionManage, "lockRecords", [](SessionContext& w, Path) { lockRecords(w, {}, ""); }},
      {O::kSettingsEdit, "changeCentreSetting",
       [](SessionContext& w, Path) { changeCentreSetting(w, kSignMinutes, "-1"); }},
      {O::kSettingsEdit, "setCentreSettingNamed",
       [](SessionContext& w, Path) { setCentreSettingNamed(w, "", ""); }},
      {O::kSettingsEdit, "storedCentreSetting",
       [](SessionContext& w, Path) { (void)storedCentreSetting(w, kSignMinutes); }},
      {O::kSettingsEdit, "setCentreName", [](SessionContext& w, Path) { setCentreName(w, ""); }},
      {O::kSettingsEdit, "setCentreIdleLimits",
       [](SessionContext& w, Path) { setCentreIdleLimits(w, 0, 0); }},
      {O::kUserManage, "simulatedPerson",
       [](SessionContext& w, Path) { (void)simulatedPerson(w, SimulatedRole::kPhysician); }},
      {O::kUserManage, "setUserRoles", [](SessionContext& w, Path) { setUserRoles(w, kNoSuch, {}, ""); }},
      {O::kAuditView, "auditActors", [](SessionContext& w, Path) { (void)auditActors(w); }},
      {O::kPersonViewCoded, "consentHistory",
       [](SessionContext& w, Path) { (void)consentHistory(w, kNoSuch); }},
      {O::kPersonEdit, "personEntry", [](SessionContext& w, Path) { (void)personEntry(w, kNoSuch); }},
      {O::kPersonEdit, "ensureRaterClasses", [](SessionContext& w, Path) { ensureRaterClasses(w); }},
      {O::kPersonEdit, "previewRoster",
       [](SessionContext& w, Path) { (void)previewRoster(w, {}, RosterKind::kTrainees, {}); }},
      {O::kDatabaseBackup, "backUpDatabase",
       [](SessionContext& w, Path folder) { backUpDatabase(w, folder / "backup.sqlite"); }},
      {O::kPersonErase, "demonstrationSize", [](SessionContext& w, Path) { (void)demonstrationSize(w); }},
      {O::kPersonErase, "removeDemonstrationData",
       [](SessionContext& w, Path) { removeDemonstrationData(w, "why"); }},
      {O::kPersonErase, "eraseDue", [](SessionContext& w, Path) { (void)eraseDue(w, {}, "why", false); }},
      {O::kRetentionManage, "eraseDue, on trial",
       [](SessionContext& w, Path) { (void)eraseDue(w, {}, "", true); }},
      {O::kRetentionManage, "retentionRules", [](SessionContext& w, Path) { (void)retentionRules(w); }},
      {O::kRetentionManage, "removeRetentionRule",
       [](SessionContext& w, Path) { removeRetentionRule(w, kNoSuch); }},
      {O::kRetentionManage, "setRetentionRule",
       [](SessionContext& w, Path) { setRetentionRule(w, kNoSuch, 30, "law"); }},
      {O::kRetentionManage, "extendRecords", [](SessionContext& w, Path) { extendRecords(w, {}, 0, "why"); }},
      {O::kRetentionManage, "releaseRecords", [](SessionContext& w, Path) { releaseRecords(w, {}, ""); }},
  };
}

std::vector<ServiceCall> studyCalls() {
  return {
      {O::kTrialViewCoded, "exportRecordings",
       [](SessionContext& w, Path folder) { (void)exportRecordings(w, kNoSuch, folder / "trials.csv"); }},
      {O::kMarkViewCoded, "exportMarks",
       [](SessionContext& w, Path folder) { (void)exportMarks(w, kNoSuch, folder / "marks.csv"); }},
      {O::kMarkViewCoded, "exportCriteria",
       [](SessionContext& w, Path folder) { (void)exportCriteria(w, kNoSuch, folder / "criteria.csv"); }},
      {O::kMarkViewCoded, "exportRubrics",
       [](SessionContext& w, Path folder) { (void)exportRubrics(w, kNoSuch, folder / "rubrics.csv"); }},
      {O::kMarkRelease, "releaseStates", [](SessionContext& w, Path) { (void)releaseStates(w, kNoSuch); }},
      {O::kMarkRelease, "releaseMarks", [](SessionContext& w, Path) { releaseMarks(w, kNoSuch, "never"); }},
      {O::kMarkRelease, "retractMarks",
       [](SessionContext& w, Path) { retractMarks(w, kNoSuch, "pre", "why"); }},
      {O::kEvaluationSetup, "campaigns", [](SessionContext& w, Path) { (void)campaigns(w); }},
      {O::kEvaluationSetup, "evaluationRecordings",
       [](SessionContext& w, Path) { (void)evaluationRecordings(w); }},
      {O::kEvaluationSetup, "addCampaign", [](SessionContext& w, Path) { (void)addCampaign(w, {}); }},
      {O::kPersonViewCoded, "cohorts", [](SessionContext& w, Path) { (void)cohorts(w); }},
      {O::kPersonViewCoded, "curricula", [](SessionContext& w, Path) { (void)curricula(w); }},
      {O::kPersonViewCoded, "publishedContent",
       [](SessionContext& w, Path) { (void)publishedContent(w, kNoSuch); }},
      {O::kCurriculumEdit, "addCurriculum", [](SessionContext& w, Path) { (void)addCurriculum(w, "", ""); }},
      {O::kPersonViewCoded, "knownOccasions", [](SessionContext& w, Path) { (void)knownOccasions(w); }},
      {O::kCurriculumEdit, "addOccasion", [](SessionContext& w, Path) { (void)addOccasion(w, ""); }},
      {O::kCurriculumEdit, "publishCurriculum",
       [](SessionContext& w, Path) { (void)publishCurriculum(w, kNoSuch, "", {}); }},
      {O::kCurriculumEdit, "runCurriculum", [](SessionContext& w, Path) { runCurriculum(w, kNoSuch); }},
      {O::kPersonViewCoded, "competenceDesigns",
       [](SessionContext& w, Path) { (void)competenceDesigns(w, kNoSuch); }},
      {O::kCurriculumEdit, "registerCompetence",
       [](SessionContext& w, Path) { (void)registerCompetence(w, {.moduleId = kNoSuch}); }},
      {O::kCurriculumEdit, "expertTolerance_deg",
       [](SessionContext& w, Path) { (void)expertTolerance_deg(w, kNoSuch, kNoSuch); }},
      {O::kCurriculumEdit, "addRubric", [](SessionContext& w, Path) { (void)addRubric(w, "", {}); }},
      {O::kStudySetup, "addCohort", [](SessionContext& w, Path) { (void)addCohort(w, {}); }},
      {O::kStudySetup, "renameCohort", [](SessionContext& w, Path) { renameCohort(w, kNoSuch, "name"); }},
      {O::kStudySetup, "setCohortState",
       [](SessionContext& w, Path) { setCohortState(w, kNoSuch, CohortState::kClosed, "why"); }},
      {O::kStudySetup, "assignCurriculum",
       [](SessionContext& w, Path) { assignCurriculum(w, kNoSuch, kNoSuch); }},
      {O::kStudySetup, "createAssignments", [](SessionContext& w, Path) { (void)createAssignments(w, {}); }},
      {O::kStudySetup, "scoringMatrix", [](SessionContext& w, Path) { (void)scoringMatrix(w, kNoSuch); }},
      {O::kStudySetup, "noteReminders",
       [](SessionContext& w, Path) { noteReminders(w, {}, ReminderWay::kCopied); }},
      {O::kStudySetup, "reassignAll", [](SessionContext& w, Path) { (void)reassignAll(w, {}, {}, "why"); }},
      {O::kStudySetup, "reportDeviation", [](SessionContext& w, Path) { (void)reportDeviation(w, {}); }},
      {O::kStudySetup, "reportDeviations", [](SessionContext& w, Path) { reportDeviations(w, {}); }},
      {O::kStudySetup, "correctDeviations",
       [](SessionContext& w, Path) { correctDeviations(w, kNoSuch, {}, "why"); }},
      {O::kAllocationRun, "takeOutCards", [](SessionContext& w, Path) { (void)takeOutCards(w, kNoSuch); }},
      {O::kStudySetup, "swapTurns",
       [](SessionContext& w, Path) { swapTurns(w, kNoSuch, kNoSuch, "other", ""); }},
      {O::kStudySetup, "checkCall", [](SessionContext& w, Path) { (void)checkCall(w, {}); }},
      {O::kStudySetup, "callTrainee", [](SessionContext& w, Path) { (void)callTrainee(w, {}); }},
      {O::kStudySetup, "endCall", [](SessionContext& w, Path) { endCall(w, kNoSuch, kNoSuch); }},
      {O::kStudySetup, "cancelCall", [](SessionContext& w, Path) { cancelCall(w, kNoSuch, kNoSuch, ""); }},
      {O::kStudySetup, "calledCases", [](SessionContext& w, Path) { (void)calledCases(w, kNoSuch); }},
      {O::kStudySetup, "enrolmentWithCode",
       [](SessionContext& w, Path) { (void)enrolmentWithCode(w, kNoSuch, ""); }},
      {O::kStudySetup, "paperCases", [](SessionContext& w, Path) { (void)paperCases(w, kNoSuch); }},
      {O::kStudySetup, "paperForm", [](SessionContext& w, Path) { (void)paperForm(w, kNoSuch); }},
      {O::kStudySetup, "enterPaperSheet",
       [](SessionContext& w, Path) { (void)enterPaperSheet(w, kNoSuch, {}); }},
      {O::kStudySetup, "paperSheets",
       [](SessionContext& w, Path) { (void)paperSheets(w, kNoSuch, kNoSuch, ""); }},
      {O::kStudySetup, "reminders", [](SessionContext& w, Path) { (void)reminders(w, kNoSuch); }},
      {O::kStudySetup, "dayBoard", [](SessionContext& w, Path) { (void)dayBoard(w, kNoSuch); }},
      {O::kStudyEnrol, "enrolTrainees", [](SessionContext& w, Path) { (void)enrolTrainees(w, kNoSuch, {}); }},
      {O::kStudyEnrol, "setEnrolmentState",
       [](SessionContext& w, Path) {
         setEnrolmentState(w, kNoSuch, kNoSuch, EnrolmentState::kCompleted, "");
       }},
      {O::kAllocationRun, "previewBalance", [](SessionContext& w, Path) { (void)previewBalance(w, {}); }},
      {O::kAllocationRun, "lockAllocation", [](SessionContext& w, Path) { (void)lockAllocation(w, {}); }},
      {O::kAllocationRun, "allocateAll", [](SessionContext& w, Path) { (void)allocateAll(w, kNoSuch); }},
      {O::kAllocationRun, "overrideAllocation",
       [](SessionContext& w, Path) { (void)overrideAllocation(w, kNoSuch, kNoSuch, kNoSuch, "why"); }},
      {O::kAllocationView, "allocationDesigns",
       [](SessionContext& w, Path) { (void)allocationDesigns(w, kNoSuch); }},
      {O::kAllocationView, "checkAllocation",
       [](SessionContext& w, Path) { (void)checkAllocation(w, kNoSuch); }},
      {O::kAllocationReveal, "revealSeed", [](SessionContext& w, Path) { (void)revealSeed(w, kNoSuch); }},
      {O::kResultsCompute, "freezeData", [](SessionContext& w, Path) { (void)freezeData(w, kNoSuch, ""); }},
      {O::kResultsCompute, "frozenData", [](SessionContext& w, Path) { (void)frozenData(w, kNoSuch); }},
      {O::kAllocationView, "allocations", [](SessionContext& w, Path) { (void)allocations(w, kNoSuch); }},
      {O::kPersonViewCoded, "enrolments", [](SessionContext& w, Path) { (void)enrolments(w, kNoSuch); }},
      {O::kPersonViewCoded, "deviations", [](SessionContext& w, Path) { (void)deviations(w, kNoSuch); }},
      {O::kPersonViewCoded, "rubrics", [](SessionContext& w, Path) { (void)rubrics(w); }},
      {O::kCurriculumEdit, "curriculumDraft",
       [](SessionContext& w, Path) { (void)curriculumDraft(w, kNoSuch); }},
      {O::kCurriculumEdit, "saveCurriculumDraft",
       [](SessionContext& w, Path) { saveCurriculumDraft(w, kNoSuch, {}); }},
      {O::kCurriculumEdit, "closeCurriculum",
       [](SessionContext& w, Path) { closeCurriculum(w, kNoSuch, "why"); }},
      {O::kCurriculumEdit, "reviseRubric",
       [](SessionContext& w, Path) { (void)reviseRubric(w, kNoSuch, {}, "why"); }},
      {O::kResultsCompute, "compareWithFrozen",
       [](SessionContext& w, Path) { (void)compareWithFrozen(w, kNoSuch); }},
  };
}

std::vector<ServiceCall> reportingCalls() {
  return {
      {O::kResultsCompute, "reportableCampaigns",
       [](SessionContext& w, Path) { (void)reportableCampaigns(w); }},
      {O::kResultsCompute, "ofCohort",
       [](SessionContext& w, Path folder) { (void)TrialDigests(folder).ofCohort(w, kNoSuch); }},
      {O::kResultsCompute, "TrialDigests::competenceOf",
       [](SessionContext& w, Path folder) { (void)TrialDigests(folder).competenceOf(w, kNoSuch, {}); }},
      {O::kResultsCompute, "reportInputs",
       [](SessionContext& w, Path folder) {
         TrialDigests digests(folder);
         (void)reportInputs(w, {.cohortId = kNoSuch}, digests);
       }},
      {O::kStudySetup, "planDay", [](SessionContext& w, Path) { (void)planDay(w, {}); }},
      {O::kStudySetup, "daySlots", [](SessionContext& w, Path) { (void)daySlots(w, kNoSuch, 0, 1); }},
      {O::kStudySetup, "removeSlots", [](SessionContext& w, Path) { removeSlots(w, kNoSuch, {}); }},
      {O::kUserManage, "makeKioskCodes", [](SessionContext& w, Path) { (void)makeKioskCodes(w, {}); }},
      {O::kUserManage, "revokeKioskCodes",
       [](SessionContext& w, Path) { (void)revokeKioskCodes(w, {}, "why"); }},
      {O::kUserManage, "invite", [](SessionContext& w, Path) { (void)invite(w, {}); }},
      {O::kUserManage, "inviteOrAsk", [](SessionContext& w, Path) { (void)inviteOrAsk(w, {}, ""); }},
      {O::kUserManage, "confirmInvitation",
       [](SessionContext& w, Path) { (void)confirmInvitation(w, kNoSuch); }},
      {O::kUserManage, "askSecondPerson, to invite",
       [](SessionContext& w, Path) { (void)askSecondPerson(w, {.act = DutyAct::kInvite}); }},
      {O::kUserManage, "browserAddress", [](SessionContext& w, Path) { (void)browserAddress(w); }},
      {O::kUserManage, "revokeInvitations",
       [](SessionContext& w, Path) { (void)revokeInvitations(w, {}, "why"); }},
      {O::kUserManage, "invitationsInForce", [](SessionContext& w, Path) { (void)invitationsInForce(w); }},
      {O::kUserManage, "requireSessionsOfOthers",
       [](SessionContext& w, Path) { requireSessionsOfOthers(w); }},
      {O::kUserManage, "endBrowserSessions", [](SessionContext& w, Path) { endBrowserSessions(w, kNoSuch); }},
      {O::kUserManage, "noteEndedSessions", [](SessionContext& w, Path) { noteEndedSessions(w, kNoSuch); }},
      {O::kSettingsEdit, "setBrowserAddress",
       [](SessionContext& w, Path) { setBrowserAddress(w, "https://desk.example.org"); }},
      {O::kSettingsEdit, "mayOpenReviewDesk", [](SessionContext& w, Path) { (void)mayOpenReviewDesk(w); }},
      {O::kSettingsEdit, "openReviewDesk",
       [](SessionContext& w, Path folder) {
         (void)openReviewDesk(w, {"/nowhere", folder});
       }},
      {O::kSettingsEdit, "startReviewDesk",
       [](SessionContext& w, Path folder) {
         startReviewDesk(w, {"/nowhere", folder}, {.certificate = "without a key"});
       }},
      {O::kSettingsEdit, "stopReviewDesk",
       [](SessionContext& w, Path folder) {
         stopReviewDesk(w, {"/nowhere", folder});
       }},
      {O::kUserManage, "kioskCodesInForce", [](SessionContext& w, Path) { (void)kioskCodesInForce(w); }},
      {O::kTrialViewOwn, "requestAboutOwnRecord",
       [](SessionContext& w, Path) { requestAboutOwnRecord(w, PersonRequestKind::kExport); }},
      {O::kTrialViewOwn, "takeBackOwnRequest",
       [](SessionContext& w, Path) { takeBackOwnRequest(w, kNoSuch); }},
      {O::kTrialViewOwn, "ownRequests", [](SessionContext& w, Path) { (void)ownRequests(w); }},
      {O::kPersonExport, "personRequests", [](SessionContext& w, Path) { (void)personRequests(w); }},
      {O::kPersonExport, "answerPersonRequest",
       [](SessionContext& w, Path) { answerPersonRequest(w, kNoSuch, true, "why"); }},
      {O::kResultsCompute, "traceNumber",
       [](SessionContext& w, Path) { (void)traceNumber(w, kNoSuch, {}, "training,all"); }},
      {O::kReportExportCoded, "exportReport, coded",
       [](SessionContext& w, Path folder) { takeOut(w, ReportIdentity::kCoded, folder); }},
      {O::kReportExportNamed, "exportReport, named",
       [](SessionContext& w, Path folder) { takeOut(w, ReportIdentity::kNamed, folder); }},
      {O::kReportExportCoded, "exportReport, aggregated",
       [](SessionContext& w, Path folder) { takeOut(w, ReportIdentity::kAggregated, folder); }},
      {O::kReportExportCoded, "nameRequest",
       [](SessionContext& w, Path) {
         ExchangeRequest request;
         nameRequest(w, "no such cohort", "", request);
       }},
      {O::kReportExportCoded, "exchangeData",
       [](SessionContext& w, Path folder) {
         TrialDigests digests(folder);
         (void)exchangeData(w, {.cohortId = kNoSuch}, digests);
       }},
      {O::kReportExportCoded, "exportWorkbook",
       [](SessionContext& w, Path folder) {
         exportWorkbook(
             w, {}, [](const Text& text) { return text.str(); }, folder / "cohort.xlsx");
       }},
      {O::kReportExportCoded, "exportTables",
       [](SessionContext& w, Path folder) { exportTables(w, {}, TableFormat::kCsv, folder / "tables"); }},
      {O::kReportExportCoded, "exportDataset",
       [](SessionContext& w, Path folder) { exportDataset(w, {}, {}, folder / "dataset"); }},
      {O::kReportExportNamed, "exportGradebook",
       [](SessionContext& w, Path folder) {
         TrialDigests digests(folder);
         exportGradebook(w, {.cohortId = kNoSuch}, digests, folder / "grades.csv");
       }},
  };
}

std::vector<ServiceCall> reviewCalls() {
  return {
      {O::kTrialViewAssigned, "loadBlindedRecording",
       [](SessionContext& w, Path) { (void)loadBlindedRecording(w, kNoSuch); }},
      {O::kTrialViewAssigned, "recordingName",
       [](SessionContext& w, Path) { (void)recordingName(w, kNoSuch); }},
      {O::kTrialViewAssigned, "blindedTask", [](SessionContext& w, Path) { (void)blindedTask(w, kNoSuch); }},
      {O::kMarkSubmit, "reportViewing",
       [](SessionContext& w, Path) { (void)reportViewing(w, kNoSuch, {}, 0); }},
      {O::kMarkSubmit, "changeSubmitted",
       [](SessionContext& w, Path) { changeSubmitted(w, kNoSuch, {}, "why"); }},
      {O::kMarkSubmit, "reviewQueue", [](SessionContext& w, Path) { (void)reviewQueue(w); }},
      {O::kMarkSubmit, "openSheet", [](SessionContext& w, Path) { (void)openSheet(w, kNoSuch); }},
      {O::kMarkSubmit, "submitSheet", [](SessionContext& w, Path) { submitSheet(w, kNoSuch, {}, {}); }},
      {O::kMarkSubmit, "amendSheet", [](SessionContext& w, Path) { amendSheet(w, kNoSuch, {}, "because"); }},
      {O::kMarkSubmit, "discrepancyCases", [](SessionContext& w, Path) { (void)discrepancyCases(w); }},
      {O::kEvaluationSubmit, "evaluationForms", [](SessionContext& w, Path) { (void)evaluationForms(w); }},
      {O::kEvaluationSubmit, "loadEvaluationRecording",
       [](SessionContext& w, Path) { (void)loadEvaluationRecording(w, kNoSuch, "X"); }},
      {O::kEvaluationSubmit, "submitEvaluation",
       [](SessionContext& w, Path) { submitEvaluation(w, kNoSuch, "X"); }},
      {O::kMarkSubmit, "keepMark", [](SessionContext& w, Path) { keepMark(w, kNoSuch, ""); }},
      {O::kMarkSubmit, "moveMark", [](SessionContext& w, Path) { moveMark(w, kNoSuch, {}, "why"); }},
      {O::kMarkSubmit, "askForAdjudicator",
       [](SessionContext& w, Path) { askForAdjudicator(w, kNoSuch, "why"); }},
      {O::kMarkSubmit, "addCaseRemark", [](SessionContext& w, Path) { addCaseRemark(w, kNoSuch, {}); }},
      {O::kMarkSubmit, "editCaseRemark",
       [](SessionContext& w, Path) { editCaseRemark(w, kNoSuch, kNoSuch, "yes"); }},
      {O::kMarkSubmit, "saveSheet", [](SessionContext& w, Path) { saveSheet(w, kNoSuch, {}, {}); }},
      {O::kMarkSubmit, "blindedCase", [](SessionContext& w, Path) { (void)blindedCase(w, kNoSuch); }},
      {O::kMarkSubmit, "caseRemarks", [](SessionContext& w, Path) { (void)caseRemarks(w, kNoSuch); }},
      {O::kTrialViewAssigned, "repliesToMe", [](SessionContext& w, Path) { (void)repliesToMe(w); }},
      {O::kTrialViewAssigned, "markReplyRead", [](SessionContext& w, Path) { markReplyRead(w, kNoSuch, 1); }},
      {O::kMarkSubmit, "sheetVersions", [](SessionContext& w, Path) { (void)sheetVersions(w, kNoSuch); }},
      {O::kMarkSubmit, "keptAt", [](SessionContext& w, Path) { (void)keptAt(w); }},
      {O::kMarkSubmit, "viewingRules", [](SessionContext& w, Path) { (void)viewingRules(w); }},
      {O::kMarkSubmit, "ownSeverity", [](SessionContext& w, Path) { (void)ownSeverity(w); }},
      {O::kMarkSubmit, "liveLines", [](SessionContext& w, Path) { (void)liveLines(w); }},
      {O::kMarkSubmit, "raterCalibration", [](SessionContext& w, Path) { (void)raterCalibration(w); }},
      {O::kMarkSubmit, "scoreReferenceRun", [](SessionContext& w, Path) { scoreReferenceRun(w, 1, 50); }},
      {O::kTrialViewAssigned, "loadReferenceRun",
       [](SessionContext& w, Path) { (void)loadReferenceRun(w, 1); }},
      {O::kStudySetup, "addReferenceRuns", [](SessionContext& w, Path) { addReferenceRuns(w, {}); }},
      {O::kStudySetup, "referenceCandidates", [](SessionContext& w, Path) { (void)referenceCandidates(w); }},
      {O::kStudySetup, "withdrawReferenceRun",
       [](SessionContext& w, Path) { withdrawReferenceRun(w, kNoSuch, "why"); }},
      {O::kStudySetup, "referenceRows", [](SessionContext& w, Path) { (void)referenceRows(w); }},
      {O::kStudySetup, "adjudicatorRequests",
       [](SessionContext& w, Path) { (void)adjudicatorRequests(w, kNoSuch); }},
      {O::kStudySetup, "assignAdjudicator",
       [](SessionContext& w, Path) { (void)assignAdjudicator(w, kNoSuch, kNoSuch, kNoSuch); }},
      {O::kEvaluationSubmit, "saveEvaluationScore",
       [](SessionContext& w, Path) { saveEvaluationScore(w, kNoSuch, "X", 0, 50); }},
  };
}

std::vector<ServiceCall> trainingCalls() {
  return {
      {O::kTrialRecordOwn, "recoverInterrupted",
       [](SessionContext& w, Path) { (void)recoverInterrupted(w); }},
      {O::kTrialViewOwn, "attemptsOf", [](SessionContext& w, Path) { (void)attemptsOf(w, kNoSuch); }},
      {O::kMarkViewOwn, "scoreGap", [](SessionContext& w, Path) { (void)scoreGap(w, kNoSuch); }},
      {O::kTrialViewOwn, "debrief",
       [](SessionContext& w, Path folder) { (void)debrief(w, kNoSuch, folder); }},
      {O::kTrialViewOwn, "addBookmark",
       [](SessionContext& w, Path) { addBookmark(w, kNoSuch, 1.0, "here"); }},
      {O::kTrialViewOwn, "nextSteps", [](SessionContext& w, Path) { (void)nextSteps(w, kNoSuch); }},
      {O::kTrialViewOwn, "transcript", [](SessionContext& w, Path) { (void)transcript(w, kNoSuch); }},
      {O::kTrialViewOwn, "trend", [](SessionContext& w, Path) { (void)trend(w, kNoSuch, kNoSuch); }},
      {O::kTrialViewOwn, "ownRemarks", [](SessionContext& w, Path) { (void)ownRemarks(w); }},
      {O::kTrialViewOwn, "unreadRemarks", [](SessionContext& w, Path) { (void)unreadRemarks(w); }},
      {O::kTrialViewOwn, "markRemarkRead", [](SessionContext& w, Path) { markRemarkRead(w, kNoSuch, 1); }},
      {O::kTrialViewOwn, "editRemark", [](SessionContext& w, Path) { editRemark(w, kNoSuch, "yes"); }},
      {O::kTrialViewOwn, "replyToRemark", [](SessionContext& w, Path) { replyToRemark(w, kNoSuch, "yes"); }},
      {O::kTrialViewOwn, "selfScore", [](SessionContext& w, Path) { selfScore(w, kNoSuch, 7.0, {}); }},
      {O::kTrialViewOwn, "questionDesk", [](SessionContext& w, Path) { (void)questionDesk(w, kNoSuch); }},
      {O::kTrialViewOwn, "askPhysician",
       [](SessionContext& w, Path) { (void)askPhysician(w, kNoSuch, 1.0, kNoSuch, "why?"); }},
      {O::kTrialViewAssigned, "questionsToMe", [](SessionContext& w, Path) { (void)questionsToMe(w); }},
      {O::kTrialViewAssigned, "questionedRun",
       [](SessionContext& w, Path) { (void)questionedRun(w, kNoSuch); }},
      {O::kTrialViewAssigned, "answerQuestion",
       [](SessionContext& w, Path) { answerQuestion(w, kNoSuch, "so"); }},
      {O::kTrialViewAssigned, "editAnswer", [](SessionContext& w, Path) { editAnswer(w, kNoSuch, "so"); }},
      {O::kTrialViewOwn, "ownConsents", [](SessionContext& w, Path) { (void)ownConsents(w); }},
      {O::kTrialRecordOwn, "decideOwnConsent",
       [](SessionContext& w, Path) { decideOwnConsent(w, kNoSuch, true, "1"); }},
      {O::kPractice, "soundsAtLimit", [](SessionContext& w, Path) { (void)soundsAtLimit(w); }},
      {O::kPractice, "gradesWithMouse", [](SessionContext& w, Path) { (void)gradesWithMouse(w); }},
      {O::kTrialRecordOwn, "recordExposure", [](SessionContext& w, Path) { (void)recordExposure(w, {}); },
       O::kStudySetup},
      {O::kTrialRecordOwn, "RunSession",
       [](SessionContext& w, Path) {
         const ManualClock clock;
         const RunSession runSession(w, {}, clock);
       }},
  };
}

}  // namespace torsio
