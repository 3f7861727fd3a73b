// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <variant>

#include "app/services/recording/async_model_playback.h"
#include "app/services/recording/recorded_run.h"
#include "app/services/recording/trial_playback.h"
#include "sim/core/live_types.h"
#include "sim/device/virtual/pointer_device.h"

namespace torsio::gui {

/// What a simulator can be at; each stage holds all that only it needs.
namespace stage {

/// No scene was loaded yet.
struct Empty {};

/// A run and who leads the instrument.
struct Running {
  std::unique_ptr<RecordedRun> run;  ///< never null
  PointerDevice* pointer = nullptr;  ///< of `run`; null: a haptic device

  [[nodiscard]] bool usesHaptic() const noexcept { return pointer == nullptr; }
};

/// Free practice: nothing is kept.
struct Practising : Running {};

/// Free practice that is recorded.
struct Recording : Running {};

/// A trainee's run; it belongs to the page that began it.
struct Training : Running {
  bool lossTold = false;  ///< that its haptic device was lost
};

/// One instant is shown and nothing moves: a picture, between two runs of a trainee, after the end.
struct Still {
  LiveState shown;
};

/// A recording is played.
struct Replaying {
  TrialPlayback playback;
  std::unique_ptr<AsyncModelPlayback> async{};  ///< null: the recording needs none
};

}  // namespace stage

using SimulationStage = std::variant<stage::Empty, stage::Practising, stage::Recording, stage::Training,
                                     stage::Still, stage::Replaying>;

/// The stages by name, in the order of the variant.
enum class StageKind : std::size_t { kEmpty, kPractising, kRecording, kTraining, kStill, kReplaying };
inline constexpr std::size_t kStageKinds = std::variant_size_v<SimulationStage>;

/// Names the stage.
[[nodiscard]] inline StageKind kindOf(const SimulationStage& stage) noexcept {
  return static_cast<StageKind>(stage.index());
}

/// Tells whether a stage may come right after another. What is recorded never changes its scene: it must end
/// first, and a trainee's run ends in stillness.
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
