// SPDX-License-Identifier: GPL-3.0-or-later
// Reports of cohorts with something unusual about them, as files. With TORSIO_STRANGE_REPORTS=FOLDER all of
// them stay there in both languages, to be read.

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <QTemporaryDir>
#include <gtest/gtest.h>
#include <qpdf/QPDF.hh>

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
