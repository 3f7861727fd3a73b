// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <variant>

#include "app/services/recording/async_model_worker.h"
#include "app/services/recording/recorded_run.h"
#include "app/services/recording/trial_playback.h"
#include "sim/core/live_types.h"
#include "sim/device/virtual/pointer_device.h"

namespace torsio::gui {

/// Stages of a simulator, each with the data only it needs.
namespace stage {

/// No scene has been loaded yet.
struct Empty {};

/// A run and the device that moves the instrument.
struct Running {
  std::unique_ptr<RecordedRun> run;  ///< never null
  PointerDevice* pointer = nullptr;  ///< of `run`; null for a haptic device

  [[nodiscard]] bool usesHaptic() const noexcept { return pointer == nullptr; }
};

/// Free practice, not stored.
struct Practising : Running {};

/// Recorded free practice.
struct Recording : Running {};

/// A trainee's run, controlled by the page that started it.
struct Training : Running {
  bool lossTold = false;  ///< the loss of its haptic device was reported
};

/// A still state: a screenshot, between two runs of a trainee, after the end.
struct Still {
  LiveState shown;
};

/// A replay of a recording.
struct Replaying {
  TrialPlayback playback;
  std::unique_ptr<AsyncModelPlayback> async{};  ///< null: not needed by the recording
};

}  // namespace stage

using SimulationStage = std::variant<stage::Empty, stage::Practising, stage::Recording, stage::Training,
                                     stage::Still, stage::Replaying>;

/// The stages, in the order of the variant.
enum class StageKind : std::size_t { kEmpty, kPractising, kRecording, kTraining, kStill, kReplaying };
inline constexpr std::size_t kStageKinds = std::variant_size_v<SimulationStage>;

/// Returns the kind of a stage.
[[nodiscard]] inline StageKind kindOf(const SimulationStage& stage) noexcept {
  return static_cast<StageKind>(stage.index());
}

/// Returns the run of a stage; null if none runs.
[[nodiscard]] inline const stage::Running* runningOf(const SimulationStage& stage) noexcept {
  if (const auto* practising = std::get_if<stage::Practising>(&stage)) {
    return practising;
  }
  if (const auto* recording = std::get_if<stage::Recording>(&stage)) {
    return recording;
  }
  return std::get_if<stage::Training>(&stage);
}

/// A stage, reduced to what views need.
enum class SimulationMode { kEmpty, kPractice, kRecording, kReplay };
[[nodiscard]] constexpr SimulationMode modeOf(StageKind stage) noexcept {
  switch (stage) {
    case StageKind::kEmpty:
      break;
    case StageKind::kPractising:
    case StageKind::kStill:
      return SimulationMode::kPractice;
    case StageKind::kRecording:
    case StageKind::kTraining:
      return SimulationMode::kRecording;
    case StageKind::kReplaying:
      return SimulationMode::kReplay;
  }
  return SimulationMode::kEmpty;
}

/// Returns whether a stage may directly follow another. A recording never changes its scene: it must end
/// first, and a trainee's run ends in kStill.
[[nodiscard]] constexpr bool mayFollow(StageKind before, StageKind after) noexcept {
  constexpr std::array<std::array<bool, kStageKinds>, kStageKinds> kMay{{
      // empty, practising, recording, training, still, replaying
      {false, true, false, false, false, true},   // after empty
      {false, true, true, true, true, true},      // after practising
      {false, true, false, false, true, false},   // after recording
      {false, false, false, false, true, false},  // after training
      {false, true, false, true, true, true},     // after still
      {false, true, false, false, true, true},    // after replaying
  }};
  return kMay[static_cast<std::size_t>(before)][static_cast<std::size_t>(after)];
}

}  // namespace torsio::gui
