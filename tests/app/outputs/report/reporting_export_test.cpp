// SPDX-License-Identifier: GPL-3.0-or-later
// Inputs of a report, who may export it, and its audit entries. Digests of recordings: measured once, on
// every core, and stored.

#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/outputs/report/cell_trace.h"
#include "app/outputs/report/coded_tables.h"
#include "app/outputs/report/report_export.h"
#include "app/services/base/csv_style.h"
#include "app/services/base/csv_table.h"
#include "app/services/people/people_service.h"
#include "app/services/recording/kept_digests.h"
#include "app/services/recording/trial_digests.h"
#include "app/services/study/campaign_service.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/frozen_data.h"
#include "app/services/study/scoring_plan.h"
#include "assessment/attempt/trial_digest.h"
#include "assessment/catalogue/quantity.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/rating/campaign.h"
#include "assessment/domain/rating/rubric.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/cohort_report.h"
#include "assessment/results/number_format.h"
#include "db/connection/connection.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/people/signature_repository.h"
#include "db/repository/rating/evaluation_repository.h"
#include "db/repository/rating/rating_repository.h"
#include "db/repository/rating/rubric_repository.h"
#include "db/repository/rating/sheet_repository.h"
#include "db/repository/study/study_repository.h"
#include "db/repository/trial/digest_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/record/sample_codec.h"
#include "tests/app/outputs/report/small_study.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {

namespace {

using testing::record;
using testing::SmallStudy;
using testing::StudyCentre;

TEST(ReportInputs, ContainTheEquivalenceMarginPlannedWithTheCohort) {
  StudyCentre centre;
  const std::string version = centre.runPaperCurriculum();
  for (const double wrong : {0.0, -1.0, 2.0 * kLargestMargin, std::nan("")}) {
    EXPECT_THROW(addCohort(centre.session(),
                           {.name = "Study", .curriculumVersionId = version, .equivalenceMargin = wrong}),
                 Error);
  }
  ReportRequest request;
  request.cohortId = addCohort(centre.session(),
                               {.name = "Study", .curriculumVersionId = version, .equivalenceMargin = 0.75});

  TrialDigests digests{centre.assets()};
  EXPECT_EQ(reportInputs(centre.as("administrator"), request, digests).equivalenceMargin, 0.75);
  EXPECT_EQ(cohorts(centre.session()).front().cohort.equivalenceMargin, 0.75);
}

TEST(ReportInputs, RequireTheRightToComputeResults) {
  SmallStudy study;
  for (const char* role : {"trainee", "rater", "allocator", ""}) {
    EXPECT_THROW((void)reportInputs(study.centre.as(role), study.request, study.digests), Error) << role;
  }

  const CohortInputs inputs = reportInputs(study.centre.as("administrator"), study.request, study.digests);

  EXPECT_EQ(inputs.trainees.size(), 6U);
  EXPECT_TRUE(inputs.allocation.sealed);
  EXPECT_FALSE(inputs.singleMarks);  // the role matrix hides marks from the administrator
  EXPECT_EQ(inputs.occasions.at(1), "after 20 min");
  EXPECT_TRUE(reportInputs(study.centre.as("statistician"), study.request, study.digests).singleMarks);
}

TEST(ReportInputs, NameTraineesOnlyForThoseWhoMaySeeNames) {
  SmallStudy study;
  study.request.identity = ReportIdentity::kNamed;

  EXPECT_THROW((void)reportInputs(study.centre.as("statistician"), study.request, study.digests), Error);
  const CohortInputs inputs = reportInputs(study.centre.as("administrator"), study.request, study.digests);

  for (const CohortTrainee& trainee : inputs.trainees) {
    EXPECT_NE(trainee.code.find(" Trainee "), std::string::npos) << trainee.code;
  }
}

TEST(ReportInputs, TellWhetherTheRecordStillMatchesTheFrozenData) {
  SmallStudy study;
  SessionContext& session = study.centre.as("administrator");
  study.request.frozenId = freezeData(session, study.request.cohortId, "first").id;
  const std::optional<CohortFreeze> frozen = reportInputs(session, study.request, study.digests).freeze;
  ASSERT_TRUE(frozen);
  EXPECT_TRUE(frozen->unchanged);
  EXPECT_EQ(frozen->frozenBy, "administrator");

  reportDeviation(session,
                  {.cohortId = study.request.cohortId, .kind = "late", .description = "by ten minutes"});

  const CohortInputs inputs = reportInputs(session, study.request, study.digests);
  EXPECT_FALSE(inputs.freeze->unchanged);
  EXPECT_EQ(inputs.deviations.at(0).description, "by ten minutes");
}

/// Reads the rows of a table without its byte order mark.
std::vector<CsvRecord> recordsOf(const std::filesystem::path& file, char separator = ',') {
  return csvRecords(readFile(file), file.filename().string(), separator);
}

/// Asks new chiefs for the sheets before training. Returns their rubric.
RubricRevision askForFirstSheets(SmallStudy& study, std::size_t chiefs) {
  const std::vector<RaterId> raters = study.centre.addChiefs(chiefs);
  const std::string rubric = study.centre.addPaperRubric();
  createAssignments(study.centre.session(), {.cohortId = study.request.cohortId,
                                             .occasionCodes = {"pre"},
                                             .raterIds = raters,
                                             .rubricRevisionId = rubric,
                                             .seed = 3});
  return RubricRepository(study.centre.connection()).revision(rubric).value();
}

/// A sheet of this rubric: every row half a point above its lowest mark.
Sheet sheetOf(const RubricRevision& rubric, std::int64_t overall_steps) {
  Sheet sheet{.overall_steps = overall_steps};
  for (const RubricLine& row : rubric.rows) {
    sheet.rows.push_back({row.code, row.scale.lo + 5, ""});
  }
  return sheet;
}

TEST(CodedTables, ContainTheCriteriaTheAnchorsTheRevisionAndTheBuild) {
  SmallStudy study;
  const RubricRevision used = askForFirstSheets(study, 2);
  SheetRepository sheets(study.centre.connection());
  const AssignmentStatus asked = sheets.assignments(study.request.cohortId).at(0);
  sheets.submit(asked.assignment.id, study.centre.session().ids().newUuid(), sheetOf(used, 75), "", 1);
  const std::filesystem::path folder = study.centre.folder();
  SessionContext& session = study.centre.as("statistician");

  exportCriteria(session, study.request.cohortId, folder / "criteria.csv");
  exportRubrics(session, study.request.cohortId, folder / "rubrics.csv");
  exportMarks(session, study.request.cohortId, folder / "german.csv", {';', ','});

  const std::vector<CsvRecord> criteria = recordsOf(folder / "criteria.csv");
  ASSERT_EQ(criteria.size(), 1 + used.rows.size());
  EXPECT_EQ(criteria[1].values[6], used.rows[0].code);
  EXPECT_EQ(criteria[1].values[5], "1");
  EXPECT_EQ(criteria[1].values[8],
            formatExact(pointsFromSteps(used.rows[0].scale.lo + 5, used.rows[0].scale)));
  EXPECT_EQ(criteria[1].values[11].size(), 64U) << "the hash of the program";
  std::size_t anchors = 0;
  for (const RubricLine& row : used.rows) {
    anchors += std::max<std::size_t>(1, row.anchors.size());
  }
  EXPECT_EQ(recordsOf(folder / "rubrics.csv").size(), 1 + anchors);
  EXPECT_EQ(criteria[0].values.back(), "trail_head");
  EXPECT_TRUE(criteria[1].values.back().starts_with("torsio-head 1 ")) << criteria[1].values.back();
  const std::vector<CsvRecord> german = recordsOf(folder / "german.csv", ';');
  ASSERT_EQ(german.size(), 2U);
  EXPECT_EQ(german[0].values.size(), german[1].values.size());
  EXPECT_EQ(german[1].values[4], "7,5") << "a decimal comma, in its own column";
  const auto mean = std::find(german[0].values.begin(), german[0].values.end(), "criteria_mean");
  ASSERT_NE(mean, german[0].values.end());
  EXPECT_EQ(german[1].values[static_cast<std::size_t>(mean - german[0].values.begin())], "1,5")
      << "each row half a point above its lowest mark of 1";
}

/// Counts the steps of this kind below a step.
std::size_t stepsOf(const TraceStep& step, const std::string& kind) {
  std::size_t count = step.what.str().starts_with(kind) ? 1 : 0;
  for (const TraceStep& part : step.madeOf) {
    count += stepsOf(part, kind);
  }
  return count;
}

TEST(ReportInputs, ContainTheSheetsBehindTheMarksAndANumberCanBeTracedToThem) {
  SmallStudy study;
  const RubricRevision used = askForFirstSheets(study, 3);
  SheetRepository sheets(study.centre.connection());
  for (const AssignmentStatus& asked : sheets.assignments(study.request.cohortId)) {
    Sheet sheet = sheetOf(used, 70);
    sheet.rows.back() = {used.rows.back().code, std::nullopt, "hidden by a hand"};
    sheets.submit(asked.assignment.id, study.centre.session().ids().newUuid(), sheet, "", 1);
  }

  CohortInputs inputs = reportInputs(study.centre.as("statistician"), study.request, study.digests);

  ASSERT_EQ(inputs.sheets.size(), 1U);
  EXPECT_EQ(inputs.sheets[0].revision, 1);
  EXPECT_EQ(inputs.sheets[0].criteria.at(0).anchors.size(), used.rows[0].anchors.size());
  ASSERT_EQ(inputs.criterionMarks.size(), 6U * 3U * used.rows.size());
  for (const CriterionMark& mark : inputs.criterionMarks) {
    EXPECT_EQ(mark.points.has_value(), mark.criterion + 1 < used.rows.size());
  }
  EXPECT_EQ(inputs.programHash.size(), 64U);
  std::string mean;
  std::string score;
  for (const CohortCsvRow& row : cohortCsvRows(inputs)) {
    if (row.statistic == "criterion_mean" && row.item == "all" && mean.empty()) {
      mean = numberAddress(row);
    }
    if (row.statistic == "score" && score.empty()) {
      score = numberAddress(row);
    }
  }
  SessionContext& session = study.centre.as("statistician");
  const TraceStep criterion = traceNumber(session, study.request.cohortId, inputs, mean);
  EXPECT_EQ(stepsOf(criterion, "criterion_mean of T-"), 2U) << "two trainees a group";
  EXPECT_EQ(stepsOf(criterion, "criterion_mark of T-"), 6U);
  EXPECT_EQ(stepsOf(criterion, "scoring sheet"), 6U);
  EXPECT_EQ(stepsOf(criterion, "program file"), 1U);
  EXPECT_THROW((void)traceNumber(session, study.request.cohortId, inputs, "training,T-99,,,,,score"), Error);
  inputs.singleMarks = false;
  const TraceStep closed = traceNumber(session, study.request.cohortId, inputs, score);
  EXPECT_EQ(stepsOf(closed, "rater_mark"), 0U) << "whoever may not see marks finds none on the way back";
  EXPECT_EQ(stepsOf(closed, "not shown to you"), 1U);
}

TEST(CsvStyle, ChangesOnlyNumbers) {
  const std::string table =
      "a,b,c\r\n-1.5,\"x; y, \"\"z\"\"\",2026-01-05 08:00 UTC\r\n2.5e-07,v1.2.3,T-1.\r\n";
  EXPECT_EQ(csvInStyle(table, {}), table);
  EXPECT_EQ(csvInStyle(table, {';', ','}),
            "a;b;c\r\n-1,5;\"x; y, \"\"z\"\"\";2026-01-05 08:00 UTC\r\n2,5e-07;v1.2.3;T-1.\r\n");
  EXPECT_EQ(csvInStyle("\xEF\xBB\xBF"
                       "a,b\r\n1.5,c\r\n",
                       {'\t', '.'}),
            "\xEF\xBB\xBF"
            "a\tb\r\n1.5\tc\r\n");
}

TEST(ReportInputs, EachSignedMarkHasItsSignerMeaningAndTime) {
  SmallStudy study;
  const RaterId chief = study.centre.addChiefs(1).at(0);
  Connection& connection = study.centre.connection();
  const std::vector<Enrolment> enrolments = StudyRepository(connection).enrolments(study.request.cohortId);
  for (const char* id : {"signed", "unsigned"}) {
    SubmittedMark mark;
    mark.id = id;
    mark.enrolmentId = enrolments.at(id == std::string("signed") ? 0 : 1).id;
    mark.raterId = chief;
    mark.occasionCode = "pre";
    mark.score_steps = 70;
    mark.submittedUtc_us = testing::kStudyTime_us;
    RatingRepository(connection, "ward").submit(std::span(&mark, 1));
  }
  SignatureRepository(connection)
      .add({.objectId = "signed",
            .userId = AccessRepository(connection).users().at(0).id,
            .personId = chief,
            .reason = "seen twice",
            .signedUtc_us = testing::kStudyTime_us,
            .passwordShownUtc_us = testing::kStudyTime_us});

  const CohortInputs inputs = reportInputs(study.centre.as("statistician"), study.request, study.digests);

  ASSERT_EQ(inputs.signatures.size(), 1U);
  EXPECT_EQ(inputs.unsignedMarks, 1);
  const ReportModel report = cohortReport(inputs);
  std::vector<ReportTable> tables;
  for (const ReportSection& section : report.sections) {
    std::copy_if(section.tables.begin(), section.tables.end(), std::back_inserter(tables),
                 [](const ReportTable& table) { return table.id == "table-mark-signatures"; });
  }
  ASSERT_EQ(tables.size(), 1U);
  ASSERT_EQ(tables[0].rows.size(), 1U);
  EXPECT_EQ(tables[0].rows[0].at(0), inputs.signatures[0].signer);
  EXPECT_EQ(tables[0].rows[0].at(2), "before");
  EXPECT_EQ(tables[0].rows[0].at(4), "I scored this case");
  EXPECT_EQ(tables[0].rows[0].at(5), formatUtc(testing::kStudyTime_us));
  EXPECT_EQ(tables[0].rows[0].at(6), "seen twice");

  study.request.identity = ReportIdentity::kNamed;
  const CohortInputs named = reportInputs(study.centre.as("administrator"), study.request, study.digests);
  EXPECT_GT(named.signatures.at(0).signer.size(), inputs.signatures[0].signer.size())
      << "with the printed name: " << named.signatures[0].signer;
}

/// Two models and three classes: one class has not scored, another has scored only the first model.
void expectClassesByThemselves(const CohortInputs& frozen) {
  const ReportModel report = cohortReport(frozen);
  const ReportTable* classes = nullptr;
  for (const ReportSection& one : report.sections) {
    for (const ReportTable& table : one.tables) {
      classes = table.id == "table-evaluation-classes" ? &table : classes;
    }
  }
  ASSERT_NE(classes, nullptr);
  ASSERT_EQ(classes->rows.size(), 6U);
  EXPECT_EQ(classes->rows[0].back().str(), "7.0000");  // the intern's mark of PM
  EXPECT_EQ(classes->rows[1].back().str(), "not defined: an index has no mark");
  const std::vector<CohortCsvRow> rows = cohortCsvRows(frozen);
  EXPECT_EQ(std::count_if(rows.begin(), rows.end(),
                          [](const CohortCsvRow& row) { return row.statistic == "class_score_eq27"; }),
            6);
}

TEST(ReportInputs, AnUnfinishedEvaluationIsReportedWithoutBlockingAnythingElse) {
  SmallStudy study;
  SessionContext& session = study.centre.as("administrator");
  CampaignPlan plan;
  plan.name = "Spring";
  plan.instrument = paperEvaluationInstrument();
  plan.models = {{"PM", "proposed"}, {"FEM", "finite elements"}};
  for (const char* raterClass : {"intern", "deputy_chief", "chief"}) {
    plan.raterIds.push_back(addPerson(
        session,
        {.fullName = "Rater", .externalId = raterClass, .trainee = false, .raterClass = raterClass}));
  }
  study.request.campaignId = addCampaign(session, plan);
  const auto submit = [&](const RaterId& raterId, const std::string& model) {
    std::vector<EvaluationMark> marks;
    for (std::int64_t index = 1; index <= 9; ++index) {
      marks.push_back({.id = session.ids().newUuid(),
                       .raterId = raterId,
                       .modelCode = model,
                       .indexNumber = index,
                       .score_steps = 70,
                       .submittedUtc_us = testing::kStudyTime_us});
    }
    EvaluationRepository(study.centre.connection()).submit(study.request.campaignId, marks);
  };
  submit(plan.raterIds[0], "PM");
  submit(plan.raterIds[0], "FEM");
  submit(plan.raterIds[2], "PM");  // the chief has not scored FEM

  const CohortInputs inputs = reportInputs(session, study.request, study.digests);

  ASSERT_TRUE(inputs.unfinishedEvaluation);
  EXPECT_EQ(inputs.unfinishedEvaluation->marks, 27);
  EXPECT_EQ(inputs.unfinishedEvaluation->classesMissing,
            (std::vector<std::string>{"deputy chief physician", "chief physician"}));
  const ReportModel report = cohortReport(inputs);
  const auto section =
      std::find_if(report.sections.begin(), report.sections.end(),
                   [](const ReportSection& candidate) { return candidate.id == "evaluation"; });
  ASSERT_NE(section, report.sections.end());
  EXPECT_NE(section->paragraphs.at(0).str().find("27 marks are in so far"), std::string::npos);
  // Lists what is missing by class, model and index.
  ASSERT_EQ(section->tables.size(), 1U) << "no score before everybody who was asked has given all marks";
  const std::vector<std::vector<ReportCell>>& lines = section->tables[0].rows;
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[0], (std::vector<ReportCell>{Text::verbatim("deputy chief physician"), Text::verbatim("PM"),
                                               Text::verbatim("all 9")}));
  EXPECT_EQ(lines[2][0].str() + " " + lines[2][1].str(), "chief physician FEM");

  // Freezing without the class loses nothing else.
  study.request.frozenId = freezeData(session, study.request.cohortId, "as it is").id;
  expectClassesByThemselves(reportInputs(session, study.request, study.digests));
  study.request.frozenId = FreezeId();

  for (const std::string& rater : {plan.raterIds[1], plan.raterIds[2]}) {
    for (const char* model : {"PM", "FEM"}) {
      if (rater != plan.raterIds[2] || model != std::string("PM")) {
        submit(rater, model);
      }
    }
  }
  const CohortInputs finished = reportInputs(session, study.request, study.digests);
  EXPECT_FALSE(finished.unfinishedEvaluation);
  ASSERT_EQ(finished.evaluations.size(), 2U);
  EXPECT_DOUBLE_EQ(finished.evaluations.front().n27, 7.0);
}

TEST(ReportInputs, MentionOnceTheWarningWithWhichACustomOrganWasAccepted) {
  SmallStudy study;
  const std::string parameters =
      R"({"formulation":"saint-venant","ridges":36,"sections":25,"organ":"file","organ_unit_m":0.001,)"
      R"("organ_warnings":[{"code":"M20","text":"the organ is %1 times as long as wide","arguments":["1.9"]}],)"
      R"("lattice":{"mode":"automatic","fixed_end_m":[0,0,0],"free_end_m":[0,0,0],"fixed_cut":[0,0,0],)"
      R"("free_cut":[0,0,0]},"material":{"id":"any"},"pattern":{"id":"own-axis"}})";
  record(study, "first", 100, parameters);
  record(study, "second", 100, parameters);
  record(study, "third", 100);

  const CohortInputs inputs = reportInputs(study.centre.as("statistician"), study.request, study.digests);

  std::vector<std::string> told;
  for (const auto& [name, value] : inputs.provenance) {
    if (name == Text::verbatim("Warning about the organ of a recording")) {
      told.push_back(value.str());
    }
  }
  EXPECT_THAT(told, ::testing::ElementsAre("M20 the organ is 1.9 times as long as wide"));
}

TEST(ReportExport, AuditsWhoExportedWhatWithTheHashOfTheFileAndNoName) {
  SmallStudy study;
  SessionContext& session = study.centre.as("administrator");
  study.request.identity = ReportIdentity::kNamed;
  const CohortInputs inputs = reportInputs(session, study.request, study.digests);
  const std::filesystem::path file = study.centre.folder() / "named.csv";

  EXPECT_THROW(exportReport(study.centre.as("statistician"), study.request, inputs, ReportFormat::kCsv, file),
               Error);
  EXPECT_FALSE(std::filesystem::exists(file));
  const ReportExport done =
      exportReport(study.centre.as("administrator"), study.request, inputs, ReportFormat::kCsv, file);

  Digest digest;
  digest.update(readFile(file));
  EXPECT_EQ(done.contentHash, digest.hex());
  const AuditEntry entry = AuditRepository(study.centre.connection()).entries({.limit = 1}).at(0);
  EXPECT_EQ(entry.action, "report.export_named");
  EXPECT_NE(entry.newJson.find(done.contentHash), std::string::npos);
  EXPECT_EQ(entry.newJson.find("Trainee"), std::string::npos);
}

TEST(ReportExport, OfTheValidityArgumentIsAuditedLikeTheTableOfNumbers) {
  SmallStudy study;
  const CohortInputs inputs = reportInputs(study.centre.as("statistician"), study.request, study.digests);
  const std::filesystem::path file = study.centre.folder() / "validity.csv";

  EXPECT_THROW(exportReport(study.centre.as("trainee"), study.request, inputs, ReportFormat::kValidity, file),
               Error);
  EXPECT_FALSE(std::filesystem::exists(file));
  const ReportExport done =
      exportReport(study.centre.as("statistician"), study.request, inputs, ReportFormat::kValidity, file);

  EXPECT_NE(readFile(file).find("implications.harms"), std::string::npos);
  const AuditEntry entry = AuditRepository(study.centre.connection()).entries({.limit = 1}).at(0);
  EXPECT_EQ(entry.action, "report.export_coded");
  EXPECT_NE(entry.newJson.find("\"format\":\"validity\""), std::string::npos);
  EXPECT_NE(entry.newJson.find(done.contentHash), std::string::npos);
}

TEST(TrialDigests, AreMeasuredOnceAndReadBackBitForBit) {
  SmallStudy study;
  record(study, "first", 100);
  record(study, "second", 70);
  SessionContext& session = study.centre.as("statistician");

  const std::vector<TrialSummaryRow> measured = study.digests.ofCohort(session, study.request.cohortId);
  TrialDigests later(study.centre.assets());
  const std::vector<TrialSummaryRow> kept = later.ofCohort(session, study.request.cohortId);

  EXPECT_EQ(study.digests.measured(), 2U);
  EXPECT_EQ(later.measured(), 0U);
  ASSERT_EQ(kept.size(), 2U);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    EXPECT_EQ(kept[i].trialId, measured[i].trialId);
    EXPECT_EQ(kept[i].trainee, measured[i].trainee);
    EXPECT_EQ(kept[i].phase, measured[i].phase);
    EXPECT_EQ(kept[i].model, measured[i].model);
    EXPECT_EQ(kept[i].minutes, measured[i].minutes);
    EXPECT_EQ(kept[i].samples, measured[i].samples);
    EXPECT_EQ(kept[i].twists, 1);
    EXPECT_EQ(kept[i].twistsOnTarget, measured[i].twistsOnTarget);
    EXPECT_EQ(kept[i].meanAbsoluteError_deg, measured[i].meanAbsoluteError_deg);
    EXPECT_EQ(kept[i].peakTorque_Nm, measured[i].peakTorque_Nm);
    EXPECT_EQ(kept[i].peakForce_N, measured[i].peakForce_N);
    EXPECT_EQ(kept[i].lateTicks, 3);
    EXPECT_EQ(kept[i].contentHash, measured[i].contentHash);
    EXPECT_EQ(kept[i].attempts, measured[i].attempts);
  }
}

TEST(TrialDigests, OfOtherFormulaVersionsAreKeptAndMeasuredAgain) {
  SmallStudy study;
  record(study, "first", 100);
  TrialDigest older{
      .trialId = "first", .formulaVersion = kMetricsVersion - 1, .contentHash = "hash of first"};
  DigestRepository(study.centre.connection()).add({&older, 1});

  const auto digests = study.digests.ofCohort(study.centre.as("statistician"), study.request.cohortId);

  EXPECT_EQ(study.digests.measured(), 1U);
  EXPECT_EQ(digests.at(0).twists, 1);
  EXPECT_EQ(DigestRepository(study.centre.connection())
                .ofCohort(study.request.cohortId, kMetricsVersion - 1)
                .size(),
            1U);
}

TEST(TrialDigests, AreRestoredBitForBitWithTheirRules) {
  SmallStudy study;
  record(study, "first", 100);
  DigestRepository repository(study.centre.connection());
  TrialDigest free;
  free.trialId = "first";
  free.formulaVersion = kMetricsVersion;
  free.tolerance_rad = 0.1;
  free.contentHash = "hash of first";
  free.measures.twists = {{1.0 / 3.0, true}, {20.0, false}};
  free.measures.values = {{Quantity::kPeakForce, 0.1 + 0.2}, {Quantity::kSparc, -1.4}};
  TrialDigest limited = free;
  limited.forceLimit_N = 0.0;  // a limit of zero differs from no limit
  limited.torqueLimit_Nm = 0.5;
  const std::vector<TrialDigest> both{free, limited};

  repository.add(both);
  repository.add(both);

  EXPECT_THAT(repository.ofTrial("first", kMetricsVersion), ::testing::UnorderedElementsAreArray(both));
}

TEST(TrialDigests, OfARecordingWithOtherContentAreIgnored) {
  SmallStudy study;
  record(study, "first", 100);
  TrialDigest other{.trialId = "first", .formulaVersion = kMetricsVersion, .contentHash = "of another"};
  other.tolerance_rad = 1.0;
  DigestRepository(study.centre.connection()).add({&other, 1});

  (void)study.digests.ofCohort(study.centre.as("statistician"), study.request.cohortId);

  EXPECT_EQ(study.digests.measured(), 1U);
}

TEST(TrialDigests, OfManyRecordingsMatchThoseOfOneCoreInOrder) {
  constexpr std::size_t kRecordings = 300;  // more than are stored, read and measured at a time
  SmallStudy study;
  Transaction together(study.centre.connection());
  for (std::size_t i = 0; i < kRecordings; ++i) {
    record(study, "r" + std::to_string(1000 + i), 20 + i % 170);
  }
  together.commit();
  SessionContext& session = study.centre.as("statistician");
  std::vector<std::string> told;

  const std::vector<TrialSummaryRow> rows = study.digests.ofCohort(
      session, study.request.cohortId, [&told](const Progress& now) { told.push_back(now.step.str()); });

  EXPECT_EQ(study.digests.measured(), kRecordings);
  ASSERT_EQ(rows.size(), kRecordings);
  EXPECT_EQ(told.front(), "Reading recording 1 of 300");
  EXPECT_GT(told.size(), 3U);
  const DigestRepository kept(study.centre.connection());
  const TrialRepository trials(study.centre.connection());
  for (std::size_t i = 0; i < kRecordings; ++i) {
    const std::string id = "r" + std::to_string(1000 + i);
    EXPECT_EQ(rows[i].trialId, id);
    const Trial trial = trials.load(id);
    const AttemptRules rules = ExerciseRules(study.centre.assets()).ofPattern("forearm", "pronation");
    const AttemptMeasures alone = measureAttempt(trial.header, decodeTrial(trial), rules);
    EXPECT_THAT(kept.ofTrial(id, kMetricsVersion),
                ::testing::ElementsAre(keptDigest(trial, alone, rules, testing::kStudyTime_us)));
  }
}

TEST(TrialDigests, AnUnreadableRecordingStopsTheReportButKeepsWhatWasMeasured) {
  SmallStudy study;
  Transaction together(study.centre.connection());
  for (std::size_t i = 0; i < 300; ++i) {
    record(study, "r" + std::to_string(1000 + i), 50);
  }
  record(study, "r2000", 50, "{}", false);
  together.commit();

  EXPECT_THROW((void)study.digests.ofCohort(study.centre.as("statistician"), study.request.cohortId), Error);

  EXPECT_EQ(
      DigestRepository(study.centre.connection()).ofCohort(study.request.cohortId, kMetricsVersion).size(),
      256U);
}

}  // namespace

}  // namespace torsio
