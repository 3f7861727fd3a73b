// SPDX-License-Identifier: GPL-3.0-or-later
// Who may export data, and its audit entries.
#include "app/outputs/dataset/cohort_exchange.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/outputs/report/report_export.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/frozen_data.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/repository/base/audit_repository.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "tests/app/outputs/dataset/foreign_readers.h"
#include "tests/app/support/small_study.h"
#include "tests/app/support/study_centre.h"

namespace torsio {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A study with free text.
struct SmallStudy : SmallStudyFor<ExchangeRequest> {
  SmallStudy() {
    reportDeviation(centre.as("administrator"),
                    {.cohortId = request.cohortId, .kind = "late", .description = "by ten minutes"});
  }
  AuditEntry newest() { return AuditRepository(centre.connection()).entries({.limit = 1}).at(0); }
};

TEST(CohortExchange, AuditsWhoExportedWhatWhyAndTheHash) {
  SmallStudy study;
  study.request.reason = "for the board";
  const std::filesystem::path file = study.centre.folder() / "cohort.xlsx";
  const ExchangeData data = exchangeData(study.centre.as("administrator"), study.request, study.digests);
  EXPECT_FALSE(data.pseudonyms);
  EXPECT_TRUE(pseudonymSentences(data).empty());

  const ExchangeFiles done = exportWorkbook(
      study.centre.as("administrator"), data, [](const Text& text) { return text.str(); }, file);

  Digest digest;
  digest.update(readFile(file));
  EXPECT_EQ(done.contentHash, digest.hex());
  EXPECT_EQ(done.bytes, readFile(file).size());
  const AuditEntry entry = study.newest();
  EXPECT_EQ(entry.action, "report.export_coded");
  EXPECT_EQ(entry.reason, "for the board");
  EXPECT_THAT(entry.newJson, HasSubstr(done.contentHash));
  EXPECT_THAT(entry.newJson, HasSubstr("workbook"));
}

TEST(CohortExchange, LeavesAndAuditsNothingIfCancelled) {
  SmallStudy study;
  const ExchangeData data = exchangeData(study.centre.as("administrator"), study.request, study.digests);
  const auto before = study.centre.rowCounts();
  const std::filesystem::path folder = study.centre.folder();
  const auto givenUpAtTrials = [](const Progress& progress) {
    if (progress.step.str() == "Writing Recorded runs") {
      throw Error(ErrorCode::kUsage, Text::verbatim("given up"), "", "");
    }
  };
  const auto same = [](const Text& text) { return text.str(); };
  SessionContext& session = study.centre.as("administrator");
  EXPECT_THROW(exportTables(session, data, TableFormat::kCsv, folder / "new", givenUpAtTrials), Error);
  EXPECT_THROW(exportWorkbook(session, data, same, folder / "a.xlsx", givenUpAtTrials), Error);
  EXPECT_FALSE(std::filesystem::exists(folder / "new"));
  EXPECT_FALSE(std::filesystem::exists(folder / "a.xlsx"));
  // Existing files are kept.
  std::filesystem::create_directories(folder / "old");
  writeFileAtomically(folder / "old" / "mine.txt", "mine");
  EXPECT_THROW(exportTables(session, data, TableFormat::kSpss, folder / "old", givenUpAtTrials), Error);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "old"), {}), 1);
  EXPECT_EQ(study.centre.rowCounts(), before);
}

TEST(CohortExchange, IsPseudonymisedForThoseWhoMayNotSeeNames) {
  SmallStudy study;
  const ExchangeData data = exchangeData(study.centre.as("statistician"), study.request, study.digests);
  ASSERT_TRUE(data.pseudonyms);
  EXPECT_EQ(data.pseudonyms->people, 6);
  EXPECT_EQ(data.pseudonyms->textsLeftOut, 1);
  for (const CohortTrainee& trainee : data.inputs.trainees) {
    EXPECT_EQ(trainee.code.substr(0, 2), "P-");
  }
  const std::filesystem::path folder = study.centre.folder() / "tables";
  const ExchangeFiles done = exportTables(study.centre.as("statistician"), data, TableFormat::kSpss, folder);
  EXPECT_GT(done.files.size(), 9U);
  EXPECT_THAT(study.newest().newJson, HasSubstr("pseudonymised"));
  EXPECT_EQ(pseudonymSentences(data).size(), 3U);

  // Scores under codes beside scores under pseudonyms tell who is who.
  const ReportRequest coded{.cohortId = study.request.cohortId};
  SessionContext& administrator = study.centre.as("administrator");
  exportReport(administrator, coded, reportInputs(administrator, coded, study.digests), ReportFormat::kCsv,
               study.centre.folder() / "cohort.csv");
  const ExchangeData later = exchangeData(study.centre.as("statistician"), study.request, study.digests);
  ASSERT_EQ(pseudonymSentences(later).size(), 4U);
  EXPECT_THAT(pseudonymSentences(later)[3].str(),
              HasSubstr("Warning: a report with scores under the centre's codes"));
}

TEST(CohortExchange, APseudonymisedWorkbookContainsNoPeopleCentreOrFreeText) {
  if (!testing::outputOf("/usr/bin/python3 -c 'import zipfile'", testing::OwnFolder().path()).empty()) {
    GTEST_SKIP() << "python3 is not installed";
  }
  SmallStudy study;
  renameCohort(study.centre.as("administrator"), study.request.cohortId, "Interns of Dr Li");
  study.request.frozenId =
      freezeData(study.centre.as("administrator"), study.request.cohortId, "for Dr Wang").id;
  study.request.pseudonymised = true;
  const std::filesystem::path file = study.centre.folder() / "cohort.xlsx";
  const auto contents = [&](bool withFreeText) {
    study.request.withFreeText = withFreeText;
    SessionContext& session = study.centre.as("administrator");
    const ExchangeData data = exchangeData(session, study.request, study.digests);
    exportWorkbook(
        study.centre.as("administrator"), data, [](const Text& text) { return text.str(); }, file);
    return testing::outputOf("/usr/bin/python3 -c \"import zipfile; z = zipfile.ZipFile('" + file.string() +
                                 "'); print(*(z.read(n).decode() for n in z.namelist()))\"",
                             study.centre.folder());
  };
  const std::string hidden = contents(false);
  ASSERT_THAT(hidden, HasSubstr("worksheet"));
  for (const char* secret : {"Dr Li", "Dr Wang", "by ten minutes", "administrator", "T-01", "T-06"}) {
    EXPECT_THAT(hidden, Not(HasSubstr(secret))) << secret;
  }
  const std::string told = contents(true);
  EXPECT_THAT(told, HasSubstr("by ten minutes"));
  EXPECT_THAT(told, HasSubstr("Dr Wang"));
  EXPECT_THAT(told, Not(HasSubstr("T-01")));
}

TEST(CohortExchange, APseudonymisedDatasetContainsNoNames) {
  SmallStudy study;
  study.request.pseudonymised = true;
  const DatasetRequest asked{.about = {.title = "Twists", .licence = "CC-BY-4.0"},
                             .layout = DatasetLayout::kRoCrate};
  SessionContext& session = study.centre.as("administrator");
  const ExchangeData data = exchangeData(session, study.request, study.digests);
  EXPECT_THROW(
      exportDataset(session, data, {.about = asked.about, .rate_Hz = 300}, study.centre.folder() / "x"),
      Error);
  EXPECT_FALSE(std::filesystem::exists(study.centre.folder() / "x"));

  const ExchangeFiles done = exportDataset(session, data, asked, study.centre.folder() / "set");

  EXPECT_GT(done.files.size(), 12U);
  for (const std::filesystem::path& file : done.files) {
    for (const char* secret : {"by ten minutes", "T-01", "T-06", "administrator"}) {
      EXPECT_THAT(readFile(file), Not(HasSubstr(secret))) << file;
    }
  }
  EXPECT_THAT(readFile(study.centre.folder() / "set" / "curriculum.json"), HasSubstr("modules"));
  EXPECT_THAT(study.newest().newJson, HasSubstr("dataset"));
  EXPECT_THAT(study.newest().newJson, HasSubstr(done.contentHash));
}

TEST(CohortExchange, IsRefusedWithoutTheRightToExport) {
  SmallStudy study;
  for (const char* role : {"trainee", "rater", "allocator", ""}) {
    EXPECT_THROW((void)exchangeData(study.centre.as(role), study.request, study.digests), Error) << role;
    EXPECT_THROW(exportGradebook(study.centre.as(role), study.request, study.digests, {},
                                 study.centre.folder() / "grades.csv"),
                 Error)
        << role;
  }
  EXPECT_FALSE(std::filesystem::exists(study.centre.folder() / "grades.csv"));
}

TEST(Gradebook, IsNotWrittenWithoutScores) {
  SmallStudy study;
  const std::filesystem::path file = study.centre.folder() / "grades.csv";
  EXPECT_THROW(exportGradebook(study.centre.as("administrator"), study.request, study.digests, {}, file),
               Error);
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_THAT(study.newest().action, Not(HasSubstr("export")));
}

}  // namespace
}  // namespace torsio
