// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/scene/organ_file.h"
#include "sim/scene/scene.h"

namespace torsio {

/// Loads the scene of an organ that is in memory, as loadScene() does of the organ file that
/// `request.organFile` names: nothing is read there, the name is the scene's title. The organ is taken as it
/// is, judged or not. Throws as loadScene().
[[nodiscard]] Scene sceneOfOrgan(const SceneRequest& request, OrganFile organ);

}  // namespace torsio
