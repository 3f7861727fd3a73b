// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/twist_guide.h"

#include <algorithm>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/trainee/station_parts.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr int kGuideWidth = 340;  // fits beside an upright arm in the smallest window

}  // namespace

TwistGuide::TwistGuide(QWidget* over)
    : QFrame(over),
      number_(plainLabel(this, "quiet")),
      what_(plainLabel(this, "subheading")),
      how_(plainLabel(this)),
      skip_(linkButton(this)) {
  setProperty("card", true);
  setAutoFillBackground(true);
  what_->setObjectName(QStringLiteral("movement"));
  skip_->setObjectName(QStringLiteral("skipGuide"));
  skip_->setFocusPolicy(Qt::TabFocus);  // keys still steer the instrument
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * kSpace, kSpace + 4, 2 * kSpace, kSpace + 4);
  column->setSpacing(kSpace / 2);
  auto* head = new QHBoxLayout;
  head->addWidget(number_, 1);
  head->addWidget(skip_);
  column->addLayout(head);
  column->addWidget(what_);
  column->addWidget(how_);
  over->installEventFilter(this);
  connect(skip_, &QPushButton::clicked, this, &TwistGuide::end);
  hide();
}

void TwistGuide::begin(bool haptic, bool held) {
  haptic_ = haptic;
  held_ = held;
  lost_ = false;
  going_ = true;
  step_ = Step::kReach;
  showStep();
  place();
  show();
  raise();
}

void TwistGuide::end() {
  going_ = false;
  hide();
}

TwistGuide::Step TwistGuide::next(const LiveState& state, bool onTarget, double heldShare) const {
  if (step_ == Step::kDone) {
    return step_;
  }
  switch (state.phase) {
    case ExercisePhase::kContact:
      return step_ == Step::kLetGo ? Step::kDone : Step::kClose;
    case ExercisePhase::kTwisting:
      if (!onTarget) {
        return Step::kTurn;
      }
      return !held_ || heldShare >= 1.0 || step_ == Step::kLetGo ? Step::kLetGo : Step::kHold;
    case ExercisePhase::kTracking:
    case ExercisePhase::kReleased:
      return step_ == Step::kLetGo ? Step::kDone : Step::kReach;
  }
  return step_;
}

void TwistGuide::follow(const LiveState& state, bool onTarget, double heldShare) {
  if (!going_) {
    return;
  }
  const Step now = next(state, onTarget, heldShare);
  if (now == step_) {
    return;
  }
  const bool held = step_ == Step::kTurn || step_ == Step::kHold;
  lost_ = now == Step::kReach ? held : lost_ && now == Step::kClose;
  step_ = now;
  showStep();
}

void TwistGuide::showStep() {
  const int all = held_ ? kMovements : kMovements - 1;
  const int number = std::min(static_cast<int>(step_) + 1, all);
  number_->setText(step_ == Step::kDone ? tr("Your first twist")
                                        : tr("Your first twist: movement %1 of %2").arg(number).arg(all));
  skip_->setText(step_ == Step::kDone ? tr("Close") : tr("Skip"));
  switch (step_) {
    case Step::kReach:
      what_->setText(lost_ ? tr("The tissue slipped. Bring the jaw to the band once more")
                           : tr("Bring the jaw to the marked band"));
      how_->setText(haptic_ ? tr("Move the stylus until the jaw touches the organ.")
                            : tr("Move the mouse, or press the arrows; the wheel or Page Up moves the "
                                 "instrument nearer, until it touches."));
      break;
    case Step::kClose:
      what_->setText(tr("Close the jaw"));
      how_->setText(haptic_ ? tr("Press the button of the stylus and keep it pressed.")
                            : tr("Hold the left mouse button or Space, and keep it held."));
      break;
    case Step::kTurn:
      what_->setText(tr("Turn to the mark on the dial"));
      how_->setText(haptic_ ? tr("Carry the jaw round the organ in one even movement.")
                            : tr("Drag, or press Q or E, in one even movement."));
      break;
    case Step::kHold:
      what_->setText(tr("Hold it there"));
      how_->setText(tr("The ring round the dial fills while you hold."));
      break;
    case Step::kLetGo:
      what_->setText(tr("Open the jaw gently"));
      how_->setText(tr("Release without a jerk; the organ turns back by itself."));
      break;
    case Step::kDone:
      what_->setText(tr("That was a whole twist"));
      how_->setText(tr("Go on as you like; the debrief shows this run afterwards."));
      break;
  }
}

void TwistGuide::retranslate() {
  showStep();
}

void TwistGuide::place() {
  const QWidget* over = parentWidget();
  const int width = std::min(kGuideWidth, over->width() - 4 * kSpace);
  const int height = std::max(sizeHint().height(), heightForWidth(width));
  setGeometry(2 * kSpace, 2 * kSpace, width, height);
}

bool TwistGuide::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget() && event->type() == QEvent::Resize) {
    place();
  }
  return QFrame::eventFilter(watched, event);
}

}  // namespace torsio::gui
