// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace torsio {

/// Returns how far a scene's organ can be turned towards `target_rad` with a pattern: the target, or the
/// angle before which the organ folds or slips back by a whole turn. Calculated (half a second, cached per
/// process) only for a target beyond that of a pattern with a task; any other target is returned unchanged.
/// Throws like loadScene(). Any thread.
[[nodiscard]] double targetReach_rad(const std::filesystem::path& assets, const std::string& sceneId,
                                     const std::string& patternId, double target_rad);

}  // namespace torsio
