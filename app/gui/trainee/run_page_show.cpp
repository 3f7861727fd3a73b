// SPDX-License-Identifier: GPL-3.0-or-later
// Of RunPage: what it shows and says.
#include <algorithm>
#include <cmath>

#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>

#include "app/gui/base/clock_time.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/simulator/detorsion_panel.h"
#include "app/gui/simulator/readout_panel.h"
#include "app/gui/simulator/validity_button.h"
#include "app/gui/trainee/live_scene.h"
#include "app/gui/trainee/run_page.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/tracker_panel.h"
#include "app/gui/trainee/trainee_labels.h"
#include "app/gui/trainee/twist_guide.h"
#include "app/gui/widgets/angle_dial.h"
#include "app/gui/widgets/card.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/level_bar.h"
#include "app/gui/widgets/number_text.h"
#include "assessment/domain/study/curriculum.h"
#include "sim/core/angle.h"
#include "sim/servo/surface_proxy.h"

namespace torsio::gui {

namespace {

constexpr std::int64_t kSoon_us = 30'000'000;
constexpr double kTargetNear = 0.85;  // of the way: time to slow down

}  // namespace

void RunPage::retranslate() {
  time_->setAccessibleName(tr("Time left"));
  timeName_->setText(tr("Time left"));
  // Their gauges say what they show; a title each would not fit a small screen.
  angle_->setAccessibleName(tr("Angle"));
  load_->setAccessibleName(tr("Load on the tissue"));
  torque_->setName(tr("Torque"), tr("N m"));
  force_->setName(tr("Force"), tr("N"));
  stop_->setText(tr("&End the run"));
  guideMe_->setText(tr("Guide me"));
  guide_->retranslate();
  tracker_->retranslate();
  dial_->retranslate();
  detorsion_->retranslate();
  validity_->retranslate();
  if (runSession_) {
    title_->setText(toQString(Text(runSession_->step().module.title)));
    mode_->setText(runSession_->graded() ? tr("Graded run") : tr("Practice"));
  }
  showCount();
  showState();
}

void RunPage::applyTheme(const Theme& theme) {
  theme_ = &theme;
  scene_->setTheme(theme);
  dial_->setTheme(theme);
  torque_->setTheme(theme);
  force_->setTheme(theme);
}

void RunPage::showState() {
  const bool runs = runSession_.has_value() && !waiting_;
  stop_->setEnabled(runs);
  if (!runSession_) {
    countdown_->setText(clockTimeLeft(0));
    stage_->setCurrentIndex(1);
    noticeTitle_->setText(inFile_ ? tr("Your run is safe") : tr("No run in progress"));
    noticeFigure_->clear();
    noticeText_->setText(inFile_ ? tr("The database did not answer. The recording is kept, on this computer "
                                      "where need be; as soon as the database answers you find its debrief "
                                      "on the page \u201c"
                                      "Debrief\u201d.")
                                 : tr("Choose a module on the page \u201cMy next step\u201d."));
    goOn_->hide();
    tracker_->hide();
    rest_->hide();
    for (QLabel* label : {warning_, verdict_, cue_}) {
      label->hide();  // of the run before
    }
    return;
  }
  const TrainingRun& run = runSession_->run();
  const RunPhase& phase = run.phase();
  const bool real = phase.arm == PhaseKind::kReal;
  countdown_->setText(clockTimeLeft(run.remainingInPhase_us()));
  setLook(countdown_, "caution", run.state() == RunState::kRunning && run.remainingInPhase_us() < kSoon_us);
  progress_->setValue(  // what is left, as the figure above it
      static_cast<int>(run.remainingInPhase_us() * 1000 / std::max<std::int64_t>(1, phase.duration_us)));
  const int number = static_cast<int>(run.phaseIndex()) + 1;
  const int all = static_cast<int>(run.plan().phases.size());
  phase_->setVisible(all > 1);
  phase_->setText(all > 1 ? tr("Phase %1 of %2: %3").arg(number).arg(all).arg(toQString(phase.label))
                          : toQString(phase.label));
  rest_->setVisible(runs && run.plan().restAllowance_us > 0);
  rest_->setEnabled(run.mayRest() && !opening_.going());
  rest_->setText(run.state() == RunState::kResting || run.restLeft_us() > 0
                     ? tr("&Rest (%1 left)").arg(clockTimeLeft(run.restLeft_us()))
                     : tr("&Rest (used up)"));
  rest_->setMinimumWidth(std::max(rest_->minimumWidth(), rest_->sizeHint().width()));
  const Scene* scene = scene_->controller().scene();
  const bool undone = scene != nullptr && scene->hollow != nullptr;
  angle_->setVisible(!real && !undone);
  detorsion_->setVisible(!real && undone);
  detorsion_->setUsable(runs && run.state() == RunState::kRunning);
  load_->setVisible(!real);
  guideMe_->setVisible(!real && !undone && !runSession_->graded());
  tracker_->setVisible(real && runs);
  tracker_->follow(tracked_ != nullptr);
  stage_->setCurrentIndex(showNotice() ? 1 : 0);
  showTold();
}

/// One thing at a time: a warning stands in place of what else is said, and while a hand turns the gauges
/// need the place.
void RunPage::showTold() {
  const bool simulated = stage_->currentIndex() == 0;
  const bool practice = simulated && !runSession_->graded();
  const bool warned = simulated && !warning_->text().isEmpty();
  warning_->setVisible(warned);
  verdict_->setVisible(practice && !warned && !turning_ && twists_.completed() > 0 &&
                       angle_->isVisibleTo(this));
  cue_->setVisible(practice && !warned);
}

/// What stands in place of the organ; false: nothing does.
bool RunPage::showNotice() {
  const TrainingRun& run = runSession_->run();
  const RunPhase& phase = run.phase();
  const bool real = phase.arm == PhaseKind::kReal;
  goOn_->setVisible(opening_.going() ? waiting_ : run.state() != RunState::kRunning);
  noticeFigure_->setVisible(!opening_.going());
  setLook(goOn_, "primary", !opening_.going());
  if (opening_.going()) {
    noticeTitle_->setText(tr("Getting the haptic device ready"));
    noticeText_->setText(waiting_ ? tr("This takes a few seconds. Your time has not begun yet.")
                                  : tr("This takes a few seconds. Your training clock is paused."));
    goOn_->setText(tr("&Cancel"));
    return true;
  }
  if (run.state() == RunState::kResting) {
    noticeTitle_->setText(tr("Rest"));
    noticeFigure_->setText(clockTimeLeft(run.restLeft_us()));
    noticeText_->setText(
        tr("Your training clock is paused. Training resumes automatically when the rest is used up."));
    goOn_->setText(tr("&Go on now"));
    return true;
  }
  if (run.state() == RunState::kHandOver) {
    noticeTitle_->setText(real ? tr("Go to the real arm") : tr("Come to the simulator"));
    noticeFigure_->setText(clockTimeLeft(run.handOverLeft_us()));
    noticeText_->setText(tr("The next phase starts automatically: %1").arg(toQString(phase.label)));
    goOn_->setText(tr("I am &ready"));
    return true;
  }
  if (real) {
    noticeTitle_->setText(tr("Train on the real arm"));
    noticeFigure_->setText(clockTimeLeft(run.remainingInPhase_us()));
    noticeText_->setText(tracked_ != nullptr
                             ? tr("This timer logs your training time. The tracker records the instrument.")
                             : tr("This timer logs your training time. Nothing is recorded."));
  }
  return real;
}

QString RunPage::cue(const LiveState& state) const {
  if (const QString untwisting = detorsion_->cue(); !untwisting.isEmpty()) {
    return untwisting;
  }
  const TrainingModule& module = runSession_->step().module;
  const double target = module.targetAngle_rad;
  const bool open = state.phase == ExercisePhase::kTracking || state.phase == ExercisePhase::kContact;
  if (open && twists_.completed() > 0 && twists_.completed() >= module.leastTwists) {
    return tr("All twists are done. End the run, or twist again.");
  }
  switch (state.phase) {
    case ExercisePhase::kTracking:
      return haptic_ ? tr("Bring the jaw to the marked band.")
                     : tr("Bring the jaw to the marked band. The wheel moves it nearer.");
    case ExercisePhase::kContact:
      return haptic_ ? tr("Touching. Close the jaw.")
                     : tr("Touching. Close the jaw: hold the left button or Space.");
    case ExercisePhase::kTwisting: {
      const double way = target == 0.0 ? 0.0 : state.response.angle_rad / target;
      if (std::abs(state.response.angle_rad - target) <= module.tolerance_rad) {
        return module.hold_us > 0 ? tr("On target. Hold, then release gently.")
                                  : tr("On target. Let go gently.");
      }
      if (way > 1.0) {
        return tr("Beyond the target. Turn back a little.");
      }
      if (way > kTargetNear) {
        return tr("Nearly there. Slow down.");
      }
      if (way < 0.0) {
        return tr("Turn in the opposite direction.");
      }
      return tr("Turn in one even movement.");
    }
    case ExercisePhase::kReleased:
      return ReadoutPanel::releaseText(state);
  }
  return {};
}

double RunPage::heldShare(const LiveState& state) {
  const TrainingModule& module = runSession_->step().module;
  const bool there = state.phase == ExercisePhase::kTwisting && dial_->onTarget();
  if (!there || module.hold_us <= 0) {
    onTargetFrom_us_ = -1;
    return 0.0;
  }
  if (onTargetFrom_us_ < 0) {
    onTargetFrom_us_ = state.time_us;
  }
  return static_cast<double>(state.time_us - onTargetFrom_us_) / static_cast<double>(module.hold_us);
}

void RunPage::showCount() {
  if (!runSession_) {
    return;
  }
  const std::int64_t wanted = runSession_->step().module.leastTwists;
  count_->setVisible(wanted > 1);
  const std::int64_t done = twists_.completed();
  count_->setText(done > wanted
                      ? tr("%n twist(s), at least %1 asked for", nullptr, static_cast<int>(done)).arg(wanted)
                      : tr("%1 of %n twist(s)", nullptr, static_cast<int>(wanted)).arg(done));
  const TrainingModule& module = runSession_->step().module;
  const QString within = numberText(degrees(module.tolerance_rad), 0);
  goal_->setText(module.hold_us > 0
                     ? tr("Within %1\u00b0, hold for %2 s, then release")
                           .arg(within, numberText(static_cast<double>(module.hold_us) * 1e-6, 1))
                     : tr("Within %1\u00b0, then release").arg(within));
  verdict_->setText(verdict());
}

void RunPage::judge() {
  const double off_rad = std::abs(twists_.releasedAt_rad() - scene_->controller().target_rad());
  onTarget_ += off_rad <= runSession_->step().module.tolerance_rad ? 1 : 0;
  letGoHeld_ = held_;
  held_ = false;
}

QString RunPage::verdict() const {
  const TrainingModule& module = runSession_->step().module;
  const double target_rad = scene_->controller().target_rad();
  const double at_rad = twists_.releasedAt_rad();
  const double off_rad = std::abs(at_rad - target_rad);
  QString how;
  if (off_rad > module.tolerance_rad) {
    const QString by = numberText(degrees(off_rad), 0);
    how = at_rad * target_rad < 0.0 ? tr("Turned the wrong way: turn in the opposite direction.")
          : std::abs(at_rad) > std::abs(target_rad)
              ? tr("Let go %1\u00b0 too far: turn back before you open the jaw.").arg(by)
              : tr("Let go %1\u00b0 too early: turn further before you open the jaw.").arg(by);
  } else {
    how = module.hold_us > 0 && !letGoHeld_
              ? tr("Released on target, but not held: wait until the ring is full.")
              : tr("Released on target.");
  }
  return tr("%1 On target: %2 of %3").arg(how).arg(onTarget_).arg(twists_.completed());
}

void RunPage::showLive(const LiveState& state) {
  if (!runSession_) {
    return;
  }
  if (desk_.outlet != nullptr) {
    desk_.outlet->show(state);
  }
  detorsion_->show(state);
  dial_->setAngle(state.response.angle_rad);
  const double held = heldShare(state);
  dial_->setHeld(held);
  guide_->follow(state, dial_->onTarget(), held);
  torque_->setValue(std::abs(state.response.torque_Nm));
  force_->setValue(norm(state.response.force_N));
  held_ = state.phase == ExercisePhase::kTwisting ? held >= 1.0 : held_;
  const std::int64_t before = twists_.completed();
  twists_.see(state);
  if (twists_.completed() > before) {
    judge();
  }
  showCount();
  const bool over = torque_->overLimit() || force_->overLimit();
  if (over && !wasOver_ && soundAtLimit_) {
    desk_.sound();
  }
  wasOver_ = over;
  const bool folded = state.phase == ExercisePhase::kReleased && state.times.folded_us >= 0 &&
                      state.times.folded_us == state.times.released_us;
  const QString otherwise = folded ? ReadoutPanel::releaseText(state) : QString();
  const bool deep = state.phase != ExercisePhase::kTwisting && state.response.depth_m > kTooDeep_m;
  warning_->setText(over   ? tr("Above the limit: ease off")
                    : deep ? tr("You are pressing too deep: draw back")
                           : otherwise);
  turning_ = state.phase == ExercisePhase::kTwisting;
  if (!runSession_->graded()) {
    cue_->setText(cue(state));
  }
  showTold();
}

}  // namespace torsio::gui
