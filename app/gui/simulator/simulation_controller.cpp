// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/simulator/simulation_controller.h"

#include <algorithm>
#include <utility>

#include <QUuid>

#include "app/base/build_info.h"
#include "app/gui/base/spoken.h"
#include "sim/base/clock.h"
#include "sim/base/contracts.h"
#include "sim/base/error.h"

namespace torsio::gui {

namespace {

constexpr double kParkingWay_m = 0.020;
constexpr double kParkingStep_m = 0.002;
constexpr double kFarthestParking_m = 0.300;
constexpr double kInsideEnd = 0.04;  // a section at the very end is too small to be pointed at
const Vec3 kTowardsViewer{0.0, -1.0, 0.0};

/// The recorded scene is found among the two formulations; its parameters tell which.
LoadedScene loadRecorded(const SceneLoader& loader, SceneRequest request, const TrialHeader& header) {
  for (const Formulation formulation : {Formulation::kSaintVenant, Formulation::kPaper}) {
    request.formulation = formulation;
    LoadedScene loaded = loader(request);
    if (loaded.scene->organHash == header.organHash && loaded.scene->parameterHash == header.parameterHash) {
      return loaded;
    }
  }
  throw Error(ErrorCode::kVerifyFailed, "the organ or its parameters are not those of the recording",
              Text("trial %1", header.trialId),
              Text("Open the organ file of the recording first, or use the version that recorded it: %1",
                   header.softwareVersion));
}

}  // namespace

LoadedScene loadSceneForView(const SceneRequest& request) {
  LoadedScene loaded;
  loaded.scene = std::make_shared<const Scene>(loadScene(request));
  // A user's organ is not what the scene it borrows was drawn for.
  const std::string tissue = request.organFile ? request.organFile->stem().string() : std::string();
  loaded.view = makeViewScene(loaded.scene, tissue);
  if (!request.organFile) loaded.view.markers = organMarkers(*loaded.scene, request.assets);
  return loaded;
}

SimulationController::SimulationController(SceneLoader loader, TrialRecording recording, QObject* parent)
    : QObject(parent), loader_(std::move(loader)), recording_(std::move(recording)) {
  workers_.setMaxThreadCount(1);
}

SimulationController::~SimulationController() {
  workers_.clear();
  workers_.waitForDone();
  run_.reset();
  haptic_.reset();
}

void SimulationController::report(const std::exception_ptr& thrown) {
  tell(problemOf(thrown, {[] { return tr("Something unexpected went wrong"); },
                          [] { return tr("Please report this."); }}));
}

void SimulationController::tell(const Problem& problem) {
  Q_EMIT problemMet(problem);
  const SpokenError said = problem();
  Q_EMIT failed(said.happened, said.remedy, said.details);
}

void SimulationController::tellSpilled(const RecordingResult& result) {
  tell([details = QString::fromStdString(result.spillFile->string() + "\n" + result.problem)] {
    return SpokenError{tr("The recording could not go to its usual place and was kept as a file"),
                       tr("Free some space or check the database, then import the file."), details};
  });
}

void SimulationController::load(const SceneRequest& request) {
  if (mode_ == Mode::kRecording) {
    Q_EMIT noticed(tr("Stop the recording before choosing another exercise."));
    return;
  }
  loadFor(request, nullptr);
}

void SimulationController::loadFor(const SceneRequest& request, std::shared_ptr<const Trial> trial) {
  const bool wasLoading = loading();
  const std::uint64_t ticket = ++wanted_;
  if (!wasLoading) Q_EMIT loadingChanged(true);
  workers_.clear();  // what has not begun yet is overtaken
  workers_.start([this, ticket, request, trial, loader = loader_] {
    auto loaded = std::make_shared<LoadedScene>();
    std::exception_ptr problem;
    try {
      *loaded = trial ? loadRecorded(loader, request, trial->header) : loader(request);
    } catch (...) {
      problem = std::current_exception();
    }
    QMetaObject::invokeMethod(
        this,
        [this, ticket, request, trial, loaded, problem] {
          if (ticket != wanted_) return;
          delivered_ = ticket;
          Q_EMIT loadingChanged(false);
          try {
            if (problem) std::rethrow_exception(problem);
            std::optional<TrialPlayback> playback;
            if (trial) playback.emplace(*trial);
            replace(request, std::move(*loaded), std::move(playback));
          } catch (...) {
            report(std::current_exception());
          }
        },
        Qt::QueuedConnection);
  });
}

void SimulationController::adopt(const SceneRequest& request, LoadedScene loaded) {
  TORSIO_EXPECTS(mode_ != Mode::kRecording);
  replace(request, std::move(loaded), std::nullopt);
}

void SimulationController::freeze(const LiveState& state) {
  TORSIO_EXPECTS(mode_ == Mode::kPractice);
  run_.reset();
  frozen_ = state;
}

void SimulationController::replace(const SceneRequest& request, LoadedScene loaded,
                                   std::optional<TrialPlayback> playback) {
  endRun();  // the servo must not see the scene change
  retireHaptic();
  frozen_.reset();
  playback_ = std::move(playback);
  request_ = request;
  request_.formulation = loaded.scene->model.options().formulation;
  loaded_ = std::move(loaded);
  target_rad_ = playback_ ? playback_->header().targetAngle_rad : loaded_.scene->pattern.targetAngle_rad;
  if (playback_) {
    playback_->setPlaying(true);
    mode_ = Mode::kReplay;
  } else {
    mode_ = Mode::kPractice;
    practise();
  }
  Q_EMIT sceneChanged();
  Q_EMIT modeChanged();
  openHaptic();
}

RunSetup SimulationController::setup() const {
  RunSetup setup;
  setup.start.position_m = parkingPoint_m();
  setup.targetAngle_rad = target_rad_;
  if (led_) setup.drive = TwistDrive::kTangential;
  return setup;
}

void SimulationController::startRun(std::unique_ptr<LiveRun> run) {
  run_ = std::move(run);
  run_->steer(pointer_);
  if (realTime_) run_->start();
}

/// Free practice with what is at hand.
void SimulationController::practise() {
  led_ = haptic_ != nullptr;
  lostSaid_ = false;
  startRun(std::make_unique<LiveRun>(loaded_.scene, setup(), std::move(haptic_)));
}

/// The device of free practice outlives its runs: opening it takes seconds.
void SimulationController::endRun() {
  if (run_ && openHaptic_) haptic_ = run_->releaseDevice();
  run_.reset();
}

void SimulationController::setMode(Mode mode) {
  if (mode == mode_) return;
  mode_ = mode;
  Q_EMIT modeChanged();
}

Vec3 SimulationController::parkingPoint_m() const {
  TORSIO_EXPECTS(scene() != nullptr);
  const Scene& shown = *scene();
  const double share = std::clamp(shown.pattern.graspArc, kInsideEnd, 1.0 - kInsideEnd);
  const Vec3 centre_m = shown.lattice().frameAt(share * shown.lattice().length_m()).centre_m;
  for (double way_m = 0.0; way_m < kFarthestParking_m; way_m += kParkingStep_m) {
    const Vec3 point_m = centre_m + kTowardsViewer * way_m;
    if (shown.collision.closest(point_m).distance_m >= kParkingWay_m) return point_m;
  }
  return centre_m + kTowardsViewer * kFarthestParking_m;
}

void SimulationController::advance(double elapsed_s) {
  watchDevice();
  if (!playback_) return;
  const bool was = playback_->playing();
  playback_->advance(elapsed_s);
  if (was != playback_->playing()) Q_EMIT modeChanged();
}

LiveState SimulationController::state() {
  if (playback_) return playback_->state();
  if (frozen_) return *frozen_;
  return run_ ? run_->latest() : LiveState{};
}

bool SimulationController::toolRidesOnTissue() const noexcept {
  if (frozen_) return false;
  return playback_ ? playback_->header().drive == TwistDrive::kRoll : !led_;
}

std::optional<SurfacePoint> SimulationController::nearby(const LiveState& state) const {
  const bool atRest = state.phase == ExercisePhase::kTracking || state.phase == ExercisePhase::kContact;
  if (scene() == nullptr || !atRest) return std::nullopt;
  SurfacePoint point = scene()->collision.closest(state.tool.position_m);
  point.distance_m -= scene()->instrument.tipRadius_m;
  return point;
}

void SimulationController::steer(const PointerInput& input) {
  pointer_ = input;
  if (run_) run_->steer(input);
}

void SimulationController::releaseTissue() {
  if (run_ && !run_->command({.kind = ServoCommand::Kind::kReleaseTissue})) {
    Q_EMIT noticed(tr("The simulation is busy; please try again."));
  }
}

void SimulationController::setTarget(double target_rad) {
  if (!run_ || mode_ == Mode::kRecording) return;
  if (!run_->command({.kind = ServoCommand::Kind::kSetTarget, .value = target_rad})) {
    Q_EMIT noticed(tr("The simulation is busy; please try again."));
    return;
  }
  target_rad_ = target_rad;
}

void SimulationController::startRecording() {
  if (mode_ != Mode::kPractice || loading()) return;
  TrialHeader header;
  header.trialId = QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
  header.sceneId = scene()->id;
  header.patternId = scene()->pattern.id;
  header.organHash = scene()->organHash;
  header.parameterHash = scene()->parameterHash;
  header.parametersJson = scene()->parametersJson;
  header.softwareVersion = softwareVersion();
  header.startedUtc_us = utcNow_us();
  header.targetAngle_rad = target_rad_;
  try {
    std::unique_ptr<TrialSink> sink = recording_.open ? recording_.open(header) : nullptr;
    if (!sink) {
      Q_EMIT noticed(tr("There is no place to keep a recording."));
      return;
    }
    endRun();
    led_ = haptic_ != nullptr;
    header.drive = setup().drive;
    startRun(std::make_unique<LiveRun>(loaded_.scene, setup(), std::move(header), std::move(sink),
                                       std::move(haptic_)));
  } catch (...) {
    report(std::current_exception());
    if (!run_) practise();
    return;
  }
  setMode(Mode::kRecording);
}

void SimulationController::stopRecording() {
  if (mode_ != Mode::kRecording) return;
  try {
    const RecordingResult result = run_->finish(TrialOutcome::kCompleted);
    const double duration_s = static_cast<double>(result.summary.samples) * 1e-3;
    if (result.spillFile) {
      tellSpilled(result);
    } else {
      Q_EMIT noticed(
          tr("Recorded %1 s to %2").arg(duration_s, 0, 'f', 1).arg(QString::fromStdString(recording_.place)));
    }
  } catch (...) {
    report(std::current_exception());
  }
  endRun();
  practise();
  setMode(Mode::kPractice);
}

bool SimulationController::startTraining(TrialHeader header, std::unique_ptr<TrialSink> sink,
                                         std::unique_ptr<HapticDevice> device) {
  if (mode_ != Mode::kPractice || loading() || scene() == nullptr) return false;
  header.organHash = scene()->organHash;
  header.parameterHash = scene()->parameterHash;
  header.parametersJson = scene()->parametersJson;
  target_rad_ = header.targetAngle_rad;
  led_ = device != nullptr;
  lostSaid_ = false;
  frozen_.reset();
  run_.reset();
  startRun(std::make_unique<LiveRun>(loaded_.scene, setup(), std::move(header), std::move(sink),
                                     std::move(device)));
  setMode(Mode::kRecording);
  return true;
}

std::optional<RecordingResult> SimulationController::endTraining(TrialOutcome outcome) {
  if (mode_ != Mode::kRecording) return std::nullopt;
  std::optional<RecordingResult> result;
  try {
    result = run_->finish(outcome);
    if (result->spillFile) tellSpilled(*result);
  } catch (...) {
    report(std::current_exception());
  }
  run_.reset();
  led_ = false;
  LiveState still;
  still.tool.position_m = parkingPoint_m();
  still.targetAngle_rad = target_rad_;
  frozen_ = still;
  setMode(Mode::kPractice);
  return result;
}

double SimulationController::recorded_s() {
  return mode_ == Mode::kRecording ? static_cast<double>(run_->latest().tick) * 1e-3 : 0.0;
}

void SimulationController::openReplay(const Trial& trial) {
  if (mode_ == Mode::kRecording) {
    Q_EMIT noticed(tr("Stop the recording before replaying another one."));
    return;
  }
  SceneRequest request;
  request.assets = request_.assets;
  request.id = trial.header.sceneId;
  request.pattern = trial.header.patternId;
  if (scene() != nullptr && scene()->organHash == trial.header.organHash) {
    request.organFile = request_.organFile;
    request.organScale_m = request_.organScale_m;
  }
  loadFor(request, std::make_shared<const Trial>(trial));
}

void SimulationController::closeReplay() {
  if (!playback_) return;
  playback_.reset();
  target_rad_ = scene()->pattern.targetAngle_rad;
  practise();
  setMode(Mode::kPractice);
  Q_EMIT sceneChanged();
}

void SimulationController::shutDown() {
  if (mode_ == Mode::kRecording) {
    try {
      static_cast<void>(run_->finish(TrialOutcome::kInterrupted));
    } catch (...) {
      report(std::current_exception());
    }
  }
  run_.reset();
  setMode(scene() != nullptr ? Mode::kPractice : Mode::kEmpty);
}

}  // namespace torsio::gui
