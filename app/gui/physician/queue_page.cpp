// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/queue_page.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QGridLayout>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/base/shell_context.h"
#include "app/gui/physician/questions_card.h"
#include "app/gui/physician/review_labels.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "sim/core/time_units.h"

namespace torsio::gui {

namespace {

constexpr int kTableHeight = 20 * kSpace;
constexpr int kDoorsBeside = 2;  // a third would leave no room for their texts

}  // namespace

QueuePage::QueuePage(ShellContext& shell, QWidget* parent)
    : Page(shell, parent),
      heading_(new PageHeading(this)),
      continue_(primaryButton(this)),
      table_(new DataTable(QStringLiteral("review.queue"), this)) {
  QVBoxLayout* outer = columnOf(this, {});
  auto* scroll = new QScrollArea(this);  // long texts in a wide font need more than a small screen
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  outer->addWidget(scroll);
  auto* ground = new QWidget;
  scroll->setWidget(ground);
  QVBoxLayout* column = columnOf(ground, {3 * kSpace, 2 * kSpace, 3 * kSpace, 2 * kSpace}, 2 * kSpace);
  column->addWidget(heading_);
  heading_->addAction(continue_);
  QHBoxLayout* figures = rowOf({}, 2 * kSpace);
  waiting_ = addFigure(figures);
  drafts_ = addFigure(figures);
  time_ = addFigure(figures);
  due_ = addFigure(figures);
  column->addLayout(figures);
  createDoors(column);
  questions_ = new QuestionsCard(shell, this);
  column->addWidget(questions_);
  replies_ = new RepliesCard(shell, this);
  column->addWidget(replies_);
  table_->setMinimumHeight(kTableHeight);
  column->addWidget(table_, 1);
  connect(continue_, &QPushButton::clicked, this, &QueuePage::goOn);
  connect(table_, &DataTable::activated, this,
          [this](const QString& id) { this->shell().open(PageId::kCase, id); });
}

QueuePage::Figure QueuePage::addFigure(QHBoxLayout* row) {
  Figure one{new Card(QString(), this), new QLabel(this), sentence(this)};
  one.figure->setProperty("figure", true);
  one.card->content()->addWidget(one.figure);
  one.card->content()->addWidget(one.words);
  one.card->content()->addStretch(1);
  row->addWidget(one.card, 1);
  return one;
}

void QueuePage::createDoors(QVBoxLayout* outer) {
  doors_ = new Card(QString(), this);
  outer->addWidget(doors_);
  doorPlaces_ = new QGridLayout;
  doorPlaces_->setHorizontalSpacing(4 * kSpace);
  doorPlaces_->setVerticalSpacing(kSpace);
  for (int column = 0; column < kDoorsBeside; ++column) {
    doorPlaces_->setColumnStretch(column, 1);
  }
  doors_->content()->addLayout(doorPlaces_);
  const auto add = [this](PageId page) {
    Door door{sentence(this, false), new QPushButton(this), new QWidget(this)};
    auto* row = new QHBoxLayout(door.row);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(door.text, 1);
    row->addWidget(door.button);
    connect(door.button, &QPushButton::clicked, this, [this, page] { this->shell().open(page); });
    return door;
  };
  calibration_ = add(PageId::kRaterCalibration);
  live_ = add(PageId::kLiveSheet);
  discrepancies_ = add(PageId::kDiscrepancyReview);
  evaluation_ = add(PageId::kEvaluation);
}

void QueuePage::enter(const QVariant&) {
  queue_ = reviewQueue(shell().session());
  questions_->read();
  replies_->read();
  showQueue();
  continue_->setFocus(Qt::OtherFocusReason);
}

void QueuePage::retranslate() {
  heading_->setTexts(tr("Your queue"),
                     tr("Cases are blinded and shuffled for you alone. Nobody sees your marks before "
                        "all have submitted, nor do you see theirs."));
  waiting_.card->setTitle(tr("Waiting"));
  drafts_.card->setTitle(tr("Drafts"));
  time_.card->setTitle(tr("Time needed"));
  due_.card->setTitle(tr("Next deadline"));
  doors_->setTitle(tr("Also waiting"));
  calibration_.button->setText(tr("Rater cali&bration"));
  live_.button->setText(tr("&Live sheet"));
  discrepancies_.button->setText(tr("Discrep&ancy review"));
  evaluation_.button->setText(tr("&Evaluation"));
  table_->view().setAccessibleName(tr("Your cases"));
  table_->setColumns(
      {{tr("Case")}, {tr("State")}, {tr("Length"), true}, {tr("Due")}, {tr("Time needed"), true}});
  table_->setEmptyText(tr("No recorded case is assigned to you. New ones appear here by themselves."));
  showQueue();
}

void QueuePage::showFigures() {
  const QLocale locale;
  waiting_.figure->setText(locale.toString(static_cast<qlonglong>(queue_.waiting)));
  const QString submitted = tr("%1 submitted so far").arg(queue_.submitted);
  const std::int64_t worked_min = (queue_.worked_us + kMinute_us / 2) / kMinute_us;
  const QString worked = worked_min < 60 ? tr("%1 min").arg(worked_min)
                                         : tr("%1 h %2 min").arg(worked_min / 60).arg(worked_min % 60);
  waiting_.words->setText(worked_min == 0 ? submitted : tr("%1 (%2). Thank you").arg(submitted, worked));
  drafts_.figure->setText(locale.toString(static_cast<qlonglong>(queue_.drafts)));
  drafts_.words->setText(queue_.drafts > 0 ? tr("in progress, saved automatically") : tr("none in progress"));
  const auto minutes = static_cast<int>(std::ceil(queue_.minutes));
  time_.figure->setText(tr("%1 min").arg(locale.toString(minutes)));
  const QString from =
      queue_.fromOwnPace ? tr("at your own pace so far") : tr("from the length of the recordings");
  const auto fitting = static_cast<int>(queue_.inTenMinutes);
  time_.words->setText(queue_.waiting + queue_.drafts == 0 ? tr("no cases are waiting for you")
                       : fitting > 0 ? tr("%n case(s) fit into ten minutes, %1", nullptr, fitting).arg(from)
                                     : from);
  due_.figure->setText(queue_.nextDueUtc_us ? dayText(*queue_.nextDueUtc_us) : QStringLiteral("\u2013"));
  due_.words->setText(queue_.overdue > 0 ? tr("%1 overdue").arg(queue_.overdue) : tr("nothing is overdue"));
  setLook(due_.words, "caution", queue_.overdue > 0);
}

void QueuePage::showDoors() {
  calibration_.text->setText(
      queue_.submitted > 0
          ? tr("Score the reference runs and see how far you are from the panel.")
          : tr("Before the first case: score the reference runs and see how far you are from the panel."));
  live_.text->setText(queue_.liveCalled > 0
                          ? tr("Live sheets outstanding: %1. Not called yet: %2.")
                                .arg(queue_.liveCalled)
                                .arg(queue_.liveWaiting)
                          : tr("Cases that will be called to the real arm: %1. The sheet follows the call.")
                                .arg(queue_.liveWaiting));
  setLook(live_.text, "caution", queue_.liveCalled > 0);
  discrepancies_.text->setText(
      tr("All have submitted. Your marks that differ from the others: %1.").arg(queue_.disagreements));
  evaluation_.text->setText(tr("Tissue models awaiting your nine marks: %1.").arg(queue_.models));
  const std::pair<Door*, bool> all[] = {{&calibration_, queue_.calibrationWaiting},
                                        {&live_, queue_.liveCalled + queue_.liveWaiting > 0},
                                        {&discrepancies_, queue_.disagreements > 0},
                                        {&evaluation_, queue_.models > 0}};
  int place = 0;
  int widest = 0;
  for (const auto& [door, waits] : all) {
    door->button->setMinimumWidth(0);
    widest = std::max(widest, door->button->sizeHint().width());
  }
  for (const auto& [door, waits] : all) {
    door->button->setMinimumWidth(widest);  // stacked in one column
    doorPlaces_->removeWidget(door->row);
    door->row->setVisible(waits);
    if (!waits) {
      continue;
    }
    doorPlaces_->addWidget(door->row, place / kDoorsBeside, place % kDoorsBeside);
    ++place;
  }
  doors_->setVisible(place > 0);
}

void QueuePage::showQueue() {
  showFigures();
  showDoors();
  continue_->setEnabled(queue_.next.has_value());
  continue_->setText(queue_.drafts > 0    ? tr("&Continue the draft")
                     : queue_.waiting > 0 ? tr("&Continue")
                                          : tr("All scored"));
  std::vector<Row> rows;
  for (const QueueLine& line : queue_.lines) {
    const bool done = line.state == SheetState::kSubmitted;
    const QString state = done                               ? tr("submitted")
                          : line.overdue                     ? tr("overdue")
                          : line.state == SheetState::kDraft ? tr("draft")
                                                             : tr("waiting");
    const std::int64_t length_us = line.shown.length_us.value_or(0);
    Row row{toQString(line.shown.assignmentId), {}};
    row.cells = {
        {tr("Case %1").arg(toQString(line.shown.label)), static_cast<int>(rows.size())},
        {state, static_cast<int>(line.state)},
        {clockTenthsOf(length_us), static_cast<qlonglong>(length_us)},
        {line.shown.dueUtc_us ? dayText(*line.shown.dueUtc_us) : QString(),
         static_cast<qlonglong>(line.shown.dueUtc_us.value_or(0))},
        {done ? QString() : clockTime(std::llround(line.estimate_min * kMinute_us)), line.estimate_min}};
    rows.push_back(std::move(row));
  }
  table_->setRows(std::move(rows));
}

void QueuePage::goOn() {
  if (queue_.next) {
    shell().open(PageId::kCase, toQString(*queue_.next));
  }
}

void QueuePage::keyPressEvent(QKeyEvent* event) {
  const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (enter && continue_->hasFocus()) {
    return goOn();
  }
  Page::keyPressEvent(event);
}

}  // namespace torsio::gui
