// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/trainee/run_panel.h"

#include <algorithm>
#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "app/connectors/built_in.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/simulator/detorsion_panel.h"
#include "app/gui/simulator/exercise_panel.h"
#include "app/gui/simulator/readout_panel.h"
#include "app/gui/simulator/simulation_controller.h"
#include "app/gui/trainee/station_parts.h"
#include "app/gui/trainee/tracker_panel.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/gauges.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/training/run_session.h"
#include "app/services/training/training_run.h"
#include "sim/core/load_decimals.h"
#include "sim/servo/surface_proxy.h"

namespace torsio::gui {

namespace {

constexpr int kPanelWidth = 316;
constexpr double kCountdown_pt = 30.0;
constexpr std::int64_t kSoon_us = 30'000'000;

/// A scroll area as high as its content if there is room, so that what follows is close below.
class ShrinkingArea : public QScrollArea {
 public:
  explicit ShrinkingArea(QWidget* parent) : QScrollArea(parent) {
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
  }
  [[nodiscard]] QSize sizeHint() const override {
    const QSize held = widget()->sizeHint();
    const int high = widget()->hasHeightForWidth() ? widget()->heightForWidth(width()) : held.height();
    return {held.width(), std::max(held.height(), high)};
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (watched == widget() && event->type() == QEvent::LayoutRequest) {
      updateGeometry();
    }
    return QScrollArea::eventFilter(watched, event);
  }
};

QLabel* namedLabel(QWidget* parent, const char* name, const char* look = nullptr) {
  QLabel* label = plainLabel(parent, look);
  label->setObjectName(QLatin1String(name));
  return label;
}

}  // namespace

RunPanel::RunPanel(SimulationController& controller, QWidget* parent)
    : QWidget(parent), controller_(controller) {
  // The buttons below are always visible; longer content scrolls on a small screen.
  setFixedWidth(kPanelWidth);
  QVBoxLayout* whole = columnOf(this, {}, 0);
  auto* scroll = new ShrinkingArea(this);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* panel = new QWidget;
  scroll->setWidget(panel);
  whole->addWidget(scroll);
  whole->addLayout(createTold());
  QVBoxLayout* column = columnOf(panel, {kSpace + 4, kSpace + 4, kSpace + 4, 0}, kSpace);
  column->addLayout(createHeading(panel));
  column->addWidget(createTime(panel));
  column->addWidget(createAngle(panel));
  detorsion_ = new DetorsionPanel(panel);
  detorsion_->steer(controller_);
  column->addWidget(detorsion_);
  load_ = new Card(QString(), panel);
  torque_ = new LevelBar(QString(), QString(), kTorqueDecimals, load_);
  force_ = new LevelBar(QString(), QString(), kForceDecimals, load_);
  load_->content()->addWidget(torque_);
  load_->content()->addWidget(force_);
  column->addWidget(load_);
  column->addStretch(1);
  whole->addStretch(1);
  whole->addLayout(createButtons());
}

QLayout* RunPanel::createTold() {
  warning_ = namedLabel(this, "warning", "caution");
  warning_->hide();
  verdict_ = namedLabel(this, "verdict");
  verdict_->hide();
  cue_ = namedLabel(this, "cue", "quiet");
  auto* told = new QVBoxLayout;
  told->setContentsMargins(kSpace + 4, kSpace / 2, kSpace + 4, 0);
  for (QLabel* label : {warning_, verdict_, cue_}) {
    told->addWidget(label);
  }
  return told;
}

QLayout* RunPanel::createHeading(QWidget* panel) {
  auto* column = new QVBoxLayout;
  column->setSpacing(kSpace);
  title_ = plainLabel(panel, "subheading");
  mode_ = plainLabel(panel, "quiet");
  validity_ = new ValidityButton(panel);
  auto* heading = new QHBoxLayout;
  heading->addWidget(title_, 1);
  heading->addWidget(validity_, 0, Qt::AlignTop);
  column->addLayout(heading);
  guideMe_ = named(linkButton(panel), "guideMe");
  guideMe_->setStyleSheet(QStringLiteral("padding: 0;"));  // aligned with the sentence beside it
  connect(guideMe_, &QPushButton::clicked, this, &RunPanel::guideWanted);
  auto* kind = new QHBoxLayout;
  kind->addWidget(mode_, 1);
  kind->addWidget(guideMe_);
  column->addLayout(kind);
  return column;
}

QWidget* RunPanel::createTime(QWidget* panel) {
  time_ = new Card(QString(), panel);
  countdown_ = namedLabel(time_, "countdown");
  makeHuge(countdown_, kCountdown_pt);
  progress_ = ranged(named(new QProgressBar(time_), "timeLeft"), 0, 1000);
  progress_->setTextVisible(false);
  phase_ = plainLabel(time_, "quiet");
  timeName_ = plainLabel(time_, "quiet");
  auto* left = new QHBoxLayout;
  left->addWidget(countdown_);
  left->addWidget(timeName_, 1, Qt::AlignBottom);
  time_->content()->addLayout(left);
  time_->content()->addWidget(progress_);
  time_->content()->addWidget(phase_);
  return time_;
}

QWidget* RunPanel::createAngle(QWidget* panel) {
  angle_ = new Card(QString(), panel);
  dial_ = new AngleDial(angle_);
  angle_->content()->addWidget(dial_, 0, Qt::AlignHCenter);
  jaw_ = namedLabel(angle_, "jaw");
  goal_ = namedLabel(angle_, "goal", "quiet");
  count_ = namedLabel(angle_, "twistCount", "subheading");
  for (QLabel* label : {jaw_, goal_, count_}) {
    label->setAlignment(Qt::AlignHCenter);
    angle_->content()->addWidget(label);
  }
  return angle_;
}

QLayout* RunPanel::createButtons() {
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(kSpace + 4, kSpace, kSpace + 4, kSpace + 4);  // as wide as the cards above
  buttons->setSpacing(kSpace);
  rest_ = named(new QPushButton(this), "rest");
  end_ = named(new QPushButton(this), "stop");
  buttons->addWidget(rest_);
  buttons->addWidget(end_);
  connect(rest_, &QPushButton::clicked, this, &RunPanel::restWanted);
  connect(end_, &QPushButton::clicked, this, &RunPanel::endWanted);
  return buttons;
}

void RunPanel::setRun(const RunSession* run) {
  run_ = run;
  wasOver_ = false;
  if (run == nullptr) {
    return;
  }
  const TrainingModule& module = run->step().module;
  dial_->setTarget(module.targetAngle_rad, module.tolerance_rad);
  coach_.begin(module, module.targetAngle_rad, false);
}

void RunPanel::showScene() {
  detorsion_->setScene(controller_.scene());
  validity_->setScene(controller_.scene());
}

void RunPanel::beginRecording(bool haptic) {
  const TrainingModule& module = run_->step().module;
  coach_.begin(module, controller_.target_rad(), haptic);
  dial_->setTarget(controller_.target_rad(), module.tolerance_rad);
  torque_->setLimit(module.maxTorque_Nm.value_or(0.0));
  force_->setLimit(module.maxForce_N.value_or(0.0));
  showCount();
}

void RunPanel::showTime(bool started, bool mayRest) {
  end_->setEnabled(started);
  rest_->setVisible(started && run_->run().plan().restAllowance_us > 0);
  if (run_ == nullptr) {
    countdown_->setText(clockTimeLeft(0));
    for (QLabel* label : {warning_, verdict_, cue_}) {
      label->hide();  // of the previous run
    }
    return;
  }
  const TrainingRun& run = run_->run();
  const RunPhase& phase = run.phase();
  const bool real = phase.arm == PhaseKind::kReal;
  countdown_->setText(clockTimeLeft(run.remainingInPhase_us()));
  setLook(countdown_, "caution", run.state() == RunState::kRunning && run.remainingInPhase_us() < kSoon_us);
  progress_->setValue(  // the remaining part, like the number above
      static_cast<int>(run.remainingInPhase_us() * 1000 / std::max<std::int64_t>(1, phase.duration_us)));
  const int number = static_cast<int>(run.phaseIndex()) + 1;
  const int all = static_cast<int>(run.plan().phases.size());
  phase_->setVisible(all > 1);
  phase_->setText(tr("Phase %1 of %2: %3").arg(number).arg(all).arg(toQString(phase.label)));
  rest_->setEnabled(mayRest && run.mayRest());
  rest_->setText(run.state() == RunState::kResting || run.restLeft_us() > 0
                     ? tr("&Rest (%1 left)").arg(clockTimeLeft(run.restLeft_us()))
                     : tr("&Rest (used up)"));
  rest_->setMinimumWidth(std::max(rest_->minimumWidth(), rest_->sizeHint().width()));
  const Scene* scene = controller_.scene();
  const bool untwisted = scene != nullptr && scene->comesTwisted();
  angle_->setVisible(!real && !untwisted);
  detorsion_->setVisible(!real && untwisted);
  detorsion_->setUsable(started && run.state() == RunState::kRunning);
  load_->setVisible(!real);
  guideMe_->setVisible(!real && !untwisted && !run_->graded());
}

/// Shows one thing at a time: a warning replaces other messages, and the gauges need the space while a hand
/// turns.
void RunPanel::showTold(bool simulated) {
  simulated_ = simulated;
  const bool practice = simulated && !run_->graded();
  const bool warned = simulated && !warning_->text().isEmpty();
  warning_->setVisible(warned);
  verdict_->setVisible(practice && !warned && !turning_ && coach_.completed() > 0 &&
                       angle_->isVisibleTo(parentWidget()));
  cue_->setVisible(practice && !warned);
}

void RunPanel::showCount() {
  goal_->setText(coach_.goal());
  count_->setVisible(run_->step().module.leastTwists > 1);
  count_->setText(coach_.count());
  verdict_->setText(coach_.verdict());
}

bool RunPanel::onTarget() const {
  return dial_->onTarget();
}

void RunPanel::follow(const LiveState& state) {
  detorsion_->show(state);
  dial_->setAngle(state.response.angle_rad);
  coach_.follow(state, dial_->onTarget());
  dial_->setHeld(coach_.heldShare());
  jaw_->setText(TwistCoach::jaw(state));
  torque_->setValue(std::abs(state.response.torque_Nm));
  force_->setValue(norm(state.response.force_N));
  showCount();
  const bool over = torque_->overLimit() || force_->overLimit();
  if (over && !wasOver_) {
    Q_EMIT limitPassed();
  }
  wasOver_ = over;
  const bool folded = state.phase == ExercisePhase::kReleased && state.times.folded_us >= 0 &&
                      state.times.folded_us == state.times.released_us;
  warning_->setText(over                                  ? tr("Above the limit: ease off")
                    : ReadoutPanel::pressesTooDeep(state) ? tr("You are pressing too deep: draw back")
                    : folded                              ? ReadoutPanel::releaseText(state)
                                                          : QString());
  turning_ = state.phase == ExercisePhase::kTwisting;
  if (!run_->graded()) {
    const QString untwisting = detorsion_->cue();
    cue_->setText(untwisting.isEmpty() ? coach_.cue(state) : untwisting);
  }
  showTold(simulated_);
}

void RunPanel::setTheme(const Theme& theme) {
  dial_->setTheme(theme);
  torque_->setTheme(theme);
  force_->setTheme(theme);
}

void RunPanel::retranslate() {
  time_->setAccessibleName(tr("Time left"));
  timeName_->setText(tr("Time left"));
  // The gauges name their quantities; separate titles would not fit a small screen.
  angle_->setAccessibleName(tr("Angle"));
  load_->setAccessibleName(tr("Load on the tissue"));
  torque_->setName(tr("Torque"), tr("N m"));
  force_->setName(tr("Force"), tr("N"));
  end_->setText(tr("&End the run"));
  guideMe_->setText(tr("Guide me"));
  dial_->retranslate();
  jaw_->clear();  // the next frame says it again
  detorsion_->retranslate();
  validity_->retranslate();
  if (run_ != nullptr) {
    title_->setText(toQString(Text(run_->step().module.title)));
    mode_->setText(run_->graded() ? tr("Graded run") : tr("Practice"));
    showCount();
  }
}

namespace {

constexpr int kTrackerWidth = 620;
constexpr double kFigure_pt = 64.0;

}  // namespace

RunNotice::RunNotice(ShellContext& shell, QWidget* parent)
    : QWidget(parent),
      title_(plainLabel(this, "heading")),
      figure_(plainLabel(this)),
      text_(plainLabel(this, "quiet")),
      goOn_(named(primaryButton(this), "goOn")),
      tracker_(new TrackerPanel(shell, this)) {
  QVBoxLayout* column = columnOf(this, {6 * kSpace, 6 * kSpace, 6 * kSpace, 6 * kSpace}, 2 * kSpace);
  makeHuge(figure_, kFigure_pt);
  column->addStretch(2);
  for (QLabel* label : {title_, figure_, text_}) {
    label->setAlignment(Qt::AlignHCenter);
    column->addWidget(label);
  }
  column->addWidget(goOn_, 0, Qt::AlignHCenter);
  tracker_->setFixedWidth(kTrackerWidth);
  tracker_->hide();
  column->addSpacing(2 * kSpace);
  column->addWidget(tracker_, 0, Qt::AlignHCenter);
  column->addStretch(3);
  connect(goOn_, &QPushButton::clicked, this, &RunNotice::goOn);
}

void RunNotice::say(const QString& title, const QString& figure, const QString& text, const QString& button) {
  title_->setText(title);
  figure_->setText(figure);
  figure_->setVisible(!figure.isEmpty());
  text_->setText(text);
  goOn_->setText(button);
  goOn_->setVisible(!button.isEmpty());
}

void RunNotice::showNoRun(bool inFile) {
  tracker_->hide();
  if (inFile) {
    say(tr("Your run is safe"), {},
        tr("The database did not answer. The recording is kept, on this computer where need be; as soon as "
           "the "
           "database answers you find its debrief on the page \u201c"
           "Debrief\u201d."),
        {});
  } else {
    say(tr("No run in progress"), {}, tr("Choose a module on the page \u201cMy next step\u201d."), {});
  }
}

bool RunNotice::showRun(const TrainingRun& run, Device device, bool tracked) {
  const bool real = run.phase().arm == PhaseKind::kReal;
  tracker_->setVisible(kTrackerBuiltIn && real && device != Device::kFetchedBeforeStart);
  tracker_->follow(tracked);
  setLook(goOn_, "primary", device == Device::kReady);
  if (device != Device::kReady) {
    const bool before = device == Device::kFetchedBeforeStart;
    say(tr("Getting the haptic device ready"), {},
        before ? tr("This takes a few seconds. Your time has not begun yet.")
               : tr("This takes a few seconds. Your training clock is paused."),
        before ? tr("&Cancel") : QString());
    return true;
  }
  if (run.state() == RunState::kResting) {
    say(tr("Rest"), clockTimeLeft(run.restLeft_us()),
        tr("Your training clock is paused. Training resumes automatically when the rest is used up."),
        tr("&Go on now"));
    return true;
  }
  if (run.state() == RunState::kHandOver) {
    say(real ? tr("Go to the real arm") : tr("Come to the simulator"), clockTimeLeft(run.handOverLeft_us()),
        tr("The next phase starts automatically: %1").arg(toQString(run.phase().label)), tr("I am &ready"));
    return true;
  }
  if (real) {
    say(tr("Train on the real arm"), clockTimeLeft(run.remainingInPhase_us()),
        tracked ? tr("Training time is logged, and the tracker records the instrument.")
                : tr("Only training time is logged."),
        {});
  }
  return real;
}

}  // namespace torsio::gui
