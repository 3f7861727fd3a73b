// SPDX-License-Identifier: GPL-3.0-or-later
// Contents of printed report pages, read back from the file.
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <QChart>
#include <QLineSeries>
#include <QProcess>
#include <QScatterSeries>
#include <QTemporaryDir>
#include <gtest/gtest.h>

#include "app/outputs/charts/chart_builder.h"
#include "app/outputs/pdf/pdf_report.h"
#include "assessment/results/cohort_report.h"
#include "assessment/results/figure_table.h"
#include "tests/support/demonstration_cohort.h"
#include "tests/support/said_cohort.h"

namespace torsio {
namespace {

/// Returns the text of the pages line by line.
std::string printedLines(const std::filesystem::path& file) {
  QProcess reader;
  reader.start(QStringLiteral("pdftotext"),
               {QStringLiteral("-layout"), QString::fromStdString(file.string()), QStringLiteral("-")});
  EXPECT_TRUE(reader.waitForFinished()) << "pdftotext of poppler-utils";
  return reader.readAllStandardOutput().toStdString();
}

TEST(PrintedReport, ListsForEachModelWhatAClassOfRatersHasNotScored) {
  const CohortInputs in = testing::aClassOfRatersIsMissing();
  ReportModel report = cohortReport(in);
  std::erase_if(report.sections, [](const ReportSection& section) {
    return section.title.str() != "Evaluation of the models";
  });
  const QTemporaryDir folder;
  const std::filesystem::path file = std::filesystem::path(folder.path().toStdString()) / "cohort.pdf";

  writePdfReport(report, file);

  const std::string& missing = in.instrument.classes[2].name;
  std::istringstream pages(printedLines(file));
  std::map<std::string, int> lines;  // by model
  for (std::string line; std::getline(pages, line);) {
    for (const ModelRatings& model : in.ratings) {
      const bool said = line.find(missing) != std::string::npos && line.find("all 9") != std::string::npos;
      lines[model.model] += said && line.find(model.model) != std::string::npos ? 1 : 0;
    }
  }
  for (const ModelRatings& model : in.ratings) {
    EXPECT_EQ(lines[model.model], 1) << missing << ", " << model.model;
  }
}

TEST(PrintedReport, DrawsTheLineOfNormalResiduals) {
  const ReportModel report = cohortReport(testing::demonstrationCohort());
  const ReportFigure* figure = testing::figureNamed(report, "figure-qq");
  ASSERT_NE(figure, nullptr);

  const std::unique_ptr<QChart> chart = buildChart(*figure);

  std::vector<const QLineSeries*> lines;
  std::size_t dots = 0;
  for (const QAbstractSeries* series : chart->series()) {
    if (const auto* line = qobject_cast<const QLineSeries*>(series)) {
      lines.push_back(line);
    } else if (const auto* points = qobject_cast<const QScatterSeries*>(series)) {
      dots += static_cast<std::size_t>(points->count());
    }
  }
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0]->name(), QStringLiteral("as normal residuals"));
  for (const QPointF& end : lines[0]->points()) {
    EXPECT_EQ(end.x(), end.y());
  }
  EXPECT_LT(lines[0]->at(0).x(), 0.0);
  EXPECT_GT(lines[0]->at(1).x(), 0.0);
  EXPECT_EQ(dots, 30U);
  EXPECT_EQ(figureTable(*figure, 4).rows.size(), 30U);  // the line is not a value
}

}  // namespace
}  // namespace torsio
