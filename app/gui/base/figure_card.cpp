// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/figure_card.h"

#include <algorithm>

#include <QButtonGroup>
#include <QClipboard>
#include <QEvent>
#include <QGraphicsScene>
#include <QGraphicsWidget>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QMetaType>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/value_text.h"
#include "app/gui/widgets/window_events.h"
#include "app/outputs/charts/chart_builder.h"
#include "app/outputs/wording/printed_minus.h"
#include "app/outputs/wording/printed_value.h"
#include "assessment/results/figure_table.h"
#include "assessment/results/provenance_line.h"

namespace torsio::gui {

namespace {

constexpr QSize kCopiedPicture(1600, 900);
constexpr double kCopiedScale = 2.0;  // laid out at 800 x 450, drawn twice as large
constexpr int kDescribedRows = 12;    // a screen reader refers to the table for more
constexpr int kLabel_px = 13;
constexpr int kRowHeight = 26;
constexpr int kFrameHeight = 110;

/// Figures use the window's language.
const Wording kTranslated = [](const Text& text) { return toQString(text); };

/// Makes a cell that sorts numbers by size and times chronologically.
Cell cellOf(const Text& content) {
  Cell cell{toQString(content)};
  if (const QString written = toQString(content.str()); printedTime(written, QLocale()) != written) {
    cell.sortKey = written;
    return cell;
  }
  bool isNumber = false;
  const QString plain = plainMinus(cell.text);
  const double value = plain.toDouble(&isNumber);
  if (isNumber) {
    cell.sortKey = value;
    if (const QString shown = numberText(plain); !shown.isEmpty()) {
      cell.text = shown;
    }
  }
  return cell;
}

}  // namespace

/// Charts are designed for a few hundred pixels. On a 4K screen, hatches would blend into a tint, and marks,
/// lines and letters would be too small.
bool isWide(int width) {
  constexpr int kPlainUpTo = 1200;
  return width > kPlainUpTo;
}

void growFor(int width, ChartStyle& look) {
  constexpr double kStroke = 1.6;
  constexpr int kWideLabel_px = 17;
  const bool wide = isWide(width);
  look.hatch = wide ? 2.0 : 1.0;
  look.stroke = wide ? kStroke : 1.0;
  look.label_px = wide ? kWideLabel_px : kLabel_px;
}

ChartStyle chartStyle(const Theme& theme) {
  ChartStyle look;
  look.ground = theme.surface;
  look.ink = theme.text;
  look.grid = theme.line;
  look.dark = theme.kind == ThemeKind::kDark;
  look.label_px = kLabel_px;
  look.number = [](double value, int decimals) { return numberText(value, decimals); };
  return look;
}

QString tabbed(const ReportTable& table) {
  QStringList lines;
  const auto line = [](const auto& cells) {
    QStringList parts;
    for (const Text& cell : cells) {
      parts << plainMinus(toQString(cell));
    }
    return parts.join(QLatin1Char('\t'));
  };
  lines << line(table.columns);
  for (const std::vector<ReportCell>& row : table.rows) {
    lines << line(row);
  }
  return lines.join(QLatin1Char('\n'));
}

FigureCanvas::FigureCanvas(QWidget* parent)
    : QGraphicsView(parent), style_(chartStyle(theme(ThemeKind::kLight))) {
  setScene(new QGraphicsScene(this));
  setFrameShape(QFrame::NoFrame);
  setRenderHints(QPainter::Antialiasing | QPainter::NonCosmeticBrushPatterns);  // else hatches do not scale
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFocusPolicy(Qt::StrongFocus);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
  setBackgroundBrush(style_.ground);
}

void FigureCanvas::setFigure(const ReportFigure& figure) {
  figure_ = figure;
  rebuild();
  describe();
  updateGeometry();
}

void FigureCanvas::setTheme(const Theme& theme) {
  style_ = chartStyle(theme);
  setBackgroundBrush(style_.ground);
  rebuild();
}

QSize FigureCanvas::sizeHint() const {
  if (!figure_) {
    return {640, 360};
  }
  const std::size_t rows = figure_->kind == FigureKind::kHeatMap  ? figure_->series.size()
                           : figure_->kind == FigureKind::kForest ? figure_->categories.size()
                                                                  : 0;
  return {640, std::max(360, kFrameHeight + kRowHeight * static_cast<int>(rows))};
}

void FigureCanvas::rebuild() {
  scene()->clear();
  item_ = nullptr;
  if (!figure_) {
    return;
  }
  growFor(viewport()->width(), style_);
  item_ = buildFigure(*figure_, style_, kTranslated).release();
  scene()->addItem(item_);
  fit();
}

void FigureCanvas::fit() {
  if (item_ == nullptr) {
    return;
  }
  const QSizeF size(viewport()->size());
  item_->resize(size);
  setSceneRect(QRectF(QPointF(0, 0), size));
}

void FigureCanvas::resizeEvent(QResizeEvent* event) {
  QGraphicsView::resizeEvent(event);
  if ((style_.hatch > 1.0) != isWide(viewport()->width())) {
    rebuild();
  } else {
    fit();
  }
}

QImage FigureCanvas::picture(const QSize& size) const {
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::white);
  if (!figure_) {
    return image;
  }
  QGraphicsScene paper;
  QGraphicsWidget* item = buildFigure(*figure_, {}, kTranslated).release();
  paper.addItem(item);
  item->resize(QSizeF(size) / kCopiedScale);
  paper.setSceneRect(item->geometry());
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::NonCosmeticBrushPatterns);
  paper.render(&painter, QRectF(image.rect()), paper.sceneRect());
  return image;
}

void FigureCanvas::copy() const {
  if (!figure_) {
    return;
  }
  auto* content = new QMimeData;  // owned by the clipboard
  content->setImageData(picture(kCopiedPicture));
  content->setText(tabbed(figureTable(*figure_)));
  QGuiApplication::clipboard()->setMimeData(content);
}

void FigureCanvas::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) {
    copy();
    event->accept();
    return;
  }
  QGraphicsView::keyPressEvent(event);
}

void FigureCanvas::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    rebuild();
    describe();
  }
  QGraphicsView::changeEvent(event);
}

void FigureCanvas::describe() {
  if (!figure_) {
    return;
  }
  setAccessibleName(toQString(figure_->title));
  const ReportTable table = figureTable(*figure_, 2);
  QStringList said;
  for (std::size_t i = 0; i < table.rows.size() && i < kDescribedRows; ++i) {
    QStringList parts;
    for (std::size_t c = 1; c < table.rows[i].size(); ++c) {
      if (!table.rows[i][c].empty()) {
        parts << QStringLiteral("%1 %2").arg(toQString(table.columns[c]), toQString(table.rows[i][c]));
      }
    }
    said << QStringLiteral("%1: %2").arg(toQString(table.rows[i].front()), parts.join(QStringLiteral(", ")));
  }
  if (table.rows.size() > kDescribedRows) {
    said << tr("%n row(s) more in the table", nullptr, static_cast<int>(table.rows.size()) - kDescribedRows);
  }
  setAccessibleDescription(said.join(QStringLiteral(". ")));
}

FigureCard::FigureCard(QWidget* parent)
    : QFrame(parent),
      title_(new QLabel(this)),
      notes_(new QLabel(this)),
      picture_(new QPushButton(this)),
      values_(new QPushButton(this)),
      copy_(new QPushButton(this)),
      stack_(new QStackedWidget(this)),
      canvas_(new FigureCanvas(stack_)),
      table_(new DataTable(QString(), stack_)) {
  table_->setObjectName(QStringLiteral("table"));
  canvas_->setObjectName(QStringLiteral("canvas"));
  setObjectName(QStringLiteral("card"));
  title_->setObjectName(QStringLiteral("cardTitle"));
  title_->setWordWrap(true);
  notes_->setProperty("quiet", true);
  notes_->setWordWrap(true);
  notes_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  for (QPushButton* button : {picture_, values_}) {
    button->setCheckable(true);
  }
  picture_->setChecked(true);
  auto* both = new QButtonGroup(this);
  both->addButton(picture_);
  both->addButton(values_);
  stack_->addWidget(canvas_);
  stack_->addWidget(table_);

  auto* head = new QHBoxLayout;
  head->setSpacing(kSpace);
  head->addWidget(title_, 1);
  head->addWidget(picture_);
  head->addWidget(values_);
  head->addWidget(copy_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kSpace, 2 * kSpace, 2 * kSpace, 2 * kSpace);
  column->setSpacing(kSpace);
  column->addLayout(head);
  column->addWidget(stack_, 1);
  column->addWidget(notes_);

  connect(picture_, &QPushButton::clicked, this, [this] { showTable(false); });
  connect(values_, &QPushButton::clicked, this, [this] { showTable(true); });
  connect(copy_, &QPushButton::clicked, this, &FigureCard::copy);
  followLanguage(this, [this] { retranslate(); });
}

void FigureCard::setFigure(const ReportFigure& figure) {
  const bool table = stack_->currentWidget() == table_ && figure_.has_value();
  figure_ = figure;
  alone_.reset();
  canvas_->setFigure(figure);
  showTexts();
  picture_->setVisible(true);
  values_->setVisible(true);
  showTable(table);
}

void FigureCard::setTable(const ReportTable& table) {
  figure_.reset();
  alone_ = table;
  showTexts();
  picture_->setVisible(false);
  values_->setVisible(false);
  stack_->setCurrentWidget(table_);
}

void FigureCard::showTexts() {
  if (!figure_ && !alone_) {
    return;
  }
  title_->setText(toQString(figure_ ? figure_->title : alone_->title));
  fillTable(figure_ ? figureTable(*figure_) : *alone_);
  showNotes(figure_ ? figure_->notes : alone_->notes, figure_ ? figure_->provenance : alone_->provenance);
}

void FigureCard::setTheme(const Theme& theme) {
  canvas_->setTheme(theme);
}

void FigureCard::showTable(bool table) {
  stack_->setCurrentWidget(table ? static_cast<QWidget*>(table_) : canvas_);
  (table ? values_ : picture_)->setChecked(true);
}

void FigureCard::fillTable(const ReportTable& table) {
  std::vector<Column> columns;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    bool numbers = !table.rows.empty();
    for (const std::vector<ReportCell>& row : table.rows) {
      numbers = numbers && (row[c].empty() || cellOf(row[c]).sortKey.typeId() == QMetaType::Double);
    }
    columns.push_back({toQString(table.columns[c]), numbers});
  }
  std::vector<Row> rows;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    Row row{QString::number(r), {}};
    for (const Text& cell : table.rows[r]) {
      row.cells.push_back(cellOf(cell));
    }
    rows.push_back(std::move(row));
  }
  table_->setRows({});
  table_->setColumns(columns);
  table_->setRows(std::move(rows));
}

void FigureCard::showNotes(const std::vector<ReportParagraph>& notes, const Provenance& provenance) {
  std::vector<Text> lines(notes.begin(), notes.end());
  if (const Text from = provenanceLine(provenance); !from.empty()) {
    lines.push_back(from);
  }
  notes_->setText(translatedLines(lines));
  notes_->setVisible(!lines.empty());
}

void FigureCard::copy() {
  if (figure_ && stack_->currentWidget() == canvas_) {
    canvas_->copy();
  } else {
    QGuiApplication::clipboard()->setText(table_->asText());
  }
}

void FigureCard::retranslate() {
  picture_->setText(tr("Picture"));
  values_->setText(tr("Values"));
  copy_->setText(tr("Copy"));
  copy_->setToolTip(tr("Copies the picture and its table (Ctrl+C)"));
  showTexts();
}

}  // namespace torsio::gui
