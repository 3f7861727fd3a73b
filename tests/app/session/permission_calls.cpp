// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/session/permission_calls.h"

#include <string>

#include "app/access/access_service.h"
#include "app/access/audit_service.h"
#include "app/access/settings_service.h"
#include "app/maintenance/database_maintenance.h"
#include "app/maintenance/demonstration_removal.h"
#include "app/maintenance/others_at_work.h"
#include "app/maintenance/person_package.h"
#include "app/maintenance/record_restore.h"
#include "app/maintenance/retention.h"
#include "app/maintenance/server_move.h"
#include "app/people/consent_service.h"
#include "app/people/people_service.h"
#include "app/people/roster_accounts.h"
#include "app/people/roster_import.h"
#include "app/recording/trial_digests.h"
#include "app/reporting/report_data.h"
#include "app/reporting/report_export.h"
#include "app/review/alignment.h"
#include "app/review/blinded_case.h"
#include "app/review/case_remarks.h"
#include "app/review/case_sheet.h"
#include "app/review/evaluation_form.h"
#include "app/review/own_severity.h"
#include "app/review/review_queue.h"
#include "app/review/third_rater.h"
#include "app/review/warm_up.h"
#include "app/study/allocation_service.h"
#include "app/study/campaign_service.h"
#include "app/study/coded_records.h"
#include "app/study/cohort_service.h"
#include "app/study/curriculum_service.h"
#include "app/study/frozen_data.h"
#include "app/study/occasion_service.h"
#include "app/study/rubric_service.h"
#include "app/study/run_day.h"
#include "app/study/scoring_plan.h"
#include "app/training/attempts.h"
#include "app/training/debrief.h"
#include "app/training/next_steps.h"
#include "app/training/questions.h"
#include "app/training/remarks.h"
#include "app/training/run_session.h"
#include "app/training/transcript.h"
#include "app/training/trend.h"
#include "sim/base/clock.h"

namespace torsio::testing {

namespace {
using O = Operation;
using Path = const std::filesystem::path&;

void takeOut(Workplace& workplace, ReportIdentity identity, Path folder) {
  CohortInputs inputs;
  inputs.identity = identity;
  exportReport(workplace, {.cohortId = kNoSuch, .identity = identity}, inputs, ReportFormat::kCsv,
               folder / (std::string(identityCode(identity)) + " report.csv"));
}

}  // namespace

std::vector<ServiceCall> officeCalls() {
  return {
      {O::kPractice, "setOwnPin", [](Workplace& w, Path) { setOwnPin(w, "1"); }},
      {O::kPersonViewCoded, "people", [](Workplace& w, Path) { (void)people(w); }},
      {O::kPersonViewCoded, "consentStates", [](Workplace& w, Path) { (void)consentStates(w, kNoSuch); }},
      {O::kPersonViewIdentity, "namedPeople", [](Workplace& w, Path) { (void)namedPeople(w); }},
      {O::kPersonViewIdentity, "identityOf", [](Workplace& w, Path) { (void)identityOf(w, kNoSuch); }},
      {O::kPersonEdit, "addPerson", [](Workplace& w, Path) { (void)addPerson(w, {}); }},
      {O::kPersonEdit, "changePerson", [](Workplace& w, Path) { changePerson(w, kNoSuch, {}, ""); }},
      {O::kPersonEdit, "setPersonState", [](Workplace& w, Path) { setPersonState(w, kNoSuch, "left", ""); }},
      {O::kPersonEdit, "importRoster",
       [](Workplace& w, Path) {
         (void)importRoster(w, {}, RosterKind::kTrainees, {}, "", RosterMode::kDryRun);
       }},
      {O::kPersonExport, "exportPersonPackage",
       [](Workplace& w, Path folder) { (void)exportPersonPackage(w, kNoSuch, folder / "package", "asked"); }},
      {O::kPersonErase, "erasePersonRecord", [](Workplace& w, Path) { erasePersonRecord(w, kNoSuch, ""); }},
      {O::kConsentRecord, "recordConsent",
       [](Workplace& w, Path) { recordConsent(w, kNoSuch, "nothing", true, "1"); }},
      {O::kReportExportCoded, "exportPeople, coded",
       [](Workplace& w, Path folder) { (void)exportPeople(w, folder / "coded.csv", false); }},
      {O::kReportExportNamed, "exportPeople, named",
       [](Workplace& w, Path folder) { (void)exportPeople(w, folder / "named.csv", true); }},
      {O::kUserManage, "users", [](Workplace& w, Path) { (void)users(w); }},
      {O::kUserManage, "addUser", [](Workplace& w, Path) { (void)addUser(w, {}); }},
      {O::kUserManage, "peopleWithoutAccount", [](Workplace& w, Path) { (void)peopleWithoutAccount(w); }},
      {O::kUserManage, "addAccounts",
       [](Workplace& w, Path) {
         std::vector<StartAccount> made;
         addAccounts(w, {}, made);
       }},
      {O::kUserManage, "setUserActive", [](Workplace& w, Path) { setUserActive(w, kNoSuch, false, ""); }},
      {O::kUserManage, "resetPassword", [](Workplace& w, Path) { resetPassword(w, kNoSuch, "short", ""); }},
      {O::kAuditView, "auditEntries", [](Workplace& w, Path) { (void)auditEntries(w); }},
      {O::kAuditView, "auditEntryCount", [](Workplace& w, Path) { (void)auditEntryCount(w, 0); }},
      {O::kAuditView, "verifyAudit", [](Workplace& w, Path) { (void)verifyAudit(w); }},
      {O::kDatabaseBackup, "checkDatabase", [](Workplace& w, Path) { (void)checkDatabase(w); }},
      {O::kDatabaseRestore, "othersAtWork", [](Workplace& w, Path) { (void)othersAtWork(w); }},
      {O::kDatabaseRestore, "requireNobodyAtWork", [](Workplace& w, Path) { requireNobodyAtWork(w); }},
      {O::kDatabaseRestore, "planRestore",
       [](Workplace& w, Path folder) { (void)planRestore(w, folder / kNoSuch); }},
      {O::kDatabaseRestore, "prepareRestore",
       [](Workplace& w, Path folder) { (void)prepareRestore(w, {.backup = folder / kNoSuch}); }},
      {O::kDatabaseRestore, "checkServer", [](Workplace& w, Path) { (void)checkServer(w, {}); }},
      {O::kDatabaseRestore, "moveToServer",
       [](Workplace& w, Path folder) { (void)moveToServer(w, {}, {}, folder); }},
      {O::kDatabaseRestore, "joinServer", [](Workplace& w, Path folder) { (void)joinServer(w, {}, folder); }},
      {O::kDatabaseRestore, "switchToServer", [](Workplace& w, Path) { (void)switchToServer(w, {}, {}); }},
      {O::kRetentionManage, "retentionQueue", [](Workplace& w, Path) { (void)retentionQueue(w); }},
      {O::kRetentionManage, "lockRecord", [](Workplace& w, Path) { lockRecord(w, kNoSuch, ""); }},
      {O::kSettingsEdit, "centreSettings", [](Workplace& w, Path) { (void)centreSettings(w); }},
      {O::kSettingsEdit, "setCentreSetting", [](Workplace& w, Path) { setCentreSetting(w, "", ""); }},
      {O::kSettingsEdit, "setCentreName", [](Workplace& w, Path) { setCentreName(w, ""); }},
      {O::kSettingsEdit, "setCentreIdleLimits", [](Workplace& w, Path) { setCentreIdleLimits(w, 0, 0); }},
      {O::kSettingsEdit, "setGradedWithMouse", [](Workplace& w, Path) { setGradedWithMouse(w, false); }},
      {O::kUserManage, "setUserRoles", [](Workplace& w, Path) { setUserRoles(w, kNoSuch, {}, ""); }},
      {O::kAuditView, "auditActors", [](Workplace& w, Path) { (void)auditActors(w); }},
      {O::kPersonViewCoded, "consentHistory", [](Workplace& w, Path) { (void)consentHistory(w, kNoSuch); }},
      {O::kPersonViewCoded, "withdrawnConsents", [](Workplace& w, Path) { (void)withdrawnConsents(w); }},
      {O::kPersonViewCoded, "raterClasses", [](Workplace& w, Path) { (void)raterClasses(w); }},
      {O::kPersonEdit, "personEntry", [](Workplace& w, Path) { (void)personEntry(w, kNoSuch); }},
      {O::kPersonEdit, "ensureRaterClasses", [](Workplace& w, Path) { ensureRaterClasses(w); }},
      {O::kPersonEdit, "previewRoster",
       [](Workplace& w, Path) { (void)previewRoster(w, {}, RosterKind::kTrainees, {}); }},
      {O::kDatabaseBackup, "backUpDatabase",
       [](Workplace& w, Path folder) { backUpDatabase(w, folder / "backup.sqlite"); }},
      {O::kPersonErase, "demonstrationSize", [](Workplace& w, Path) { (void)demonstrationSize(w); }},
      {O::kPersonErase, "removeDemonstrationData",
       [](Workplace& w, Path) { removeDemonstrationData(w, "why"); }},
      {O::kPersonErase, "eraseDue", [](Workplace& w, Path) { (void)eraseDue(w, {}, "why", false); }},
      {O::kRetentionManage, "eraseDue, on trial",
       [](Workplace& w, Path) { (void)eraseDue(w, {}, "", true); }},
      {O::kRetentionManage, "retentionRules", [](Workplace& w, Path) { (void)retentionRules(w); }},
      {O::kRetentionManage, "removeRetentionRule",
       [](Workplace& w, Path) { removeRetentionRule(w, kNoSuch); }},
      {O::kRetentionManage, "setRetentionRule",
       [](Workplace& w, Path) { setRetentionRule(w, kNoSuch, 30, "law"); }},
      {O::kRetentionManage, "extendRecord", [](Workplace& w, Path) { extendRecord(w, kNoSuch, 0, "why"); }},
      {O::kRetentionManage, "releaseRecord", [](Workplace& w, Path) { releaseRecord(w, kNoSuch, ""); }},
  };
}

std::vector<ServiceCall> studyCalls() {
  return {
      {O::kTrialViewCoded, "codedTrials", [](Workplace& w, Path) { (void)codedTrials(w); }},
      {O::kMarkViewCoded, "codedMarks", [](Workplace& w, Path) { (void)codedMarks(w, kNoSuch); }},
      {O::kMarkRelease, "releaseStates", [](Workplace& w, Path) { (void)releaseStates(w, kNoSuch); }},
      {O::kMarkRelease, "releaseMarks", [](Workplace& w, Path) { releaseMarks(w, kNoSuch, "never"); }},
      {O::kMarkRelease, "retractMarks", [](Workplace& w, Path) { retractMarks(w, kNoSuch, "pre", "why"); }},
      {O::kEvaluationSetup, "campaigns", [](Workplace& w, Path) { (void)campaigns(w); }},
      {O::kEvaluationSetup, "addCampaign", [](Workplace& w, Path) { (void)addCampaign(w, {}); }},
      {O::kPersonViewCoded, "cohorts", [](Workplace& w, Path) { (void)cohorts(w); }},
      {O::kPersonViewCoded, "curricula", [](Workplace& w, Path) { (void)curricula(w); }},
      {O::kPersonViewCoded, "publishedContent",
       [](Workplace& w, Path) { (void)publishedContent(w, kNoSuch); }},
      {O::kCurriculumEdit, "addCurriculum", [](Workplace& w, Path) { (void)addCurriculum(w, "", ""); }},
      {O::kPersonViewCoded, "knownOccasions", [](Workplace& w, Path) { (void)knownOccasions(w); }},
      {O::kCurriculumEdit, "addOccasion", [](Workplace& w, Path) { (void)addOccasion(w, ""); }},
      {O::kCurriculumEdit, "publishCurriculum",
       [](Workplace& w, Path) { (void)publishCurriculum(w, kNoSuch, "", {}); }},
      {O::kCurriculumEdit, "runCurriculum", [](Workplace& w, Path) { runCurriculum(w, kNoSuch); }},
      {O::kCurriculumEdit, "addRubric", [](Workplace& w, Path) { (void)addRubric(w, "", {}); }},
      {O::kStudySetup, "addCohort", [](Workplace& w, Path) { (void)addCohort(w, {}); }},
      {O::kStudySetup, "assignCurriculum", [](Workplace& w, Path) { assignCurriculum(w, kNoSuch, kNoSuch); }},
      {O::kStudySetup, "createAssignments", [](Workplace& w, Path) { (void)createAssignments(w, {}); }},
      {O::kStudySetup, "scoringMatrix", [](Workplace& w, Path) { (void)scoringMatrix(w, kNoSuch); }},
      {O::kStudySetup, "reassign", [](Workplace& w, Path) { (void)reassign(w, kNoSuch, kNoSuch, "why"); }},
      {O::kStudySetup, "reportDeviation", [](Workplace& w, Path) { (void)reportDeviation(w, {}); }},
      {O::kAllocationRun, "takeOutCards", [](Workplace& w, Path) { (void)takeOutCards(w, kNoSuch); }},
      {O::kStudySetup, "swapTurns", [](Workplace& w, Path) { swapTurns(w, kNoSuch, kNoSuch, "other", ""); }},
      {O::kStudySetup, "runDayBoard", [](Workplace& w, Path) { (void)runDayBoard(w, kNoSuch); }},
      {O::kStudyEnrol, "enrolTrainees", [](Workplace& w, Path) { (void)enrolTrainees(w, kNoSuch, {}); }},
      {O::kStudyEnrol, "setEnrolmentState",
       [](Workplace& w, Path) { setEnrolmentState(w, kNoSuch, kNoSuch, EnrolmentState::kCompleted, ""); }},
      {O::kAllocationRun, "previewBalance", [](Workplace& w, Path) { (void)previewBalance(w, {}); }},
      {O::kAllocationRun, "lockAllocation", [](Workplace& w, Path) { (void)lockAllocation(w, {}); }},
      {O::kAllocationRun, "allocateOne", [](Workplace& w, Path) { (void)allocateOne(w, kNoSuch, kNoSuch); }},
      {O::kAllocationRun, "allocateAll", [](Workplace& w, Path) { (void)allocateAll(w, kNoSuch); }},
      {O::kAllocationRun, "overrideAllocation",
       [](Workplace& w, Path) { (void)overrideAllocation(w, kNoSuch, kNoSuch, kNoSuch, "why"); }},
      {O::kAllocationView, "allocationDesigns",
       [](Workplace& w, Path) { (void)allocationDesigns(w, kNoSuch); }},
      {O::kAllocationView, "checkAllocation", [](Workplace& w, Path) { (void)checkAllocation(w, kNoSuch); }},
      {O::kAllocationReveal, "revealSeed", [](Workplace& w, Path) { (void)revealSeed(w, kNoSuch); }},
      {O::kResultsCompute, "freezeData", [](Workplace& w, Path) { (void)freezeData(w, kNoSuch, ""); }},
      {O::kResultsCompute, "frozenData", [](Workplace& w, Path) { (void)frozenData(w, kNoSuch); }},
      {O::kAllocationView, "allocations", [](Workplace& w, Path) { (void)allocations(w, kNoSuch); }},
      {O::kPersonViewCoded, "enrolments", [](Workplace& w, Path) { (void)enrolments(w, kNoSuch); }},
      {O::kPersonViewCoded, "deviations", [](Workplace& w, Path) { (void)deviations(w, kNoSuch); }},
      {O::kPersonViewCoded, "rubrics", [](Workplace& w, Path) { (void)rubrics(w); }},
      {O::kCurriculumEdit, "curriculumDraft", [](Workplace& w, Path) { (void)curriculumDraft(w, kNoSuch); }},
      {O::kCurriculumEdit, "saveCurriculumDraft",
       [](Workplace& w, Path) { saveCurriculumDraft(w, kNoSuch, {}); }},
      {O::kCurriculumEdit, "closeCurriculum", [](Workplace& w, Path) { closeCurriculum(w, kNoSuch, "why"); }},
      {O::kCurriculumEdit, "reviseRubric",
       [](Workplace& w, Path) { (void)reviseRubric(w, kNoSuch, {}, "why"); }},
      {O::kResultsCompute, "compareWithFrozen",
       [](Workplace& w, Path) { (void)compareWithFrozen(w, kNoSuch); }},
  };
}

std::vector<ServiceCall> reportingCalls() {
  return {
      {O::kResultsCompute, "reportableCohorts", [](Workplace& w, Path) { (void)reportableCohorts(w); }},
      {O::kResultsCompute, "reportableCampaigns", [](Workplace& w, Path) { (void)reportableCampaigns(w); }},
      {O::kResultsCompute, "ofCohort",
       [](Workplace& w, Path folder) { (void)TrialDigests(folder).ofCohort(w, kNoSuch); }},
      {O::kResultsCompute, "reportInputs",
       [](Workplace& w, Path folder) {
         TrialDigests digests(folder);
         (void)reportInputs(w, {.cohortId = kNoSuch}, digests);
       }},
      {O::kReportExportCoded, "exportReport, coded",
       [](Workplace& w, Path folder) { takeOut(w, ReportIdentity::kCoded, folder); }},
      {O::kReportExportNamed, "exportReport, named",
       [](Workplace& w, Path folder) { takeOut(w, ReportIdentity::kNamed, folder); }},
      {O::kReportExportCoded, "exportReport, aggregated",
       [](Workplace& w, Path folder) { takeOut(w, ReportIdentity::kAggregated, folder); }},
  };
}

std::vector<ServiceCall> reviewCalls() {
  return {
      {O::kTrialViewAssigned, "loadBlindedRecording",
       [](Workplace& w, Path) { (void)loadBlindedRecording(w, kNoSuch); }},
      {O::kMarkSubmit, "reviewQueue", [](Workplace& w, Path) { (void)reviewQueue(w); }},
      {O::kMarkSubmit, "openSheet", [](Workplace& w, Path) { (void)openSheet(w, kNoSuch); }},
      {O::kMarkSubmit, "submitSheet", [](Workplace& w, Path) { submitSheet(w, kNoSuch, {}, {}); }},
      {O::kMarkSubmit, "amendSheet", [](Workplace& w, Path) { amendSheet(w, kNoSuch, {}, "because"); }},
      {O::kMarkSubmit, "alignmentCases", [](Workplace& w, Path) { (void)alignmentCases(w); }},
      {O::kEvaluationSubmit, "evaluationForms", [](Workplace& w, Path) { (void)evaluationForms(w); }},
      {O::kEvaluationSubmit, "submitEvaluation",
       [](Workplace& w, Path) { submitEvaluation(w, kNoSuch, "X"); }},
      {O::kMarkSubmit, "keepMark", [](Workplace& w, Path) { keepMark(w, kNoSuch, ""); }},
      {O::kMarkSubmit, "moveMark", [](Workplace& w, Path) { moveMark(w, kNoSuch, {}, "why"); }},
      {O::kMarkSubmit, "askForThird", [](Workplace& w, Path) { askForThird(w, kNoSuch, "why"); }},
      {O::kMarkSubmit, "addCaseRemark", [](Workplace& w, Path) { addCaseRemark(w, kNoSuch, {}); }},
      {O::kMarkSubmit, "saveSheet", [](Workplace& w, Path) { saveSheet(w, kNoSuch, {}, {}); }},
      {O::kMarkSubmit, "blindedCase", [](Workplace& w, Path) { (void)blindedCase(w, kNoSuch); }},
      {O::kMarkSubmit, "caseRemarks", [](Workplace& w, Path) { (void)caseRemarks(w, kNoSuch); }},
      {O::kMarkSubmit, "sheetVersions", [](Workplace& w, Path) { (void)sheetVersions(w, kNoSuch); }},
      {O::kMarkSubmit, "keptAt", [](Workplace& w, Path) { (void)keptAt(w); }},
      {O::kMarkSubmit, "viewingRules", [](Workplace& w, Path) { (void)viewingRules(w); }},
      {O::kMarkSubmit, "ownSeverity", [](Workplace& w, Path) { (void)ownSeverity(w); }},
      {O::kMarkSubmit, "liveLines", [](Workplace& w, Path) { (void)liveLines(w); }},
      {O::kMarkSubmit, "warmUp", [](Workplace& w, Path) { (void)warmUp(w); }},
      {O::kMarkSubmit, "scoreReferenceRun", [](Workplace& w, Path) { scoreReferenceRun(w, 1, 50); }},
      {O::kTrialViewAssigned, "loadReferenceRun", [](Workplace& w, Path) { (void)loadReferenceRun(w, 1); }},
      {O::kStudySetup, "addReferenceRuns", [](Workplace& w, Path) { addReferenceRuns(w, {}); }},
      {O::kStudySetup, "referenceCandidates", [](Workplace& w, Path) { (void)referenceCandidates(w); }},
      {O::kStudySetup, "withdrawReferenceRun",
       [](Workplace& w, Path) { withdrawReferenceRun(w, kNoSuch, "why"); }},
      {O::kStudySetup, "referenceRows", [](Workplace& w, Path) { (void)referenceRows(w); }},
      {O::kStudySetup, "thirdRequests", [](Workplace& w, Path) { (void)thirdRequests(w, kNoSuch); }},
      {O::kStudySetup, "assignThird",
       [](Workplace& w, Path) { (void)assignThird(w, kNoSuch, kNoSuch, kNoSuch); }},
      {O::kEvaluationSubmit, "saveEvaluationScore",
       [](Workplace& w, Path) { saveEvaluationScore(w, kNoSuch, "X", 0, 50); }},
  };
}

std::vector<ServiceCall> trainingCalls() {
  return {
      {O::kTrialRecordOwn, "recoverInterrupted", [](Workplace& w, Path) { (void)recoverInterrupted(w); }},
      {O::kTrialViewOwn, "attemptsOf", [](Workplace& w, Path) { (void)attemptsOf(w, kNoSuch); }},
      {O::kTrialViewOwn, "attemptOf", [](Workplace& w, Path) { (void)attemptOf(w, kNoSuch); }},
      {O::kMarkViewOwn, "scoreGap", [](Workplace& w, Path) { (void)scoreGap(w, kNoSuch); }},
      {O::kTrialViewOwn, "debrief", [](Workplace& w, Path folder) { (void)debrief(w, kNoSuch, folder); }},
      {O::kTrialViewOwn, "addBookmark", [](Workplace& w, Path) { addBookmark(w, kNoSuch, 1.0, "here"); }},
      {O::kTrialViewOwn, "nextSteps", [](Workplace& w, Path) { (void)nextSteps(w, kNoSuch); }},
      {O::kTrialViewOwn, "transcript", [](Workplace& w, Path) { (void)transcript(w, kNoSuch); }},
      {O::kTrialViewOwn, "trend", [](Workplace& w, Path) { (void)trend(w, kNoSuch, kNoSuch); }},
      {O::kTrialViewOwn, "ownRemarks", [](Workplace& w, Path) { (void)ownRemarks(w); }},
      {O::kTrialViewOwn, "unreadRemarks", [](Workplace& w, Path) { (void)unreadRemarks(w); }},
      {O::kTrialViewOwn, "markRemarkRead", [](Workplace& w, Path) { markRemarkRead(w, kNoSuch); }},
      {O::kTrialViewOwn, "replyToRemark", [](Workplace& w, Path) { replyToRemark(w, kNoSuch, "yes"); }},
      {O::kTrialViewOwn, "selfScore", [](Workplace& w, Path) { selfScore(w, kNoSuch, 7.0, {}); }},
      {O::kTrialViewOwn, "questionDesk", [](Workplace& w, Path) { (void)questionDesk(w, kNoSuch); }},
      {O::kTrialViewOwn, "askPhysician",
       [](Workplace& w, Path) { (void)askPhysician(w, kNoSuch, 1.0, kNoSuch, "why?"); }},
      {O::kTrialViewAssigned, "questionsToMe", [](Workplace& w, Path) { (void)questionsToMe(w); }},
      {O::kTrialViewAssigned, "questionedRun", [](Workplace& w, Path) { (void)questionedRun(w, kNoSuch); }},
      {O::kTrialViewAssigned, "answerQuestion", [](Workplace& w, Path) { answerQuestion(w, kNoSuch, "so"); }},
      {O::kTrialViewOwn, "hasOwnConsent", [](Workplace& w, Path) { (void)hasOwnConsent(w, kNoSuch); }},
      {O::kTrialRecordOwn, "decideOwnConsent",
       [](Workplace& w, Path) { decideOwnConsent(w, kNoSuch, true, "1"); }},
      {O::kPractice, "gradesWithMouse", [](Workplace& w, Path) { (void)gradesWithMouse(w); }},
      {O::kTrialRecordOwn, "RunSession",
       [](Workplace& w, Path) {
         const ManualClock clock;
         const RunSession session(w, {}, clock);
       }},
  };
}

}  // namespace torsio::testing
