// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/geometry/section_lattice.h"
#include "sim/scene/scene.h"
#include "sim/tissue/material.h"

namespace torsio {

/// A scene file (assets/scenes/<id>.json) with the files it names resolved, before any geometry is built.
struct SceneDescription {
  std::string id;
  std::string title;
  std::string provenance;
  std::filesystem::path organ;
  double organUnit_m = 0.001;
  LatticeOptions lattice;
  Material material;
  Formulation formulation = Formulation::kSaintVenant;
  Instrument instrument;
  std::vector<TwistPattern> patterns;  ///< at least one
};

/// Throws Error{kFileMissing} naming the known scenes, {kBadData} naming file and field: malformed JSON,
/// unknown, missing or wrong field, unknown material or instrument, number out of range.
[[nodiscard]] SceneDescription readSceneFile(const std::filesystem::path& assets, const std::string& id);

/// All materials of assets/scenes/materials.json. Throws as above.
[[nodiscard]] std::vector<Material> readMaterials(const std::filesystem::path& assets);

}  // namespace torsio
