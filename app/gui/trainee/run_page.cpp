// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/run_page.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QMessageBox>
#include <QPushButton>
#include <QStackedWidget>
#include <QStringList>

#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/trainee/live_scene.h"
#include "app/gui/trainee/run_panel.h"
#include "app/gui/trainee/station_desk.h"
#include "app/gui/trainee/tracker_panel.h"
#include "app/gui/trainee/twist_guide.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/form.h"
#include "app/services/recording/station_writer.h"
#include "app/services/recording/unstored_trials.h"
#include "assessment/domain/study/curriculum.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr int kClock_ms = 100;
constexpr std::chrono::milliseconds kLastWrites{500};
const QVariant kLater = QStringLiteral("later");

}  // namespace

RunPage::RunPage(ShellContext& context, StationDesk& desk, QWidget* parent)
    : Page(context, parent),
      desk_(desk),
      stage_(new QStackedWidget(this)),
      scene_(named(new LiveScene(desk.loader, context.assets(), this), "scene")),
      notice_(new RunNotice(context, this)),
      panel_(new RunPanel(scene_->controller(), this)),
      guide_(named(new TwistGuide(scene_), "guide")) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  stage_->addWidget(scene_);
  stage_->addWidget(notice_);
  row->addWidget(stage_, 1);
  row->addWidget(panel_);
  connect(panel_, &RunPanel::restWanted, this, &RunPage::rest);
  connect(panel_, &RunPanel::endWanted, this, &RunPage::askToEnd);
  connect(panel_, &RunPanel::guideWanted, this, &RunPage::guide);
  connect(panel_, &RunPanel::limitPassed, this, [this] {
    if (soundAtLimit_) {
      desk_.sound();
    }
  });
  connect(notice_, &RunNotice::goOn, this, &RunPage::goOn);
  connect(&notice_->tracker(), &TrackerPanel::lettingGo, this,
          [this] { endTracked(TrialOutcome::kCompleted); });
  scene_->controller().setRealTime(desk.realTime);
  connect(scene_, &LiveScene::shown, this, &RunPage::showLive);
  connect(scene_, &LiveScene::gripLost, this, [this] {
    if (scene_->controller().state().phase == ExercisePhase::kTwisting) {
      shell().notify(tr("The keyboard left the organ: the jaw has opened."));
    }
  });
  scene_->view().installEventFilter(this);
  connect(&scene_->controller(), &SimulationController::sceneChanged, this, [this] {
    panel_->showScene();
    if (waiting_ && !opening_.going()) {
      begin();
    }
  });
  connect(&scene_->controller(), &SimulationController::problemMet, &shell(), &ShellContext::tell);
  connect(&scene_->controller(), &SimulationController::deviceLost, this, [this] {
    if (runSession_) {
      withoutDevice([] { return TranslatedError{tr("The haptic device was disconnected"), {}, {}}; });
    }
  });
  connect(&timer_, &QTimer::timeout, this, &RunPage::tick);
  timer_.setInterval(kClock_ms);
}

RunPage::~RunPage() {
  timer_.stop();
}

bool RunPage::askWhyUnscored(RunRequest& request) {
  const NextSteps steps = nextSteps(shell().session(), shell().session().actor().personId);
  if (!steps.scoringDue) {
    return true;
  }
  QInputDialog dialog(this);
  dialog.setWindowTitle(tr("Not scored yet"));
  dialog.setLabelText(
      tr("Only %1 of %n sheet(s) for this occasion are in; the others cannot be made up once training "
         "continues. Call the study team. Why should training begin anyway? It is noted as a deviation.",
         nullptr, static_cast<int>(steps.scoringDue->asked))
          .arg(steps.scoringDue->submitted));
  dialog.setOkButtonText(tr("Begin anyway"));
  dialog.setCancelButtonText(tr("Back"));
  QPushButton* begin = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  begin->setEnabled(false);  // without a reason it would only return here
  connect(&dialog, &QInputDialog::textValueChanged, begin,
          [begin](const QString& text) { begin->setEnabled(!text.trimmed().isEmpty()); });
  if (dialog.exec() != QDialog::Accepted || dialog.textValue().trimmed().isEmpty()) {
    return false;
  }
  request.reason = dialog.textValue().trimmed().toStdString();
  return true;
}

void RunPage::enter(const QVariant& argument) {
  if (runSession_ || argument == kLater) {
    return;
  }
  if (!attempt(shell(), [&] {
        RunRequest request{desk_.moduleId, desk_.graded, desk_.readiness.value_or(DeviceReadiness{})};
        if (!askWhyUnscored(request)) {
          return;
        }
        runSession_.emplace(shell().session(), request, *desk_.clock, shell().line());
      })) {
    inFile_ = false;
    retranslate();  // clears the previous run
    return;
  }
  if (!runSession_) {
    QTimer::singleShot(0, this, [this] { shell().open(PageId::kNextStep); });
    return;
  }
  lastTrial_.clear();
  lastTracked_.clear();
  inFile_ = false;
  panel_->setRun(&*runSession_);
  attempt(shell(), [&] { soundAtLimit_ = soundsAtLimit(shell().session()); });
  retranslate();
  if (runSession_->run().phase().arm == PhaseKind::kReal) {
    begin();
    return;
  }
  waiting_ = true;
  const TrainingModule& module = runSession_->step().module;
  SceneRequest request;
  request.assets = shell().assets();
  request.id = module.sceneId;
  request.pattern = module.patternId;
  scene_->controller().load(request);
  showState();
}

/// Starts once the scene is there. The first recording's device is opened before the clock starts, because
/// waiting is not training.
void RunPage::begin() {
  const bool real = runSession_->run().phase().arm == PhaseKind::kReal;
  if (!real && desk_.openDevice) {
    fetchDevice();
  } else {
    start();
  }
}

void RunPage::start() {
  waiting_ = false;
  const bool begun = attempt(shell(), [this] {
    runSession_->start();
    const std::vector<RunPhase>& phases = runSession_->run().plan().phases;
    const bool onRealArm = std::any_of(phases.begin(), phases.end(),
                                       [](const RunPhase& phase) { return phase.arm == PhaseKind::kReal; });
    notice_->tracker().begin(onRealArm ? desk_.tracker : std::nullopt);
    timer_.start();
    follow(runSession_->advance());
  });
  if (!begun) {
    forgetRun();
    device_.reset();
  }
}

void RunPage::fetchDevice() {
  opening_.begin([open = desk_.openDevice, scene = scene_->controller().sharedScene(),
                  target_rad = runSession_->module().targetAngle_rad] { return open(*scene, target_rad); },
                 [this](std::unique_ptr<HapticDevice> device) {
                   device_ = std::move(device);
                   haveDevice();
                 },
                 [this](const std::exception_ptr& problem) {
                   withoutDevice(problemOf(problem, {[] { return tr("The haptic device did not answer"); },
                                                     [] { return tr("Check its cable and its power"); }}));
                 });
  showState();
}

void RunPage::haveDevice() {
  if (waiting_) {
    start();
    return;
  }
  runSession_->hold();
  tick();
}

void RunPage::goOn() {
  if (waiting_) {  // nothing has started: the trainee does not want to wait for the device
    opening_.cancel();
    forgetRun();
    shell().open(PageId::kNextStep);
  } else if (runSession_) {
    follow(runSession_->resume());
  }
}

void RunPage::rest() {
  if (!runSession_ || !runSession_->rest()) {
    return;
  }
  endRecording(TrialOutcome::kCompleted);
  tick();
}

void RunPage::record() {
  if (desk_.openDevice && !device_) {
    fetchDevice();
    return;
  }
  const RecordingSpec recording = runSession_->newTrial();
  std::unique_ptr<HapticDevice> device = device_ ? *std::exchange(device_, std::nullopt) : nullptr;
  haptic_ = device != nullptr;
  if (!scene_->controller().startTraining(
          recording, recordingSink(shell().session().key().locator, recording.context), std::move(device))) {
    return;
  }
  lastTrial_ = toQString(recording.trialId);
  panel_->beginRecording(haptic_);
  if ((runSession_->firstEver() || desk_.guided) && runSession_->trials().size() == 1) {
    guide();
  }
  focusDue_ = true;
}

void RunPage::guide() {
  const Scene* scene = scene_->controller().scene();
  if (!runSession_ || runSession_->graded() || scene == nullptr || scene->comesTwisted()) {
    return;
  }
  guide_->begin(haptic_, runSession_->step().module.hold_us > 0);
  scene_->view().setFocus();
}

/// Handles a lost device: a graded run is not judged with a different device; practice continues with the
/// mouse.
void RunPage::withoutDevice(const Problem& why) {
  endRecording(TrialOutcome::kInterrupted);
  desk_.readiness.reset();  // the device is checked again before the next graded run
  if (!runSession_->graded()) {
    desk_.openDevice = nullptr;
    shell().notify(tr("%1. Continue with mouse and keyboard").arg(why().happened));
    if (waiting_) {
      start();
    }
    return;
  }
  const bool begun = !waiting_;
  runSession_->stop("the haptic device was lost");
  forgetRun();
  shell().tell([why, begun] {
    const TranslatedError said = why();
    QStringList parts{said.happened};
    if (!said.details.isEmpty()) {
      parts << said.details;
    }
    const QString details = parts.join(QLatin1Char('\n'));
    if (!begun) {
      return TranslatedError{tr("The haptic device is not ready: the graded run did not begin"),
                             tr("No attempt was used. Check the device, then begin again"), details};
    }
    return TranslatedError{tr("The haptic device was disconnected: the graded run has ended"),
                           tr("What was recorded is kept as interrupted, and no attempt was used. Check the "
                              "device, then begin again"),
                           details};
  });
  showState();
}

void RunPage::tick() {
  if (!runSession_ || waiting_) {
    return;
  }
  if (opening_.going()) {
    runSession_->hold();
    showState();
    return;
  }
  attempt(shell(), [&] { follow(runSession_->advance()); });
}

void RunPage::follow(const std::vector<RunEvent>& events) {
  using Kind = RunEvent::Kind;
  bool finished = false;
  attempt(shell(), [&] {
    for (const RunEvent& event : events) {
      if (event.kind == Kind::kPhaseEnded) {
        endRecording(TrialOutcome::kCompleted);
      }
      if (event.kind == Kind::kPaused) {
        shell().notify(tr("The computer stalled. That time does not count."));
      }
      if (event.kind == Kind::kRestUsedUp) {
        shell().notify(tr("The rest is used up. Training resumes."));
      }
      if (event.kind == Kind::kFinished) {
        finish();
        finished = true;
        return;
      }
    }
    const TrainingRun& run = runSession_->run();
    const bool recording = scene_->controller().mode() == SimulationController::Mode::kRecording;
    if (run.state() == RunState::kRunning && run.phase().arm == PhaseKind::kVirtual && !recording) {
      record();
    }
    track();
  });
  if (!finished && !holdsButton(*this)) {
    showState();
    if (std::exchange(focusDue_, false)) {
      scene_->view().setFocus();  // a button that loses focus loses its press
    }
  }
}

void RunPage::endRecording(TrialOutcome outcome) {
  guide_->end();
  const std::optional<RecordingResult> result = scene_->controller().endTraining(outcome);
  inFile_ = inFile_ || (result && result->spillFile);
  endTracked(outcome);
}

void RunPage::track() {
  const TrainingRun& run = runSession_->run();
  TrackerLink* link = notice_->tracker().link();
  if (tracked_ != nullptr || run.state() != RunState::kRunning || run.phase().arm != PhaseKind::kReal ||
      link == nullptr) {
    return;
  }
  const TrackerView view = link->view();
  if (view.stage != TrackerStage::kTracking || !view.period_us) {
    return;
  }
  const RecordingSpec recording = runSession_->newTrackedTrial();
  lastTracked_ = toQString(recording.trialId.text());
  tracked_ = std::make_unique<TrackedRecording>(
      *link, view, recording, recordingSink(shell().session().key().locator, recording.context));
}

void RunPage::endTracked(TrialOutcome outcome) {
  if (tracked_ == nullptr) {
    return;
  }
  const std::unique_ptr<TrackedRecording> ended = std::move(tracked_);
  attempt(shell(), [&] { inFile_ = inFile_ || ended->finish(outcome).spillFile; });
}

void RunPage::forgetRun() {
  timer_.stop();
  waiting_ = false;
  panel_->setRun(nullptr);
  runSession_.reset();
}

void RunPage::finish() {
  opening_.cancel();
  device_.reset();
  endRecording(TrialOutcome::kCompleted);
  desk_.lastScene = scene_->controller().sharedScene();
  forgetRun();
  if (StationWriter* line = shell().line(); line != nullptr) {
    static_cast<void>(line->settled(kLastWrites));
  }
  inFile_ = inFile_ || shell().databaseAway();
  if (inFile_) {
    showState();
    return;
  }
  if (lastTrial_.isEmpty()) {
    shell().notify(tr("The time on the real arm is over. It has been logged."));
  }
  const QString& last = lastTrial_.isEmpty() ? lastTracked_ : lastTrial_;
  if (last.isEmpty()) {
    shell().open(PageId::kNextStep);
  } else {
    shell().open(PageId::kDebrief, last);
  }
}

void RunPage::askToEnd() {
  if (!runSession_) {
    return;
  }
  QMessageBox question(this);
  question.setIcon(QMessageBox::NoIcon);
  question.setText(tr("End this run now?"));
  question.setInformativeText(runSession_->graded() ? tr("What was recorded is kept, and the attempt counts.")
                                                    : tr("What was recorded is kept."));
  // Enter means continue: holding it on the button does not end the run.
  QPushButton* end = question.addButton(tr("&End the run"), QMessageBox::AcceptRole);
  question.setDefaultButton(question.addButton(tr("&Go on"), QMessageBox::RejectRole));
  question.exec();
  if (question.clickedButton() != end || !runSession_) {
    focusDue_ = true;  // Space grips again instead of pressing the button
    return;
  }
  attempt(shell(), [&] { runSession_->stop("ended by the trainee"); });
  finish();
}

/// Focuses the organ when the mouse returns to it.
bool RunPage::eventFilter(QObject* watched, QEvent* event) {
  if (watched == &scene_->view() && event->type() == QEvent::Enter && busy() && !holdsButton(*this)) {
    scene_->view().setFocus();
  }
  return Page::eventFilter(watched, event);
}

bool RunPage::leave() {
  if (busy()) {
    shell().notify(tr("A run is in progress. End it first."));
    return false;
  }
  opening_.cancel();
  endTracked(TrialOutcome::kInterrupted);
  forgetRun();
  scene_->controller().shutDown();
  return true;
}

bool RunPage::busy() const {
  return runSession_ && !waiting_ && runSession_->run().state() != RunState::kReady &&
         !runSession_->run().over();
}

void RunPage::showState() {
  const bool started = runSession_.has_value() && !waiting_;
  panel_->showTime(started, !opening_.going());
  if (!runSession_) {
    notice_->showNoRun(inFile_);
    stage_->setCurrentWidget(notice_);
    return;
  }
  using Device = RunNotice::Device;
  const Device device = !opening_.going() ? Device::kReady
                        : waiting_        ? Device::kFetchedBeforeStart
                                          : Device::kFetchedInRun;
  const bool noticed = notice_->showRun(runSession_->run(), device, tracked_ != nullptr);
  stage_->setCurrentIndex(noticed ? 1 : 0);
  panel_->showTold(!noticed);
}

void RunPage::showLive(const LiveState& state) {
  if (!runSession_) {
    return;
  }
  if (desk_.outlet != nullptr) {
    desk_.outlet->show(state);
  }
  panel_->follow(state);
  guide_->follow(state, panel_->onTarget(), panel_->coach().heldShare());
}

void RunPage::retranslate() {
  guide_->retranslate();
  notice_->tracker().retranslate();
  panel_->retranslate();
  showState();
}

void RunPage::applyTheme(const Theme& theme) {
  scene_->setTheme(theme);
  panel_->setTheme(theme);
}

}  // namespace torsio::gui
