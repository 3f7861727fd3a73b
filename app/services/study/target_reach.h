// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace torsio {

/// Returns how far a scene's organ can be turned towards `target_rad` with a pattern: the target itself, or
/// the angle at which the organ folds or slips back by a whole turn before. Only a target beyond that of a
/// pattern with a task is worked out, by turning the organ (half a second), once per process; any other is
/// returned. Throws as loadScene(). Any thread.
[[nodiscard]] double targetReach_rad(const std::filesystem::path& assets, const std::string& sceneId,
                                     const std::string& patternId, double target_rad);

}  // namespace torsio
