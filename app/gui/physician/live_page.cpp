// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/physician/live_page.h"

#include <algorithm>
#include <utility>

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>

#include "app/gui/base/background.h"
#include "app/gui/base/page.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/sign_dialog.h"
#include "app/gui/physician/review_labels.h"
#include "app/gui/physician/sheet_editor_panel.h"
#include "app/gui/physician/sheet_panel.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "assessment/domain/ids.h"
#include "sim/core/time_units.h"

namespace torsio::gui {

namespace {

constexpr int kTick_ms = 100;
constexpr int kFollow_ms = 2'000;

}  // namespace

LivePage::LivePage(ShellContext& shell, QWidget* parent)
    : Page(shell, parent),
      heading_(new PageHeading(this)),
      group_(new QButtonGroup(this)),
      case_(new QLabel(this)),
      clock_(new QLabel(this)),
      start_(primaryButton(this)),
      write_(new QPushButton(this)),
      submit_(primaryButton(this)),
      amend_(new QPushButton(this)),
      older_(new QPushButton(this)),
      said_(sentence(this)),
      called_(sentence(this, false)),
      reader_(new Background(this)),
      sheet_(named(new SheetEditorPanel(true, this), "sheetPanel")) {
  QVBoxLayout* column = columnOf(this, {3 * kSpace, 2 * kSpace, 3 * kSpace, 2 * kSpace}, kSpace);
  column->addWidget(heading_);
  QHBoxLayout* row = rowOf({}, 2 * kSpace);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* ground = new QWidget;
  order_ = new QVBoxLayout(ground);
  order_->setContentsMargins(0, 0, 0, 0);
  keepOffScrollBar(*scroll, *order_);
  scroll->setWidget(ground);
  auto* left = new QVBoxLayout;
  left->addWidget(scroll, 1);
  left->addWidget(older_);
  row->addLayout(left, 1);
  auto* right = new QVBoxLayout;
  called_.label()->setObjectName(QStringLiteral("called"));
  called_.label()->hide();
  right->addWidget(called_.label());
  createClock(right);
  right->addWidget(sheet_, 1);
  auto* foot = new QHBoxLayout;
  foot->addWidget(said_.label(), 1);
  foot->addWidget(amend_);
  foot->addWidget(submit_);
  right->addLayout(foot);
  row->addLayout(right, 3);
  column->addLayout(row, 1);
  // The application's style sheet sets the height of push buttons; fingers need more.
  const QString tall = QStringLiteral("QPushButton { min-height: %1px; }").arg(kTouch_px - 2 * kSpace + 2);
  for (QPushButton* button : {start_, write_, submit_, amend_, older_}) {
    button->setStyleSheet(tall);
  }
  group_->setExclusive(true);
  connect(sheet_, &SheetPanel::edited, this, &LivePage::edited);
  connect(sheet_, &SheetEditorPanel::finishWanted, this, &LivePage::submit);
  connect(sheet_, &SheetEditorPanel::heldBack, this,
          [this] { this->shell().notify(tr("This is the next case. Change its sheet first")); });
  connect(submit_, &QPushButton::clicked, this, &LivePage::submit);
  connect(amend_, &QPushButton::clicked, this, &LivePage::amend);
  connect(older_, &QPushButton::clicked, this, [this] {
    withOlder_ = !withOlder_;
    showLines();
  });
  connect(&tick_, &QTimer::timeout, this, &LivePage::showClock);
  follow_.setParent(this);
  follow_.setInterval(kFollow_ms);
  connect(&follow_, &QTimer::timeout, this, &LivePage::lookForCalls);
}

LivePage::~LivePage() = default;

void LivePage::createClock(QVBoxLayout* column) {
  case_->setProperty("heading", true);
  clock_->setProperty("figure", true);
  QHBoxLayout* row = rowOf({}, 2 * kSpace);
  row->addWidget(case_, 1);
  row->addWidget(clock_);
  row->addWidget(start_);
  row->addWidget(write_);
  column->addLayout(row);
  connect(start_, &QPushButton::clicked, this, &LivePage::toggleClock);
  connect(write_, &QPushButton::clicked, this, &LivePage::writeTime);
}

void LivePage::enter(const QVariant&) {
  keptAt_ = keptAt(shell().session());
  withOlder_ = false;
  retranslate();  // the heading says where things are stored
  opened_ = {};
  followed_ = {};
  sheet_->endSheet();
  readLines();
  follow_.start();
  followCall();
  if (sheet_->editor() == nullptr) {
    showAll();  // a late sheet is opened by hand alone: whoever waits for a call must not score into it
  }
}

bool LivePage::leave() {
  if (!tick_.isActive()) {
    follow_.stop();
    return true;
  }
  shell().notify(tr("The timer is running. Stop it first"));
  return false;
}

void LivePage::readLines() {
  lines_ = liveLines(shell().session());
  showLines();
}

void LivePage::lookForCalls() {
  if (holdsButton(*this) || reader_->working() || shell().databaseAway()) {
    return;
  }
  reader_->run(
      shell().session().key(), [](SessionContext& own) { return liveLines(own); },
      [this](std::vector<QueueLine> lines) {
        const auto stateOf = [](const std::vector<QueueLine>& all) {
          std::vector<std::pair<AssignmentId, bool>> states;
          for (const QueueLine& line : all) {
            states.emplace_back(line.shown.assignmentId, line.call && line.call->open);
          }
          return states;
        };
        if (!follow_.isActive() || holdsButton(*this) || stateOf(lines) == stateOf(lines_)) {
          return;  // lines are not rebuilt under a finger
        }
        lines_ = std::move(lines);
        showLines();
        followCall();
      },
      [](const std::exception_ptr&) {});  // the window shows a database outage; the next refresh tries again
}

void LivePage::followCall() {
  const bool shown = sheet_->editor() != nullptr;
  const CallGuide guide = guideToCall(lines_, shown ? opened_.shown.assignmentId : AssignmentId(),
                                      tick_.isActive() || sheet_->unsaved(), AssignmentId(followed_));
  if (!guide.called) {
    called_.label()->hide();
    return;
  }
  if (guide.opens) {
    followed_ = guide.called->shown.assignmentId;
    return static_cast<void>(attempt(shell(), [&] { openLine(AssignmentId(followed_)); }));
  }
  called_.say(
      [otherRoom = guide.otherRoom, label = toQString(guide.called->shown.label),
       room = toQString(guide.called->call->room)] {
        return otherRoom
                   ? tr("Case %1 is called to %2: if you are there, choose it at the left.").arg(label, room)
                   : tr("Case %1 is called now. What you have begun here is kept: submit it, or choose the "
                        "case at the left and come back later.")
                         .arg(label);
      },
      true);
  called_.label()->show();
}

bool LivePage::callsGoOn() const {
  return torsio::callsGoOn(lines_, shell().session().now_us());
}

QString LivePage::stateText(const QueueLine& line) const {
  if (line.state == SheetState::kSubmitted) {
    return tr("submitted");
  }
  const bool open = line.call && line.call->open;
  if (line.state == SheetState::kDraft) {
    return open ? tr("draft, called now") : tr("draft, late");
  }
  return open ? tr("called now") : tr("late");
}

void LivePage::showLines() {
  for (QAbstractButton* button : group_->buttons()) {
    group_->removeButton(button);
    button->hide();
    button->deleteLater();
  }
  while (QLayoutItem* item = order_->takeAt(0)) {
    delete item;
  }
  const std::int64_t now_us = shell().session().now_us();
  int number = 0;
  int hidden = 0;
  for (const QueueLine& line : lines_) {
    if (isOfEarlierDay(line, now_us)) {
      ++hidden;
      if (!withOlder_) {
        continue;
      }
    }
    auto* button = new QToolButton(this);
    button->setCheckable(true);
    button->setMinimumHeight(kTouch_px);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    button->setText(tr("%1.  Case %2, %3").arg(++number).arg(toQString(line.shown.label), stateText(line)));
    button->setChecked(line.shown.assignmentId == opened_.shown.assignmentId);
    group_->addButton(button);
    order_->addWidget(button);
    button->show();
    const AssignmentId id = line.shown.assignmentId;
    connect(button, &QToolButton::clicked, this, [this, id] {
      if (!leave()) {
        return showLines();
      }
      attempt(this->shell(), [&] { openLine(id); });
    });
  }
  order_->addStretch(1);
  older_->setVisible(hidden > 0);
  older_->setText(withOlder_ ? tr("Hide earlier ones") : tr("Show earlier ones (%1)").arg(hidden));
}

QString LivePage::savedText() const {
  return keptAt_ == KeptAt::kThisMachine ? tr("Saved on this machine") : tr("Saved on the centre's server");
}

void LivePage::amend() {
  if (sheet_->editor() != nullptr) {
    shell().open(PageId::kCase, toQString(opened_.shown.assignmentId));
  }
}

void LivePage::openLine(const AssignmentId& assignmentId) {
  opened_ = openSheet(shell().session(), assignmentId);
  sheet_->beginSheet(opened_.rubric, opened_.sheet);
  clocked_us_ = 0;
  said_.clear();
  readLines();
  followCall();
  showAll();
  sheet_->takeFocus();
}

void LivePage::customEvent(QEvent* event) {
  if (event->type() == databaseAnsweredEvent() && sheet_->unsaved()) {
    edited();
  }
}

void LivePage::edited() {
  sheet_->save(
      shell(), said_, [this] { return savedText(); },
      [this] {
        SheetEditor& editor = *sheet_->editor();
        editor.saved(
            saveSheet(shell().session(), opened_.shown.assignmentId, editor.sheet(), opened_.watched));
        if (opened_.state != SheetState::kOpen) {
          return;
        }
        opened_.state = SheetState::kDraft;
        readLines();
      });
  showAll();
}

void LivePage::toggleClock() {
  if (tick_.isActive()) {
    clocked_us_ += running_.nsecsElapsed() / 1000;
    tick_.stop();
    opened_.watched.worked(clocked_us_);
  } else {
    running_.start();
    tick_.start(kTick_ms);
  }
  showAll();
}

void LivePage::showClock() {
  const std::int64_t now_us = clocked_us_ + (tick_.isActive() ? running_.nsecsElapsed() / 1000 : 0);
  clock_->setText(clockTime(now_us));
}

void LivePage::writeTime() {
  if (sheet_->editor() == nullptr) {
    return;
  }
  QString text = toQString(sheet_->editor()->sheet().comment);
  if (!text.isEmpty() && !text.endsWith(QLatin1Char('\n'))) {
    text += QLatin1Char('\n');
  }
  text += tr("Time taken: %1").arg(clockTime(clocked_us_));
  if (sheet_->editor()->setComment(text.toStdString())) {
    sheet_->refresh();
    edited();
  }
}

void LivePage::submit() {
  if (sheet_->editor() == nullptr || opened_.state == SheetState::kSubmitted) {
    return;
  }
  const SheetCheck check =
      checkSheet(opened_, sheet_->editor()->sheet(), opened_.watched, {}, shell().session().now_us());
  if (!check.mayBeSubmitted()) {
    said_.say([left = check.unanswered.size()] { return tr("Still open: %1").arg(left); }, true);
    sheet_->setCurrentRow(check.unanswered.front());
    sheet_->takeFocus();
    return;
  }
  if (!sheet_->asking()) {
    sheet_->setAsking(true);
    said_.say([check] {
      return check.allTheSame ? tr("All rows have the same mark. Press again to seal the sheet.")
             : check.farApart ? tr("The rows lie far apart. Press again to seal the sheet.")
             : check.soonAfterCall_us
                 ? tr("The trainee was called only %1 s ago. Press again to seal the sheet.")
                       .arg(*check.soonAfterCall_us / kSecond_us)
             : check.overallOutside
                 ? tr("The overall mark is outside the rows' range. Press again to seal the sheet.")
                 : tr("Everything is scored. Press again to seal the sheet.");
    });
    return;
  }
  if (!readyToSign(this, shell(), SignatureMeaning::kScored)) {
    return;
  }
  attempt(shell(), [&] {
    submitSheet(shell().session(), opened_.shown.assignmentId, sheet_->editor()->sheet(), opened_.watched);
    shell().notify(tr("Case %1 is submitted and sealed").arg(toQString(opened_.shown.label)));
    enter({});
    sheet_->waitForTouch();
  });
}

void LivePage::showAll() {
  const bool open = sheet_->editor() != nullptr && opened_.state != SheetState::kSubmitted;
  case_->setText(sheet_->editor() != nullptr ? tr("Case %1").arg(toQString(opened_.shown.label))
                                             : tr("Nobody is called now"));
  start_->setText(tick_.isActive() ? tr("Stop the timer") : tr("Start the timer"));
  start_->setEnabled(open);
  write_->setEnabled(open && !tick_.isActive() && clocked_us_ > 0);
  submit_->setVisible(open);
  amend_->setVisible(!open && sheet_->editor() != nullptr);
  sheet_->setReadOnly(!open);
  if (!open && sheet_->editor() != nullptr) {
    said_.say([] { return tr("Submitted and sealed"); });
  }
  if (sheet_->editor() == nullptr) {
    const bool late = std::any_of(lines_.begin(), lines_.end(), [](const QueueLine& line) {
      return line.state != SheetState::kSubmitted && line.call && !line.call->open;
    });
    said_.say([late] {
      const QString opens = tr("The sheet opens by itself when an administrator calls a case.");
      return late ? opens + QLatin1Char(' ') +
                        tr("Some sheets are late: choose one on the left to fill it in.")
                  : opens;
    });
  }
  showClock();
}

void LivePage::retranslate() {
  heading_->setTexts(
      tr("Live sheet"),
      keptAt_ == KeptAt::kThisMachine
          ? tr("Real arm: the sheet follows the call. Works without a network; every tap is saved.")
          : tr("Real arm: the sheet follows the call. Every tap is saved on the centre's server; if it "
               "cannot be reached, it is said at once."));
  amend_->setText(tr("&Amend\u2026"));
  amend_->setToolTip(tr("Makes a new version with a reason; the submitted one is kept"));
  write_->setText(tr("Note the time"));
  submit_->setText(tr("Submit"));
  clock_->setAccessibleName(tr("Timer"));
  sheet_->retranslate();
  said_.again();
  called_.again();
  showLines();
  showAll();
}

std::vector<std::pair<QString, QString>> LivePage::keys() const {
  std::vector<std::pair<QString, QString>> all = sheetKeys();
  all.emplace_back(tr("Start or stop the timer"), QStringLiteral("Space"));
  all.emplace_back(tr("Not assessable: type why, Enter"), QStringLiteral("N"));
  return all;
}

void LivePage::applyTheme(const Theme& theme) {
  sheet_->setTheme(theme);
}

void LivePage::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Space && event->modifiers() == Qt::NoModifier && sheet_->editor() != nullptr &&
      opened_.state != SheetState::kSubmitted) {
    return toggleClock();
  }
  if (sheet_->handle(event)) {
    return;
  }
  Page::keyPressEvent(event);
}

}  // namespace torsio::gui
