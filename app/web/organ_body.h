// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "app/web/shapes/shape_basis.h"
#include "sim/scene/scene.h"

namespace torsio::web {

/// What a page draws an organ and the instrument from, whatever was recorded of them, as BinaryContainer,
/// gzipped (docs/server.md describes the arrays): surface, colour, and the shapes of `basis`, which are those
/// of the scene's pattern. The same scene and basis give the same bytes. Throws Error{kFileMissing},
/// {kBadMesh} for the instrument's files.
[[nodiscard]] std::string organBody(const Scene& scene, const ShapeBasis& basis,
                                    const std::filesystem::path& assets);

}  // namespace torsio::web
