// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/base/figure_card.h"

#include <QButtonGroup>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMetaType>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/base/figure_canvas.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/number_text.h"
#include "app/outputs/wording/printed_minus.h"
#include "app/outputs/wording/printed_value.h"
#include "assessment/results/figure_table.h"
#include "assessment/results/provenance_line.h"

namespace torsio::gui {

namespace {

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
  retranslate();
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

void FigureCard::showNotes(const std::vector<Text>& notes, const Provenance& provenance) {
  std::vector<Text> lines = notes;
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

void FigureCard::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    retranslate();
  }
  QFrame::changeEvent(event);
}

void FigureCard::retranslate() {
  picture_->setText(tr("Picture"));
  values_->setText(tr("Values"));
  copy_->setText(tr("Copy"));
  copy_->setToolTip(tr("Copies the picture and its table (Ctrl+C)"));
  showTexts();
}

}  // namespace torsio::gui
