// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene_file.h"

namespace torsio {

/// Writes everything that decides what the model answers as one line of JSON with its fields in a fixed
/// order: equal parameters give equal text on every machine. `usersOrgan`: the organ is a user's mesh.
/// `tissue`: the model that answers the hand.
[[nodiscard]] std::string parametersText(const SceneDescription& scene, const TwistPattern& pattern,
                                         bool usersOrgan, TissueModel tissue);

/// Adds to such a text how far the law of the wall was checked (RecordedValidity), which decides nothing and
/// is no part of its hash; unchanged without a wall.
[[nodiscard]] std::string withValidity(const std::string& parameters, const HollowOrgan& organ);
/// Takes it out again.
[[nodiscard]] std::string withoutValidity(const std::string& parameters);

}  // namespace torsio
