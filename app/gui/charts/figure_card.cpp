// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/charts/figure_card.h"

#include <QButtonGroup>
#include <QClipboard>
#include <QEvent>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/charts/figure_canvas.h"
#include "app/gui/look/data_table.h"
#include "assessment/report/figure_table.h"

namespace torsio::gui {

namespace {

QString text(const std::string& utf8) {
  return QString::fromStdString(utf8);
}

QString provenanceLine(const Provenance& from) {
  QStringList parts;
  if (!from.formula.empty())
    parts << (from.formulaVersion.empty()
                  ? text(from.formula)
                  : QStringLiteral("%1 (%2)").arg(text(from.formula), text(from.formulaVersion)));
  if (from.n > 0) {
    parts << QStringLiteral("n = %1").arg(from.n);
    parts << FigureCard::tr("missing = %1").arg(from.missing);
  }
  for (const std::string& flag : from.flags) parts << text(flag);
  return parts.join(QStringLiteral("; "));
}

/// Numbers sort by size.
Cell cellOf(const std::string& content) {
  Cell cell{text(content)};
  bool isNumber = false;
  const double value = cell.text.toDouble(&isNumber);
  if (isNumber) cell.sortKey = value;
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
  setObjectName(QStringLiteral("card"));
  title_->setObjectName(QStringLiteral("cardTitle"));
  title_->setWordWrap(true);
  notes_->setProperty("quiet", true);
  notes_->setWordWrap(true);
  notes_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  for (QPushButton* button : {picture_, values_}) {
    button->setCheckable(true);
    button->setStyleSheet(
        QStringLiteral("QPushButton:checked { border: 2px solid palette(highlight); font-weight: 600; }"));
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
  title_->setText(text(figure.title));
  canvas_->setFigure(figure);
  fillTable(figureTable(figure));
  showNotes(figure.notes, figure.provenance);
  picture_->setVisible(true);
  values_->setVisible(true);
  showTable(table);
}

void FigureCard::setTable(const ReportTable& table) {
  figure_.reset();
  title_->setText(text(table.title));
  fillTable(table);
  showNotes(table.notes, table.provenance);
  picture_->setVisible(false);
  values_->setVisible(false);
  stack_->setCurrentWidget(table_);
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
    for (const std::vector<std::string>& row : table.rows)
      numbers = numbers && (row[c].empty() || cellOf(row[c]).sortKey.isValid());
    columns.push_back({text(table.columns[c]), numbers});
  }
  std::vector<Row> rows;
  for (std::size_t r = 0; r < table.rows.size(); ++r) {
    Row row{QString::number(r), {}};
    for (const std::string& cell : table.rows[r]) row.cells.push_back(cellOf(cell));
    rows.push_back(std::move(row));
  }
  table_->setRows({});
  table_->setColumns(columns);
  table_->setRows(std::move(rows));
}

void FigureCard::showNotes(const std::vector<std::string>& notes, const Provenance& provenance) {
  QStringList lines;
  for (const std::string& note : notes) lines << text(note);
  const QString from = provenanceLine(provenance);
  if (!from.isEmpty()) lines << from;
  notes_->setText(lines.join(QLatin1Char('\n')));
  notes_->setVisible(!lines.isEmpty());
}

void FigureCard::copy() {
  if (figure_ && stack_->currentWidget() == canvas_) {
    canvas_->copy();
  } else {
    QGuiApplication::clipboard()->setText(table_->asText());
  }
}

void FigureCard::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QFrame::changeEvent(event);
}

void FigureCard::retranslate() {
  picture_->setText(tr("&Picture"));
  values_->setText(tr("&Values"));
  copy_->setText(tr("&Copy"));
  copy_->setToolTip(tr("Copies the picture and its table (Ctrl+C)"));
  if (figure_) showNotes(figure_->notes, figure_->provenance);
}

}  // namespace torsio::gui
