// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/simulation_controller.h"

#include <cmath>
#include <utility>

#include <QUuid>

#include "app/gui/base/translated_text.h"
#include "app/gui/simulator/tool_pose.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/recording/recording_spec.h"
#include "sim/core/clock.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"
#include "sim/servo/tool_touch.h"

namespace torsio::gui {

SimulationController::SimulationController(SceneLoader loader, TrialRecording recording, QObject* parent)
    : QObject(parent), loader_(std::move(loader)), recording_(std::move(recording)) {
  workers_.setMaxThreadCount(1);
}

SimulationController::~SimulationController() {
  workers_.clear();
  workers_.waitForDone();
}

bool SimulationController::attempt(const std::function<void()>& action) {
  try {
    action();
    return true;
  } catch (...) {
    report(std::current_exception());
    return false;
  }
}

void SimulationController::report(const std::exception_ptr& thrown) {
  tell(problemOf(thrown, {[] { return tr("Something unexpected went wrong"); },
                          [] { return tr("Please report this."); }}));
}

void SimulationController::tell(const Problem& problem) {
  Q_EMIT problemMet(problem);
  const TranslatedError said = problem();
  Q_EMIT failed(said.happened, said.remedy, said.details);
}

void SimulationController::tellSpilled(const RecordingResult& result) {
  tell([details = toQString(result.spillFile->string() + "\n" + result.problem)] {
    return TranslatedError{tr("The recording could not go to its usual place and was kept as a file"),
                           tr("Free some space or check the database, then import the file."), details};
  });
}

void SimulationController::load(const SceneRequest& request) {
  if (mode() == Mode::kRecording) {
    Q_EMIT noticed(tr("Stop the recording before choosing another exercise."));
    return;
  }
  loadFor(request, nullptr);
}

void SimulationController::loadFor(const SceneRequest& request, std::shared_ptr<const Trial> trial) {
  const bool wasLoading = loading();
  const std::uint64_t ticket = ++wanted_;
  if (!wasLoading) {
    Q_EMIT loadingChanged(true);
  }
  workers_.clear();  // cancels loads that have not started
  workers_.start([this, ticket, request, trial, loader = loader_] {
    auto loaded = std::make_shared<LoadedScene>();
    auto poses = std::make_shared<PoseTrack>();
    std::exception_ptr problem;
    try {
      *loaded = trial ? loadRecordedScene(loader, request, trial->header) : loader(request);
      if (trial) {
        *poses = PoseTrack(*loaded->scene, trial->header, trial->chunks);
      }
    } catch (...) {
      problem = std::current_exception();
    }
    QMetaObject::invokeMethod(
        this,
        [this, ticket, request, trial, loaded, poses, problem] {
          if (ticket != wanted_) {
            return;
          }
          delivered_ = ticket;
          Q_EMIT loadingChanged(false);
          attempt([&] {
            if (problem) {
              std::rethrow_exception(problem);
            }
            std::optional<TrialPlayback> playback;
            if (trial) {
              playback.emplace(*trial);
              playback->setPoses(std::move(*poses));
            }
            replace(request, std::move(*loaded), std::move(playback));
          });
        },
        Qt::QueuedConnection);
  });
}

void SimulationController::adopt(const SceneRequest& request, LoadedScene loaded) {
  TORSIO_EXPECTS(mode() != Mode::kRecording);
  replace(request, std::move(loaded), std::nullopt);
}

void SimulationController::freeze(const LiveState& state) {
  enter(stage::Still{state});
}

void SimulationController::replace(const SceneRequest& request, LoadedScene loaded,
                                   std::optional<TrialPlayback> playback) {
  opening_.retire(takeHaptic());  // its workspace is centred on the old scene
  request_ = request;
  request_.formulation = loaded.scene->model.options().formulation;
  loaded_ = std::move(loaded);
  if (playback) {
    target_rad_ = playback->header().targetAngle_rad;
    playback->setPlaying(true);
    enter(stage::Replaying{std::move(*playback), asyncPlayback()});
  } else {
    target_rad_ = loaded_.scene->pattern.targetAngle_rad;
    practise(nullptr);
  }
  Q_EMIT sceneChanged();
  Q_EMIT modeChanged();
  tellWarnings();
  openHaptic();
}

void SimulationController::tellWarnings() {
  QStringList sentences;
  for (const OrganWarning& warning : loaded_.scene->organWarnings) {
    sentences << toQString(coded(warning));
  }
  if (!sentences.isEmpty()) {
    Q_EMIT noticed(tr("This organ was accepted with a warning, which stays with every recording: %1")
                       .arg(sentences.join(QStringLiteral("; "))));
  }
}

void SimulationController::enter(SimulationStage next) {
  TORSIO_EXPECTS(mayFollow(stage(), kindOf(next)));
  const Mode before = mode();
  const QString model = hapticModel();
  stage_ = std::move(next);  // destroys the previous stage, and with it a running run
  if (stage::Running* now = running(); now != nullptr && realTime_) {
    now->run->start();
  }
  if (model != hapticModel()) {
    Q_EMIT hapticModelChanged();
  }
  if (before != mode()) {
    Q_EMIT modeChanged();
  }
}

stage::Running* SimulationController::running() noexcept {
  return const_cast<stage::Running*>(runningOf(stage_));
}

RecordedRun* SimulationController::run() noexcept {
  return running() != nullptr ? running()->run.get() : nullptr;
}

TrialPlayback* SimulationController::playback() noexcept {
  auto* replaying = std::get_if<stage::Replaying>(&stage_);
  return replaying != nullptr ? &replaying->playback : nullptr;
}

stage::Running SimulationController::newRun(std::unique_ptr<HapticDevice> device,
                                            const RecordingSpec& recording,
                                            std::shared_ptr<TrialSink> sink) const {
  stage::Running running;
  if (!device) {
    Pose parked;
    parked.position_m = parkingPoint_m();
    auto pointer = std::make_unique<PointerDevice>(parked);
    pointer->publish(pointer_);
    running.pointer = pointer.get();
    device = std::move(pointer);
  }
  running.run = std::make_unique<RecordedRun>(loaded_.scene, std::move(device), recording, std::move(sink),
                                              loaded_.shape);
  return running;
}

/// `device`: null for the pointer.
void SimulationController::practise(std::unique_ptr<HapticDevice> device) {
  enter(stage::Practising{newRun(std::move(device), {.targetAngle_rad = target_rad_}, nullptr)});
}

/// Closes the running recording. Empty: it could not be stored (failed() has been emitted).
std::optional<RecordingResult> SimulationController::finishRun(TrialOutcome outcome) {
  std::optional<RecordingResult> result;
  attempt([&] { result = running()->run->finish(outcome); });
  return result;
}

Vec3 SimulationController::parkingPoint_m() const {
  TORSIO_EXPECTS(scene() != nullptr);
  return torsio::gui::parkingPoint_m(*scene());
}

void SimulationController::advance(double elapsed_s) {
  watchDevice();
  TrialPlayback* played = playback();
  if (played == nullptr) {
    return;
  }
  const bool was = played->playing();
  played->advance(elapsed_s);
  if (const auto& async = std::get<stage::Replaying>(stage_).async) {
    async->follow(played->state());
  }
  if (was != played->playing()) {
    Q_EMIT modeChanged();
  }
}

LiveState SimulationController::state() {
  if (const TrialPlayback* played = playback()) {
    return played->state();
  }
  if (const auto* still = std::get_if<stage::Still>(&stage_)) {
    return still->shown;
  }
  return run() != nullptr ? run()->latest() : LiveState{};
}

std::unique_ptr<AsyncModelPlayback> SimulationController::asyncPlayback() const {
  return loaded_.shape ? std::make_unique<AsyncModelPlayback>(loaded_.scene, loaded_.shape) : nullptr;
}

std::optional<double> SimulationController::asyncRate_per_s() const {
  const stage::Running* now = runningOf(stage_);
  if (now == nullptr || now->run->asyncModel() == nullptr) {
    return std::nullopt;
  }
  return now->run->asyncModel()->framesPerSecond();
}

bool SimulationController::toolRidesOnTissue() const noexcept {
  if (const auto* replaying = std::get_if<stage::Replaying>(&stage_)) {
    return replaying->playback.header().drive == TwistDrive::kRoll;
  }
  const stage::Running* now = runningOf(stage_);
  return now != nullptr && now->run->header().drive == TwistDrive::kRoll;
}

std::optional<SurfacePoint> SimulationController::nearby(const LiveState& state) const {
  const bool free = state.phase == ExercisePhase::kTracking || state.phase == ExercisePhase::kContact;
  if (scene() == nullptr || !free) {
    return std::nullopt;
  }
  SurfacePoint point = nearestSurface(state.tool.position_m, *scene(), organStateOf(state));
  point.distance_m -= scene()->instrument.tipRadius_m;
  return point;
}

void SimulationController::steer(const PointerInput& input) {
  pointer_ = input;
  if (stage::Running* now = running(); now != nullptr && now->pointer != nullptr) {
    now->pointer->publish(input);
  }
}

void SimulationController::releaseTissue() {
  command({.kind = ServoCommand::Kind::kReleaseTissue});
}

void SimulationController::command(const ServoCommand& command) {
  if (run() != nullptr && !run()->command(command)) {
    Q_EMIT noticed(tr("The simulation is busy; please try again."));
  }
}

void SimulationController::setTarget(double target_rad) {
  if (stage() != StageKind::kPractising) {
    return;
  }
  if (!run()->command({.kind = ServoCommand::Kind::kSetTarget, .value = target_rad})) {
    Q_EMIT noticed(tr("The simulation is busy; please try again."));
    return;
  }
  target_rad_ = target_rad;
}

void SimulationController::startRecording() {
  if (stage() != StageKind::kPractising || loading()) {
    return;
  }
  const RecordingSpec recording{
      .trialId = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString(),
      .targetAngle_rad = target_rad_,
      .startedUtc_us = utcNow_us(),
      .context = stationContext(),
  };
  std::unique_ptr<TrialSink> sink;
  if (!attempt([&] { sink = recording_.open ? recording_.open(recording) : nullptr; })) {
    return;
  }
  if (!sink) {
    Q_EMIT noticed(tr("There is no place to keep a recording."));
    return;
  }
  std::unique_ptr<HapticDevice> device = takeHaptic();
  const bool begun =
      attempt([&] { enter(stage::Recording{newRun(std::move(device), recording, std::move(sink))}); });
  if (!begun) {
    practise(nullptr);
  }
}

void SimulationController::stopRecording() {
  if (stage() != StageKind::kRecording) {
    return;
  }
  if (const std::optional<RecordingResult> result = finishRun(TrialOutcome::kCompleted)) {
    if (result->spillFile) {
      tellSpilled(*result);
    } else {
      Q_EMIT noticed(
          tr("Recorded: %1. Replay shows it again").arg(clockTenths(spanOf_s(result->summary.samples))));
    }
  }
  practise(takeHaptic());
}

bool SimulationController::startTraining(const RecordingSpec& recording, std::unique_ptr<TrialSink> sink,
                                         std::unique_ptr<HapticDevice> device) {
  if (mode() != Mode::kPractice || loading()) {
    return false;
  }
  stage::Training training{newRun(std::move(device), recording, std::move(sink))};
  target_rad_ = training.run->header().targetAngle_rad;
  enter(std::move(training));
  return true;
}

std::optional<RecordingResult> SimulationController::endTraining(TrialOutcome outcome) {
  if (stage() != StageKind::kTraining) {
    return std::nullopt;
  }
  std::optional<RecordingResult> result = finishRun(outcome);
  if (result && result->spillFile) {
    tellSpilled(*result);
  }
  LiveState still;
  still.tool.position_m = parkingPoint_m();
  still.targetAngle_rad = target_rad_;
  enter(stage::Still{still});
  return result;
}

double SimulationController::recorded_s() {
  return mode() == Mode::kRecording ? spanOf_s(run()->latest().tick) : 0.0;
}

void SimulationController::openReplay(const Trial& trial) {
  if (mode() == Mode::kRecording) {
    Q_EMIT noticed(tr("Stop the recording before replaying another one."));
    return;
  }
  SceneRequest request;
  request.assets = request_.assets;
  request.id = trial.header.sceneId;
  request.pattern = trial.header.patternId;
  request.recorded = trial.header.parametersJson;
  if (scene() != nullptr && scene()->organHash == trial.header.organHash) {
    request.organFile = request_.organFile;
    request.organScale_m = request_.organScale_m;
    request.asRecorded = true;
    request.organWarnings = recordedOrganWarnings(trial.header.parametersJson);
  }
  loadFor(request, std::make_shared<const Trial>(trial));
}

void SimulationController::closeReplay() {
  if (stage() != StageKind::kReplaying) {
    return;
  }
  target_rad_ = scene()->pattern.targetAngle_rad;
  practise(nullptr);
  Q_EMIT sceneChanged();
}

void SimulationController::shutDown() {
  if (stage() == StageKind::kEmpty) {
    return;
  }
  if (mode() == Mode::kRecording) {
    static_cast<void>(finishRun(TrialOutcome::kInterrupted));
  }
  enter(stage::Still{state()});
}

void SimulationController::useHapticDevice(HapticOpener opener) {
  const bool was = static_cast<bool>(openHaptic_);
  if (was && !opener) {
    opening_.cancel();
    if (stage() == StageKind::kPractising) {
      takeHaptic().reset();  // immediately, because another page may open it next
      practise(nullptr);
    }
  }
  openHaptic_ = std::move(opener);
  openHaptic();
}

void SimulationController::openHaptic() {
  if (!openHaptic_ || scene() == nullptr || mode() == Mode::kReplay || !hapticModel().isEmpty()) {
    return;
  }
  opening_.begin(
      [open = openHaptic_, scene = loaded_.scene] { return open(*scene); },
      [this](std::unique_ptr<HapticDevice> device) { tookHaptic(std::move(device)); },
      [this](const std::exception_ptr& problem) {
        Q_EMIT noticed(tr("You practise with mouse and keyboard: %1").arg(problemSentence(problem)));
      });
}

void SimulationController::tookHaptic(std::unique_ptr<HapticDevice> device) {
  if (!device) {
    Q_EMIT noticed(tr("No haptic device was found. You practise with mouse and keyboard"));
    return;
  }
  const QString model = toQString(device->capabilities().model);
  const bool felt = device->capabilities().rendersForce;
  if (stage() != StageKind::kPractising) {
    return;  // released, and requested again with the next scene
  }
  practise(std::move(device));
  Q_EMIT noticed(felt ? tr("You practise with %1. The force is felt").arg(model)
                      : tr("You practise with %1. The force is shown, not felt").arg(model));
}

/// Stops free practice with the haptic device, and returns the device, which is reused because opening it
/// takes seconds. Null: there is none, or it is no longer wanted.
std::unique_ptr<HapticDevice> SimulationController::takeHaptic() {
  stage::Running* now = stage() == StageKind::kTraining ? nullptr : running();
  if (now == nullptr || !now->usesHaptic()) {
    return nullptr;
  }
  std::unique_ptr<HapticDevice> device = now->run->releaseDevice();
  return openHaptic_ ? std::move(device) : nullptr;
}

void SimulationController::watchDevice() {
  stage::Running* now = running();
  if (now == nullptr || !now->usesHaptic()) {
    return;
  }
  if ((now->run->latest().deviceStatus & kDeviceLost) == 0) {
    return;
  }
  auto* training = std::get_if<stage::Training>(&stage_);
  if (training == nullptr) {
    loseHaptic();
  } else if (!training->lossTold) {
    training->lossTold = true;
    Q_EMIT deviceLost();
  }
}

/// Handles the loss of the device. The servo has already set the force to zero: a lost device gets none.
void SimulationController::loseHaptic() {
  const bool recorded = stage() == StageKind::kRecording;
  if (recorded) {
    static_cast<void>(finishRun(TrialOutcome::kInterrupted));
  }
  opening_.retire(takeHaptic());
  practise(nullptr);
  Q_EMIT noticed(recorded
                     ? tr("The haptic device was disconnected. The recording up to then is kept; continue "
                          "with the mouse")
                     : tr("The haptic device was disconnected. Put it down and continue with the mouse"));
}

QString SimulationController::hapticModel() const {
  const bool free = stage() == StageKind::kPractising || stage() == StageKind::kRecording;
  const stage::Running* now = free ? runningOf(stage_) : nullptr;
  if (now == nullptr || !now->usesHaptic()) {
    return {};
  }
  return toQString(now->run->header().deviceModel);
}

}  // namespace torsio::gui
