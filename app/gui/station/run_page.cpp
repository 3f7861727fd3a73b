// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/station/run_page.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "app/gui/look/angle_dial.h"
#include "app/gui/look/card.h"
#include "app/gui/look/form.h"
#include "app/gui/look/level_bar.h"
#include "app/gui/shell/shell_context.h"
#include "app/gui/shell/spoken.h"
#include "app/gui/station/live_scene.h"
#include "app/gui/station/station_desk.h"
#include "app/gui/station/station_parts.h"
#include "app/gui/station/station_words.h"
#include "app/session/care/station_line.h"
#include "sim/base/error.h"

namespace torsio::gui {

namespace {

constexpr int kPanelWidth = 316;
constexpr int kClock_ms = 100;
constexpr double kCountdown_pt = 30.0;
constexpr double kNotice_pt = 64.0;
constexpr std::int64_t kSoon_us = 30'000'000;
constexpr std::chrono::milliseconds kLastWrites{500};
const QVariant kLater = QStringLiteral("later");
constexpr double kTargetNear = 0.85;  // of the way: time to slow down

}  // namespace

RunPage::RunPage(ShellContext& context, QWidget* parent)
    : Page(context, parent),
      theme_(&theme(context.themeKind())),
      stage_(new QStackedWidget(this)),
      scene_(new LiveScene(StationDesk::of(context).loader, context.assets(), this)) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  stage_->addWidget(scene_);
  stage_->addWidget(createNotice());
  row->addWidget(stage_, 1);
  row->addWidget(createPanel());
  scene_->controller().setRealTime(StationDesk::of(context).realTime);
  connect(scene_, &LiveScene::shown, this, &RunPage::showLive);
  connect(&scene_->controller(), &SimulationController::sceneChanged, this, [this] {
    if (waiting_) begin();
  });
  connect(&scene_->controller(), &SimulationController::failed, this,
          [this](const QString& happened, const QString& remedy, const QString& details) {
            Q_EMIT shell().failed(happened, remedy, details);
          });
  connect(&scene_->controller(), &SimulationController::deviceLost, this, [this] {
    if (session_) withoutDevice(tr("The haptic device was lost"));
  });
  connect(&timer_, &QTimer::timeout, this, &RunPage::tick);
  timer_.setInterval(kClock_ms);
}

RunPage::~RunPage() {
  timer_.stop();
}

QWidget* RunPage::createNotice() {
  auto* ground = new QWidget(this);
  auto* column = new QVBoxLayout(ground);
  column->setContentsMargins(6 * kSpace, 6 * kSpace, 6 * kSpace, 6 * kSpace);
  column->setSpacing(2 * kSpace);
  noticeTitle_ = plainLabel(ground, "heading");
  noticeFigure_ = plainLabel(ground);
  makeHuge(noticeFigure_, kNotice_pt);
  noticeText_ = plainLabel(ground, "quiet");
  goOn_ = primaryButton(ground);
  goOn_->setObjectName(QStringLiteral("goOn"));
  column->addStretch(2);
  for (QLabel* label : {noticeTitle_, noticeFigure_, noticeText_}) {
    label->setAlignment(Qt::AlignHCenter);
    column->addWidget(label);
  }
  column->addWidget(goOn_, 0, Qt::AlignHCenter);
  column->addStretch(3);
  connect(goOn_, &QPushButton::clicked, this, [this] {
    if (session_) follow(session_->resume());
  });
  return ground;
}

QWidget* RunPage::createPanel() {
  // What must always be in reach stands below; what is taller than a small screen scrolls.
  auto* side = new QWidget(this);
  side->setFixedWidth(kPanelWidth);
  auto* whole = new QVBoxLayout(side);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(0);
  auto* scroll = new QScrollArea(side);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusPolicy(Qt::NoFocus);
  auto* panel = new QWidget;
  scroll->setWidget(panel);
  whole->addWidget(scroll, 1);
  auto* buttons = new QHBoxLayout;
  buttons->setContentsMargins(kSpace, kSpace, kSpace, kSpace + 4);
  buttons->setSpacing(kSpace);
  whole->addLayout(buttons);
  auto* column = new QVBoxLayout(panel);
  column->setContentsMargins(kSpace + 4, kSpace + 4, kSpace + 4, 0);
  column->setSpacing(kSpace);
  title_ = plainLabel(panel, "subheading");
  mode_ = plainLabel(panel, "quiet");
  column->addWidget(title_);
  column->addWidget(mode_);
  time_ = new Card(QString(), panel);
  countdown_ = plainLabel(time_);
  countdown_->setObjectName(QStringLiteral("countdown"));
  makeHuge(countdown_, kCountdown_pt);
  progress_ = new QProgressBar(time_);
  progress_->setTextVisible(false);
  progress_->setRange(0, 1000);
  phase_ = plainLabel(time_, "quiet");
  for (QWidget* widget : std::initializer_list<QWidget*>{countdown_, progress_, phase_})
    time_->content()->addWidget(widget);
  column->addWidget(time_);
  angle_ = new Card(QString(), panel);
  dial_ = new AngleDial(angle_);
  angle_->content()->addWidget(dial_, 0, Qt::AlignHCenter);
  column->addWidget(angle_);
  load_ = new Card(QString(), panel);
  torque_ = new LevelBar(QString(), QString(), 3, load_);
  force_ = new LevelBar(QString(), QString(), 2, load_);
  warning_ = plainLabel(load_, "caution");
  load_->content()->addWidget(torque_);
  load_->content()->addWidget(force_);
  load_->content()->addWidget(warning_);
  column->addWidget(load_);
  cue_ = plainLabel(panel, "quiet");
  cue_->setObjectName(QStringLiteral("cue"));
  column->addWidget(cue_);
  column->addStretch(1);
  rest_ = new QPushButton(side);
  rest_->setObjectName(QStringLiteral("rest"));
  stop_ = new QPushButton(side);
  stop_->setObjectName(QStringLiteral("stop"));
  buttons->addWidget(rest_);
  buttons->addWidget(stop_);
  connect(rest_, &QPushButton::clicked, this, [this] {
    if (!session_ || !session_->rest()) return;
    endRecording(TrialOutcome::kCompleted);
    tick();
  });
  connect(stop_, &QPushButton::clicked, this, &RunPage::askToStop);
  return side;
}

void RunPage::enter(const QVariant& argument) {
  if (session_ || argument == kLater) return;
  StationDesk& desk = StationDesk::of(shell());
  try {
    session_.emplace(shell().workplace(),
                     RunRequest{desk.moduleId, desk.graded, desk.readiness.value_or(DeviceReadiness{})},
                     *desk.clock, shell().line());
  } catch (...) {
    shell().report(std::current_exception());
    return;
  }
  lastTrial_.clear();
  inFile_ = false;
  retranslate();
  if (session_->run().phase().arm == TrainingArm::kReal) {
    begin();
    return;
  }
  waiting_ = true;
  SceneRequest request;
  request.assets = shell().assets();
  request.id = session_->step().module.sceneId;
  request.pattern = session_->step().module.patternId;
  scene_->controller().load(request);
  showState();
}

void RunPage::begin() {
  waiting_ = false;
  try {
    session_->start();
    timer_.start();
    follow(session_->advance());
  } catch (...) {
    session_.reset();
    shell().report(std::current_exception());
  }
}

void RunPage::record() {
  StationDesk& desk = StationDesk::of(shell());
  const TrialOrder order = session_->newTrial();
  std::unique_ptr<HapticDevice> device;
  try {
    if (desk.openDevice)
      device = desk.openDevice(*scene_->controller().scene(), order.header.targetAngle_rad);
  } catch (const Error& problem) {
    withoutDevice(spoken(problem).happened);
    return;
  }
  haptic_ = device != nullptr;
  if (!scene_->controller().startTraining(order.header, session_->sinkFor(order), std::move(device))) return;
  lastTrial_ = QString::fromStdString(order.header.trialId);
  const StoredModule& module = session_->step().module;
  dial_->setTarget(order.header.targetAngle_rad, module.tolerance_rad);
  torque_->setLimit(module.maxTorque_Nm.value_or(0.0));
  force_->setLimit(module.maxForce_N.value_or(0.0));
  scene_->view().setFocus();
}

/// A graded run is not judged with another device than it began with; practice goes on with the mouse.
void RunPage::withoutDevice(const QString& why) {
  StationDesk& desk = StationDesk::of(shell());
  endRecording(TrialOutcome::kInterrupted);
  desk.readiness.reset();  // the device is checked anew before the next graded run
  if (!session_->graded()) {
    desk.openDevice = nullptr;
    shell().notify(tr("%1. You go on with mouse and keyboard").arg(why));
    return;
  }
  session_->stop("the haptic device was lost");
  timer_.stop();
  session_.reset();
  Q_EMIT shell().failed(tr("The haptic device was lost: the graded run has ended"),
                        tr("What was recorded is kept as interrupted, and no attempt was used. Check the "
                           "device, then begin again"),
                        why);
  showState();
}

void RunPage::tick() {
  if (!session_ || waiting_) return;
  try {
    follow(session_->advance());
  } catch (...) {
    shell().report(std::current_exception());
  }
}

void RunPage::follow(const std::vector<RunEvent>& events) {
  using Kind = RunEvent::Kind;
  try {
    for (const RunEvent& event : events) {
      if (event.kind == Kind::kPhaseEnded) endRecording(TrialOutcome::kCompleted);
      if (event.kind == Kind::kPaused)
        shell().notify(tr("The computer stood still. That time does not count."));
      if (event.kind == Kind::kRestUsedUp) shell().notify(tr("The rest is used up. Training goes on."));
      if (event.kind == Kind::kFinished) {
        finish();
        return;
      }
    }
    const TrainingRun& run = session_->run();
    const bool recording = scene_->controller().mode() == SimulationController::Mode::kRecording;
    if (run.state() == RunState::kRunning && run.phase().arm == TrainingArm::kVirtual && !recording) record();
  } catch (...) {
    shell().report(std::current_exception());
  }
  showState();
}

void RunPage::endRecording(TrialOutcome outcome) {
  const std::optional<RecordingResult> result = scene_->controller().endTraining(outcome);
  inFile_ = inFile_ || (result && result->spillFile);
}

void RunPage::finish() {
  timer_.stop();
  endRecording(TrialOutcome::kCompleted);
  StationDesk::of(shell()).lastScene = scene_->controller().sharedScene();
  session_.reset();
  if (StationLine* line = shell().line(); line != nullptr) static_cast<void>(line->settled(kLastWrites));
  inFile_ = inFile_ || shell().databaseAway();
  if (inFile_) {
    showState();
    return;
  }
  if (lastTrial_.isEmpty()) {
    shell().notify(tr("The time on the real arm is over. It has been logged."));
    shell().open(QStringLiteral("station.next"));
  } else {
    shell().open(QStringLiteral("station.debrief"), lastTrial_);
  }
}

void RunPage::askToStop() {
  if (!session_) return;
  QMessageBox question(this);
  question.setIcon(QMessageBox::NoIcon);
  question.setText(tr("End this run now?"));
  question.setInformativeText(session_->graded() ? tr("What was recorded is kept, and the attempt counts.")
                                                 : tr("What was recorded is kept."));
  QPushButton* end = question.addButton(tr("&End the run"), QMessageBox::AcceptRole);
  question.addButton(tr("&Go on"), QMessageBox::RejectRole);
  question.exec();
  if (question.clickedButton() != end || !session_) return;
  try {
    session_->stop("ended by the trainee");
  } catch (...) {
    shell().report(std::current_exception());
  }
  finish();
}

bool RunPage::leave() {
  if (busy()) {
    shell().notify(tr("A run goes on. End it first."));
    return false;
  }
  timer_.stop();
  session_.reset();
  waiting_ = false;
  scene_->controller().shutDown();
  return true;
}

bool RunPage::busy() const {
  return session_ && !waiting_ && session_->run().state() != RunState::kReady && !session_->run().over();
}

void RunPage::retranslate() {
  time_->setTitle(tr("Time left"));
  // Their gauges say what they show; a title each would not fit a small screen.
  angle_->setAccessibleName(tr("Angle"));
  load_->setAccessibleName(tr("Load on the tissue"));
  torque_->setName(tr("Torque"), tr("N m"));
  force_->setName(tr("Force"), tr("N"));
  stop_->setText(tr("&End the run"));
  dial_->retranslate();
  if (session_) {
    title_->setText(spoken(session_->step().module.title));
    mode_->setText(session_->graded() ? tr("Graded run") : tr("Practice"));
  }
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
  const bool runs = session_.has_value() && !waiting_;
  rest_->setVisible(runs);
  stop_->setEnabled(runs);
  if (!session_) {
    countdown_->setText(StationWords::clock(0));
    stage_->setCurrentIndex(1);
    noticeTitle_->setText(inFile_ ? tr("Your run is safe") : tr("No run goes on"));
    noticeFigure_->clear();
    noticeText_->setText(inFile_ ? tr("The database did not answer. The recording is kept, on this computer "
                                      "where need be; as soon as the database answers you find its debrief "
                                      "on the page \u201cDebrief\u201d.")
                                 : tr("Choose a module on the page \u201cMy next step\u201d."));
    goOn_->hide();
    rest_->hide();
    return;
  }
  const TrainingRun& run = session_->run();
  const RunPhase& phase = run.phase();
  const bool real = phase.arm == TrainingArm::kReal;
  countdown_->setText(StationWords::clock(run.remainingInPhase_us()));
  setLook(countdown_, "caution", run.state() == RunState::kRunning && run.remainingInPhase_us() < kSoon_us);
  progress_->setValue(static_cast<int>(phase.done_us * 1000 / std::max<std::int64_t>(1, phase.duration_us)));
  const int number = static_cast<int>(run.phaseIndex()) + 1;
  const int all = static_cast<int>(run.plan().phases.size());
  phase_->setVisible(all > 1);
  phase_->setText(all > 1
                      ? tr("Phase %1 of %2: %3").arg(number).arg(all).arg(QString::fromStdString(phase.label))
                      : QString::fromStdString(phase.label));
  rest_->setVisible(runs && run.plan().restAllowance_us > 0);
  rest_->setEnabled(run.mayRest());
  rest_->setText(run.state() == RunState::kResting || run.restLeft_us() > 0
                     ? tr("&Rest (%1 left)").arg(StationWords::clock(run.restLeft_us()))
                     : tr("&Rest (used up)"));
  angle_->setVisible(!real);
  load_->setVisible(!real);
  cue_->setVisible(!real && !session_->graded());
  const bool notice = run.state() == RunState::kResting || run.state() == RunState::kHandOver || real;
  stage_->setCurrentIndex(notice ? 1 : 0);
  if (run.state() == RunState::kResting) {
    noticeTitle_->setText(tr("Rest"));
    noticeFigure_->setText(StationWords::clock(run.restLeft_us()));
    noticeText_->setText(
        tr("Your training clock stands still. Training goes on by itself when the rest is used up."));
    goOn_->setText(tr("&Go on now"));
    goOn_->show();
  } else if (run.state() == RunState::kHandOver) {
    noticeTitle_->setText(real ? tr("Go to the real arm") : tr("Come to the simulator"));
    noticeFigure_->setText(StationWords::clock(run.handOverLeft_us()));
    noticeText_->setText(tr("The next phase starts by itself: %1").arg(QString::fromStdString(phase.label)));
    goOn_->setText(tr("I am &ready"));
    goOn_->show();
  } else if (real) {
    noticeTitle_->setText(tr("Train on the real arm"));
    noticeFigure_->setText(StationWords::clock(run.remainingInPhase_us()));
    noticeText_->setText(tr("This timer logs your training time. Nothing is recorded by the simulator."));
    goOn_->hide();
  }
}

QString RunPage::cue(const LiveState& state) const {
  const StoredModule& module = session_->step().module;
  const double target = module.targetAngle_rad;
  switch (state.phase) {
    case ExercisePhase::kTracking:
      return haptic_ ? tr("Bring the jaw to the marked band.")
                     : tr("Bring the jaw to the marked band. The wheel moves it nearer.");
    case ExercisePhase::kContact:
      return haptic_ ? tr("Touching. Close the jaw.")
                     : tr("Touching. Close the jaw: hold the left button or Space.");
    case ExercisePhase::kTwisting: {
      const double way = target == 0.0 ? 0.0 : state.response.angle_rad / target;
      if (std::abs(state.response.angle_rad - target) <= module.tolerance_rad)
        return module.hold_us > 0 ? tr("On target. Hold, then let go gently.")
                                  : tr("On target. Let go gently.");
      if (way > 1.0) return tr("Beyond the target. Turn back a little.");
      if (way > kTargetNear) return tr("Nearly there. Slow down.");
      if (way < 0.0) return tr("The other way round.");
      return tr("Turn in one even movement.");
    }
    case ExercisePhase::kReleased:
      return tr("The tissue returns to rest.");
  }
  return {};
}

void RunPage::showLive(const LiveState& state) {
  if (!session_) return;
  dial_->setAngle(state.response.angle_rad);
  torque_->setValue(std::abs(state.response.torque_Nm));
  force_->setValue(norm(state.force_N));
  const bool over = torque_->overLimit() || force_->overLimit();
  warning_->setText(over ? tr("Above the limit: ease off") : QString());
  if (!session_->graded()) cue_->setText(cue(state));
}

}  // namespace torsio::gui
