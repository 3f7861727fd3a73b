// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/web/shapes/shape_basis.h"
#include "sim/scene/scene.h"

namespace torsio::web {

/// Makes what pages draw an organ and the instrument from, independent of the recording: a gzipped
/// BinaryContainer (docs/server.md describes the arrays) with surface, colour, and the shapes of `basis`,
/// those of the scene's pattern. Reproducible. Throws Error{kFileMissing}, {kBadMesh} for the instrument's
/// files.
[[nodiscard]] std::string organBody(const Scene& scene, const ShapeBasis& basis,
                                    const std::filesystem::path& assets);

}  // namespace torsio::web
