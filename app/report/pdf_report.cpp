// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/pdf_report.h"

#include <algorithm>
#include <system_error>

#include <QCoreApplication>
#include <QDateTime>
#include <QGraphicsScene>
#include <QGraphicsWidget>
#include <QPainter>
#include <QPdfWriter>

#include "app/report/chart_builder.h"
#include "app/report/page_flow.h"
#include "assessment/report/figure_table.h"
#include "sim/base/contracts.h"
#include "sim/base/error.h"
#include "sim/base/file_io.h"

namespace torsio {

namespace {

constexpr int kResolution_dpi = 600;
constexpr double kChartHeight_mm = 66.0;
constexpr double kRowHeight_mm = 7.0;  // of a heat map or forest
constexpr double kFrame_mm = 24.0;     // axis, labels and legend round the rows
constexpr double kTallestChart_mm = 170.0;
constexpr int kTableDecimals = 4;
constexpr std::size_t kLongestTwin = 40;  // rows; longer ones would bury the report
constexpr std::size_t kWidestTwin = 12;   // columns that a page can hold
constexpr double kSectionStart_mm =
    130.0;  // a section begins on the page of the last one if half of it is free
constexpr double kChartPixelsPerMm = 3.78;  // 96 pixels an inch: chart fonts come out at about 9 points
const QColor kAccent(0x00, 0x4A, 0x7C);
const QColor kQuiet(0x60, 0x6E, 0x76);
const QColor kWarning(0xA0, 0x4A, 0x00);

QString text(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

QString provenanceLine(const Provenance& from) {
  QStringList parts;
  if (!from.formula.empty()) {
    parts << text(from.formula) +
                 (from.formulaVersion.empty() ? QString() : " (" + text(from.formulaVersion) + ")");
  }
  if (from.n > 0) parts << QStringLiteral("n = %1").arg(from.n);
  if (from.n > 0) parts << QStringLiteral("missing = %1").arg(from.missing);
  for (const std::string& flag : from.flags) parts << text(flag);
  return parts.join(QStringLiteral("; "));
}

void addNotes(PageFlow& flow, const std::vector<std::string>& notes, const Provenance& from) {
  for (const std::string& note : notes) flow.text(text(note), 7.5, false, kQuiet);
  const QString line = provenanceLine(from);
  if (!line.isEmpty()) flow.text(line, 7.5, false, kQuiet);
  flow.space(4.0);
}

double heightOf(const ReportFigure& figure) {
  const std::size_t rows = figure.kind == FigureKind::kHeatMap  ? figure.series.size()
                           : figure.kind == FigureKind::kForest ? figure.categories.size()
                                                                : 0;
  if (rows == 0) return kChartHeight_mm;
  return std::min(kTallestChart_mm, kFrame_mm + kRowHeight_mm * static_cast<double>(rows));
}

void addTwin(PageFlow& flow, const ReportFigure& figure) {
  const ReportTable twin = figureTable(figure, kTableDecimals);
  if (twin.rows.size() > kLongestTwin || twin.columns.size() > kWidestTwin) {
    flow.text(QStringLiteral(
                  "The %1 values drawn are too many to print here; the program shows them under Results.")
                  .arg(twin.rows.size() * (twin.columns.size() - 1)),
              7.5, false, kQuiet);
    return;
  }
  flow.table(twin.columns, twin.rows);
  flow.space(1.0);
}

void addFigure(PageFlow& flow, const ReportFigure& figure) {
  const double height_mm = heightOf(figure);
  flow.text(text(figure.title), 9.5, true, kAccent, height_mm + 8.0);
  const double width_mm = flow.width_mm();
  flow.add(height_mm, [&figure, width_mm, height_mm](QPainter& painter, const QRectF& area, double) {
    QGraphicsScene scene;
    QGraphicsWidget* chart = buildFigure(figure).release();  // the scene owns it from here
    scene.addItem(chart);
    chart->resize(width_mm * kChartPixelsPerMm, height_mm * kChartPixelsPerMm);
    scene.setSceneRect(chart->geometry());
    scene.render(&painter, area, scene.sceneRect());
  });
  addTwin(flow, figure);
  addNotes(flow, figure.notes, figure.provenance);
}

void addTable(PageFlow& flow, const ReportTable& table) {
  for (const auto& row : table.rows) TORSIO_EXPECTS(row.size() == table.columns.size());
  flow.text(text(table.title), 9.5, true, kAccent, 16.0);
  flow.space(1.0);
  flow.table(table.columns, table.rows);
  flow.space(1.0);
  addNotes(flow, table.notes, table.provenance);
}

void addCover(PageFlow& flow, const ReportModel& model) {
  flow.add(30.0, [](QPainter& painter, const QRectF& area, double unit) {
    painter.fillRect(QRectF(area.left(), area.top() + 12.0 * unit, 18.0 * unit, 1.6 * unit), kAccent);
  });
  flow.text(text(model.title), 24.0, true, kAccent);
  flow.space(2.0);
  flow.text(text(model.subtitle), 13.0, false, kQuiet);
  flow.space(8.0);
  if (model.demonstration) {
    flow.text(QStringLiteral(
                  "Demonstration: the people, their movements and all marks in this report are simulated. "
                  "Nothing in it is a result about real trainees."),
              10.5, true, kWarning);
    flow.space(6.0);
  }
  std::vector<std::vector<std::string>> facts;
  if (!model.centre.empty()) facts.push_back({"Centre", model.centre});
  for (const auto& [label, value] : model.facts) facts.push_back({label, value});
  flow.table({"", ""}, facts);
  flow.space(8.0);
  flow.text(
      QStringLiteral("Torsio is a training tool. It is not a medical device and holds no patient data."), 8.5,
      false, kQuiet);
}

void compose(PageFlow& flow, const ReportModel& model) {
  addCover(flow, model);
  for (const ReportSection& section : model.sections) {
    const bool first = &section == &model.sections.front();
    if (first || flow.room_mm() < kSectionStart_mm) {
      flow.newPage();
    } else {
      flow.space(6.0);
    }
    flow.text(text(section.title), 16.0, true, kAccent, 20.0);
    flow.space(2.5);
    for (const std::string& paragraph : section.paragraphs) {
      flow.text(text(paragraph), 9.5);
      flow.space(2.0);
    }
    flow.space(2.0);
    for (const ReportFigure& figure : section.figures) addFigure(flow, figure);
    for (const ReportTable& table : section.tables) addTable(flow, table);
  }
}

}  // namespace

void writePdfReport(const ReportModel& model, const std::filesystem::path& file,
                    const PdfProgress& progress) {
  TORSIO_EXPECTS(QCoreApplication::instance() != nullptr);
  const std::filesystem::path temporary = temporaryBeside(file);
  std::error_code failed;
  bool painted = false;
  {
    QPdfWriter writer(QString::fromStdString(temporary.string()));
    writer.setResolution(kResolution_dpi);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setTitle(text(model.title));
    writer.setCreator(QStringLiteral("Torsio ") + text(model.softwareVersion));
    const QString created = QDateTime::fromMSecsSinceEpoch(model.createdUtc_us / 1000, Qt::UTC)
                                .toString(QStringLiteral("yyyy-MM-dd HH:mm 'UTC'"));
    PageFlow::Style style;
    style.headerText = text(model.title);
    style.footerText = QStringLiteral("Torsio %1  |  %2").arg(text(model.softwareVersion), created);
    if (model.demonstration) style.watermark = QStringLiteral("DEMONSTRATION DATA - SIMULATED");
    PageFlow flow(writer, style);
    compose(flow, model);
    QPainter painter;
    if (painter.begin(&writer)) {
      try {
        flow.render(painter, progress);
      } catch (...) {
        painter.end();
        std::filesystem::remove(temporary, failed);
        throw;
      }
      painted = painter.end();
    }
  }
  if (painted) std::filesystem::rename(temporary, file, failed);
  if (!painted || failed) {
    std::filesystem::remove(temporary, failed);
    throw Error(ErrorCode::kFileUnwritable, "the report cannot be written", file.string(),
                "Check that the folder exists, is not read-only, and that the disk is not full");
  }
}

}  // namespace torsio
