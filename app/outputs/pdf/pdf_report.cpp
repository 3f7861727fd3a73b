// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/pdf/pdf_report.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <vector>

#include <QCoreApplication>
#include <QGraphicsScene>
#include <QGraphicsWidget>
#include <QPainter>
#include <QPdfWriter>
#include <QStringList>

#include "app/outputs/charts/category_labels.h"
#include "app/outputs/charts/chart_builder.h"
#include "app/outputs/charts/chart_style.h"
#include "app/outputs/charts/relief_item.h"
#include "app/outputs/pdf/page_flow.h"
#include "app/outputs/pdf/pdf_structure.h"
#include "app/outputs/wording/joined_sentences.h"
#include "assessment/results/figure_table.h"
#include "assessment/results/number_format.h"
#include "assessment/results/provenance_line.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/core/file_lock.h"

namespace torsio {

namespace {

constexpr int kResolution_dpi = 600;
constexpr double kChartHeight_mm = 64.0;
constexpr double kCloudHeight_mm = 84.0;  // flatter, the shape of a cloud would be lost; thirty values fit
                                          // below
constexpr double kRowHeight_mm = 7.0;     // of a heat map or forest
constexpr double kAnswerFrame_mm = 18.0;  // numbers and title of the axis; less, and Qt leaves them out
constexpr double kAnswerRow_mm = 5.5;     // of the first page's forest
constexpr std::size_t kMinRows = 3;       // whose room it has: with less Qt shortens numbers to dots
constexpr double kFrame_mm = 24.0;        // axis, labels and legend around the rows
constexpr double kTallestChart_mm = 170.0;
constexpr double kTallestPictures_mm = 225.0;
constexpr int kTableDecimals = 4;
constexpr std::size_t kLongestTwin = 100;  // rows; longer tables would swamp the annex
constexpr std::size_t kWidestTwin = 12;    // columns that fit on a page
constexpr double kHalfRatio = 1.45;        // width over height of a figure in a column
// Labels of a forest that can be read in a column: rows, and characters of one.
constexpr qsizetype kNarrowRows = 12;
constexpr qsizetype kNarrowLabel = 24;
constexpr double kAxisShare = 0.87;   // of a chart's width; the rest is for its numbers and title
constexpr double kColumnScale = 1.3;  // chart fonts in a column appear at about 7 points
constexpr double kTitle_pt = 9.5;
constexpr double kSectionStart_mm =
    45.0;  // a section begins on the page of the previous one if so much is free
constexpr double kChartPixelsPerMm = 3.78;  // 96 pixels per inch: chart fonts appear at about 9 points
constexpr double kNote_pt = 7.5;
constexpr std::array kBoard_pt{9.0, 8.5, 8.0};  // of the first page, the largest that has room
constexpr double kBoardTitle_pt = 13.0;
constexpr double kBoardGap_mm = 0.8;
constexpr double kHeading_mm = 8.0;
constexpr double kBelowTitle_mm = 1.0;  // of a table
constexpr double kBehindNotes_mm = 4.0;
constexpr std::size_t kRowsWithTitle = 2;
constexpr double kShortTable_mm = 60.0;
constexpr std::size_t kFoldedRows = 14;  // from so many on, a narrow table goes down both columns of a page
const QColor kAccent(0x00, 0x4A, 0x7C);

double heightOf(const ReportFigure& figure, double width_mm) {
  if (figure.kind == FigureKind::kReliefs) {
    return std::min(kTallestPictures_mm,
                    ReliefItem::heightFor(figure, width_mm * kChartPixelsPerMm) / kChartPixelsPerMm);
  }
  const std::size_t rows = figure.kind == FigureKind::kHeatMap  ? figure.series.size()
                           : figure.kind == FigureKind::kForest ? figure.categories.size()
                                                                : 0;
  if (rows == 0) {
    return figure.kind == FigureKind::kScatter ? kCloudHeight_mm : kChartHeight_mm;
  }
  return figure.valuesInLabels
             ? kAnswerFrame_mm + kAnswerRow_mm * static_cast<double>(std::max(rows, kMinRows))
             : std::min(kTallestChart_mm, kFrame_mm + kRowHeight_mm * static_cast<double>(rows));
}

/// Returns the style of a chart that is so many pixels wide.
ChartStyle styleFor(double width_px) {
  ChartStyle style;
  style.axis_px = kAxisShare * width_px;
  return style;
}

/// Returns whether a figure and its labels can be read in a column of this width.
bool isNarrow(const ReportFigure& figure, const Wording& say, double width_mm) {
  if (figure.kind == FigureKind::kHeatMap || figure.kind == FigureKind::kReliefs || figure.valuesInLabels) {
    return false;
  }
  QStringList labels;
  qsizetype longest = 0;
  for (const Text& category : figure.categories) {
    labels << say(category);
    longest = std::max(longest, labels.back().size());
  }
  return figure.kind == FigureKind::kForest
             ? labels.size() <= kNarrowRows && longest <= kNarrowLabel
             : labels.isEmpty() ||
                   labelsAreReadable(labels, styleFor(width_mm * kColumnScale * kChartPixelsPerMm));
}

/// Lays out a report on pages in one language.
class Composer {
 public:
  Composer(PageFlow& flow, const Wording& wording)
      : flow_(flow), say_([&wording](const Text& text) {  // a number and its per cent sign stay together
          return wording(text).replace(QStringLiteral(" %"), QStringLiteral("\u00A0%"));
        }) {}

  /// `whole`: a page of its own; otherwise other content must fit below.
  void title(const ReportModel& model, bool whole) {
    const double above_mm = whole ? 12.0 : 2.0;
    flow_.add(above_mm + (whole ? 18.0 : 4.0), [above_mm](QPainter& painter, const QRectF& area,
                                                          double unit) {
      painter.fillRect(QRectF(area.left(), area.top() + above_mm * unit, 18.0 * unit, 1.6 * unit), kAccent);
    });
    flow_.text(say_(model.title), whole ? 24.0 : 17.0, true, kAccent);
    flow_.space(whole ? 2.0 : 1.0);
    flow_.text(say_(model.subtitle), whole ? 13.0 : 10.0, false, kQuietInk);
    flow_.space(whole ? 8.0 : 3.0);
    if (model.demonstration) {
      flow_.text(say_(Text::tr("Demonstration: the people, their movements and all marks in this report are "
                               "simulated. Nothing in it is a result about real trainees.")),
                 whole ? 10.5 : 8.5, true, kWarningInk);
      flow_.space(whole ? 6.0 : 3.0);
    }
  }

  void facts(const ReportModel& model) {
    PlainTable facts{{QString(), QString()}, {}};
    if (!model.centre.empty()) {
      facts.rows.push_back({say_(Text::tr("Centre")), say_(model.centre)});
    }
    for (const auto& [label, value] : model.facts) {
      facts.rows.push_back({say_(label), say_(value)});
    }
    flow_.table(facts);
    flow_.space(8.0);
    flow_.text(
        say_(Text::tr("Torsio is a training tool. It is not a medical device and holds no patient data.")),
        8.5, false, kQuietInk);
  }

  /// Lays out the first page: as many reservations as leave room for the rest, and all of them behind it if
  /// some do not fit.
  void board(const ReportSection& section) {
    ReportSection rest{"reservations", Text::tr("What stands against the answer")};
    rest.paragraphs = {Text::tr(
        "In this order: doubts about the data, what else could explain a difference, missing data, how "
        "the answer was reached.")};
    std::copy_if(section.paragraphs.begin(), section.paragraphs.end(), std::back_inserter(rest.paragraphs),
                 [](const ReportParagraph& one) { return one.reservation; });
    const std::size_t reservations = rest.paragraphs.size() - 1;
    std::size_t shown = reservations;
    std::vector<ReportParagraph> paragraphs = section.paragraphs;
    const std::vector<Item> items = itemsOf(section);
    const auto found = [&] {
      return std::any_of(kBoard_pt.begin(), kBoard_pt.end(), [&](double points) {
        board_pt_ = points;
        return fits(section, paragraphs, items);
      });
    };
    while (!found() && shown > 0) {  // smaller letters before fewer reservations
      paragraphs = withReservations(section.paragraphs, --shown, reservations);
    }
    this->section(section, paragraphs);
    flow_.newPage();
    if (shown < reservations) {
      this->section(rest, rest.paragraphs);
      flow_.space(4.0);
    }
  }

  void section(const ReportSection& section) { this->section(section, section.paragraphs); }

  void section(const ReportSection& section, const std::vector<ReportParagraph>& paragraphs) {
    const double gap_mm = section.onFirstPage ? kBoardGap_mm : 2.0;
    std::vector<Item> items = itemsOf(section);
    double below_mm = 20.0;
    if (paragraphs.size() <= 1 && !items.empty()) {  // no heading stands alone, or with one sentence
      below_mm = 3.0 * gap_mm + items.front().begin_mm;
      for (const Text& paragraph : paragraphs) {
        below_mm += flow_.textHeight_mm(say_(paragraph), 9.5);
      }
    }
    flow_.text(say_(section.title), section.onFirstPage ? kBoardTitle_pt : 16.0, true, kAccent, below_mm);
    flow_.bookmark(say_(section.title), 0);
    flow_.space(gap_mm);
    for (const Text& paragraph : paragraphs) {
      flow_.text(say_(paragraph), section.onFirstPage ? board_pt_ : 9.5);
      flow_.space(gap_mm);
    }
    flow_.space(gap_mm);
    place(std::move(items));
  }

  /// Adds the values of all figures, those that fit as tables.
  void values(const ReportModel& model) {
    std::vector<ReportTable> twins;
    std::vector<Text> unprinted;
    Text where;
    for (const ReportSection& section : model.sections) {
      for (const ReportFigure& figure : section.figures) {
        ReportTable twin = figureTable(figure, kTableDecimals);
        if (figure.valuesInLabels || twin.rows.empty()) {
          continue;
        }
        if (twin.rows.size() > kLongestTwin || twin.columns.size() > kWidestTwin) {
          unprinted.push_back(figure.title);
          where = figure.valuesStand.empty() ? where : figure.valuesStand;
          continue;
        }
        twin.title = figure.title;
        twin.notes.clear();
        twin.provenance = {};
        twins.push_back(std::move(twin));
      }
    }
    if (!twins.empty() || !unprinted.empty()) {
      flow_.newPage();
      flow_.text(say_(Text::tr("Annex: values of the figures")), 16.0, true, kAccent, 20.0);
      flow_.bookmark(say_(Text::tr("Annex: values of the figures")), 0);
      flow_.space(2.0);
    }
    for (std::size_t i = 0; i < twins.size(); ++i) {
      if (i + 1 < twins.size() && fitsColumn(twins[i]) && fitsColumn(twins[i + 1])) {
        addPair(twins[i], twins[i + 1]);
        ++i;
      } else {
        place({tableItem(twins[i])});
      }
    }
    if (!unprinted.empty()) {
      flow_.text(joinedSentences({say_(Text::tr("The values of these figures are too many to print: %1.",
                                                listed(unprinted, Text::tr("%1; %2")))),
                                  say_(where)}),
                 kNote_pt, false, kQuietInk);
    }
  }

 private:
  [[nodiscard]] PlainTable plain(const ReportTable& table) const {
    PlainTable out;
    for (const Text& column : table.columns) {  // keep "Eq. 25" together
      out.columns.push_back(say_(column).replace(QStringLiteral("Eq. "), QStringLiteral("Eq.\u00A0")));
    }
    for (const std::vector<ReportCell>& row : table.rows) {
      TORSIO_EXPECTS(row.size() == table.columns.size());
      out.rows.emplace_back();
      for (const Text& cell : row) {
        out.rows.back().push_back(say_(cell));
      }
    }
    return out;
  }

  /// Figures or a table that are placed together.
  struct Item {
    bool table = false;
    double begin_mm = 0.0;  ///< room that its first part needs
    double whole_mm = 0.0;
    double taken_mm = 0.0;  ///< with the space behind it
    std::function<void()> add;
  };

  [[nodiscard]] std::vector<Item> itemsOf(const ReportSection& section) {
    std::vector<Item> items = figureItems(section.figures);
    for (const ReportTable& table : section.tables) {
      items.push_back(tableItem(table));
    }
    return items;
  }

  /// Returns the paragraphs with so many of the reservations, and how many more there are.
  [[nodiscard]] static std::vector<ReportParagraph> withReservations(
      const std::vector<ReportParagraph>& paragraphs, std::size_t shown, std::size_t reservations) {
    std::vector<ReportParagraph> out;
    std::size_t seen = 0;
    for (const ReportParagraph& paragraph : paragraphs) {
      if (!paragraph.reservation || seen < shown) {
        out.push_back(paragraph);
      } else if (seen == shown) {
        out.emplace_back(
            shown > 0
                ? Text::tr(
                      "%1 more {reservation stands|reservations stand} against the answer. The next page "
                      "lists all %2, the most serious first.",
                      reservations - shown, reservations)
                : Text::tr("%1 {reservation stands against the answer: it is|reservations stand against "
                           "the answer: they are} on the next page, the most serious first.",
                           reservations));
      }
      seen += paragraph.reservation ? 1 : 0;
    }
    return out;
  }

  /// Returns whether the first page has room for these paragraphs and `items`.
  [[nodiscard]] bool fits(const ReportSection& section, const std::vector<ReportParagraph>& paragraphs,
                          const std::vector<Item>& items) const {
    double taken_mm = flow_.textHeight_mm(say_(section.title), kBoardTitle_pt, true) + 2.0 * kBoardGap_mm;
    for (const Text& paragraph : paragraphs) {
      taken_mm += flow_.textHeight_mm(say_(paragraph), board_pt_) + kBoardGap_mm;
    }
    for (const Item& item : items) {
      taken_mm += item.taken_mm;
    }
    return taken_mm <= flow_.room_mm();
  }

  /// Places items in order; where a figure does not fit on the page, the next table fills the room if it can.
  void place(std::vector<Item> items) {
    while (!items.empty()) {
      auto next = items.begin();
      if (!next->table && next->begin_mm > flow_.room_mm()) {
        const auto table =
            std::find_if(items.begin(), items.end(), [](const Item& item) { return item.table; });
        next = table != items.end() && table->whole_mm <= flow_.room_mm() ? table : next;
      }
      next->add();
      items.erase(next);
    }
  }

  [[nodiscard]] Item figureItem(const ReportFigure& figure) {
    const double height_mm = heightOf(figure, flow_.width_mm());
    const double begin_mm = 2.0 * kHeading_mm + height_mm;
    const double notes_mm = notesHeight_mm(figure.notes, figure.provenance, flow_.width_mm());
    const double title_mm = flow_.textHeight_mm(say_(figure.title), kTitle_pt, true);
    return {false, begin_mm, begin_mm + notes_mm, title_mm + height_mm + notes_mm + kBehindNotes_mm,
            [this, &figure, height_mm] {
              flow_.text(say_(figure.title), kTitle_pt, true, kAccent, height_mm + kHeading_mm);
              flow_.bookmark(say_(figure.title), 1);
              addChart(figure, height_mm);
              addNotes(figure.notes, figure.provenance);
            }};
  }

  /// Two figures stand beside each other where both can be read in a column; wide ones keep their place.
  [[nodiscard]] std::vector<Item> figureItems(const std::vector<ReportFigure>& figures) {
    std::vector<Item> items;
    const ReportFigure* waiting = nullptr;
    for (const ReportFigure& figure : figures) {
      if (!isNarrow(figure, say_, flow_.columnWidth_mm())) {
        items.push_back(figureItem(figure));
      } else if (waiting == nullptr) {
        waiting = &figure;
      } else {
        items.push_back(pairItem(*waiting, figure));
        waiting = nullptr;
      }
    }
    if (waiting != nullptr) {
      items.push_back(loneItem(*waiting));
    }
    return items;
  }

  /// Returns the height of a chart in a column; the rows of a forest need room for their names.
  [[nodiscard]] double columnHeight_mm(const ReportFigure& figure) const {
    const double height_mm = flow_.columnWidth_mm() / kHalfRatio;
    return figure.kind == FigureKind::kForest
               ? std::max(height_mm,
                          kFrame_mm + kAnswerRow_mm * static_cast<double>(figure.categories.size()))
               : height_mm;
  }

  /// Two figures beside each other.
  [[nodiscard]] Item pairItem(const ReportFigure& left, const ReportFigure& right) {
    const double width_mm = flow_.columnWidth_mm();
    const auto title_mm = [&](const ReportFigure& figure) {
      return flow_.textHeight_mm(say_(figure.title), kTitle_pt, true, width_mm);
    };
    const double titles_mm = std::max(title_mm(left), title_mm(right));
    const double chart_mm = std::max(columnHeight_mm(left), columnHeight_mm(right));
    const double height_mm = titles_mm + chart_mm +
                             std::max(notesHeight_mm(left.notes, left.provenance, width_mm),
                                      notesHeight_mm(right.notes, right.provenance, width_mm));
    const std::array<double, 2> below_mm = {titles_mm - title_mm(left), titles_mm - title_mm(right)};
    return {false, height_mm, height_mm, height_mm + kBehindNotes_mm,
            [this, &left, &right, height_mm, chart_mm, below_mm] {
              flow_.beginColumns(height_mm);
              addInColumn(left, below_mm[0], chart_mm);
              addNotes(left.notes, left.provenance);
              flow_.nextColumn();
              addInColumn(right, below_mm[1], chart_mm);
              addNotes(right.notes, right.provenance);
              flow_.endColumns();
            }};
  }

  /// One figure in a column, and its notes beside it.
  [[nodiscard]] Item loneItem(const ReportFigure& figure) {
    const double width_mm = flow_.columnWidth_mm();
    const double height_mm =
        std::max(columnHeight_mm(figure) + flow_.textHeight_mm(say_(figure.title), kTitle_pt, true, width_mm),
                 notesHeight_mm(figure.notes, figure.provenance, width_mm));
    return {false, height_mm, height_mm, height_mm + kBehindNotes_mm, [this, &figure, height_mm] {
              flow_.beginColumns(height_mm);
              addInColumn(figure, 0.0, columnHeight_mm(figure));
              flow_.nextColumn();
              flow_.space(kHeading_mm);
              addNotes(figure.notes, figure.provenance);
              flow_.endColumns();
              flow_.space(3.0);
            }};
  }

  /// Adds title and chart of a figure. `below_mm`: free below the title; `chart_mm`: height.
  void addInColumn(const ReportFigure& figure, double below_mm, double chart_mm) {
    flow_.text(say_(figure.title), kTitle_pt, true, kAccent);
    flow_.bookmark(say_(figure.title), 1);
    flow_.space(below_mm);
    addChart(figure, chart_mm, kColumnScale);
  }

  /// `scale`: pixels of the chart for each one that it has over the whole width.
  void addChart(const ReportFigure& figure, double height_mm, double scale = 1.0) {
    const double width_mm = flow_.width_mm();
    const double pixels = scale * kChartPixelsPerMm;
    flow_.add(
        height_mm,
        [&figure, say = say_, width_mm, height_mm, pixels](QPainter& painter, const QRectF& area, double) {
          QGraphicsScene scene;
          QGraphicsWidget* chart =
              buildFigure(figure, styleFor(width_mm * pixels), say).release();  // the scene takes ownership
          scene.addItem(chart);
          chart->resize(width_mm * pixels, height_mm * pixels);
          scene.setSceneRect(chart->geometry());
          scene.render(&painter, area, scene.sceneRect());
        },
        0.0, {PdfRole::kFigure, say_(figure.title)});
  }

  /// Returns the layout of a table in a column of the page, if it is as readable there as over the whole
  /// width.
  [[nodiscard]] std::optional<TableLayout> inColumn(const PlainTable& cells, const TableLayout& whole) const {
    TableLayout layout = flow_.layOut(cells, flow_.columnWidth_mm());
    const bool readable = layout.regular.pointSizeF() == whole.regular.pointSizeF() &&
                          layout.rows_mm == whole.rows_mm && !layout.rows_mm.empty();
    return readable ? std::optional(std::move(layout)) : std::nullopt;
  }

  /// Returns whether two tables like this one can stand beside each other.
  [[nodiscard]] bool fitsColumn(const ReportTable& table) const {
    const PlainTable cells = plain(table);
    return table.rows.size() < kFoldedRows && inColumn(cells, flow_.layOut(cells)).has_value();
  }

  /// Adds two short tables beside each other, without notes.
  void addPair(const ReportTable& left, const ReportTable& right) {
    const double width_mm = flow_.columnWidth_mm();
    const auto height_mm = [&](const ReportTable& table) {
      return flow_.textHeight_mm(say_(table.title), kTitle_pt, true, width_mm) + kBelowTitle_mm +
             flow_.layOut(plain(table), width_mm).height_mm();
    };
    const auto addOne = [&](const ReportTable& table) {
      const PlainTable cells = plain(table);
      flow_.text(say_(table.title), kTitle_pt, true, kAccent);
      flow_.bookmark(say_(table.title), 1);
      flow_.space(kBelowTitle_mm);
      flow_.table(cells, flow_.layOut(cells));
    };
    flow_.beginColumns(std::max(height_mm(left), height_mm(right)));
    addOne(left);
    flow_.nextColumn();
    addOne(right);
    flow_.endColumns();
    flow_.space(1.0 + kBehindNotes_mm);
  }

  /// A long narrow table, down both columns of the page.
  [[nodiscard]] Item foldedItem(const ReportTable& table, PlainTable cells, TableLayout layout) {
    const double notes_mm = notesHeight_mm(table.notes, table.provenance, flow_.width_mm());
    const double title_mm = flow_.textHeight_mm(say_(table.title), kTitle_pt, true);
    const double begin_mm = layout.header_mm + kRowsWithTitle * layout.rows_mm.front();
    const double whole_mm = layout.header_mm + 0.5 * layout.height_mm() + notes_mm;
    return {true, begin_mm + 2.0 * kHeading_mm, whole_mm + 2.0 * kHeading_mm,
            title_mm + whole_mm + 1.0 + kBehindNotes_mm,
            [this, &table, cells = std::move(cells), layout = std::move(layout), begin_mm] {
              flow_.text(say_(table.title), kTitle_pt, true, kAccent, begin_mm + kBelowTitle_mm);
              flow_.bookmark(say_(table.title), 1);
              flow_.space(kBelowTitle_mm);
              flow_.tableInColumns(cells, layout);
              flow_.space(1.0);
              addNotes(table.notes, table.provenance);
            }};
  }

  [[nodiscard]] Item tableItem(const ReportTable& table) {
    PlainTable cells = plain(table);
    TableLayout layout = flow_.layOut(cells);
    if (table.rows.size() >= kFoldedRows) {
      if (std::optional<TableLayout> narrow = inColumn(cells, layout)) {
        return foldedItem(table, std::move(cells), *std::move(narrow));
      }
    }
    const double notes_mm = notesHeight_mm(table.notes, table.provenance, flow_.width_mm());
    // Keep a title with the header and the first rows, or with the whole of a short table.
    double begin_mm = kHeading_mm + layout.header_mm;
    for (std::size_t r = 0; r < std::min(kRowsWithTitle, layout.rows_mm.size()); ++r) {
      begin_mm += layout.rows_mm[r];
    }
    const double whole_mm = kHeading_mm + layout.height_mm() + notes_mm;
    if (whole_mm - kHeading_mm < kShortTable_mm) {
      begin_mm = whole_mm - kHeading_mm + kBelowTitle_mm;
    }
    const double title_mm = flow_.textHeight_mm(say_(table.title), kTitle_pt, true);
    return {true, begin_mm + kHeading_mm, whole_mm + kHeading_mm,
            title_mm + layout.height_mm() + notes_mm + 1.0 + kBehindNotes_mm,
            [this, &table, cells = std::move(cells), layout = std::move(layout), begin_mm, notes_mm] {
              flow_.text(say_(table.title), kTitle_pt, true, kAccent, begin_mm);
              flow_.bookmark(say_(table.title), 1);
              flow_.space(kBelowTitle_mm);
              flow_.table(cells, layout, notes_mm);
              flow_.space(1.0);
              addNotes(table.notes, table.provenance);
            }};
  }

  [[nodiscard]] double notesHeight_mm(const std::vector<ReportParagraph>& notes, const Provenance& from,
                                      double width_mm) const {
    double height_mm = 1.0;
    for (const Text& note : notes) {
      height_mm += flow_.textHeight_mm(say_(note), kNote_pt, false, width_mm);
    }
    const Text line = provenanceLine(from);
    return line.empty() ? height_mm : height_mm + flow_.textHeight_mm(say_(line), kNote_pt, false, width_mm);
  }

  void addNotes(const std::vector<ReportParagraph>& notes, const Provenance& from) {
    const Text line = provenanceLine(from);
    const double last_mm = line.empty() ? 0.0 : flow_.textHeight_mm(say_(line), kNote_pt);
    for (const Text& note : notes) {  // keep the last line from being alone on a page
      flow_.text(say_(note), kNote_pt, false, kQuietInk, &note == &notes.back() ? last_mm : 0.0);
    }
    if (!line.empty()) {
      flow_.text(say_(line), kNote_pt, false, kQuietInk);
    }
    flow_.space(kBehindNotes_mm);
  }

  PageFlow& flow_;
  const Wording say_;
  double board_pt_ = kBoard_pt.front();
};

void compose(PageFlow& flow, const ReportModel& model, const Wording& wording) {
  Composer composer(flow, wording);
  auto next = model.sections.begin();
  const bool board = next != model.sections.end() && next->onFirstPage;
  composer.title(model, !board);
  if (board) {
    composer.board(*next++);
  }
  composer.facts(model);
  bool annex = false;
  for (auto at = next; at != model.sections.end(); ++at) {
    const ReportSection& section = *at;
    if (flow.room_mm() < kSectionStart_mm || section.startsPage || (section.annex && !annex)) {
      annex = annex || section.annex;
      flow.newPage();
    } else {
      flow.space(6.0);
    }
    composer.section(section);
  }
  composer.values(model);
}

}  // namespace

void writePdfReport(const ReportModel& model, const std::filesystem::path& file, const Wording& wording,
                    const PdfProgress& progress, const std::string& language) {
  TORSIO_EXPECTS(QCoreApplication::instance() != nullptr);
  PartFile part(file);
  bool painted = false;
  std::optional<PageFlow> flow;
  {
    const QString version = QString::fromStdString(model.softwareVersion);
    QPdfWriter writer(QString::fromStdString(part.path().string()));
    writer.setPdfVersion(QPagedPaintDevice::PdfVersion_A1b);
    writer.setResolution(kResolution_dpi);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(0, 0, 0, 0));
    writer.setTitle(wording(model.title));
    writer.setCreator(QStringLiteral("Torsio ") + version);
    const QString created = wording(formatUtc(model.createdUtc_us));
    PageFlow::Style style;
    style.headerText = wording(model.title);
    style.footerText = QStringLiteral("Torsio %1  |  %2").arg(version, created);
    if (!model.number.empty()) {
      style.reference = wording(model.auditHead.empty()
                                    ? Text::tr("Report %1  |  numbers %2", model.number, model.numbersHash)
                                    : Text::tr("Report %1  |  numbers %2\naudit trail %3", model.number,
                                               model.numbersHash, model.auditHead));
    }
    if (model.demonstration) {
      style.watermark = wording(Text::tr("DEMONSTRATION DATA \u2013 SIMULATED"));
    }
    style.pageText = [&wording](std::size_t page, std::size_t pages) {
      return wording(Text::tr("page %1 of %2", page, pages));
    };
    flow.emplace(writer, style);
    compose(*flow, model, wording);
    QPainter painter;
    if (painter.begin(&writer)) {
      try {
        flow->render(painter, progress);
      } catch (...) {
        painter.end();
        throw;
      }
      painted = painter.end();
    }
  }
  if (!painted) {
    throw Error(ErrorCode::kFileUnwritable, Text::tr("the report cannot be written"), file.string(),
                Text::tr("Check that the folder exists, is not read-only, and that the disk is not full"));
  }
  const QString centre = wording(model.centre);
  const PdfStructure structure{centre.isEmpty() ? QStringLiteral("Torsio") : centre,
                               QString::fromStdString(language).replace(QLatin1Char('_'), QLatin1Char('-')),
                               flow->bookmarks(), flow->parts()};
  writeFileAtomically(part.path(), withStructure(readFile(part.path()), structure));
  part.finish();
}

}  // namespace torsio
