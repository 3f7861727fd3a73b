// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/physician/discrepancy_review_page.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/sign_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/physician/review_labels.h"
#include "app/gui/physician/sheet_editor_panel.h"
#include "app/gui/physician/sheet_panel.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/review/case_sheet.h"
#include "assessment/domain/rating/sheet.h"
#include "assessment/domain/rating/written_words.h"

namespace torsio::gui {

DiscrepancyReviewPage::DiscrepancyReviewPage(ShellContext& shell, QWidget* parent)
    : Page(shell, parent),
      heading_(new PageHeading(this)),
      table_(new DataTable(QStringLiteral("review.discrepancies"), this)),
      right_(new QWidget(this)),
      case_(new QLabel(this)),
      state_(sentence(this)),
      legend_(sentence(this)),
      bars_(new ComparisonBars(this)),
      sheet_(new SheetEditorPanel(false, this)),
      reason_(new QLineEdit(this)),
      why_(fieldHint(this)),
      keep_(new QPushButton(this)),
      move_(new QPushButton(this)),
      adjudicator_(new QPushButton(this)),
      replay_(linkButton(this)),
      empty_(sentence(this)) {
  QVBoxLayout* column = columnOf(this, {3 * kSpace, 2 * kSpace, 3 * kSpace, 2 * kSpace}, 2 * kSpace);
  column->addWidget(heading_);
  empty_->setAlignment(Qt::AlignCenter);
  column->addWidget(empty_, 1);
  QHBoxLayout* row = rowOf({}, 3 * kSpace);
  row->addWidget(table_, 2);
  row->addWidget(right_, 3);
  column->addLayout(row, 1);
  case_->setProperty("subheading", true);
  reason_->setMaxLength(static_cast<int>(kLongestReason));
  QVBoxLayout* right = columnOf(right_, {}, kSpace);
  auto* head = new QHBoxLayout;
  head->addWidget(case_);
  head->addWidget(state_, 1);
  head->addWidget(replay_);
  right->addLayout(head);
  right->addWidget(legend_);
  right->addWidget(bars_);
  right->addWidget(sheet_, 1);
  right->addStretch(0);
  right->addWidget(reason_);
  right->addWidget(why_);
  auto* buttons = new QHBoxLayout;
  for (QPushButton* button : {keep_, move_, adjudicator_}) {
    buttons->addWidget(button);
  }
  buttons->addStretch(1);
  right->addLayout(buttons);
  right->addStretch(1);
  connectAll();
}

void DiscrepancyReviewPage::connectAll() {
  connect(table_, &DataTable::currentChanged, this, [this](const QString& id) {
    if (id.isEmpty() || id.toStdString() == chosen_) {
      return;
    }
    chosen_ = id.toStdString();
    stopMoving();
    showCase();
  });
  connect(replay_, &QPushButton::clicked, this, [this] {
    if (const DiscrepancyCase* one = current()) {
      this->shell().open(PageId::kCase, toQString(one->shown.assignmentId));
    }
  });
  connect(keep_, &QPushButton::clicked, this, [this] {
    if (sheet_->editor() != nullptr) {
      stopMoving();
      showCase();
      return;
    }
    decide([](SessionContext& w, const std::string& id, const std::string& why) { keepMark(w, id, why); },
           tr("Your mark stays as it is"));
  });
  connect(move_, &QPushButton::clicked, this, &DiscrepancyReviewPage::startMoving);
  connect(sheet_, &SheetEditorPanel::finishWanted, this, &DiscrepancyReviewPage::startMoving);  // seals
  connect(reason_, &QLineEdit::textChanged, this, [this] { sayHint(why_, QString()); });
  connect(adjudicator_, &QPushButton::clicked, this, [this] {
    if (!hasReason()) {
      return;
    }
    decide([](SessionContext& w, const std::string& id,
              const std::string& why) { askForAdjudicator(w, id, why); },
           tr("An adjudicator has been requested"));
  });
}

DiscrepancyReviewPage::~DiscrepancyReviewPage() = default;

void DiscrepancyReviewPage::enter(const QVariant&) {
  stopMoving();
  read();
  for (const DiscrepancyCase& one : cases_) {
    if (one.decision) {
      continue;
    }
    chosen_ = one.shown.assignmentId;
    break;
  }
  showCase();
  showList();
}

void DiscrepancyReviewPage::read() {
  cases_ = discrepancyCases(shell().session());
  opens_ = whenCasesAreCompared(shell().session());
  showList();
}

void DiscrepancyReviewPage::showList() {
  std::vector<Row> rows;
  for (const DiscrepancyCase& one : cases_) {
    const QString decision = one.decision == DiscrepancyChoice::kKeep    ? tr("kept")
                             : one.decision == DiscrepancyChoice::kMove  ? tr("moved")
                             : one.decision == DiscrepancyChoice::kThird ? tr("adjudicator requested")
                                                                         : tr("to be decided");
    rows.push_back({toQString(one.shown.assignmentId),
                    {{tr("Case %1").arg(toQString(one.shown.label)), static_cast<int>(rows.size())},
                     {QLocale().toString(one.largest, 'f', 1), one.largest},
                     {decision}}});
  }
  table_->setRows(std::move(rows));
  if (const DiscrepancyCase* one = current()) {
    table_->select(toQString(one->shown.assignmentId));
  }
}

const DiscrepancyCase* DiscrepancyReviewPage::current() const {
  for (const DiscrepancyCase& one : cases_) {
    if (one.shown.assignmentId == chosen_) {
      return &one;
    }
  }
  return cases_.empty() ? nullptr : &cases_.front();
}

void DiscrepancyReviewPage::showCase() {
  const DiscrepancyCase* one = current();
  const bool moving = sheet_->editor() != nullptr;
  empty_->setText(tr("No disagreements are waiting for you.") + QStringLiteral("\n\n") + toQString(opens_));
  empty_->setVisible(cases_.empty());
  table_->setVisible(!cases_.empty());
  right_->setVisible(one != nullptr);
  if (one == nullptr) {
    return;
  }
  case_->setText(tr("Case %1").arg(toQString(one->shown.label)));
  state_->setText(!one->decision        ? QString()
                  : one->reason.empty() ? tr("Decided. You may change your decision.")
                                        : tr("Decided: %1").arg(toQString(one->reason)));
  bars_->setRows(one->rows);
  bars_->setVisible(!moving);
  legend_->setVisible(!moving);
  sheet_->setVisible(moving);
  // Bars are at the top; a sheet takes all the space.
  auto* column = static_cast<QVBoxLayout*>(right_->layout());
  column->setStretch(column->count() - 1, moving ? 0 : 1);
  replay_->setVisible(!one->shown.live);
  keep_->setText(moving ? tr("Leave it unchanged") : tr("&Keep my mark"));
  move_->setText(moving ? tr("Seal the moved mark") : tr("&Move with a reason\u2026"));
  adjudicator_->setVisible(!moving);
}

void DiscrepancyReviewPage::startMoving() {
  const DiscrepancyCase* one = current();
  if (one == nullptr) {
    return;
  }
  if (sheet_->editor() != nullptr) {
    if (!hasReason() || !readyToSign(this, shell(), SignatureMeaning::kAmended)) {
      return;
    }
    const Sheet sheet = sheet_->editor()->sheet();
    decide([&sheet](SessionContext& w, const std::string& id,
                    const std::string& why) { moveMark(w, id, sheet, why); },
           tr("The moved mark is sealed and flagged; the one before is kept"));
    return;
  }
  attempt(shell(), [&] {
    const OpenedSheet opened = openSheet(shell().session(), one->shown.assignmentId);
    sheet_->beginSheet(opened.rubric, opened.sheet);
    showCase();
    sheet_->takeFocus();
  });
}

void DiscrepancyReviewPage::stopMoving() {
  sheet_->endSheet();
  sayHint(why_, QString());
}

bool DiscrepancyReviewPage::hasReason() {
  const bool has = !reason_->text().trimmed().isEmpty();
  sayHint(why_, has ? QString() : tr("A reason is needed: write it in a few words"));
  if (!has) {
    reason_->setFocus(Qt::OtherFocusReason);
  }
  return has;
}

template <typename Action>
void DiscrepancyReviewPage::decide(const Action& action, const QString& said) {
  const DiscrepancyCase* one = current();
  if (one == nullptr) {
    return;
  }
  if (!attempt(shell(), [&] {
        action(shell().session(), one->shown.assignmentId, reason_->text().trimmed().toStdString());
        reason_->clear();
        stopMoving();
        read();
        showCase();
        shell().notify(said);
      })) {
    reason_->setFocus(Qt::OtherFocusReason);
  }
}

void DiscrepancyReviewPage::retranslate() {
  heading_->setTexts(tr("Discrepancy review"),
                     tr("Only cases that everyone has submitted, and only where your mark differs from the "
                        "others. The others are not named, nor are you to them."));
  table_->view().setAccessibleName(tr("Cases where your mark differs"));
  table_->setColumns({{tr("Case")}, {tr("Difference"), true}, {tr("Decision")}});
  reason_->setPlaceholderText(tr("Reason (needed to move a mark or to ask for an adjudicator)"));
  reason_->setAccessibleName(tr("Reason"));
  adjudicator_->setText(tr("Ask for an adjudica&tor"));
  replay_->setText(tr("Look at it again"));
  legend_->setText(tr("Diamond: you. Band: lowest to highest of the others. Line: their mean."));
  bars_->retranslate();
  sheet_->retranslate();
  showList();
  showCase();
}

std::vector<std::pair<QString, QString>> DiscrepancyReviewPage::keys() const {
  return sheetKeys();
}

void DiscrepancyReviewPage::applyTheme(const Theme& theme) {
  bars_->setTheme(theme);
  sheet_->setTheme(theme);
}

void DiscrepancyReviewPage::keyPressEvent(QKeyEvent* event) {
  if (sheet_->editor() == nullptr || !sheet_->handle(event)) {
    Page::keyPressEvent(event);
  }
}

namespace {

constexpr int kBand = 10;

QString tenths(double points) {
  return numberText(points, 1);
}

}  // namespace

ComparisonBars::ComparisonBars(QWidget* parent) : QWidget(parent), theme_(&theme(ThemeKind::kLight)) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ComparisonBars::setTheme(const Theme& theme) {
  theme_ = &theme;
  update();
}

void ComparisonBars::setRows(std::vector<RowComparison> rows) {
  rows_ = std::move(rows);
  describe();
  updateGeometry();
  update();
}

int ComparisonBars::rowHeight() const {
  return 2 * fontMetrics().height() + 2 * kSpace;
}

QSize ComparisonBars::sizeHint() const {
  return {360, std::max(1, static_cast<int>(rows_.size())) * rowHeight()};
}

QString ComparisonBars::sentenceOf(const RowComparison& row) const {
  const QString others =
      tr("others %1, from %2 to %3").arg(tenths(row.mean), tenths(row.lowest), tenths(row.highest));
  const QString own = tr("you %1").arg(tenths(row.own));
  return row.apart ? tr("%1; %2; difference %3").arg(own, others, tenths(std::abs(row.own - row.mean)))
                   : tr("%1; %2").arg(own, others);
}

void ComparisonBars::describe() {
  setAccessibleName(tr("Your marks beside the others'"));
  QStringList lines;
  for (const RowComparison& row : rows_) {
    lines << tr("%1: %2").arg(row.label.empty() ? tr("Overall") : toQString(Text(row.label)),
                              sentenceOf(row));
  }
  setAccessibleDescription(lines.join(QStringLiteral(". ")));
}

void ComparisonBars::drawRow(QPainter& painter, const RowComparison& row, const QRect& area) const {
  const int line = fontMetrics().height();
  const QRect head(area.left(), area.top(), area.width(), line);
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(theme_->text);
  painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                   row.label.empty() ? tr("Overall") : toQString(Text(row.label)));
  painter.setFont(font());
  painter.setPen(row.apart ? theme_->caution : theme_->quietText);
  painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, sentenceOf(row));
  const double lo = pointsFromSteps(row.scale.lo, row.scale);
  const double hi = pointsFromSteps(row.scale.hi, row.scale);
  const QRectF bar(area.left() + kBand, area.top() + line + kSpace / 2.0, area.width() - 2 * kBand, kBand);
  const auto xOf = [&](double points) { return bar.left() + (points - lo) / (hi - lo) * bar.width(); };
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme_->track);
  painter.drawRoundedRect(bar, kBand / 2.0, kBand / 2.0);
  painter.setBrush(theme_->border);
  painter.drawRoundedRect(
      QRectF(xOf(row.lowest) - 3, bar.top(), xOf(row.highest) - xOf(row.lowest) + 6, bar.height()), 4, 4);
  painter.setPen(QPen(theme_->text, 2.0));
  painter.drawLine(QPointF(xOf(row.mean), bar.top() - 3), QPointF(xOf(row.mean), bar.bottom() + 3));
  const QPointF own(xOf(row.own), bar.center().y());
  painter.setPen(QPen(theme_->surface, 1.5));
  painter.setBrush(theme_->accent);
  painter.drawPolygon(
      QPolygonF({own + QPointF(0, -8), own + QPointF(8, 0), own + QPointF(0, 8), own + QPointF(-8, 0)}));
}

void ComparisonBars::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  int top = 0;
  for (const RowComparison& row : rows_) {
    drawRow(painter, row, QRect(0, top, width(), rowHeight()));
    top += rowHeight();
  }
}

}  // namespace torsio::gui
