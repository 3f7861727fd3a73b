// SPDX-License-Identifier: GPL-3.0-or-later
// What raters may see: the de-identification layer, and nothing of the others before all have submitted.
// Administrators' tasks when physicians disagree, and before they start: an adjudicator, and the reference
// runs of rater calibration.

#include <functional>

#include <gtest/gtest.h>

#include "app/services/access/centre_settings.h"
#include "app/services/review/adjudicator.h"
#include "app/services/review/blinded_case.h"
#include "app/services/review/case_remarks.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/discrepancy_review.h"
#include "app/services/review/evaluation_form.h"
#include "app/services/review/rater_calibration.h"
#include "app/services/review/review_queue.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/campaign.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/rating/desk_repository.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/system/audit_verification.h"
#include "db/repository/trial/remark_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/record/sample_codec.h"
#include "tests/app/support/audit_entries.h"
#include "tests/app/support/review_centre.h"
#include "tests/support/refusal.h"

namespace torsio {

namespace {

using testing::refusalCode;

WatchLog watchedWhole() {
  WatchLog log(2'000'000);
  log.played(0, 2'000'000, 1.0);
  return log;
}

void expectNoSecretIn(ReviewCentre& centre, const std::string& text) {
  for (const std::string& secret : centre.secrets()) {
    EXPECT_EQ(text.find(secret), std::string::npos) << secret;
  }
}

TEST(BlindedRecording, PlaysTheSameSamplesUnderACaseLabel) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto desk = centre.physician(0);
  const std::string id = centre.caseAbout(0, 0);
  const Trial original = TrialRepository(centre.connection()).load(centre.trialIds()[0]);

  const BlindedRecording recording = loadBlindedRecording(*desk, id);

  EXPECT_EQ(decodeTrial(recording.trial), decodeTrial(original));
  ASSERT_EQ(recording.trial.chunks.size(), original.chunks.size());
  for (std::size_t i = 0; i < original.chunks.size(); ++i) {
    EXPECT_EQ(recording.trial.chunks[i].outputDigest, original.chunks[i].outputDigest);
  }
  const TrialHeader& header = recording.trial.header;
  expectNoSecretIn(centre, header.trialId + header.traineeCode + header.phaseLabel + header.softwareVersion +
                               recording.label + recording.digest + recording.trial.summary.contentHash);
  EXPECT_EQ(header.startedUtc_us, 0);
  EXPECT_EQ(recording.digest, blindedDigest(original.summary.contentHash, id));
  EXPECT_EQ(recording.digest.size(), 8U);
}

TEST(BlindedRecording, TwoRatersCannotMatchTheirCasesByTheDigest) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto first = centre.physician(0);
  const auto second = centre.physician(1);

  EXPECT_NE(loadBlindedRecording(*first, centre.caseAbout(0, 0)).digest,
            loadBlindedRecording(*second, centre.caseAbout(1, 0)).digest);
}

TEST(BlindedRecording, IsForAssignedRatersOnlyAndOnlyWhileAssigned) {
  ReviewCentre centre({.live = true});
  const auto desk = centre.physician(0);
  const auto other = centre.physician(1);
  const std::string id = centre.cases(0).front();
  EXPECT_EQ(refusalCode([&] { static_cast<void>(loadBlindedRecording(*other, id)); }),
            ErrorCode::kPermission);
  EXPECT_EQ(
      refusalCode([&] { static_cast<void>(loadBlindedRecording(*desk, centre.cases(0, true).front())); }),
      ErrorCode::kBadData);

  SheetRepository(centre.connection()).withdraw(id, "on leave", "office", kReviewTime_us);

  EXPECT_EQ(refusalCode([&] { static_cast<void>(loadBlindedRecording(*desk, id)); }), ErrorCode::kPermission);
}

TEST(BlindedRecording, ItsErrorsNameOnlyTheCase) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const Error error = testing::refusal([&] {
    rethrowBlinded(std::make_exception_ptr(Error(ErrorCode::kVerifyFailed, "trial " + centre.trialIds()[0],
                                                 centre.trialIds()[0], Text::verbatim("ask TR-4100"))),
                   "7F");
  });
  EXPECT_EQ(error.code(), ErrorCode::kVerifyFailed);
  EXPECT_EQ(error.where(), "case 7F");
  expectNoSecretIn(centre, std::string(error.what()) + error.where() + error.remedy());
}

TEST(DiscrepancyReview, MarksOfOthersAreHiddenUntilAllHaveSubmitted) {
  ReviewCentre centre({.raters = 3, .trainees = 1});
  const auto first = centre.physician(0);
  submitSheet(*first, centre.caseAbout(0, 0), reviewSheet(2, 2, 2), watchedWhole());
  submitSheet(*centre.physician(1), centre.caseAbout(1, 0), reviewSheet(8, 8, 8), watchedWhole());
  EXPECT_TRUE(discrepancyCases(*first).empty());
  EXPECT_TRUE(ownSeverity(*first).cases.empty());
  EXPECT_EQ(ownSeverity(*first).waiting, 1U);
  EXPECT_EQ(refusalCode([&] { keepMark(*first, centre.caseAbout(0, 0), ""); }), ErrorCode::kBadData);

  submitSheet(*centre.physician(2), centre.caseAbout(2, 0), reviewSheet(7, 7, 7), watchedWhole());

  const std::vector<DiscrepancyCase> cases = discrepancyCases(*first);
  ASSERT_EQ(cases.size(), 1U);
  const RowComparison& overall = cases[0].rows.back();
  EXPECT_DOUBLE_EQ(overall.own, 2.0);
  EXPECT_DOUBLE_EQ(overall.mean, 7.5);  // of 8 and 7
  EXPECT_DOUBLE_EQ(overall.lowest, 7.0);
  EXPECT_DOUBLE_EQ(overall.highest, 8.0);
  EXPECT_TRUE(overall.apart);
  const OwnSeverity severity = ownSeverity(*first);
  ASSERT_TRUE(severity.difference_points.has_value());
  EXPECT_DOUBLE_EQ(*severity.difference_points, -5.5);
}

TEST(DiscrepancyReview, ThePanelWaitsForTheRatersOwnSheetsOfTheOccasion) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto first = centre.physician(0);
  const AssignmentId done = centre.caseAbout(0, 0);
  submitSheet(*first, done, reviewSheet(2, 2, 2), watchedWhole());
  for (std::size_t trainee = 0; trainee < 2; ++trainee) {
    submitSheet(*centre.physician(1), centre.caseAbout(1, trainee), reviewSheet(8, 8, 8), watchedWhole());
  }

  EXPECT_TRUE(discrepancyCases(*first).empty());
  EXPECT_EQ(casesSealedForNow(*first), 1U);
  EXPECT_EQ(
      whenCasesAreCompared(*first),
      "A case is compared here when all its raters have submitted it and you have submitted all your own "
      "sheets of the occasion. Cases that wait for your own sheets: 1.");
  EXPECT_TRUE(ownSeverity(*first).cases.empty());
  EXPECT_EQ(ownSeverity(*first).sealed, 1U);
  EXPECT_FALSE(openSheet(*first, done).panelOpen);
  EXPECT_EQ(refusalCode([&] { keepMark(*first, done, ""); }), ErrorCode::kBadData);
  EXPECT_EQ(discrepancyCases(*centre.physician(1)).size(), 1U) << "who has finished sees the panel";
  centre.passTime_us(1'000'000);
  amendSheet(*first, done, changedSheet(1, 3, 3, 3), "a slip");
  EXPECT_FALSE(sheetVersions(*first, done).back().afterPanel) << "the panel was not seen";

  centre.passTime_us(1'000'000);
  submitSheet(*first, centre.caseAbout(0, 1), reviewSheet(8, 8, 8), watchedWhole());
  EXPECT_EQ(discrepancyCases(*first).size(), 1U);
  EXPECT_EQ(ownSeverity(*first).cases.size(), 2U);
  EXPECT_TRUE(openSheet(*first, done).panelOpen);
  EXPECT_FALSE(sheetVersions(*first, done).back().afterPanel);
}

TEST(DiscrepancyReview, TheCentreMayOpenThePanelOfEachCase) {
  ReviewCentre centre(ReviewCentre::Setup{});
  setCentreSetting<kPanelWaits>(*centre.administrator(), false);
  const auto first = centre.physician(0);
  submitSheet(*first, centre.caseAbout(0, 0), reviewSheet(2, 2, 2), watchedWhole());
  submitSheet(*centre.physician(1), centre.caseAbout(1, 0), reviewSheet(8, 8, 8), watchedWhole());

  EXPECT_EQ(discrepancyCases(*first).size(), 1U);
  EXPECT_EQ(casesSealedForNow(*first), 0U);
  EXPECT_EQ(ownSeverity(*first).cases.size(), 1U);
}

TEST(DiscrepancyReview, ShowsOnlyDisagreementsAndRemembersDecisions) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto first = centre.physician(0);
  for (std::size_t trainee = 0; trainee < 2; ++trainee) {
    submitSheet(*first, centre.caseAbout(0, trainee), reviewSheet(4, 4, 4), watchedWhole());
    const double theirs = trainee == 0 ? 4.5 : 8.0;
    submitSheet(*centre.physician(1), centre.caseAbout(1, trainee), reviewSheet(theirs, theirs, theirs),
                watchedWhole());
  }
  ASSERT_EQ(discrepancyCases(*first).size(), 1U);
  const std::string id = discrepancyCases(*first)[0].shown.assignmentId;
  EXPECT_EQ(id, centre.caseAbout(0, 1));
  EXPECT_EQ(refusalCode([&] { askForAdjudicator(*first, id, ""); }), ErrorCode::kBadParameter);

  askForAdjudicator(*first, id, "I cannot explain the distance");
  EXPECT_EQ(discrepancyCases(*first)[0].decision, DiscrepancyChoice::kThird);
  keepMark(*first, id, "");
  EXPECT_EQ(discrepancyCases(*first)[0].decision, DiscrepancyChoice::kKeep);
  moveMark(*first, id, changedSheet(1, 8, 8, 7.5), "missed the second grip");

  EXPECT_TRUE(discrepancyCases(*first).empty());  // no differences left
  setCentreSetting<kDiscrepancy_points>(*centre.administrator(), 0.1);
  EXPECT_FALSE(discrepancyCases(*first).empty());
  EXPECT_EQ(sheetVersions(*first, id).size(), 2U);
  EXPECT_EQ(refusalCode([&] { keepMark(*centre.physician(1), id, ""); }), ErrorCode::kPermission);
}

TEST(CaseRemarks, AreVisibleOnlyToTheirRater) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto first = centre.physician(0);
  addCaseRemark(*first, centre.caseAbout(0, 0), {900'000, "second grip slips"});
  addCaseRemark(*first, centre.caseAbout(0, 0), {300'000, ""});

  const std::vector<CaseRemark> own = caseRemarks(*first, centre.caseAbout(0, 0));

  ASSERT_EQ(own.size(), 2U);
  EXPECT_EQ(own[0].time_us, 300'000);
  EXPECT_EQ(own[1].text, "second grip slips");
  EXPECT_TRUE(caseRemarks(*centre.physician(1), centre.caseAbout(1, 0)).empty());
}

TEST(CaseRemarks, KeepEarlierVersionsWhenEdited) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto first = centre.physician(0);
  const AssignmentId own = centre.caseAbout(0, 0);
  addCaseRemark(*first, own, {900'000, "second grip slips"});
  addCaseRemark(*first, own, {300'000, ""});
  const std::vector<CaseRemark> before = caseRemarks(*first, own);

  editCaseRemark(*first, own, before[1].id, "second grip slips twice");

  const std::vector<CaseRemark> now = caseRemarks(*first, own);
  ASSERT_EQ(now.size(), 2U);
  EXPECT_EQ(now[1].text, "second grip slips twice");
  EXPECT_EQ(now[1].time_us, 900'000);
  EXPECT_NE(now[1].editedUtc_us, 0);
  ASSERT_EQ(now[1].earlier.size(), 1U);
  EXPECT_EQ(now[1].earlier[0].text, "second grip slips");
  const auto other = centre.physician(1);
  EXPECT_EQ(refusalCode([&] { editCaseRemark(*other, centre.caseAbout(1, 0), now[1].id, "mine"); }),
            ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { editCaseRemark(*first, centre.caseAbout(0, 1), now[1].id, "there"); }),
            ErrorCode::kBadParameter);
  EXPECT_EQ(refusalCode([&] { editCaseRemark(*first, own, now[0].id, "a bookmark"); }),
            ErrorCode::kBadParameter);
  EXPECT_EQ(refusalCode([&] { editCaseRemark(*first, own, now[1].id, "  "); }), ErrorCode::kBadParameter);
}

TEST(RaterCalibration, ShowsThePanelOnlyAfterTheRatersMark) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto desk = centre.physician(0);
  const auto office = centre.administrator();
  EXPECT_EQ(refusalCode([&] { addReferenceRuns(*desk, {}); }), ErrorCode::kPermission);
  addReferenceRuns(*office, {{centre.trialIds()[0], centre.rubricRevisionId(), 6.2, 8, false},
                             {centre.trialIds()[1], centre.rubricRevisionId(), 3.0, 8, false}});
  const RaterCalibration before = raterCalibration(*desk);
  ASSERT_EQ(before.runs.size(), 2U);
  EXPECT_FALSE(before.runs[0].panel_points.has_value());
  EXPECT_TRUE(reviewQueue(*desk).calibrationWaiting);
  expectNoSecretIn(centre, loadReferenceRun(*desk, 1).trial.header.trialId);

  scoreReferenceRun(*desk, 1, 50);
  centre.passTime_us(1);
  scoreReferenceRun(*desk, 1, 70);  // a second attempt
  scoreReferenceRun(*desk, 2, 25);

  const RaterCalibration after = raterCalibration(*desk);
  EXPECT_TRUE(after.complete());
  EXPECT_EQ(after.runs[0].tries, 2U);
  EXPECT_NEAR(*after.runs[0].offset_points, 0.8, 1e-12);   // 7.0 - 6.2
  EXPECT_NEAR(*after.runs[1].offset_points, -0.5, 1e-12);  // 2.5 - 3.0
  EXPECT_NEAR(*after.meanOffset_points(), 0.15, 1e-12);
  EXPECT_FALSE(reviewQueue(*desk).calibrationWaiting);
  EXPECT_EQ(refusalCode([&] { scoreReferenceRun(*desk, 3, 50); }), ErrorCode::kBadData);
  EXPECT_EQ(refusalCode([&] { scoreReferenceRun(*desk, 1, 101); }), ErrorCode::kBadData);
}

TEST(RaterCalibration, OmitsAWithdrawnRunAndKeepsItsScores) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto desk = centre.physician(0);
  const auto office = centre.administrator();
  addReferenceRuns(*office, {{centre.trialIds()[0], centre.rubricRevisionId(), 6.2, 8, false},
                             {centre.trialIds()[1], centre.rubricRevisionId(), 3.0, 8, false}});
  scoreReferenceRun(*desk, 1, 50);
  EXPECT_EQ(refusalCode([&] { withdrawReferenceRun(*desk, centre.trialIds()[0], "why"); }),
            ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { withdrawReferenceRun(*office, centre.trialIds()[0], ""); }),
            ErrorCode::kBadParameter);
  EXPECT_EQ(refusalCode([&] { withdrawReferenceRun(*office, "none", "why"); }), ErrorCode::kBadData);

  expectAudited(centre.connection(), office->actor().userId, "reference_run.withdraw",
                [&] { withdrawReferenceRun(*office, centre.trialIds()[0], "the panel met only in part"); });

  const RaterCalibration left = raterCalibration(*desk);
  ASSERT_EQ(left.runs.size(), 1U);  // the second one is now the first
  EXPECT_FALSE(left.runs[0].own_steps.has_value());
  EXPECT_FALSE(left.complete());
  EXPECT_EQ(refusalCode([&] { scoreReferenceRun(*desk, 2, 50); }), ErrorCode::kBadData);
  EXPECT_EQ(RemarkRepository(centre.connection()).calibrationScores(centre.raterId(0)).size(), 1U);
  const std::vector<ReferenceRow> rows = referenceRows(*office);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].trialId, centre.trialIds()[1]);
  EXPECT_EQ(rows[1].number, 0U);
  EXPECT_EQ(rows[1].withdrawnBecause, "the panel met only in part");
  EXPECT_EQ(AuditRepository(centre.connection()).entries({.limit = 1}).front().reason,
            "the panel met only in part");
}

TEST(RaterCalibration, AWithdrawnRunCannotBeRestoredOrWithdrawnAgain) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto office = centre.administrator();
  const std::string trial = centre.trialIds()[0];
  addReferenceRuns(*office, {{trial, centre.rubricRevisionId(), 6.2, 8, false}});
  withdrawReferenceRun(*office, trial, "wrong recording");

  EXPECT_EQ(refusalCode([&] { withdrawReferenceRun(*office, trial, "again"); }), ErrorCode::kBadData);
  EXPECT_EQ(refusalCode([&] {
              addReferenceRuns(*office, {{trial, centre.rubricRevisionId(), 6.2, 8, false}});
            }),
            ErrorCode::kBadData);
  addReferenceRuns(*office, {{centre.trialIds()[1], centre.rubricRevisionId(), 3.0, 8, false}});
  EXPECT_EQ(referenceRows(*office)[0].trialId, centre.trialIds()[1]);
  EXPECT_EQ(referenceRows(*office)[0].number, 1U);
}

TEST(EvaluationForm, SealsNothingThatNobodyWatched) {
  ReviewCentre centre(ReviewCentre::Setup{});
  centre.addTwoModels(true, {"PM,FEM"});
  const CampaignId campaignId = "campaign";
  const auto desk = centre.physician(0);
  for (std::size_t i = 0; i < 9; ++i) {
    saveEvaluationScore(*desk, campaignId, "K", i, 70);
  }
  const EvaluationForm form = evaluationForms(*desk)[0];
  WatchLog half(2'000'000);
  half.played(0, 1'000'000, 1.0);

  const SheetCheck unopened = checkEvaluation(form, form.models[0], WatchLog(), evaluationRules(*desk));
  EXPECT_TRUE(unopened.watchedTooLittle);
  EXPECT_TRUE(unopened.allTheSame);
  EXPECT_EQ(refusalCode([&] { submitEvaluation(*desk, campaignId, "K", WatchLog()); }), ErrorCode::kBadData);
  EXPECT_EQ(refusalCode([&] { submitEvaluation(*desk, campaignId, "K", half); }), ErrorCode::kBadData);

  submitEvaluation(*desk, campaignId, "K", watchedWhole());
  EXPECT_TRUE(evaluationForms(*desk)[0].models[0].submitted);
}

TEST(EvaluationForm, HidesTheModelsAndKeepsTheRatersOrder) {
  ReviewCentre centre(ReviewCentre::Setup{});
  centre.addTwoModels(false, {"FEM,PM", "PM,FEM"});
  const CampaignId campaignId = "campaign";
  const auto desk = centre.physician(0);

  const std::vector<EvaluationForm> forms = evaluationForms(*desk);
  ASSERT_EQ(forms.size(), 1U);
  EXPECT_EQ(forms[0].models[0].hiddenLabel, "M");
  EXPECT_EQ(forms[0].models[1].hiddenLabel, "K");
  EXPECT_EQ(forms[0].indices.size(), 9U);
  EXPECT_EQ(evaluationForms(*centre.physician(1))[0].models[0].hiddenLabel, "K");
  for (std::size_t i = 0; i < 8; ++i) {
    saveEvaluationScore(*desk, campaignId, "M", i, 73);
  }
  EXPECT_EQ(refusalCode([&] { submitEvaluation(*desk, campaignId, "M", WatchLog()); }), ErrorCode::kBadData);
  saveEvaluationScore(*desk, campaignId, "M", 8, 100);
  EXPECT_EQ(evaluationForms(*desk)[0].models[0].scores[0], 73);  // the draft is on disk
  EXPECT_EQ(refusalCode([&] { saveEvaluationScore(*desk, campaignId, "M", 8, 101); }), ErrorCode::kBadData);

  submitEvaluation(*desk, campaignId, "M", WatchLog());

  EXPECT_TRUE(evaluationForms(*desk)[0].models[0].submitted);
  EXPECT_EQ(EvaluationRepository(centre.connection()).marks(campaignId).size(), 9U);
  EXPECT_EQ(refusalCode([&] { saveEvaluationScore(*desk, campaignId, "M", 0, 10); }), ErrorCode::kBadData);
  EXPECT_TRUE(DeskRepository(centre.connection()).evaluationDraft(campaignId, centre.raterId(0)).empty());
}

TEST(EvaluationForm, ShowsRealRecordingsUnderTheirLettersAndNeverTheirModel) {
  ReviewCentre centre(ReviewCentre::Setup{});
  centre.addTwoModels(true);
  const CampaignId campaignId = "campaign";
  const auto desk = centre.physician(0);

  const EvaluationForm form = evaluationForms(*desk).at(0);
  const BlindedRecording shown = loadEvaluationRecording(*desk, campaignId, "M");

  EXPECT_TRUE(form.models[0].recorded && form.models[1].recorded);
  EXPECT_EQ(shown.label, "M");
  EXPECT_EQ(shown.trial.header.trialId, "case M");
  EXPECT_EQ(shown.trial.header.traineeCode, "");
  EXPECT_EQ(shown.trial.summary.contentHash, "");
  EXPECT_FALSE(shown.trial.chunks.empty());
  EXPECT_EQ(refusalCode([&] { (void)loadEvaluationRecording(*desk, campaignId, "K2"); }),
            ErrorCode::kBadData);
  EXPECT_EQ(refusalCode([&] { (void)loadEvaluationRecording(*centre.physician(1), campaignId, "M"); }),
            ErrorCode::kPermission);
}

TEST(Blinded, RemovesTheModelFromTheHeader) {
  TrialHeader header;
  header.model = TissueModel::kFiniteElements;

  EXPECT_EQ(blinded(header, "M"), blinded(TrialHeader{}, "M"));
}

TEST(ReviewDesk, EveryChangeIsAuditedAndTheTrailVerifies) {
  ReviewCentre centre(ReviewCentre::Setup{});
  setCentreSetting<kPanelWaits>(*centre.administrator(), false);  // their queues are longer
  const auto desk = centre.physician(0);
  const auto office = centre.administrator();
  const std::string own = centre.caseAbout(0, 0);
  Campaign campaign{.id = "campaign", .name = "One model", .instrument = paperInstrument()};
  campaign.instrument.classes = {{"chief", "chief physicians", 1000}};
  campaign.models = {{"PM", "proposed model", "K", 1}};
  campaign.raters = {{centre.raterId(0), "chief", "PM"}};
  EvaluationRepository(centre.connection()).addCampaign(campaign);
  for (std::size_t i = 0; i < 9; ++i) {
    saveEvaluationScore(*desk, campaign.id, "K", i, 73);
  }
  const auto auditedBy = [&](SessionContext& by, const char* action, const std::function<void()>& change) {
    expectAudited(centre.connection(), by.actor().userId, action, change);
    EXPECT_TRUE(verifyAuditTrail(centre.connection()).empty()) << action;
  };

  auditedBy(*office, "reference_run.add", [&] {
    addReferenceRuns(*office, {{centre.trialIds()[0], centre.rubricRevisionId(), 6.2, 8, false}});
  });
  auditedBy(*desk, "warmup.score", [&] { scoreReferenceRun(*desk, 1, 50); });
  auditedBy(*desk, "remark.add", [&] { addCaseRemark(*desk, own, {900'000, "second grip slips"}); });
  auditedBy(*desk, "remark.add",
            [&] { editCaseRemark(*desk, own, caseRemarks(*desk, own)[0].id, "first grip slips"); });
  auditedBy(*desk, "sheet.submit", [&] { submitSheet(*desk, own, reviewSheet(4, 4, 4), watchedWhole()); });
  auditedBy(*desk, "sheet.amend", [&] { amendSheet(*desk, own, changedSheet(1, 3, 3, 3), "a slip"); });
  const auto other = centre.physician(1);
  auditedBy(*other, "sheet.submit",
            [&] { submitSheet(*other, centre.caseAbout(1, 0), reviewSheet(8, 8, 8), watchedWhole()); });
  auditedBy(*desk, "alignment.third", [&] { askForAdjudicator(*desk, own, "far apart"); });
  auditedBy(*desk, "alignment.keep", [&] { keepMark(*desk, own, ""); });
  auditedBy(*desk, "alignment.move", [&] { moveMark(*desk, own, changedSheet(2, 7, 7, 7), "seen again"); });
  auditedBy(*desk, "evaluation.form", [&] { submitEvaluation(*desk, campaign.id, "K", WatchLog()); });
}

constexpr std::int64_t kLater_us = 1'000'000;

WatchLog wholeLog() {
  WatchLog log(2'000'000);
  log.played(0, 2'000'000, 1.0);
  return log;
}

/// Two physicians who disagree about trainee 0, a third one not assigned, and one of another class.
class Disagreement : public ::testing::Test {
 protected:
  ReviewCentre centre_{ReviewCentre::Setup{}};
  CohortId cohortId_ = StudyRepository(centre_.connection()).cohorts().front().id;
  std::string chiefId_ = addRater("CH-900", "chief");
  std::string internId_ = addRater("IN-900", "intern");

  void SetUp() override {
    setCentreSetting<kPanelWaits>(*centre_.administrator(), false);  // their queues are longer
    submitSheet(*centre_.physician(0), centre_.caseAbout(0, 0), reviewSheet(2, 2, 2), wholeLog());
    submitSheet(*centre_.physician(1), centre_.caseAbout(1, 0), reviewSheet(8, 8, 8), wholeLog());
    centre_.passTime_us(kLater_us);
  }

  std::string addRater(const std::string& code, const std::string& classCode) {
    PeopleRepository people(centre_.connection());
    if (classCode != "chief") {
      people.addRaterClasses(std::vector<SeniorityClass>{{classCode, classCode, 2}});
    }
    Rater rater;
    rater.person.id = "rater-" + code;
    rater.person.code = code;
    rater.person.createdUtc_us = kReviewTime_us;
    rater.classCode = classCode;
    people.addRaters(std::span(&rater, 1));
    return rater.person.id;
  }
};

TEST_F(Disagreement, IsListedOncePerCaseAndOffersRatersNotAssignedBefore) {
  EXPECT_TRUE(adjudicatorRequests(*centre_.administrator(), cohortId_).empty());
  askForAdjudicator(*centre_.physician(0), centre_.caseAbout(0, 0), "I cannot explain the distance");
  centre_.passTime_us(kLater_us);
  askForAdjudicator(*centre_.physician(1), centre_.caseAbout(1, 0), "nor can I");

  const std::vector<AdjudicatorRequest> requests = adjudicatorRequests(*centre_.administrator(), cohortId_);

  ASSERT_EQ(requests.size(), 1U);
  EXPECT_EQ(requests[0].traineeCode, "TR-4100");
  EXPECT_EQ(requests[0].occasion.code, "mid");
  EXPECT_FALSE(requests[0].live);
  EXPECT_EQ(requests[0].marks, 2U);
  EXPECT_EQ(requests[0].askedBy, (std::vector<std::string>{"CH-100", "CH-101"}));
  EXPECT_EQ(requests[0].reasons, (std::vector<std::string>{"I cannot explain the distance", "nor can I"}));
  ASSERT_EQ(requests[0].free.size(), 2U);
  EXPECT_EQ(requests[0].free[0].code, "CH-900");  // same class first
  EXPECT_EQ(requests[0].free[1].code, "IN-900");
}

TEST_F(Disagreement, IsAssignedToAnAdjudicatorUnderAnotherLabelAndIsThenDone) {
  const std::string asked = centre_.caseAbout(0, 0);
  askForAdjudicator(*centre_.physician(0), asked, "I cannot explain the distance");
  centre_.passTime_us(kLater_us);
  const auto office = centre_.administrator();
  EXPECT_EQ(refusalCode([&] { assignAdjudicator(*office, cohortId_, asked, centre_.raterId(1)); }),
            ErrorCode::kBadData);

  std::string made;
  expectAudited(centre_.connection(), office->actor().userId, "assignment.third",
                [&] { made = assignAdjudicator(*office, cohortId_, asked, chiefId_); });

  DeskRepository desk(centre_.connection());
  const Assignment before = desk.assignment(asked).value();
  const Assignment third = desk.assignment(made).value();
  EXPECT_EQ(third.raterId, chiefId_);
  EXPECT_EQ(third.trialId, before.trialId);
  EXPECT_EQ(third.rubricRevisionId, before.rubricRevisionId);
  EXPECT_NE(third.caseLabel, before.caseLabel);
  EXPECT_TRUE(adjudicatorRequests(*office, cohortId_).empty());
  EXPECT_EQ(refusalCode([&] { assignAdjudicator(*office, cohortId_, asked, internId_); }),
            ErrorCode::kBadData);
  // Until the third one has submitted, the others' marks are hidden again.
  EXPECT_TRUE(discrepancyCases(*centre_.physician(0)).empty());
}

TEST_F(Disagreement, IsNoLongerARequestOnceThePhysicianDecidesOtherwise) {
  askForAdjudicator(*centre_.physician(0), centre_.caseAbout(0, 0), "far apart");
  keepMark(*centre_.physician(0), centre_.caseAbout(0, 0), "");

  EXPECT_TRUE(adjudicatorRequests(*centre_.administrator(), cohortId_).empty());
}

TEST_F(Disagreement, IsForTheAdministratorOnly) {
  const auto rater = centre_.physician(0);
  EXPECT_EQ(refusalCode([&] { static_cast<void>(adjudicatorRequests(*rater, cohortId_)); }),
            ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { assignAdjudicator(*rater, cohortId_, centre_.caseAbout(0, 0), chiefId_); }),
            ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { static_cast<void>(referenceCandidates(*rater)); }), ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { static_cast<void>(referenceRows(*rater)); }), ErrorCode::kPermission);
  EXPECT_EQ(refusalCode([&] { addReferenceRuns(*rater, {}); }), ErrorCode::kPermission);
}

TEST(ReferenceRuns, AreOfferedFromRecordingsThatNobodyScores) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto office = centre.administrator();
  EXPECT_TRUE(referenceCandidates(*office).empty());  // every recording is a case
  const std::string assignment = centre.caseAbout(0, 0);
  const TrialId trialId = centre.trialIds()[0];
  // The same recording again, without a case.
  Trial copy = TrialRepository(centre.connection()).load(trialId);
  const std::string free = "11111111-2222-4333-8444-555555555555";
  copy.header.trialId = free;
  TrialRepository repository(centre.connection(), {.station = "station-7"});
  repository.begin(copy.header);
  for (const TrialChunk& chunk : copy.chunks) {
    repository.append(chunk);
  }
  repository.finish(copy.summary);

  const std::vector<ReferenceCandidate> candidates = referenceCandidates(*office);
  ASSERT_EQ(candidates.size(), 1U);
  EXPECT_EQ(candidates[0].trialId, free);
  EXPECT_EQ(candidates[0].length_us, 2'000'000);
  addReferenceRuns(*office, {{free, centre.rubricRevisionId(), 6.2, 8, false}});

  EXPECT_TRUE(referenceCandidates(*office).empty());
  const std::vector<ReferenceRow> rows = referenceRows(*office);
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0].number, 1U);
  EXPECT_DOUBLE_EQ(rows[0].panel_points, 6.2);
  EXPECT_EQ(rows[0].panelRaters, 8);
}

TEST(ReferenceRuns, AreRejectedIfTheyCannotBeScored) {
  ReviewCentre centre(ReviewCentre::Setup{});
  const auto office = centre.administrator();
  const auto add = [&](const std::string& trial, const std::string& rubric, double points,
                       std::int64_t raters) {
    return refusalCode([&] { addReferenceRuns(*office, {{trial, rubric, points, raters, false}}); });
  };
  const std::string trial = centre.trialIds()[0];
  EXPECT_EQ(add("no such", centre.rubricRevisionId(), 6.0, 5), ErrorCode::kBadData);
  EXPECT_EQ(add(trial, "no such", 6.0, 5), ErrorCode::kBadData);
  EXPECT_EQ(add(trial, centre.rubricRevisionId(), 10.5, 5), ErrorCode::kBadParameter);
  EXPECT_EQ(add(trial, centre.rubricRevisionId(), 6.0, 0), ErrorCode::kBadParameter);
  addReferenceRuns(*office, {{trial, centre.rubricRevisionId(), 6.0, 5, false}});
  EXPECT_EQ(add(trial, centre.rubricRevisionId(), 6.0, 5), ErrorCode::kBadData);
}

}  // namespace

}  // namespace torsio
