// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QObject>
#include <QString>
#include <QThreadPool>

#include "app/gui/base/problem.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/simulator/async_view.h"
#include "app/gui/simulator/loaded_scene.h"
#include "app/gui/simulator/simulation_stage.h"
#include "app/gui/simulator/trial_recording.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

/// Opens the haptic device for a scene. Called in a worker thread; throws Error{kDevice}.
using HapticOpener = std::function<std::unique_ptr<HapticDevice>(const Scene&)>;

/// Everything between the widgets and the simulation: which scene is loaded, the running exercise, its
/// recording, or a recording that is played. Scenes are loaded in a worker thread and swapped here, after the
/// servo has stopped. GUI thread; the servo is never waited for except while it ends.
class SimulationController : public QObject {
  Q_OBJECT

 public:
  /// What a view must know of the stage.
  enum class Mode { kEmpty, kPractice, kRecording, kReplay };

  SimulationController(SceneLoader loader, TrialRecording recording, QObject* parent = nullptr);
  ~SimulationController() override;

  /// Tests drive the servo themselves.
  void setRealTime(bool realTime) noexcept { realTime_ = realTime; }

  /// Loads in the background; sceneChanged() or failed() follows. A newer call overtakes an older one. Ends a
  /// replay; refused while recording.
  void load(const SceneRequest& request);
  /// Shows a scene that was loaded already.
  void adopt(const SceneRequest& request, LoadedScene loaded);
  /// Shows one instant in place of free practice: for pictures. Until the next scene.
  void freeze(const LiveState& state);
  [[nodiscard]] bool frozen() const noexcept { return stage() == StageKind::kStill; }
  [[nodiscard]] bool loading() const noexcept { return wanted_ != delivered_; }
  /// The request of the scene that is shown.
  [[nodiscard]] const SceneRequest& request() const noexcept { return request_; }
  /// Null before the first scene.
  [[nodiscard]] const Scene* scene() const noexcept { return loaded_.scene.get(); }
  [[nodiscard]] const std::shared_ptr<const Scene>& sharedScene() const noexcept { return loaded_.scene; }
  [[nodiscard]] const ViewScene& viewScene() const noexcept { return loaded_.view; }
  [[nodiscard]] Mode mode() const noexcept;
  /// Names what goes on; mode() without what only this class tells apart.
  [[nodiscard]] StageKind stage() const noexcept { return kindOf(stage_); }

  /// Once a frame, before state(): moves a replay on.
  void advance(double elapsed_s);
  /// What the window shows now.
  [[nodiscard]] LiveState state();
  /// How often a second the asynchronous model answers; 0 before its first answer, nothing where the
  /// servo answers alone or nothing runs.
  [[nodiscard]] std::optional<double> asyncRate_per_s() const;
  /// True while the pointer turns what it holds instead of carrying it round (TwistDrive::kRoll).
  [[nodiscard]] bool toolRidesOnTissue() const noexcept;
  /// The organ's surface next to the tip while nothing holds it; `distance_m` counts from the tip's sphere.
  [[nodiscard]] std::optional<SurfacePoint> nearby(const LiveState& state) const;
  /// Where the instrument waits: in front of the section to grasp, on the side of the viewer.
  [[nodiscard]] Vec3 parkingPoint_m() const;

  /// From now on free practice is done with the haptic device: it is opened in the background for each scene,
  /// and the pointer serves until it is there, when there is none (noticed() says so), and after it was lost.
  /// Empty: the device is given back, at once.
  void useHapticDevice(HapticOpener opener);
  /// Model of the haptic device of free practice; empty: the pointer.
  [[nodiscard]] QString hapticModel() const;

  void steer(const PointerInput& input);
  void releaseTissue();
  /// Asks the servo for something at its next tick; noticed() says so when it cannot take it. Nothing runs:
  /// nothing happens.
  void command(const ServoCommand& command);
  void setTarget(double target_rad);
  [[nodiscard]] double target_rad() const noexcept { return target_rad_; }

  /// Free practice starts anew and is recorded from its first tick.
  void startRecording();
  void stopRecording();
  /// Begins a trainee's run on the scene that is shown. `device` null: the pointer. False while no scene is
  /// ready or another recording goes on. Throws what the device does; then nothing has changed.
  [[nodiscard]] bool startTraining(const RecordingSpec& recording, std::unique_ptr<TrialSink> sink,
                                   std::unique_ptr<HapticDevice> device);
  /// Ends such a run; the organ then stands still until the next one. Empty: none went on, or it could not be
  /// kept (failed() has said so).
  std::optional<RecordingResult> endTraining(TrialOutcome outcome);
  /// Samples recorded so far in seconds.
  [[nodiscard]] double recorded_s();
  [[nodiscard]] const TrialRecording& recording() const noexcept { return recording_; }

  /// Loads the trial's scene, checks that it is the recorded one, and plays. Refused while recording.
  void openReplay(const Trial& trial);
  void closeReplay();
  /// Null when nothing is played.
  [[nodiscard]] TrialPlayback* playback() noexcept;

  /// Ends a running trial as interrupted, and nothing moves any more until the next scene: when the window
  /// closes.
  void shutDown();

  /// For tests that drive the servo themselves; null when nothing runs.
  [[nodiscard]] RecordedRun* run() noexcept;

 Q_SIGNALS:
  void loadingChanged(bool loading);
  void sceneChanged();
  void modeChanged();
  void problemMet(const torsio::gui::Problem& problem);
  /// Sent with problemMet, in the present language.
  void failed(const QString& happened, const QString& remedy, const QString& details);
  void noticed(const QString& sentence);
  /// hapticModel() is another one.
  void hapticModelChanged();
  /// The device of a training run does not answer any more; nobody knows its force then. Once a run.
  void deviceLost();

 private:
  void replace(const SceneRequest& request, LoadedScene loaded, std::optional<TrialPlayback> playback);
  void loadFor(const SceneRequest& request, std::shared_ptr<const Trial> trial);
  /// The only way from one stage to the next.
  void enter(SimulationStage next);
  [[nodiscard]] stage::Running* running() noexcept;
  [[nodiscard]] const stage::Running* running() const noexcept;
  [[nodiscard]] stage::Running newRun(std::unique_ptr<HapticDevice> device, const RecordingSpec& recording,
                                      std::shared_ptr<TrialSink> sink) const;
  [[nodiscard]] std::unique_ptr<AsyncModelPlayback> asyncPlayback() const;
  void practise(std::unique_ptr<HapticDevice> device);
  [[nodiscard]] std::optional<RecordingResult> finishRun(TrialOutcome outcome);
  void openHaptic();
  void tellWarnings();
  void tookHaptic(std::unique_ptr<HapticDevice> device, const QString& problem);
  [[nodiscard]] std::unique_ptr<HapticDevice> takeHaptic();
  void retireHaptic(std::unique_ptr<HapticDevice> device);
  void watchDevice();
  void loseHaptic();
  /// Does `action`, once: what it throws is told to whoever listens. True when it went well.
  bool attempt(const std::function<void()>& action);
  void report(const std::exception_ptr& thrown);
  void tell(const Problem& problem);
  void tellSpilled(const RecordingResult& result);

  SceneLoader loader_;
  TrialRecording recording_;
  bool realTime_ = true;
  QThreadPool workers_;
  std::uint64_t wanted_ = 0;     // number of the newest load
  std::uint64_t delivered_ = 0;  // number of the last load that ended
  SceneRequest request_;
  LoadedScene loaded_;
  double target_rad_ = 0.0;
  PointerInput pointer_;  // the newest
  SimulationStage stage_;
  HapticOpener openHaptic_;                     // empty: free practice with the pointer
  std::atomic<std::uint64_t> hapticWanted_{0};  // number of the newest attempt to open it
};

}  // namespace torsio::gui
