// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/reporting/report_preview.h"

#include <algorithm>
#include <utility>

#include <QAbstractTextDocumentLayout>
#include <QDialogButtonBox>
#include <QGraphicsScene>
#include <QGraphicsWidget>
#include <QHeaderView>
#include <QImage>
#include <QLineEdit>
#include <QMimeData>
#include <QPaintEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSplitter>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextDocumentFragment>
#include <QTextFrame>
#include <QTextTable>
#include <QTreeWidget>
#include <QUrl>
#include <QVBoxLayout>

#include "app/gui/base/language.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/outputs/charts/chart_builder.h"
#include "app/outputs/wording/printed_minus.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_csv.h"

namespace torsio::gui {

namespace {

constexpr QSize kFigure(640, 300);
constexpr char kNumber[] = "number:";
constexpr char kRows[] = "rows:";
constexpr std::size_t kRowsShown = 15;      // of a long table, until all rows are requested
constexpr std::size_t kDefaultColumns = 9;  // more columns need a smaller font
constexpr int kTableRoom = 1000;            // minimum width for a wide table, px
constexpr int kSheet = 1120;                // widest page, px; the rest shows the background
constexpr int kLine = 86;  // in average characters, about 95 of running text: longer lines are hard to follow

QImage drawn(const ReportFigure& figure, const Wording& wording) {
  const bool tall = figure.kind == FigureKind::kHeatMap || figure.kind == FigureKind::kForest;
  const std::size_t rows =
      figure.kind == FigureKind::kHeatMap ? figure.series.size() : figure.categories.size();
  const QSize size(kFigure.width(),
                   tall ? std::clamp(100 + 24 * static_cast<int>(rows), 180, 700) : kFigure.height());
  QImage image(2 * size, QImage::Format_RGB32);
  image.fill(Qt::white);
  QGraphicsScene scene;
  QGraphicsWidget* item = buildFigure(figure, {}, wording).release();
  scene.addItem(item);
  item->resize(size);
  scene.setSceneRect(item->geometry());
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::NonCosmeticBrushPatterns);
  scene.render(&painter, QRectF(image.rect()), scene.sceneRect());
  return image;
}

/// Allows line breaks in hashes, which would otherwise widen their table.
QString withHashBreaks(QString html) {
  static const QRegularExpression kSixteen(
      QStringLiteral("((?:(?<=\u200B)|(?<![0-9a-f]))[0-9a-f]{16})(?=[0-9a-f])"));
  qsizetype length = 0;
  while (length != html.size()) {  // each replacement makes room for the next
    length = html.size();
    html.replace(kSixteen, QStringLiteral("\\1\u200B"));
  }
  return html;
}

}  // namespace

ReportPreview::ReportPreview(QWidget* parent) : QTextBrowser(parent) {
  setOpenLinks(false);
  connect(this, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
    const QString text = link.toString(QUrl::FullyEncoded);
    if (text.startsWith(QLatin1String(kNumber))) {
      Q_EMIT numberPressed(
          QUrl::fromPercentEncoding(text.mid(static_cast<qsizetype>(qstrlen(kNumber))).toLatin1()));
    } else if (text.startsWith(QLatin1String(kRows))) {
      toggleRows(text.mid(static_cast<qsizetype>(qstrlen(kRows))));
    }
  });
  QPalette paper = palette();
  paper.setColor(QPalette::Base, Qt::white);
  paper.setColor(QPalette::Text, QColor(0x17, 0x22, 0x2B));
  setPalette(paper);
  setStyleSheet(
      QStringLiteral("QTextBrowser { background: transparent; color: #17222b; border-radius: 6px; }"));
  document()->setDocumentMargin(3 * kSpace);
}

QString ReportPreview::tableHtml(const ReportTable& table, const QString& name,
                                 const Wording& wording) const {
  const auto html = [&wording](const Text& text) { return wording(text).toHtmlEscaped(); };
  const bool crowded = table.columns.size() > kDefaultColumns;
  const auto inCell = [crowded](const QString& words) {
    return crowded ? QStringLiteral("<small>%1</small>").arg(words) : words;
  };
  QString text = QStringLiteral("<p><b>%1</b></p><table cellpadding='4' cellspacing='0' border='0'><tr>")
                     .arg(html(table.title));
  for (const Text& column : table.columns) {
    text += QStringLiteral("<th align='left' bgcolor='#e4ecf2'>%1</th>").arg(inCell(html(column)));
  }
  text += QStringLiteral("</tr>");
  const bool whole = table.rows.size() <= kRowsShown || whole_.contains(name);
  for (std::size_t r = 0; r < (whole ? table.rows.size() : kRowsShown); ++r) {
    text += QStringLiteral("<tr>");
    for (std::size_t c = 0; c < table.rows[r].size(); ++c) {
      const QString cell = inCell(withHashBreaks(html(table.rows[r][c])));
      const auto& key = table.rows[r][c].key;
      text += key == nullptr
                  ? QStringLiteral("<td>%1</td>").arg(cell)
                  : QStringLiteral("<td><a href=\"%1%2\" style=\"color:#004a7c\">%3</a></td>")
                        .arg(QLatin1String(kNumber),
                             QString::fromLatin1(QUrl::toPercentEncoding(toQString(keyAddress(*key)))), cell);
    }
    text += QStringLiteral("</tr>");
  }
  text += QStringLiteral("</table>");
  if (table.rows.size() > kRowsShown) {
    text += QStringLiteral("<p><i>%1</i> <a href=\"%2%3\" style=\"color:#004a7c\">%4</a></p>")
                .arg(html(whole ? Text::tr("all %1 {row|rows}", table.rows.size())
                                : Text::tr("%1 of %2 rows", kRowsShown, table.rows.size())),
                     QLatin1String(kRows), name, html(whole ? Text::tr("Show fewer") : Text::tr("Show all")));
  }
  for (const Text& note : table.notes) {
    text += QStringLiteral("<p style='color:#51606c'>%1</p>").arg(html(note));
  }
  return text;
}

void ReportPreview::setReport(const ReportModel& model, const Wording& wording) {
  model_ = model;
  wording_ = wording;
  whole_.clear();
  pictures_.clear();
  showReport();
  moveCursor(QTextCursor::Start);
}

void ReportPreview::toggleRows(const QString& name) {
  if (whole_.erase(name) == 0) {
    whole_.insert(name);
  }
  const int at = verticalScrollBar()->value();
  showReport();
  verticalScrollBar()->setValue(at);
}

void ReportPreview::showReport() {
  const ReportModel& model = model_;
  const Wording& wording = wording_;
  clear();
  const auto html = [&wording](const Text& text) { return wording(text).toHtmlEscaped(); };
  QString text = QStringLiteral("<h1>%1</h1><p>%2</p>").arg(html(model.title), html(model.subtitle));
  if (model.demonstration) {
    text += QStringLiteral("<p style='color:#a04a00'><b>%1</b></p>")
                .arg(html(Text::tr("Demonstration data: not study results.")));
  }
  QString facts = QStringLiteral("<table cellpadding='3'>");
  for (const auto& [label, value] : model.facts) {
    facts += QStringLiteral("<tr><td>%1</td><td><b>%2</b></td></tr>")
                 .arg(html(label), withHashBreaks(html(value)));
  }
  facts += QStringLiteral("</table>");
  int tables = 0;
  for (const ReportSection& section : model.sections) {
    if (!section.onFirstPage) {  // below what is on the first page
      text += std::exchange(facts, {});
    }
    text += QStringLiteral("<h2>%1</h2>").arg(html(section.title));
    for (const Text& paragraph : section.paragraphs) {
      text += QStringLiteral("<p>%1</p>").arg(html(paragraph));
    }
    for (const ReportFigure& figure : section.figures) {
      const QString name = QStringLiteral("figure:%1").arg(toQString(figure.id).toHtmlEscaped());
      QImage& image = pictures_[name];
      if (image.isNull()) {
        image = drawn(figure, wording);
      }
      document()->addResource(QTextDocument::ImageResource, QUrl(name), image);
      text += QStringLiteral("<p><b>%1</b></p><p><img src='%2' width='%3'></p>")
                  .arg(html(figure.title), name)
                  .arg(image.width() / 2);
      for (const Text& note : figure.notes) {
        text += QStringLiteral("<p style='color:#51606c'>%1</p>").arg(html(note));
      }
    }
    for (const ReportTable& table : section.tables) {
      text += tableHtml(table, QString::number(tables++), wording);
    }
  }
  text += facts;
  // setHtml() would discard the pictures: they belong to the present document.
  QTextCursor(document()).insertHtml(text);
  besideText_ = 0;
  keepLinesShort();
  showBarIfNeeded();
}

void ReportPreview::resizeEvent(QResizeEvent* event) {
  const int bar = verticalScrollBar()->isVisibleTo(this) ? verticalScrollBar()->width() : 0;
  const int desk = contentsRect().width() - bar;
  const int beside = std::max(0, (desk - kSheet) / 2);
  if (beside != viewportMargins().left()) {
    setViewportMargins(beside, 0, beside, 0);  // re-enters here if that changes the width
  }
  QTextBrowser::resizeEvent(event);
  keepLinesShort();
  showBarIfNeeded();
}

/// Shows the scroll bar only if a table is cut: the layout also counts empty space beside tables.
void ReportPreview::showBarIfNeeded() {
  double right = 0.0;
  for (QTextFrame* table : document()->rootFrame()->childFrames()) {
    right = std::max(right, document()->documentLayout()->frameBoundingRect(table).right());
  }
  setHorizontalScrollBarPolicy(right > viewport()->width() ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
}

/// Removes the inserted breaks from copied text.
QMimeData* ReportPreview::createMimeDataFromSelection() const {
  auto* copied = new QMimeData;
  copied->setText(textCursor().selection().toPlainText().remove(QChar(0x200B)));
  return copied;
}

void ReportPreview::paintEvent(QPaintEvent* event) {
  QPainter(viewport()).fillRect(event->rect(), Qt::white);
  QTextBrowser::paintEvent(event);
}

/// Limits the line length of paragraphs and centres them on a wide page; tables may extend to its right edge.
void ReportPreview::keepLinesShort() {
  const int margin = static_cast<int>(document()->documentMargin());
  const int page = viewport()->width() - 2 * margin;
  const int beside = std::max(0, page - kLine * fontMetrics().averageCharWidth());
  if (beside == std::exchange(besideText_, beside)) {
    return;
  }
  const int left = std::min(beside / 2, std::max(0, page - kTableRoom));
  QTextFrame* frame = document()->rootFrame();
  QTextFrameFormat edges = frame->frameFormat();
  edges.setLeftMargin(margin + left);
  frame->setFrameFormat(edges);
  QTextCursor cursor(document());
  cursor.beginEditBlock();
  QTextBlockFormat narrow;
  narrow.setRightMargin(beside - left);
  for (QTextBlock block = document()->begin(); block.isValid(); block = block.next()) {
    cursor.setPosition(block.position());
    if (cursor.currentTable() == nullptr && block.length() > 1) {  // not the empty block after a table
      cursor.mergeBlockFormat(narrow);
    }
  }
  cursor.endEditBlock();
}

namespace {

constexpr QSize kDialogSize(1100, 640);
constexpr int kStepWidth = 380;
constexpr int kOpened = 1;  // levels initially expanded

void addStep(const TraceStep& step, QTreeWidgetItem* item, int depth) {
  item->setText(0, toQString(step.what));
  item->setText(1, toQString(step.value));
  item->setToolTip(1, toQString(step.value));
  for (const TraceStep& part : step.madeOf) {
    addStep(part, new QTreeWidgetItem(item), depth + 1);
  }
  item->setExpanded(depth < kOpened);
}

}  // namespace

TraceDialog::TraceDialog(ShellContext& shell, const CohortId& cohortId,
                         std::shared_ptr<const CohortInputs> inputs, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      cohortId_(cohortId),
      inputs_(std::move(inputs)),
      numbers_(named(new DataTable(QStringLiteral("numbers"), this), "numbers")),
      steps_(named(new QTreeWidget(this), "steps")) {
  setWindowTitle(tr("Where a number comes from"));
  resize(kDialogSize);
  steps_->setHeaderLabels({tr("Made of"), tr("Value")});
  steps_->setAccessibleName(tr("What the chosen number was made of"));
  steps_->setColumnWidth(0, kStepWidth);
  steps_->setAllColumnsShowFocus(true);
  QVBoxLayout* column = columnOf(this, {3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace});
  auto* told = sentence(this);
  told->setText(
      tr("Choose a number; type a code such as T-07 to find those of a person. Its sources are shown below: "
         "open a step to continue to marks, criteria, scoring sheet, recording and program."));
  column->addWidget(told);
  auto* split = new QSplitter(Qt::Vertical, this);
  split->addWidget(numbers_);
  split->addWidget(steps_);
  split->setChildrenCollapsible(false);
  column->addWidget(split, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(numbers_, &DataTable::currentChanged, this, [this](const QString& id) {
    wanted_ = id;
    start();
  });
  // Another number may have been chosen meanwhile.
  connect(&shell_, &ShellContext::jobEnded, this, [this] {
    running_ = false;
    start();
  });
  fill();
  numbers_->filter().setFocus();  // so that a code can be typed at once
}

void TraceDialog::fill() {
  numbers_->setColumns({{tr("Number")},
                        {tr("Of")},
                        {tr("Group")},
                        {tr("Model or criterion")},
                        {tr("Index or rater")},
                        {tr("Occasion")},
                        {tr("Value"), true}});
  std::vector<Row> rows;
  const Ledger ledger = analysedCohort(*inputs_).ledger;
  ledger.eachLine([&](const Result& result) {
    const auto [section, item, group, model, index, occasion, statistic] = keyCells(result.key);
    const QString value = toQString(resultText(result.value));
    const std::optional<double> number = numberIn(result.value);
    rows.push_back({toQString(keyAddress(result.key)),
                    {{toQString(statistic)},
                     {toQString(item)},
                     {toQString(group)},
                     {toQString(model)},
                     {toQString(index)},
                     {toQString(occasion)},
                     {printedMinus(value), number ? QVariant(*number) : QVariant(), value}}});
  });
  numbers_->setRows(std::move(rows));
}

void TraceDialog::follow(const QString& address) {
  numbers_->select(address);
  wanted_ = address;
  start();
}

void TraceDialog::start() {
  if (running_ || wanted_.isEmpty() || wanted_ == followed_) {
    return;
  }
  running_ = true;
  followed_ = wanted_;
  shell_.run(
      this, tr("Following the number"),
      [cohort = cohortId_, inputs = inputs_, cell = wanted_.toStdString()](SessionContext& session,
                                                                           const ProgressCallback&) {
        return traceNumber(session, cohort, *inputs, cell);
      },
      [this](const TraceStep& step) { show(step); });
}

void TraceDialog::show(const TraceStep& step) {
  steps_->clear();
  auto* top = new QTreeWidgetItem(steps_);
  addStep(step, top, 0);
  steps_->setCurrentItem(top);
}

}  // namespace torsio::gui
