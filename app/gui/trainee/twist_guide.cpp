// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/trainee/twist_guide.h"

#include <algorithm>
#include <cmath>

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/simulator/readout_panel.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/outputs/wording/joined_sentences.h"
#include "sim/core/angle.h"
#include "sim/servo/exercise.h"

namespace torsio::gui {

namespace {

constexpr int kGuideWidth = 340;  // fits beside an upright arm in the smallest window

}  // namespace

TwistGuide::TwistGuide(QWidget* over)
    : QFrame(over),
      number_(plainLabel(this, "quiet")),
      what_(plainLabel(this, "subheading")),
      how_(plainLabel(this)),
      skip_(named(linkButton(this), "skipGuide")) {
  setProperty("card", true);
  setAutoFillBackground(true);
  what_->setObjectName(QStringLiteral("movement"));
  skip_->setFocusPolicy(Qt::TabFocus);  // keys still steer the instrument
  QVBoxLayout* column = columnOf(this, {2 * kSpace, kSpace + 4, 2 * kSpace, kSpace + 4}, kSpace / 2);
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
                            : tr("Press and hold the left mouse button or Space."));
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
      what_->setText(tr("First twist done"));
      how_->setText(tr("Keep practising; the debrief shows this run afterwards."));
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

namespace {

constexpr double kTargetNear = 0.85;  // of the angle: time to slow down

}  // namespace

void TwistCoach::begin(const TrainingModule& module, double target_rad, bool haptic) {
  *this = {};
  module_ = module;
  target_rad_ = target_rad;
  haptic_ = haptic;
}

void TwistCoach::follow(const LiveState& state, bool onTarget) {
  heldShare_ = heldShareOf(state, onTarget);
  held_ = state.phase == ExercisePhase::kTwisting ? heldShare_ >= 1.0 : held_;
  const std::int64_t before = completed();
  twists_.see(state);
  if (completed() > before) {
    released_ += std::abs(twists_.releasedAt_rad() - target_rad_) <= module_.tolerance_rad ? 1 : 0;
    letGoHeld_ = held_;
    held_ = false;
  }
}

double TwistCoach::heldShareOf(const LiveState& state, bool onTarget) {
  if (state.phase != ExercisePhase::kTwisting || !onTarget || module_.hold_us <= 0) {
    onTargetFrom_us_ = -1;
    return 0.0;
  }
  if (onTargetFrom_us_ < 0) {
    onTargetFrom_us_ = state.time_us;
  }
  return static_cast<double>(state.time_us - onTargetFrom_us_) / static_cast<double>(module_.hold_us);
}

QString TwistCoach::goal() const {
  const QString within = numberText(degrees(module_.tolerance_rad), 0);
  return module_.hold_us > 0 ? tr("Within %1\u00b0, hold for %2 s, then release")
                                   .arg(within, numberText(static_cast<double>(module_.hold_us) * 1e-6, 1))
                             : tr("Within %1\u00b0, then release").arg(within);
}

QString TwistCoach::count() const {
  const std::int64_t wanted = module_.leastTwists;
  const std::int64_t done = completed();
  return done > wanted ? tr("%n twist(s), at least %1 asked for", nullptr, static_cast<int>(done)).arg(wanted)
                       : tr("%1 of %n twist(s)", nullptr, static_cast<int>(wanted)).arg(done);
}

QString TwistCoach::verdict() const {
  const double at_rad = twists_.releasedAt_rad();
  const double off_rad = std::abs(at_rad - target_rad_);
  QString how;
  if (off_rad > module_.tolerance_rad) {
    const QString by = numberText(degrees(off_rad), 0);
    how = at_rad * target_rad_ < 0.0 ? tr("Turned the wrong way: turn in the opposite direction.")
          : std::abs(at_rad) > std::abs(target_rad_)
              ? tr("Let go %1\u00b0 too far: turn back before you open the jaw.").arg(by)
              : tr("Let go %1\u00b0 too early: turn further before you open the jaw.").arg(by);
  } else {
    how = module_.hold_us > 0 && !letGoHeld_
              ? tr("Released on target, but not held: wait until the ring is full.")
              : tr("Released on target.");
  }
  return tr("%1 On target: %2 of %3").arg(how).arg(released_).arg(completed());
}

QString TwistCoach::cue(const LiveState& state) const {
  const bool open = state.phase == ExercisePhase::kTracking || state.phase == ExercisePhase::kContact;
  if (open && completed() > 0 && completed() >= module_.leastTwists) {
    return tr("All twists are done. End the run, or twist again.");
  }
  switch (state.phase) {
    case ExercisePhase::kTracking:
      if (state.grip > kJawCloses) {
        return closedInAir();
      }
      return haptic_ ? tr("Bring the jaw to the marked band.")
                     : tr("Bring the jaw to the marked band. The wheel moves it nearer.");
    case ExercisePhase::kContact:
      if (state.grip > kJawCloses) {
        return closedInAir();  // it arrived closed
      }
      return haptic_ ? tr("Touching. Close the jaw.")
                     : tr("Touching. Close the jaw: hold the left button or Space.");
    case ExercisePhase::kTwisting:
      return twistingCue(state.response.angle_rad);
    case ExercisePhase::kReleased:
      return joinedSentences({ReadoutPanel::releaseText(state), tr("Draw back before the next twist.")});
  }
  return {};
}

QString TwistCoach::jaw(const LiveState& state) {
  return state.phase == ExercisePhase::kTwisting ? tr("Jaw: holds the tissue")
         : state.grip > kJawCloses               ? tr("Jaw: closed, nothing in it")
                                                 : tr("Jaw: open");
}

QString TwistCoach::closedInAir() const {
  return haptic_ ? tr("The jaw closed without tissue. Release the button, touch the band, then press it.")
                 : tr("The jaw closed without tissue. Let go, touch the band, then close it.");
}

QString TwistCoach::twistingCue(double angle_rad) const {
  const double target_rad = module_.targetAngle_rad;
  const double way = target_rad == 0.0 ? 0.0 : angle_rad / target_rad;
  if (std::abs(angle_rad - target_rad) <= module_.tolerance_rad) {
    return module_.hold_us > 0 ? tr("On target. Hold, then release gently.")
                               : tr("On target. Let go gently.");
  }
  if (way > 1.0) {
    return tr("Beyond the target. Turn back a little.");
  }
  if (way > kTargetNear) {
    return tr("Nearly there. Slow down.");
  }
  return way < 0.0 ? tr("Turn in the opposite direction.") : tr("Turn in one even movement.");
}

}  // namespace torsio::gui
