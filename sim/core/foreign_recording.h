// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

#include "sim/core/ids.h"

namespace torsio {

/// The scene of a recording that other equipment made: path, rotation and jaw of an instrument in a frame of
/// its own. No organ answered, nothing was felt, and there is nothing to compute again.
inline constexpr std::string_view kForeignScene = "foreign";
/// What stands in place of the model's name in tables and reports.
inline constexpr std::string_view kForeignModel = "foreign recording";
/// The one key of the parameters of such a recording: source, frame, unit, how it was read.
inline constexpr const char* kForeignParameters = "foreign";

/// Keys of the parameters, and of the map: what was confirmed although something else would have fitted
/// better.
inline constexpr const char* kUnitConfirmed = "unit_confirmed";
inline constexpr const char* kTimeConfirmed = "time_confirmed";
inline constexpr const char* kScaleConfirmed = "scale_confirmed";

/// A pose that is the same bit for bit for longer is no pose of a hand: the instrument was out of view.
inline constexpr std::int64_t kFrozenPose_us = 200'000;

/// Whether a recording of this scene came from other equipment. Any thread.
[[nodiscard]] inline bool isForeign(const SceneId& scene) {
  return scene.text() == kForeignScene;
}

}  // namespace torsio
