// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/services/access/permission_calls.h"

#include <string>

#include "app/outputs/dataset/cohort_exchange.h"
#include "app/outputs/report/cell_trace.h"
#include "app/outputs/report/coded_tables.h"
#include "app/outputs/report/report_data.h"
#include "app/outputs/report/report_export.h"
#include "app/outputs/report/report_names.h"
#include "app/services/access/access_service.h"
#include "app/services/access/audit_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/invitations.h"
#include "app/services/access/kiosk_codes.h"
#include "app/services/access/moved_record.h"
#include "app/services/access/outdated_access.h"
#include "app/services/access/second_factor.h"
#include "app/services/access/two_people.h"
#include "app/services/centres/site_export.h"
#include "app/services/centres/site_pool.h"
#include "app/services/maintenance/copies.h"
#include "app/services/maintenance/database_maintenance.h"
#include "app/services/maintenance/kept_backups.h"
#include "app/services/maintenance/person_package.h"
#include "app/services/maintenance/record_restore.h"
#include "app/services/maintenance/retention.h"
#include "app/services/maintenance/server_move.h"
#include "app/services/maintenance/station_anchor.h"
#include "app/services/people/consent_service.h"
#include "app/services/people/people_service.h"
#include "app/services/people/roster_accounts.h"
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
#include "app/services/serving/review_desk.h"
#include "app/services/study/allocation_service.h"
#include "app/services/study/campaign_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/curriculum_service.h"
#include "app/services/study/day_board.h"
#include "app/services/study/day_plan.h"
#include "app/services/study/frozen_data.h"
#include "app/services/study/live_call.h"
#include "app/services/study/open_sheets.h"
#include "app/services/study/paper_sheets.h"
#include "app/services/study/rubric_service.h"
#include "app/services/study/scoring_plan.h"
#include "app/services/study/study_statements.h"
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
using W = SessionContext&;
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
      {O::kUserManage, "secondFactors", [](W w, Path) { (void)secondFactors(w); }},
      {O::kPractice, "setOwnPin", [](W w, Path) { setOwnPin(w, "1"); }},
      {O::kPersonViewCoded, "people", [](W w, Path) { (void)people(w); }},
      {O::kPersonViewIdentity, "namedPeople", [](W w, Path) { (void)namedPeople(w); }},
      {O::kPersonEdit, "addPerson", [](W w, Path) { (void)addPerson(w, {}); }},
      {O::kPersonEdit, "changePerson", [](W w, Path) { changePerson(w, kNoSuch, {}, ""); }},
      {O::kPersonEdit, "setPersonState",
       [](W w, Path) { setPersonState(w, kNoSuch, PersonState::kLeft, ""); }},
      {O::kPersonEdit, "importRoster",
       [](W w, Path) { (void)importRoster(w, {}, RosterKind::kTrainees, {}, "", RosterMode::kDryRun); }},
      {O::kPersonEdit, "importedRosters", [](W w, Path) { (void)importedRosters(w); }},
      {O::kPersonEdit, "takeBackRosters",
       [](W w, Path) { takeBackRosters(w, std::array{std::string(kNoSuch)}, "imported by mistake"); }},
      {O::kPersonExport, "exportPersonPackage",
       [](W w, Path folder) { (void)exportPersonPackage(w, kNoSuch, folder / "package", "asked"); }},
      {O::kPersonErase, "copiesHolding", [](W w, Path) { (void)copiesHolding(w, kNoSuch); }},
      {O::kPersonExport, "exportPersonPackages",
       [](W w, Path folder) {
         (void)exportPersonPackages(w, std::array{PersonId(kNoSuch)}, folder / "packages", "asked");
       }},
      {O::kPersonErase, "erasePersonRecord", [](W w, Path) { erasePersonRecord(w, kNoSuch, ""); }},
      {O::kConsentRecord, "recordConsent",
       [](W w, Path) { recordConsent(w, kNoSuch, "nothing", true, "1"); }},
      {O::kPractice, "askedConsent", [](W w, Path folder) { (void)askedConsent(w, folder); }},
      {O::kPersonViewCoded, "consentVersions", [](W w, Path folder) { (void)consentVersions(w, folder); }},
      {O::kSettingsEdit, "publishConsent",
       [](W w, Path folder) { (void)publishConsent(w, folder, {}, "why"); }},
      {O::kReportExportCoded, "exportPeople, coded",
       [](W w, Path folder) { (void)exportPeople(w, folder / "coded.csv", false); }},
      {O::kReportExportNamed, "exportPeople, named",
       [](W w, Path folder) { (void)exportPeople(w, folder / "named.csv", true); }},
      {O::kUserManage, "users", [](W w, Path) { (void)users(w); }},
      {O::kUserManage, "addUser", [](W w, Path) { (void)addUser(w, {}); }},
      {O::kUserManage, "peopleWithoutAccount", [](W w, Path) { (void)peopleWithoutAccount(w); }},
      {O::kUserManage, "addAccounts",
       [](W w, Path) {
         std::vector<StartAccount> made;
         addAccounts(w, {}, made);
       }},
      {O::kUserManage, "accountsOf", [](W w, Path) { (void)accountsOf(w, {}); }},
      {O::kUserManage, "confirmAccounts",
       [](W w, Path) {
         std::vector<StartAccount> made;
         confirmAccounts(w, {}, made);
       }},
      {O::kUserManage, "otherAdministrators", [](W w, Path) { (void)otherAdministrators(w); }},
      {O::kUserManage, "setUserActive", [](W w, Path) { setUserActive(w, kNoSuch, false, ""); }},
      {O::kUserManage, "makeUser", [](W w, Path) { (void)makeUser(w, {}); }},
      {O::kUserManage, "passwordNeedsTwo", [](W w, Path) { (void)passwordNeedsTwo(w, {}); }},
      {O::kUserManage, "openRequests", [](W w, Path) { (void)openRequests(w); }, O::kAllocationReveal},
      {O::kUserManage, "declineRequest", [](W w, Path) { declineRequest(w, kNoSuch, "why"); },
       O::kAllocationReveal},
      {O::kStudySetup, "askSecondPerson, to open the allocation",
       [](W w, Path) { (void)askSecondPerson(w, {.act = DutyAct::kRevealAllocation}); },
       O::kAllocationReveal},
      {O::kResultsCompute, "askSecondPerson, to freeze an interim state",
       [](W w, Path) { (void)askSecondPerson(w, {.act = DutyAct::kFreezeInterim}); }},
      {O::kResultsCompute, "isRequested",
       [](W w, Path) { (void)isRequested(w, {.act = DutyAct::kFreezeInterim}); }},
      {O::kUserManage, "confirmRequest", [](W w, Path) { (void)confirmRequest(w, kNoSuch); }},
      {O::kUserManage, "askSecondPerson, for an account",
       [](W w, Path) { (void)askSecondPerson(w, {.subject = kNoSuch, .reason = "why"}); }},
      {O::kPersonErase, "askSecondPerson, to erase",
       [](W w, Path) { (void)askSecondPerson(w, {.act = DutyAct::kErase}); }},
      {O::kDatabaseRestore, "askSecondPerson, to restore",
       [](W w, Path) { (void)askSecondPerson(w, {.act = DutyAct::kRestore}); }},
      {O::kSettingsEdit, "askSecondPerson, to be one",
       [](W w, Path) { (void)askSecondPerson(w, {.act = DutyAct::kOnePerson}); }},
      {O::kDatabaseRestore, "mayRestoreNow", [](W w, Path) { (void)mayRestoreNow(w, {}); }},
      {O::kDatabaseRestore, "poolSite", [](W w, Path folder) { (void)poolSite(w, folder / kNoSuch, {}); }},
      {O::kReportExportCoded, "exportSite",
       [](W w, Path folder) { (void)exportSite(w, {.out = folder / kNoSuch}); }},
      {O::kReportExportCoded, "siteStates", [](W w, Path) { (void)siteStates(w); }},
      {O::kDatabaseRestore, "noteRestore", [](W w, Path folder) { noteRestore(w, folder / kNoSuch); }},
      {O::kDatabaseRestore, "prepareServer", [](W w, Path) { prepareServer(w, "stations"); }},
      {O::kDatabaseRestore, "copyDatabase",
       [](W w, Path folder) { (void)copyDatabase(w, (folder / kNoSuch / "a.sqlite").string()); }},
      {O::kUserManage, "resetPassword", [](W w, Path) { resetPassword(w, kNoSuch, "short", ""); }},
      {O::kAuditView, "auditEntries", [](W w, Path) { (void)auditEntries(w); }},
      {O::kAuditView, "auditEntryCount", [](W w, Path) { (void)auditEntryCount(w, 0); }},
      {O::kAuditView, "auditSubjectCodes", [](W w, Path) { (void)auditSubjectCodes(w, 0); }},
      {O::kAuditView, "exportAuditTrail",
       [](W w, Path folder) { (void)exportAuditTrail(w, {}, folder / "trail.csv"); }},
      {O::kAuditView, "verifyAudit", [](W w, Path) { (void)verifyAudit(w); }},
      {O::kAuditView, "stationHeads", [](W w, Path) { (void)stationHeads(w); }},
      {O::kAuditView, "headNow", [](W w, Path) { (void)headNow(w); }},
      {O::kAuditView, "keepHeadNow", [](W w, Path) { (void)keepHeadNow(w); }},
      {O::kAuditView, "verifyHeads", [](W w, Path) { (void)verifyHeads(w, {}, ""); }},
      {O::kSettingsEdit, "setStampAuthority", [](W w, Path) { setStampAuthority(w, {}); }},
      {O::kSettingsEdit, "chooseWitness",
       [](W w, Path folder) { chooseWitness(w, folder / kNoSuch / "witness"); }},
      {O::kSettingsEdit, "makeStationKey",
       [](W w, Path folder) { makeStationKey(w, folder / kNoSuch / "key"); }},
      {O::kSettingsEdit, "chooseStationKey",
       [](W w, Path folder) { chooseStationKey(w, folder / kNoSuch / "key"); }},
      {O::kDatabaseBackup, "checkDatabase", [](W w, Path) { (void)checkDatabase(w); }},
      {O::kDatabaseRestore, "othersAtWork", [](W w, Path) { (void)othersAtWork(w); }},
      {O::kDatabaseRestore, "requireNobodyAtWork", [](W w, Path) { requireNobodyAtWork(w); }},
      {O::kDatabaseRestore, "planRestore", [](W w, Path folder) { (void)planRestore(w, folder / kNoSuch); }},
      {O::kDatabaseRestore, "prepareRestore",
       [](W w, Path folder) { (void)prepareRestore(w, {.backup = folder / kNoSuch}); }},
      {O::kDatabaseRestore, "checkServer", [](W w, Path) { (void)checkServer(w, {}); }},
      {O::kDatabaseRestore, "moveToServer", [](W w, Path folder) { (void)moveToServer(w, {}, {}, folder); }},
      {O::kDatabaseRestore, "joinServer", [](W w, Path folder) { (void)joinServer(w, {}, folder); }},
      {O::kDatabaseRestore, "switchToServer", [](W w, Path) { (void)switchToServer(w, {}, {}); }},
      {O::kRetentionManage, "retentionQueue", [](W w, Path) { (void)retentionQueue(w); }},
      {O::kRetentionManage, "lockRecords", [](W w, Path) { lockRecords(w, {}, ""); }},
      {O::kSettingsEdit, "changeCentreSetting",
       [](W w, Path) { changeCentreSetting(w, kSignMinutes, "-1"); }},
      {O::kSettingsEdit, "setCentreSettingNamed", [](W w, Path) { setCentreSettingNamed(w, "", ""); }},
      {O::kSettingsEdit, "storedCentreSetting",
       [](W w, Path) { (void)storedCentreSetting(w, kSignMinutes); }},
      {O::kSettingsEdit, "setCentreName", [](W w, Path) { setCentreName(w, ""); }},
      {O::kSettingsEdit, "setCentreIdleLimits", [](W w, Path) { setCentreIdleLimits(w, 0, 0); }},
      {O::kUserManage, "simulatedPerson",
       [](W w, Path) { (void)simulatedPerson(w, SimulatedRole::kPhysician); }},
      {O::kUserManage, "setUserRoles", [](W w, Path) { setUserRoles(w, kNoSuch, {}, ""); }},
      {O::kAuditView, "auditActors", [](W w, Path) { (void)auditActors(w); }},
      {O::kPersonViewCoded, "consentHistory", [](W w, Path) { (void)consentHistory(w, kNoSuch); }},
      {O::kPersonEdit, "personEntry", [](W w, Path) { (void)personEntry(w, kNoSuch); }},
      {O::kPersonEdit, "ensureRaterClasses", [](W w, Path) { ensureRaterClasses(w); }},
      {O::kPersonEdit, "previewRoster",
       [](W w, Path) { (void)previewRoster(w, {}, RosterKind::kTrainees, {}); }},
      {O::kDatabaseBackup, "backUpDatabase",
       [](W w, Path folder) { backUpDatabase(w, folder / "backup.sqlite"); }},
      {O::kDatabaseBackup, "keepBackup", [](W w, Path folder) { keepBackup(w, folder / "kept", {}); }},
      {O::kPersonErase, "demonstrationSize", [](W w, Path) { (void)demonstrationSize(w); }},
      {O::kPersonErase, "removeDemonstrationData", [](W w, Path) { removeDemonstrationData(w, "why"); }},
      {O::kPersonErase, "eraseDue", [](W w, Path) { (void)eraseDue(w, {}, "why", false); }},
      {O::kRetentionManage, "eraseDue, on trial", [](W w, Path) { (void)eraseDue(w, {}, "", true); }},
      {O::kRetentionManage, "retentionRules", [](W w, Path) { (void)retentionRules(w); }},
      {O::kRetentionManage, "removeRetentionRule", [](W w, Path) { removeRetentionRule(w, kNoSuch); }},
      {O::kRetentionManage, "setRetentionRule", [](W w, Path) { setRetentionRule(w, kNoSuch, 30, "law"); }},
      {O::kRetentionManage, "extendRecords", [](W w, Path) { extendRecords(w, {}, 0, "why"); }},
      {O::kRetentionManage, "releaseRecords", [](W w, Path) { releaseRecords(w, {}, ""); }},
  };
}

std::vector<ServiceCall> studyCalls() {
  return {
      {O::kTrialViewCoded, "exportRecordings",
       [](W w, Path folder) { (void)exportRecordings(w, kNoSuch, folder / "trials.csv"); }},
      {O::kMarkViewCoded, "exportMarks",
       [](W w, Path folder) { (void)exportMarks(w, kNoSuch, folder / "marks.csv"); }},
      {O::kMarkViewCoded, "exportCriteria",
       [](W w, Path folder) { (void)exportCriteria(w, kNoSuch, folder / "criteria.csv"); }},
      {O::kMarkViewCoded, "exportRubrics",
       [](W w, Path folder) { (void)exportRubrics(w, kNoSuch, folder / "rubrics.csv"); }},
      {O::kMarkRelease, "releaseStates", [](W w, Path) { (void)releaseStates(w, kNoSuch); }},
      {O::kMarkRelease, "releaseMarks", [](W w, Path) { releaseMarks(w, kNoSuch, "never"); }},
      {O::kMarkRelease, "retractMarks", [](W w, Path) { retractMarks(w, kNoSuch, "pre", "why"); }},
      {O::kEvaluationSetup, "campaigns", [](W w, Path) { (void)campaigns(w); }},
      {O::kEvaluationSetup, "evaluationRecordings", [](W w, Path) { (void)evaluationRecordings(w); }},
      {O::kEvaluationSetup, "addCampaign", [](W w, Path) { (void)addCampaign(w, {}); }},
      {O::kPersonViewCoded, "cohorts", [](W w, Path) { (void)cohorts(w); }},
      {O::kPersonViewCoded, "curricula", [](W w, Path) { (void)curricula(w); }},
      {O::kPersonViewCoded, "publishedContent", [](W w, Path) { (void)publishedContent(w, kNoSuch); }},
      {O::kCurriculumEdit, "addCurriculum", [](W w, Path) { (void)addCurriculum(w, "", ""); }},
      {O::kPersonViewCoded, "knownOccasions", [](W w, Path) { (void)knownOccasions(w); }},
      {O::kCurriculumEdit, "addOccasion", [](W w, Path) { (void)addOccasion(w, ""); }},
      {O::kCurriculumEdit, "publishCurriculum",
       [](W w, Path) { (void)publishCurriculum(w, kNoSuch, "", {}); }},
      {O::kCurriculumEdit, "runCurriculum", [](W w, Path) { runCurriculum(w, kNoSuch); }},
      {O::kPersonViewCoded, "competenceDesigns", [](W w, Path) { (void)competenceDesigns(w, kNoSuch); }},
      {O::kCurriculumEdit, "registerCompetence",
       [](W w, Path) { (void)registerCompetence(w, {.moduleId = kNoSuch}); }},
      {O::kCurriculumEdit, "dependenceOfRuns", [](W w, Path) { (void)dependenceOfRuns(w, kNoSuch); }},
      {O::kPersonViewCoded, "interruptedRuns", [](W w, Path) { (void)interruptedRuns(w, kNoSuch); }},
      {O::kStudySetup, "excuseRun", [](W w, Path) { excuseRun(w, kNoSuch, ""); }},
      {O::kCurriculumEdit, "expertTolerance_deg",
       [](W w, Path) { (void)expertTolerance_deg(w, kNoSuch, kNoSuch); }},
      {O::kCurriculumEdit, "addRubric", [](W w, Path) { (void)addRubric(w, "", {}); }},
      {O::kStudySetup, "addCohort", [](W w, Path) { (void)addCohort(w, {}); }},
      {O::kPersonViewCoded, "studyStatements", [](W w, Path) { (void)studyStatements(w, kNoSuch); }},
      {O::kStudySetup, "setStudyStatements", [](W w, Path) { setStudyStatements(w, kNoSuch, {}); }},
      {O::kStudySetup, "renameCohort", [](W w, Path) { renameCohort(w, kNoSuch, "name"); }},
      {O::kStudySetup, "setCohortState",
       [](W w, Path) { setCohortState(w, kNoSuch, CohortState::kClosed, "why"); }},
      {O::kStudySetup, "assignCurriculum", [](W w, Path) { assignCurriculum(w, kNoSuch, kNoSuch); }},
      {O::kStudySetup, "createAssignments", [](W w, Path) { (void)createAssignments(w, {}); }},
      {O::kStudySetup, "scoringMatrix", [](W w, Path) { (void)scoringMatrix(w, kNoSuch); }},
      {O::kStudySetup, "noteReminders", [](W w, Path) { noteReminders(w, {}, ReminderWay::kCopied); }},
      {O::kStudySetup, "reassignAll", [](W w, Path) { (void)reassignAll(w, {}, {}, "why"); }},
      {O::kStudySetup, "reportDeviation", [](W w, Path) { (void)reportDeviation(w, {}); }},
      {O::kStudySetup, "reportDeviations", [](W w, Path) { reportDeviations(w, {}); }},
      {O::kStudySetup, "correctDeviations", [](W w, Path) { correctDeviations(w, kNoSuch, {}, "why"); }},
      {O::kAllocationRun, "takeOutCards", [](W w, Path) { (void)takeOutCards(w, kNoSuch); }},
      {O::kStudySetup, "swapTurns", [](W w, Path) { swapTurns(w, kNoSuch, kNoSuch, "other", ""); }},
      {O::kStudySetup, "checkCall", [](W w, Path) { (void)checkCall(w, {}); }},
      {O::kStudySetup, "callTrainee", [](W w, Path) { (void)callTrainee(w, {}); }},
      {O::kStudySetup, "endCall", [](W w, Path) { endCall(w, kNoSuch, kNoSuch); }},
      {O::kStudySetup, "cancelCall", [](W w, Path) { cancelCall(w, kNoSuch, kNoSuch, ""); }},
      {O::kStudySetup, "calledCases", [](W w, Path) { (void)calledCases(w, kNoSuch); }},
      {O::kStudySetup, "enrolmentWithCode", [](W w, Path) { (void)enrolmentWithCode(w, kNoSuch, ""); }},
      {O::kStudySetup, "paperCases", [](W w, Path) { (void)paperCases(w, kNoSuch); }},
      {O::kStudySetup, "paperForm", [](W w, Path) { (void)paperForm(w, kNoSuch); }},
      {O::kStudySetup, "enterPaperSheet", [](W w, Path) { (void)enterPaperSheet(w, kNoSuch, {}); }},
      {O::kStudySetup, "paperSheets", [](W w, Path) { (void)paperSheets(w, kNoSuch, kNoSuch, ""); }},
      {O::kStudySetup, "reminders", [](W w, Path) { (void)reminders(w, kNoSuch); }},
      {O::kStudySetup, "dayBoard", [](W w, Path) { (void)dayBoard(w, kNoSuch); }},
      {O::kStudyEnrol, "enrolTrainees", [](W w, Path) { (void)enrolTrainees(w, kNoSuch, {}); }},
      {O::kStudyEnrol, "setEnrolmentState",
       [](W w, Path) { setEnrolmentState(w, kNoSuch, kNoSuch, EnrolmentState::kCompleted, ""); }},
      {O::kAllocationRun, "previewBalance", [](W w, Path) { (void)previewBalance(w, {}); }},
      {O::kAllocationRun, "lockAllocation", [](W w, Path) { (void)lockAllocation(w, {}); }},
      {O::kAllocationRun, "allocateAll", [](W w, Path) { (void)allocateAll(w, kNoSuch); }},
      {O::kAllocationRun, "overrideAllocation",
       [](W w, Path) { (void)overrideAllocation(w, kNoSuch, kNoSuch, kNoSuch, "why"); }},
      {O::kAllocationView, "allocationDesigns", [](W w, Path) { (void)allocationDesigns(w, kNoSuch); }},
      {O::kAllocationView, "checkAllocation", [](W w, Path) { (void)checkAllocation(w, kNoSuch); }},
      {O::kAllocationReveal, "revealSeed", [](W w, Path) { (void)revealSeed(w, kNoSuch); }},
      {O::kResultsCompute, "mayFreezeNow", [](W w, Path) { (void)mayFreezeNow(w, kNoSuch); }},
      {O::kResultsCompute, "freezeData", [](W w, Path) { (void)freezeData(w, kNoSuch, ""); }},
      {O::kResultsCompute, "frozenData", [](W w, Path) { (void)frozenData(w, kNoSuch); }},
      {O::kAllocationView, "allocations", [](W w, Path) { (void)allocations(w, kNoSuch); }},
      {O::kPersonViewCoded, "enrolments", [](W w, Path) { (void)enrolments(w, kNoSuch); }},
      {O::kPersonViewCoded, "deviations", [](W w, Path) { (void)deviations(w, kNoSuch); }},
      {O::kPersonViewCoded, "rubrics", [](W w, Path) { (void)rubrics(w); }},
      {O::kCurriculumEdit, "curriculumDraft", [](W w, Path) { (void)curriculumDraft(w, kNoSuch); }},
      {O::kCurriculumEdit, "saveCurriculumDraft", [](W w, Path) { saveCurriculumDraft(w, kNoSuch, {}); }},
      {O::kCurriculumEdit, "closeCurriculum", [](W w, Path) { closeCurriculum(w, kNoSuch, "why"); }},
      {O::kCurriculumEdit, "reviseRubric", [](W w, Path) { (void)reviseRubric(w, kNoSuch, {}, "why"); }},
      {O::kResultsCompute, "compareWithFrozen", [](W w, Path) { (void)compareWithFrozen(w, kNoSuch); }},
  };
}

std::vector<ServiceCall> reportingCalls() {
  return {
      {O::kResultsCompute, "reportableCampaigns", [](W w, Path) { (void)reportableCampaigns(w); }},
      {O::kResultsCompute, "ofCohort",
       [](W w, Path folder) { (void)TrialDigests(folder).ofCohort(w, kNoSuch); }},
      {O::kResultsCompute, "TrialDigests::competenceOf",
       [](W w, Path folder) { (void)TrialDigests(folder).competenceOf(w, kNoSuch, {}); }},
      {O::kResultsCompute, "reportInputs",
       [](W w, Path folder) {
         TrialDigests digests(folder);
         (void)reportInputs(w, {.cohortId = kNoSuch}, digests);
       }},
      {O::kStudySetup, "planDay", [](W w, Path) { (void)planDay(w, {}); }},
      {O::kStudySetup, "daySlots", [](W w, Path) { (void)daySlots(w, kNoSuch, 0, 1); }},
      {O::kStudySetup, "removeSlots", [](W w, Path) { removeSlots(w, kNoSuch, {}); }},
      {O::kUserManage, "makeKioskCodes", [](W w, Path) { (void)makeKioskCodes(w, {}); }},
      {O::kUserManage, "revokeKioskCodes", [](W w, Path) { (void)revokeKioskCodes(w, {}, "why"); }},
      {O::kUserManage, "invite", [](W w, Path) { (void)invite(w, {}); }},
      {O::kUserManage, "inviteOrAsk", [](W w, Path) { (void)inviteOrAsk(w, {}, ""); }},
      {O::kUserManage, "confirmInvitation", [](W w, Path) { (void)confirmInvitation(w, kNoSuch); }},
      {O::kUserManage, "askSecondPerson, to invite",
       [](W w, Path) { (void)askSecondPerson(w, {.act = DutyAct::kInvite}); }},
      {O::kUserManage, "browserAddress", [](W w, Path) { (void)browserAddress(w); }},
      {O::kUserManage, "revokeInvitations", [](W w, Path) { (void)revokeInvitations(w, {}, "why"); }},
      {O::kUserManage, "invitationsInForce", [](W w, Path) { (void)invitationsInForce(w); }},
      {O::kUserManage, "requireSessionsOfOthers", [](W w, Path) { requireSessionsOfOthers(w); }},
      {O::kUserManage, "endBrowserSessions", [](W w, Path) { endBrowserSessions(w, kNoSuch); }},
      {O::kUserManage, "noteEndedSessions", [](W w, Path) { noteEndedSessions(w, kNoSuch); }},
      {O::kSettingsEdit, "setBrowserAddress",
       [](W w, Path) { setBrowserAddress(w, "https://desk.example.org"); }},
      {O::kSettingsEdit, "mayOpenReviewDesk", [](W w, Path) { (void)mayOpenReviewDesk(w); }},
      {O::kSettingsEdit, "openReviewDesk",
       [](W w, Path folder) {
         (void)openReviewDesk(w, {"/nowhere", folder});
       }},
      {O::kSettingsEdit, "startReviewDesk",
       [](W w, Path folder) {
         startReviewDesk(w, {"/nowhere", folder}, {.certificate = "without a key"});
       }},
      {O::kSettingsEdit, "stopReviewDesk",
       [](W w, Path folder) {
         stopReviewDesk(w, {"/nowhere", folder});
       }},
      {O::kUserManage, "kioskCodesInForce", [](W w, Path) { (void)kioskCodesInForce(w); }},
      {O::kUserManage, "outdatedAccess", [](W w, Path) { (void)outdatedAccess(w); }},
      {O::kTrialViewOwn, "requestAboutOwnRecord",
       [](W w, Path) { requestAboutOwnRecord(w, PersonRequestKind::kExport); }},
      {O::kTrialViewOwn, "takeBackOwnRequest", [](W w, Path) { takeBackOwnRequest(w, kNoSuch); }},
      {O::kTrialViewOwn, "ownRequests", [](W w, Path) { (void)ownRequests(w); }},
      {O::kPersonExport, "personRequests", [](W w, Path) { (void)personRequests(w); }},
      {O::kPersonExport, "answerPersonRequest",
       [](W w, Path) { answerPersonRequest(w, kNoSuch, true, "why"); }},
      {O::kResultsCompute, "traceNumber",
       [](W w, Path) { (void)traceNumber(w, kNoSuch, {}, "training,all"); }},
      {O::kReportExportCoded, "exportReport, coded",
       [](W w, Path folder) { takeOut(w, ReportIdentity::kCoded, folder); }},
      {O::kReportExportNamed, "exportReport, named",
       [](W w, Path folder) { takeOut(w, ReportIdentity::kNamed, folder); }},
      {O::kReportExportCoded, "exportReport, aggregated",
       [](W w, Path folder) { takeOut(w, ReportIdentity::kAggregated, folder); }},
      {O::kReportExportCoded, "reportNamed",
       [](W w, Path) { (void)reportNamed(w, {.cohort = "no such cohort"}); }},
      {O::kReportExportCoded, "nameRequest",
       [](W w, Path) {
         ExchangeRequest request;
         nameRequest(w, "no such cohort", "", request);
       }},
      {O::kReportExportCoded, "exchangeData",
       [](W w, Path folder) {
         TrialDigests digests(folder);
         (void)exchangeData(w, {.cohortId = kNoSuch}, digests);
       }},
      {O::kReportExportCoded, "exportWorkbook",
       [](W w, Path folder) {
         exportWorkbook(
             w, {}, [](const Text& text) { return text.str(); }, folder / "cohort.xlsx");
       }},
      {O::kReportExportCoded, "exportTables",
       [](W w, Path folder) { exportTables(w, {}, TableFormat::kCsv, folder / "tables"); }},
      {O::kReportExportCoded, "exportReplication",
       [](W w, Path folder) { exportReplication(w, {}, folder / "replication"); }},
      {O::kReportExportCoded, "exportDataset",
       [](W w, Path folder) { exportDataset(w, {}, {}, folder / "dataset"); }},
      {O::kReportExportNamed, "exportGradebook",
       [](W w, Path folder) {
         TrialDigests digests(folder);
         exportGradebook(w, {.cohortId = kNoSuch}, digests, {}, folder / "grades.csv");
       }},
  };
}

std::vector<ServiceCall> reviewCalls() {
  return {
      {O::kTrialViewAssigned, "loadBlindedRecording",
       [](W w, Path) { (void)loadBlindedRecording(w, kNoSuch); }},
      {O::kTrialViewAssigned, "recordingName", [](W w, Path) { (void)recordingName(w, kNoSuch); }},
      {O::kTrialViewAssigned, "blindedTask", [](W w, Path) { (void)blindedTask(w, kNoSuch); }},
      {O::kMarkSubmit, "reportViewing", [](W w, Path) { (void)reportViewing(w, kNoSuch, {}); }},
      {O::kDatabaseRestore, "noteMoved", [](W w, Path) { noteMoved(w); }},
      {O::kDatabaseRestore, "takeBackMove", [](W w, Path) { takeBackMove(w, "why"); }},
      {O::kEvaluationSubmit, "beginWatching", [](W w, Path) { beginWatching(w, ""); }},
      {O::kEvaluationSubmit, "watchedInBrowser", [](W w, Path) { (void)watchedInBrowser(w, "", {}, {}); }},
      {O::kEvaluationSubmit, "watchedInWindow", [](W w, Path) { (void)watchedInWindow(w, "", {}, {}); }},
      {O::kMarkSubmit, "changeSubmitted", [](W w, Path) { changeSubmitted(w, kNoSuch, {}, "why"); }},
      {O::kMarkSubmit, "reviewQueue", [](W w, Path) { (void)reviewQueue(w); }},
      {O::kMarkSubmit, "openSheet", [](W w, Path) { (void)openSheet(w, kNoSuch); }},
      {O::kMarkSubmit, "submitSheet", [](W w, Path) { submitSheet(w, kNoSuch, {}, {}); }},
      {O::kMarkSubmit, "amendSheet", [](W w, Path) { amendSheet(w, kNoSuch, {}, "because"); }},
      {O::kMarkSubmit, "discrepancyCases", [](W w, Path) { (void)discrepancyCases(w); }},
      {O::kMarkSubmit, "whenCasesAreCompared", [](W w, Path) { (void)whenCasesAreCompared(w); }},
      {O::kMarkSubmit, "casesSealedForNow", [](W w, Path) { (void)casesSealedForNow(w); }},
      {O::kEvaluationSubmit, "evaluationForms", [](W w, Path) { (void)evaluationForms(w); }},
      {O::kEvaluationSubmit, "loadEvaluationRecording",
       [](W w, Path) { (void)loadEvaluationRecording(w, kNoSuch, "X"); }},
      {O::kEvaluationSubmit, "evaluationRules", [](W w, Path) { (void)evaluationRules(w); }},
      {O::kEvaluationSubmit, "submitEvaluation",
       [](W w, Path) { submitEvaluation(w, kNoSuch, "X", WatchLog()); }},
      {O::kMarkSubmit, "keepMark", [](W w, Path) { keepMark(w, kNoSuch, ""); }},
      {O::kMarkSubmit, "moveMark", [](W w, Path) { moveMark(w, kNoSuch, {}, "why"); }},
      {O::kMarkSubmit, "askForAdjudicator", [](W w, Path) { askForAdjudicator(w, kNoSuch, "why"); }},
      {O::kMarkSubmit, "addCaseRemark", [](W w, Path) { addCaseRemark(w, kNoSuch, {}); }},
      {O::kMarkSubmit, "editCaseRemark", [](W w, Path) { editCaseRemark(w, kNoSuch, kNoSuch, "yes"); }},
      {O::kMarkSubmit, "saveSheet", [](W w, Path) { saveSheet(w, kNoSuch, {}, {}); }},
      {O::kMarkSubmit, "blindedCase", [](W w, Path) { (void)blindedCase(w, kNoSuch); }},
      {O::kMarkSubmit, "caseRemarks", [](W w, Path) { (void)caseRemarks(w, kNoSuch); }},
      {O::kTrialViewAssigned, "repliesToMe", [](W w, Path) { (void)repliesToMe(w); }},
      {O::kTrialViewAssigned, "markReplyRead", [](W w, Path) { markReplyRead(w, kNoSuch, 1); }},
      {O::kMarkSubmit, "sheetVersions", [](W w, Path) { (void)sheetVersions(w, kNoSuch); }},
      {O::kMarkSubmit, "keptAt", [](W w, Path) { (void)keptAt(w); }},
      {O::kMarkSubmit, "viewingRules", [](W w, Path) { (void)viewingRules(w); }},
      {O::kMarkSubmit, "ownSeverity", [](W w, Path) { (void)ownSeverity(w); }},
      {O::kMarkSubmit, "liveLines", [](W w, Path) { (void)liveLines(w); }},
      {O::kMarkSubmit, "raterCalibration", [](W w, Path) { (void)raterCalibration(w); }},
      {O::kMarkSubmit, "scoreReferenceRun", [](W w, Path) { scoreReferenceRun(w, 1, 50); }},
      {O::kTrialViewAssigned, "loadReferenceRun", [](W w, Path) { (void)loadReferenceRun(w, 1); }},
      {O::kStudySetup, "addReferenceRuns", [](W w, Path) { addReferenceRuns(w, {}); }},
      {O::kStudySetup, "referenceCandidates", [](W w, Path) { (void)referenceCandidates(w); }},
      {O::kStudySetup, "withdrawReferenceRun", [](W w, Path) { withdrawReferenceRun(w, kNoSuch, "why"); }},
      {O::kStudySetup, "referenceRows", [](W w, Path) { (void)referenceRows(w); }},
      {O::kStudySetup, "adjudicatorRequests", [](W w, Path) { (void)adjudicatorRequests(w, kNoSuch); }},
      {O::kStudySetup, "assignAdjudicator",
       [](W w, Path) { (void)assignAdjudicator(w, kNoSuch, kNoSuch, kNoSuch); }},
      {O::kEvaluationSubmit, "saveEvaluationScore",
       [](W w, Path) { saveEvaluationScore(w, kNoSuch, "X", 0, 50); }},
  };
}

std::vector<ServiceCall> trainingCalls() {
  return {
      {O::kTrialRecordOwn, "recoverInterrupted", [](W w, Path) { (void)recoverInterrupted(w); }},
      {O::kTrialViewOwn, "attemptsOf", [](W w, Path) { (void)attemptsOf(w, kNoSuch); }},
      {O::kTrialViewOwn, "realArmRuns", [](W w, Path) { (void)realArmRuns(w, kNoSuch); }},
      {O::kMarkViewOwn, "scoreGap", [](W w, Path) { (void)scoreGap(w, kNoSuch); }},
      {O::kTrialViewOwn, "debrief", [](W w, Path folder) { (void)debrief(w, kNoSuch, folder); }},
      {O::kTrialViewOwn, "addBookmark", [](W w, Path) { addBookmark(w, kNoSuch, 1.0, "here"); }},
      {O::kTrialViewOwn, "nextSteps", [](W w, Path) { (void)nextSteps(w, kNoSuch); }},
      {O::kTrialViewOwn, "transcript", [](W w, Path) { (void)transcript(w, kNoSuch); }},
      {O::kTrialViewOwn, "trend", [](W w, Path) { (void)trend(w, kNoSuch, kNoSuch); }},
      {O::kTrialViewOwn, "ownRemarks", [](W w, Path) { (void)ownRemarks(w); }},
      {O::kTrialViewOwn, "unreadRemarks", [](W w, Path) { (void)unreadRemarks(w); }},
      {O::kTrialViewOwn, "markRemarkRead", [](W w, Path) { markRemarkRead(w, kNoSuch, 1); }},
      {O::kTrialViewOwn, "editRemark", [](W w, Path) { editRemark(w, kNoSuch, "yes"); }},
      {O::kTrialViewOwn, "replyToRemark", [](W w, Path) { replyToRemark(w, kNoSuch, "yes"); }},
      {O::kTrialViewOwn, "selfScore", [](W w, Path) { selfScore(w, kNoSuch, 7.0, {}); }},
      {O::kTrialViewOwn, "questionDesk", [](W w, Path) { (void)questionDesk(w, kNoSuch); }},
      {O::kTrialViewOwn, "askPhysician",
       [](W w, Path) { (void)askPhysician(w, kNoSuch, 1.0, kNoSuch, "why?"); }},
      {O::kTrialViewAssigned, "questionsToMe", [](W w, Path) { (void)questionsToMe(w); }},
      {O::kTrialViewAssigned, "questionedRun", [](W w, Path) { (void)questionedRun(w, kNoSuch); }},
      {O::kTrialViewAssigned, "answerQuestion", [](W w, Path) { answerQuestion(w, kNoSuch, "so"); }},
      {O::kTrialViewAssigned, "editAnswer", [](W w, Path) { editAnswer(w, kNoSuch, "so"); }},
      {O::kTrialViewOwn, "ownConsents", [](W w, Path) { (void)ownConsents(w); }},
      {O::kTrialRecordOwn, "decideOwnConsent", [](W w, Path) { decideOwnConsent(w, kNoSuch, true, "1"); }},
      {O::kPractice, "soundsAtLimit", [](W w, Path) { (void)soundsAtLimit(w); }},
      {O::kPractice, "gradesWithMouse", [](W w, Path) { (void)gradesWithMouse(w); }},
      {O::kTrialRecordOwn, "recordExposure", [](W w, Path) { (void)recordExposure(w, {}); }, O::kStudySetup},
      {O::kTrialRecordOwn, "RunSession",
       [](W w, Path) {
         const ManualClock clock;
         const RunSession runSession(w, {}, clock);
       }},
  };
}

}  // namespace torsio
