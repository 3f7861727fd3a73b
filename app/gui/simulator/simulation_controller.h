// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QObject>
#include <QString>
#include <QThreadPool>

#include "app/gui/base/translated_text.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/simulator/device_opening.h"
#include "app/gui/simulator/loaded_scene.h"
#include "app/gui/simulator/simulation_stage.h"
#include "app/gui/simulator/trial_recording.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

/// Opens the haptic device for a scene, in a worker thread; throws Error{kDevice}.
using HapticOpener = std::function<std::unique_ptr<HapticDevice>(const Scene&)>;

/// Connects widgets and simulation: the loaded scene, the running exercise and its recording, or a replay.
/// Loads scenes in a worker thread and swaps them here after the servo has stopped. GUI thread; waits for the
/// servo only when it ends.
class SimulationController : public QObject {
  Q_OBJECT

 public:
  using Mode = SimulationMode;

  SimulationController(SceneLoader loader, TrialRecording recording, QObject* parent = nullptr);
  ~SimulationController() override;

  /// Lets tests drive the servo.
  void setRealTime(bool realTime) noexcept { realTime_ = realTime; }

  /// Loads in the background; then emits sceneChanged() or failed(). A newer call supersedes an older one.
  /// Ends a replay; refused while recording.
  void load(const SceneRequest& request);
  /// Shows a scene already loaded.
  void adopt(const SceneRequest& request, LoadedScene loaded);
  /// Shows one state in place of free practice, for screenshots, until the next scene.
  void freeze(const LiveState& state);
  [[nodiscard]] bool frozen() const noexcept { return stage() == StageKind::kStill; }
  [[nodiscard]] bool loading() const noexcept { return wanted_ != delivered_; }
  /// Returns the request of the present scene.
  [[nodiscard]] const SceneRequest& request() const noexcept { return request_; }
  /// Returns the scene; null before the first one.
  [[nodiscard]] const Scene* scene() const noexcept { return loaded_.scene.get(); }
  [[nodiscard]] const std::shared_ptr<const Scene>& sharedScene() const noexcept { return loaded_.scene; }
  [[nodiscard]] const ViewScene& viewScene() const noexcept { return loaded_.view; }
  [[nodiscard]] Mode mode() const noexcept { return modeOf(stage()); }
  /// Returns the stage; mode() is the reduced form for views.
  [[nodiscard]] StageKind stage() const noexcept { return kindOf(stage_); }

  /// Advances a replay; call once per frame, before state().
  void advance(double elapsed_s);
  /// Returns the state to show now.
  [[nodiscard]] LiveState state();
  /// Returns the rate of the asynchronous model, per second; 0 before its first response, empty without such
  /// a model or if nothing runs.
  [[nodiscard]] std::optional<double> asyncRate_per_s() const;
  /// Returns whether the pointer turns what it holds instead of carrying it round (TwistDrive::kRoll).
  [[nodiscard]] bool toolRidesOnTissue() const noexcept;
  /// Returns the organ's surface nearest to the free tip; `distance_m` from the tip's sphere.
  [[nodiscard]] std::optional<SurfacePoint> nearby(const LiveState& state) const;
  /// Returns the instrument's waiting position: in front of the section to grasp, on the viewer's side.
  [[nodiscard]] Vec3 parkingPoint_m() const;

  /// Uses the haptic device for free practice: it is opened in the background for each scene; the pointer is
  /// used until then, without a device (noticed() is emitted), and after its loss. Empty: releases the device
  /// immediately.
  void useHapticDevice(HapticOpener opener);
  /// Returns the model of free practice's haptic device; empty: the pointer.
  [[nodiscard]] QString hapticModel() const;

  void steer(const PointerInput& input);
  void releaseTissue();
  /// Sends a command for the servo's next tick; emits noticed() if it cannot be accepted. No effect if
  /// nothing runs.
  void command(const ServoCommand& command);
  void setTarget(double target_rad);
  [[nodiscard]] double target_rad() const noexcept { return target_rad_; }

  /// Restarts free practice and records it from the first tick.
  void startRecording();
  void stopRecording();
  /// Starts a trainee's run on the present scene. `device`: null for the pointer. False without a loaded
  /// scene or during another recording. Throws like the device; then nothing has changed.
  [[nodiscard]] bool startTraining(const RecordingSpec& recording, std::unique_ptr<TrialSink> sink,
                                   std::unique_ptr<HapticDevice> device);
  /// Ends a trainee's run; the organ is still until the next one. Empty: there was none, or it could not be
  /// stored (failed() has been emitted).
  std::optional<RecordingResult> endTraining(TrialOutcome outcome);
  /// Returns the length of the recording so far, s.
  [[nodiscard]] double recorded_s();
  [[nodiscard]] const TrialRecording& recording() const noexcept { return recording_; }

  /// Loads a trial's scene, verifies it against the recording, and plays. Refused while recording.
  void openReplay(const Trial& trial);
  void closeReplay();
  /// Returns the playback; null without a replay.
  [[nodiscard]] TrialPlayback* playback() noexcept;

  /// Ends a running trial as interrupted and stops everything until the next scene; called when the window
  /// closes.
  void shutDown();

  /// Returns the run for tests that drive the servo; null if nothing runs.
  [[nodiscard]] RecordedRun* run() noexcept;

 Q_SIGNALS:
  void loadingChanged(bool loading);
  void sceneChanged();
  void modeChanged();
  void problemMet(const torsio::gui::Problem& problem);
  /// Emitted with problemMet, in the present language.
  void failed(const QString& happened, const QString& remedy, const QString& details);
  void noticed(const QString& sentence);
  /// hapticModel() has changed.
  void hapticModelChanged();
  /// The device of a training run has stopped responding, so its force is unknown. Emitted once per run.
  void deviceLost();

 private:
  void replace(const SceneRequest& request, LoadedScene loaded, std::optional<TrialPlayback> playback);
  void loadFor(const SceneRequest& request, std::shared_ptr<const Trial> trial);
  /// Changes the stage; the only place where it changes.
  void enter(SimulationStage next);
  [[nodiscard]] stage::Running* running() noexcept;
  [[nodiscard]] stage::Running newRun(std::unique_ptr<HapticDevice> device, const RecordingSpec& recording,
                                      std::shared_ptr<TrialSink> sink) const;
  [[nodiscard]] std::unique_ptr<AsyncModelPlayback> asyncPlayback() const;
  void practise(std::unique_ptr<HapticDevice> device);
  [[nodiscard]] std::optional<RecordingResult> finishRun(TrialOutcome outcome);
  void openHaptic();
  void tellWarnings();
  void tookHaptic(std::unique_ptr<HapticDevice> device);
  [[nodiscard]] std::unique_ptr<HapticDevice> takeHaptic();
  void watchDevice();
  void loseHaptic();
  /// Runs `action` and reports exceptions through problemMet(). True on success.
  bool attempt(const std::function<void()>& action);
  void report(const std::exception_ptr& thrown);
  void tell(const Problem& problem);
  void tellSpilled(const RecordingResult& result);

  SceneLoader loader_;
  TrialRecording recording_;
  bool realTime_ = true;
  QThreadPool workers_;
  std::uint64_t wanted_ = 0;     // number of the latest load
  std::uint64_t delivered_ = 0;  // number of the last completed load
  SceneRequest request_;
  LoadedScene loaded_;
  double target_rad_ = 0.0;
  PointerInput pointer_;  // latest input
  SimulationStage stage_;
  HapticOpener openHaptic_;  // empty: free practice with the pointer
  DeviceOpening opening_;    // of the haptic device of free practice
};

}  // namespace torsio::gui
