// SPDX-License-Identifier: GPL-3.0-or-later
// Reports of cohorts with something unusual about them, as files. With TORSIO_STRANGE_REPORTS=FOLDER all of
// them stay there in both languages, to be read.

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <QProcess>
#include <QString>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/outputs/pdf/pdf_report.h"
#include "app/outputs/wording/wording.h"
#include "assessment/results/cohort_report.h"
#include "tests/support/strange_cohorts.h"

namespace torsio {
namespace {

std::vector<testing::StrangeCohort> everyStrangeCohort() {
  std::vector<testing::StrangeCohort> all;
  for (auto* some : {testing::strangeAllocations, testing::strangeTrainings, testing::strangePeople,
                     testing::strangeMarks}) {
    for (testing::StrangeCohort& one : some()) {
      all.push_back(std::move(one));
    }
  }
  return all;
}

/// Returns the text of the first page in one line.
QString firstPrintedPage(const std::filesystem::path& file) {
  QProcess reader;
  reader.start(QStringLiteral("pdftotext"), {QStringLiteral("-l"), QStringLiteral("1"),
                                             QString::fromStdString(file.string()), QStringLiteral("-")});
  EXPECT_TRUE(reader.waitForFinished()) << "pdftotext of poppler-utils";
  return QString::fromUtf8(reader.readAllStandardOutput()).simplified();
}

TEST(StrangeReports, ReservationsStandOnTheFirstPageInSmallerLettersBeforeTheyAreLeftToTheNext) {
  CohortInputs in = testing::soundCohort();
  in.markWays = {.live = 900};
  for (CohortTrainee& trainee : in.trainees) {
    trainee.withdrew = true;
  }
  in.equivalenceMargin.reset();
  const QTemporaryDir folder;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "cohort.pdf";

  writePdfReport(cohortReport(in), file);

  const QString page = firstPrintedPage(file);
  for (const char* said : {"Raters were not blinded", "Everybody withdrew.",
                           "No plan of the analysis is in the record", "Signatures"}) {
    EXPECT_TRUE(page.contains(QString::fromLatin1(said))) << said << "\n" << page.toStdString();
  }
}

TEST(StrangeReports, ChineseCharactersAreFoundByASearch) {
  const QTemporaryDir folder;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "cohort.pdf";
  writePdfReport(cohortReport(testing::soundCohort()), file, wordingIn("zh_CN"), {}, "zh_CN");

  const QString page = firstPrintedPage(file);
  for (const char16_t* said : {u"人员", u"方式", u"手臂", u"签名"}) {
    EXPECT_TRUE(page.contains(QString::fromUtf16(said))) << page.toStdString();
  }
  for (const QChar& character : page) {
    EXPECT_FALSE(character >= QChar(0x2E80) && character <= QChar(0x2FD5))
        << "a radical: " << QString(character).toStdString();
  }
}

TEST(StrangeReports, AreWritten) {
  const char* kept = std::getenv("TORSIO_STRANGE_REPORTS");
  const QTemporaryDir temporary;
  const std::filesystem::path folder = kept != nullptr ? kept : temporary.path().toStdString();
  const std::vector<testing::StrangeCohort> all = everyStrangeCohort();
  const std::size_t step = kept != nullptr ? 1 : 10;
  for (std::size_t i = 0; i < all.size(); i += step) {
    std::string name = all[i].name;
    std::replace(name.begin(), name.end(), ' ', '-');
    const ReportModel report = cohortReport(all[i].cohort);
    for (const std::string& language : reportLanguages()) {
      const std::filesystem::path file = folder / (name + "." + language + ".pdf");
      writePdfReport(report, file, wordingIn(language), {}, language);
      EXPECT_TRUE(std::filesystem::exists(file)) << name;
    }
  }
}

}  // namespace
}  // namespace torsio
