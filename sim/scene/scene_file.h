// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/plausible.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "sim/scene/scene.h"
#include "sim/tissue/twist/twist_model.h"

namespace torsio {

/// Where the line of a task lies in an organ whose landmarks are not known.
enum class AxisElsewhere {
  kEnds,  ///< from the fixed to the free end: the long axis
  kBend,  ///< at half length, from the inside of the organ's bend to the outside: the short axis
};

/// A pattern as the scene file has it.
struct PatternDescription {
  TwistPattern pattern;
  AxisElsewhere elsewhere = AxisElsewhere::kEnds;  ///< of a task about a line
};

/// A scene file (assets/scenes/<id>.json) with the paths of the files that it names, before any geometry is
/// built.
struct SceneDescription {
  std::string id;
  std::string title;
  std::string provenance;
  std::filesystem::path organ;
  double organUnit_m = 0.001;
  LatticeOptions lattice;
  Material material;
  Formulation formulation = Formulation::kSaintVenant;
  ModelChoice model;  ///< parts that the formulation knows
  Instrument instrument;
  std::vector<Restraint> restraints;         ///< of the organ where a pattern has a task
  std::vector<PatternDescription> patterns;  ///< at least one, ids all different
  std::vector<OrganWarning> organWarnings;   ///< of a user's organ
};

/// Reads the scene file with this id; that of kOwnOrganScene names no organ. Throws Error{kFileMissing}
/// naming the known scenes, {kBadData} naming file and field: malformed JSON, unknown, missing or wrong
/// field, unknown material or instrument, number out of range.
[[nodiscard]] SceneDescription readSceneFile(const std::filesystem::path& assets, const std::string& id);

/// Least and most of a measure of an instrument, millimetres.
struct InstrumentRange {
  double least = 0.0;
  double most = 0.0;
};
inline constexpr InstrumentRange kInstrumentTip_mm{0.5, 20.0};
/// Of a shaft, or of the whole instrument: Stated::kInstrumentSide.
[[nodiscard]] inline InstrumentRange instrumentLength_mm() noexcept {
  constexpr double kMillimetresPerMetre = 1e3;
  const PlausibleRow& side = plausible(Stated::kInstrumentSide);
  return {kMillimetresPerMetre * side.least, kMillimetresPerMetre * side.most};
}
inline constexpr InstrumentRange kInstrumentReach_mm{0.5, 30.0};

/// Reads assets/instruments/<id>.json, as far as the collision needs it. Throws as readSceneFile().
[[nodiscard]] Instrument readInstrument(const std::filesystem::path& assets, const std::string& id);

/// Reads the scene as it was before, for recordings that were made on it: assets/scenes/former/<id>.json,
/// then <id>-2.json and so on, oldest first. None where it has always been what it is. Throws as
/// readSceneFile.
[[nodiscard]] std::vector<SceneDescription> readFormerScenes(const std::filesystem::path& assets,
                                                             const std::string& id);

/// Returns where the markers of a shipped organ lie, NAME_markers.json beside NAME.ply, which scenes of one
/// organ share; the file need not exist. Empty for an organ of the user's and for a former one, on which they
/// do not lie. Throws as readSceneFile.
[[nodiscard]] std::filesystem::path organMarkersFile(const std::filesystem::path& assets, const Scene& scene);

/// Reads all materials of assets/scenes/materials.json. Throws Error{kFileMissing, kBadData} as
/// readSceneFile.
[[nodiscard]] std::vector<Material> readMaterials(const std::filesystem::path& assets);

/// Returns the material with this id. Throws Error{`code`} at `where`, naming the known ones.
[[nodiscard]] Material findMaterial(const std::filesystem::path& assets, const std::string& id,
                                    ErrorCode code, const std::string& where);

/// Joins names to "a, b, c".
[[nodiscard]] std::string listed(const std::vector<std::string>& names);

}  // namespace torsio
