// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <QBarSeries>
#include <QBarSet>
#include <QBoxPlotSeries>
#include <QBoxSet>
#include <QCategoryAxis>
#include <QChart>
#include <QGraphicsScene>
#include <QGraphicsTextItem>
#include <QImage>
#include <QPainter>
#include <QProcess>
#include <gtest/gtest.h>
#include <qpdf/QPDF.hh>

#include "app/outputs/charts/chart_builder.h"
#include "app/outputs/charts/graphics_application.h"
#include "app/outputs/pdf/pdf_report.h"
#include "app/outputs/pdf/pdf_structure.h"
#include "app/outputs/wording/wording.h"
#include "assessment/results/cohort_report.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/file_lock.h"
#include "tests/support/demonstration_cohort.h"

namespace torsio {
namespace {

namespace fs = std::filesystem;

fs::path freshFolder(const std::string& name) {
  const fs::path folder = fs::temp_directory_path() / ("torsio-report-" + name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

ReportFigure figureOf(FigureKind kind) {
  ReportFigure figure;
  figure.id = "figure";
  figure.title = Text::verbatim("Marks by index");
  figure.kind = kind;
  figure.xLabel = Text::verbatim("index");
  figure.yLabel = Text::verbatim("mark (0 to 10)");
  figure.yMin = 0.0;
  figure.yMax = 10.0;
  for (int c = 1; c <= 9; ++c) {
    figure.categories.push_back(std::to_string(c));
  }
  for (const char* name : {"proposed model", "finite elements", "mass-spring"}) {
    FigureSeries series;
    series.name = std::string(name);
    for (int c = 0; c < 9; ++c) {
      series.y.push_back(8.0 - 0.3 * c - static_cast<double>(figure.series.size()));
      series.low.push_back(*series.y.back() - 2.0);
      series.high.push_back(*series.y.back() + 1.5);
      series.x.push_back(c);
    }
    series.box = BoxSummary{5, 6, 7, 8, 9, 6.9, {2.5}};
    figure.series.push_back(series);
  }
  figure.notes = {Text::verbatim("The whisker ends at the last value within 1.5 interquartile ranges.")};
  figure.provenance = {Text::verbatim("Eq. 25"), "1", Text::verbatim("40"), Text::verbatim("0"), {}};
  return figure;
}

ReportModel smallReport() {
  ReportModel model;
  model.title = Text::verbatim("Twist training: cohort report");
  model.subtitle = Text::verbatim("Three groups of ten");
  model.softwareVersion = "0.1.0";
  model.demonstration = true;
  model.facts = {{Text::verbatim("Trainees"), Text::verbatim("30")},
                 {Text::verbatim("Raters"), Text::verbatim("10")}};
  ReportSection section;
  section.title = Text::verbatim("Evaluation");
  section.paragraphs = {Text::verbatim("Forty raters marked nine indices of three models.")};
  for (const FigureKind kind : {FigureKind::kGroupedBars, FigureKind::kRanges, FigureKind::kBoxes,
                                FigureKind::kPoints, FigureKind::kLines}) {
    section.figures.push_back(figureOf(kind));
  }
  ReportTable table;
  table.title = Text::verbatim("A table longer than a page");
  table.columns = {Text::verbatim("index"), Text::verbatim("name"), Text::verbatim("M")};
  for (int i = 0; i < 80; ++i) {
    table.rows.push_back({std::to_string(i), Text::verbatim("effectiveness"), Text::verbatim("7.87")});
  }
  section.tables.push_back(table);
  model.sections.push_back(section);
  return model;
}

ReportFigure intervals() {
  ReportFigure figure = figureOf(FigureKind::kForest);
  figure.references = {{5.0, Text::verbatim("middle")}};
  return figure;
}

/// A file as read by qpdf, which rejects broken cross-references.
class ReadPdf {
 public:
  explicit ReadPdf(const fs::path& file) {
    pdf_.setAttemptRecovery(false);
    pdf_.processFile(file.string().c_str());
  }
  QPDFObjectHandle catalog() { return pdf_.getRoot(); }
  QPDFObjectHandle info() { return pdf_.getTrailer().getKey("/Info"); }
  QPDF& file() { return pdf_; }

  /// Counts objects whose `key` is `name`; empty: any.
  std::size_t count(const std::string& key, const std::string& name = {}) {
    std::size_t count = 0;
    for (QPDFObjectHandle object : objectsWith(key)) {
      QPDFObjectHandle value = object.getKey(key);
      count += name.empty() || (value.isName() && value.getName() == name) ? 1U : 0U;
    }
    return count;
  }
  std::vector<QPDFObjectHandle> objectsWith(const std::string& key) {
    std::vector<QPDFObjectHandle> found;
    for (QPDFObjectHandle object : pdf_.getAllObjects()) {
      if (object.isDictionary() && object.hasKey(key)) {
        found.push_back(object);
      }
    }
    return found;
  }
  static std::string stream(QPDFObjectHandle object) {
    const std::shared_ptr<Buffer> data = object.getStreamData();
    return {reinterpret_cast<const char*>(data->getBuffer()), data->getSize()};
  }

 private:
  QPDF pdf_;
};

TEST(PdfReport, IsAVectorFileOfSeveralPages) {
  const fs::path file = freshFolder("pdf") / "cohort.pdf";

  writePdfReport(smallReport(), file);

  const std::string pdf = readFile(file);
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_GE(ReadPdf(file).file().getAllPages().size(), 5U);
  EXPECT_EQ(pdf.find("/Subtype /Image"), std::string::npos) << "charts must stay vectors";
  EXPECT_FALSE(fs::exists(temporaryBeside(file)));
}

TEST(PdfReport, IsWrittenByOneProgramAtATime) {
  const fs::path file = freshFolder("pdf-twice") / "cohort.pdf";
  const PartFile other(file);

  EXPECT_THROW(writePdfReport(smallReport(), file), Error);

  EXPECT_FALSE(fs::exists(file));
}

TEST(PdfReport, HasBookmarksOfSectionsFiguresAndTablesAndItsReferenceOnEveryPage) {
  const fs::path file = freshFolder("bookmarks") / "report.pdf";
  ReportModel model = smallReport();
  model.number = "R-12-3fa29b1c";
  model.numbersHash = std::string(64, 'a');
  model.auditHead = std::string(64, 'b');
  std::size_t said = 0;
  std::size_t pages = 0;
  const Wording listen = [&said](const Text& text) {
    const QString words = englishWording(text);
    said += words.contains(QStringLiteral("R-12-3fa29b1c")) && words.contains(QString(64, QLatin1Char('b')))
                ? 1U
                : 0U;
    return words;
  };

  writePdfReport(
      model, file, listen, [&pages](std::size_t, std::size_t all) { pages = all; }, "zh_CN");

  ReadPdf pdf(file);
  EXPECT_EQ(pdf.catalog().getKey("/PageMode").getName(), "/UseOutlines");
  EXPECT_EQ(pdf.catalog().getKey("/Lang").getUTF8Value(), "zh-CN");
  std::size_t things = 1;  // the annex with the values of the figures
  std::size_t inFirst = 0;
  for (const ReportSection& section : model.sections) {
    inFirst = section.figures.size() + section.tables.size();
    things += 1 + 2 * section.figures.size() + section.tables.size();
  }
  EXPECT_EQ(pdf.count("/Dest"), things);
  QPDFObjectHandle outlines = pdf.catalog().getKey("/Outlines");
  ASSERT_EQ(model.sections.size(), 1U);
  EXPECT_EQ(outlines.getKey("/Count").getIntValue(), 2);
  EXPECT_EQ(outlines.getKey("/First").getKey("/Title").getUTF8Value(), "Evaluation");
  EXPECT_EQ(outlines.getKey("/First").getKey("/Count").getIntValue(), -static_cast<int>(inFirst));
  EXPECT_EQ(said, 1U) << "composed once and drawn in the foot of all " << pages << " pages";
}

/// Returns the number of the page on which the first section of the annex begins, from 1.
std::size_t firstPageOfAnnex(QPDF& file, const std::string& annex) {
  const std::vector<QPDFObjectHandle>& pages = file.getAllPages();
  for (QPDFObjectHandle entry = file.getRoot().getKey("/Outlines").getKey("/First"); entry.isDictionary();
       entry = entry.getKey("/Next")) {
    if (!entry.getKey("/Title").getUTF8Value().starts_with(annex)) {
      continue;
    }
    const QPDFObjectHandle page = entry.getKey("/Dest").getArrayItem(0);
    for (std::size_t i = 0; i < pages.size(); ++i) {
      if (pages[i].getObjGen() == page.getObjGen()) {
        return i + 1;
      }
    }
  }
  return 0;
}

TEST(PdfReport, HasABodyOfTwelvePagesAndChecklistsOfTwo) {
  const ReportModel model = cohortReport(testing::demonstrationCohort());
  struct Language {
    const char* code;
    const char* annex;
    const char* checklists;
    const char* values;
  };
  for (const auto& [language, annex, checklists, values] :
       {Language{"en", "Annex", "Annex: Checklists", "Annex: values of the figures"},
        Language{"zh_CN", "附录", "附录：清单", "附录：各图的数值"}}) {
    const fs::path file = freshFolder(std::string("body-") + language) / "report.pdf";
    writePdfReport(model, file, wordingIn(language), {}, language);
    ReadPdf pdf(file);
    const std::size_t page = firstPageOfAnnex(pdf.file(), annex);
    EXPECT_GE(page, 8U) << language;
    EXPECT_LE(page, 13U) << language << ": the annex begins on a page of its own";
    const std::size_t begin = firstPageOfAnnex(pdf.file(), checklists);
    ASSERT_GT(begin, page) << language;
    EXPECT_EQ(firstPageOfAnnex(pdf.file(), values) - begin, 2U) << language;
  }
}

TEST(PdfReport, DeclaresThatItIsAnArchiveFileAndContainsWhatOneNeeds) {
  const fs::path file = freshFolder("archive") / "report.pdf";

  writePdfReport(smallReport(), file);

  const std::string pdf = readFile(file);
  EXPECT_NE(pdf.find("pdfaid:part=\"1\""), std::string::npos);
  EXPECT_NE(pdf.find("pdfaid:conformance=\"B\""), std::string::npos);
  ReadPdf read(file);
  EXPECT_TRUE(read.catalog().getKey("/Metadata").isStream());
  EXPECT_TRUE(read.catalog().getKey("/OutputIntents").isArray());
  EXPECT_TRUE(read.file().getTrailer().hasKey("/ID"));
  EXPECT_EQ(pdf.substr(0, 8), "%PDF-1.4") << "PDF/A-1";
  EXPECT_EQ(pdf.find("/ObjStm"), std::string::npos) << "PDF/A-1";
  for (std::size_t at = pdf.find("/SMask"); at != std::string::npos; at = pdf.find("/SMask", at + 1)) {
    EXPECT_EQ(pdf.substr(at, 12), "/SMask /None") << "no transparency in PDF/A-1";
  }
  for (const char* key : {"/CA ", "/ca "}) {
    for (std::size_t at = pdf.find(key); at != std::string::npos; at = pdf.find(key, at + 1)) {
      EXPECT_EQ(pdf.substr(at + 4, 3), "1.0") << key;
    }
  }
}

std::size_t countOf(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + what.size())) {
    ++count;
  }
  return count;
}

TEST(PdfReport, IsTaggedForScreenReaders) {
  const fs::path file = freshFolder("tagged") / "report.pdf";
  ReportModel model = smallReport();
  model.centre = "Skills & sutures";

  writePdfReport(model, file);

  ReadPdf pdf(file);
  EXPECT_TRUE(pdf.catalog().getKey("/MarkInfo").getKey("/Marked").getBoolValue());
  EXPECT_TRUE(pdf.catalog().hasKey("/StructTreeRoot"));
  EXPECT_EQ(pdf.info().getKey("/Author").getUTF8Value(), "Skills & sutures");
  const std::string xml = readFile(file);  // uncompressed, so that text search finds it
  EXPECT_NE(xml.find("<rdf:li>Skills &amp; sutures</rdf:li>"), std::string::npos);
  EXPECT_NE(xml.find("<dc:language><rdf:Bag><rdf:li>en</rdf:li>"), std::string::npos);
  std::size_t figures = 0;
  std::size_t titles = 0;
  for (const ReportSection& section : model.sections) {
    figures += section.figures.size();
    titles += 2 * section.figures.size() + section.tables.size();  // each figure's values are in the annex
  }
  EXPECT_EQ(pdf.count("/S", "/H1"), model.sections.size() + 1);
  EXPECT_EQ(pdf.count("/S", "/H2"), titles);
  EXPECT_EQ(pdf.count("/S", "/Figure"), figures);
  EXPECT_EQ(pdf.count("/Alt"), figures);
  EXPECT_GE(pdf.count("/S", "/Table"), 2U);
  EXPECT_GT(pdf.count("/S", "/TH"), 2U);
  std::size_t pieces = 0;
  for (QPDFObjectHandle page : pdf.file().getAllPages()) {
    const std::string drawing = ReadPdf::stream(page.getKey("/Contents"));
    const std::size_t named = countOf(drawing, " BDC\n");
    pieces += named;
    EXPECT_GT(named, 0U);
    EXPECT_EQ(named + countOf(drawing, " BMC\n"), countOf(drawing, "EMC\n"));
    EXPECT_EQ(countOf(drawing, "-5000"), 0U) << "no mark is left in the drawing";
    EXPECT_TRUE(page.hasKey("/StructParents"));
  }
  EXPECT_EQ(pdf.count("/Type", "/StructElem"),
            pieces + 1 + pdf.count("/S", "/Table") + pdf.count("/S", "/TR"));
}

TEST(PdfReport, TextCanBeFoundAndCopiedExactly) {
  const fs::path file = freshFolder("letters") / "report.pdf";
  ReportModel model = smallReport();
  model.number = "R-12-3ffa29b1";
  model.numbersHash = "ff0ffi1ffl2fi3fl";  // common ligatures

  writePdfReport(model, file);

  ReadPdf pdf(file);
  std::size_t fonts = 0;
  for (QPDFObjectHandle font : pdf.objectsWith("/ToUnicode")) {
    const std::string map = ReadPdf::stream(font.getKey("/ToUnicode"));
    ++fonts;
    EXPECT_NE(map.find("begincmap"), std::string::npos);
    EXPECT_EQ(map.find("<FB0"), std::string::npos) << "joined letters";
    EXPECT_EQ(map.find("<fb0"), std::string::npos) << "joined letters";
  }
  EXPECT_GT(fonts, 0U);
}

TEST(PdfStructure, RejectsOtherFiles) {
  EXPECT_THROW((void)withStructure("", {}), Error);
  EXPECT_THROW((void)withStructure("startxref\n5\n/Root 1 0 R /Size 3", {}), Error);
}

TEST(PdfReport, StatesWhereToFindValuesTooManyToPrint) {
  ReportModel model = smallReport();
  ReportFigure figure;
  figure.title = Text::verbatim("A course of two hundred moments");
  figure.kind = FigureKind::kLines;
  FigureSeries series{Text::verbatim("model"), {}, {}, {}, {}, {}, {}, false};
  for (int i = 0; i < 200; ++i) {
    series.x.push_back(i);
    series.y.emplace_back(i);
  }
  figure.series = {series};
  figure.valuesStand = Text::verbatim("They stand in course.csv.");
  model.sections[0].figures = {figure};
  std::vector<QString> said;
  const Wording listen = [&said](const Text& text) {
    said.push_back(englishWording(text));
    return said.back();
  };

  writePdfReport(model, freshFolder("values") / "values.pdf", listen);

  EXPECT_NE(std::find(said.begin(), said.end(), QStringLiteral("They stand in course.csv.")), said.end());
  EXPECT_NE(std::find(said.begin(), said.end(),
                      QStringLiteral("The values of these figures are too many to print: A course of two "
                                     "hundred moments.")),
            said.end())
      << "a sentence of its own";
  for (const QString& sentence : said) {
    EXPECT_FALSE(sentence.contains(QStringLiteral("Results"))) << sentence.toStdString();
  }
}

TEST(PdfReport, FailsForAMissingFolderAndLeavesNothing) {
  const fs::path folder = freshFolder("missing");
  const fs::path file = folder / "no-such-folder" / "cohort.pdf";

  EXPECT_THROW(writePdfReport(smallReport(), file), Error);
  EXPECT_TRUE(fs::is_empty(folder));
}

TEST(ChartBuilder, DrawsOneBarSetPerSeries) {
  const auto chart = buildChart(figureOf(FigureKind::kGroupedBars));
  ASSERT_EQ(chart->series().size(), 1);
  const auto* bars = qobject_cast<QBarSeries*>(chart->series().first());
  ASSERT_NE(bars, nullptr);
  EXPECT_EQ(bars->barSets().size(), 3);
  EXPECT_DOUBLE_EQ(bars->barSets().first()->at(0), 8.0);
}

TEST(ChartBuilder, NamesEachCategoryEvenIfTwoNamesAreEqual) {
  for (const FigureKind kind : {FigureKind::kGroupedBars, FigureKind::kPoints, FigureKind::kForest}) {
    ReportFigure figure = figureOf(kind);
    figure.categories[8] = figure.categories[2];
    const std::unique_ptr<QChart> chart = buildChart(figure);
    qsizetype named = 0;
    for (QAbstractAxis* axis : chart->axes()) {
      if (auto* categories = qobject_cast<QCategoryAxis*>(axis)) {
        named = categories->categoriesLabels().size();
      }
    }
    EXPECT_EQ(named, 9) << static_cast<int>(kind);
  }
}

TEST(ChartBuilder, TruncatesNoNameOfTheNineIndicesOnPaper) {
  ReportFigure figure = figureOf(FigureKind::kGroupedBars);
  figure.xLabel = {};
  figure.categories = {Text::verbatim("Effectiveness"),
                       Text::verbatim("Force feedback"),
                       Text::verbatim("Real-time performance"),
                       Text::verbatim("System stability"),
                       Text::verbatim("Deformation efficiency"),
                       Text::verbatim("Fidelity"),
                       Text::verbatim("Image fluency"),
                       Text::verbatim("Telepresence"),
                       Text::verbatim("Texture")};
  QGraphicsScene scene;
  QChart* chart = buildChart(figure).release();  // the scene takes ownership
  scene.addItem(chart);
  constexpr double kAcrossPage_px = 170.0 * 3.78;  // width on a report page
  chart->resize(kAcrossPage_px, 280.0);
  QImage paper(static_cast<int>(kAcrossPage_px), 280, QImage::Format_RGB32);
  QPainter painter(&paper);
  scene.render(&painter);

  std::set<QString> drawn;
  for (const QGraphicsItem* item : scene.items()) {
    if (const auto* text = qgraphicsitem_cast<const QGraphicsTextItem*>(item)) {
      drawn.insert(text->toPlainText().simplified());
    }
  }
  for (const Text& name : figure.categories) {
    EXPECT_TRUE(drawn.contains(QString::fromStdString(name.str()))) << name;
  }
}

TEST(PdfReport, ReportsEveryPageAndLeavesNothingIfCancelled) {
  const fs::path folder = freshFolder("cancel");
  const fs::path file = folder / "cohort.pdf";
  writeFileAtomically(file, "older");
  struct GivenUp {};

  EXPECT_THROW(writePdfReport(smallReport(), file, englishWording,
                              [](std::size_t page, std::size_t pages) {
                                EXPECT_GE(pages, 5U);
                                if (page == 2) {
                                  throw GivenUp{};
                                }
                              }),
               GivenUp);

  EXPECT_EQ(readFile(file), "older");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST(PdfReport, DrawsForestsHeatMapsAndCloudsAsVectors) {
  ReportModel model;
  model.title = Text::verbatim("Kinds");
  ReportSection section;
  section.title = Text::verbatim("All");
  ReportFigure cloud = figureOf(FigureKind::kScatter);
  section.figures = {intervals(), figureOf(FigureKind::kHeatMap), cloud};
  model.sections.push_back(section);
  const fs::path file = freshFolder("kinds") / "kinds.pdf";

  writePdfReport(model, file);

  EXPECT_EQ(readFile(file).find("/Subtype /Image"), std::string::npos);
}

TEST(ChartBuilder, DistinguishesSeriesWithoutColour) {
  const auto chart = buildChart(figureOf(FigureKind::kGroupedBars));
  const auto* bars = qobject_cast<QBarSeries*>(chart->series().first());
  std::set<Qt::BrushStyle> patterns;
  for (const QBarSet* set : bars->barSets()) {
    patterns.insert(set->brush().style());
  }
  EXPECT_EQ(patterns.size(), 3U);
  // Higher values are darker in a heat map, on white; lightness is monotonic.
  for (int i = 1; i <= 10; ++i) {
    EXPECT_LT(qGray(shade(0.1 * i).rgb()), qGray(shade(0.1 * (i - 1)).rgb()));
  }
}

TEST(ChartBuilder, DrawsOneBoxPerSeriesWithItsMedian) {
  const auto chart = buildChart(figureOf(FigureKind::kBoxes));
  const auto* boxes = qobject_cast<QBoxPlotSeries*>(chart->series().first());
  ASSERT_NE(boxes, nullptr);
  ASSERT_EQ(boxes->count(), 3);
  EXPECT_DOUBLE_EQ(boxes->boxSets().first()->at(QBoxSet::Median), 7.0);
}

}  // namespace
}  // namespace torsio

int main(int argc, char** argv) {
  ::testing::InitGoogleTest(&argc, argv);
  const auto application = torsio::makeHeadlessGraphicsApplication(argc, argv);
  return RUN_ALL_TESTS();
}
