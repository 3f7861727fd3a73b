// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/scene_file.h"

#include <algorithm>

#include "sim/base/error.h"
#include "sim/base/file_io.h"
#include "sim/base/portable_math.h"
#include "sim/geometry/mesh_import.h"
#include "sim/scene/json_fields.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr double kMillimetre = 1e-3;
constexpr double kLargestAngle_deg = 3600.0;

nlohmann::json readJson(const fs::path& file) {
  try {
    return nlohmann::json::parse(readFile(file));
  } catch (const nlohmann::json::exception& error) {
    throw Error(ErrorCode::kBadData, std::string("is not valid JSON (") + error.what() + ")", file.string(),
                "Correct the file");
  }
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

LatticeOptions readLattice(JsonFields& parent) {
  JsonFields fields(parent.child("lattice"), parent.where() + " lattice");
  LatticeOptions lattice;
  lattice.ridges = fields.integer("ridges", kFewestRidges, kMostRidges, lattice.ridges);
  lattice.sections = fields.integer("sections", kFewestSections, kMostSections, lattice.sections);
  lattice.mode = fields.choice("mode", {"harmonic", "straight-axis"}, 0) == 0 ? LatticeMode::kHarmonic
                                                                              : LatticeMode::kStraightAxis;
  lattice.spacing = fields.choice("spacing", {"arc-length", "angle"}, 0) == 0 ? RidgeSpacing::kArcLength
                                                                              : RidgeSpacing::kAngle;
  if (fields.has("fixed_end_mm") || fields.has("free_end_mm")) {
    lattice.fixedEnd_m = fields.vector("fixed_end_mm") * kMillimetre;
    lattice.freeEnd_m = fields.vector("free_end_mm") * kMillimetre;
  }
  if (fields.has("fixed_cut")) lattice.fixedCut = normalized(fields.vector("fixed_cut"));
  if (fields.has("free_cut")) lattice.freeCut = normalized(fields.vector("free_cut"));
  lattice.capRadius_m = fields.number("cap_radius_mm", 0.0, 200.0, 0.0) * kMillimetre;
  if (fields.has("ridge_zero")) lattice.ridgeZero = normalized(fields.vector("ridge_zero"));
  lattice.ridgeZeroFraction = fields.number("ridge_zero_fraction", 0.0, 1.0, 0.0);
  fields.finish();
  return lattice;
}

TwistOperation readOperation(const nlohmann::json& json, const std::string& where) {
  JsonFields fields(json, where);
  TwistOperation operation;
  if (fields.choice("axis", {"centreline", "straight"}, 0) == 1) {
    operation.axis = TwistAxis::kStraight;
    operation.axisFrom_m = fields.vector("axis_from_mm") * kMillimetre;
    operation.axisTo_m = fields.vector("axis_to_mm") * kMillimetre;
    operation.coordinate = fields.choice("coordinate", {"along-axis", "arc"}, 0) == 0
                               ? TwistCoordinate::kAlongAxis
                               : TwistCoordinate::kArc;
  }
  constexpr TwistProfile kProfiles[] = {TwistProfile::kElastic, TwistProfile::kRamp, TwistProfile::kTent,
                                        TwistProfile::kSmoothRamp, TwistProfile::kSmoothTent};
  operation.profile =
      kProfiles[fields.choice("profile", {"elastic", "ramp", "tent", "smooth-ramp", "smooth-tent"}, 0)];
  operation.from = fields.number("from", -10.0, 10.0, operation.from);
  operation.to = fields.number("to", -10.0, 10.0, operation.to);
  if (fields.has("peak")) operation.peak = fields.number("peak", -10.0, 10.0);
  operation.ratio = fields.number("ratio", -10.0, 10.0, operation.ratio);
  fields.finish();
  return operation;
}

TwistPattern readPattern(const nlohmann::json& json, const std::string& where) {
  JsonFields fields(json, where);
  TwistPattern pattern;
  pattern.id = fields.text("id");
  pattern.title = fields.text("title");
  pattern.ends = fields.choice("ends", {"clamped-free", "both-held"}, 0) == 0 ? EndCondition::kClampedFree
                                                                              : EndCondition::kBothHeld;
  pattern.graspArc = fields.number("grasp", 0.01, 1.0);
  pattern.targetAngle_rad = fields.number("angle_deg", -kLargestAngle_deg, kLargestAngle_deg) * kDegree;
  pattern.tolerance_rad = fields.number("tolerance_deg", 0.1, 90.0) * kDegree;
  pattern.forceLimit_N = fields.number("force_limit_n", 0.1, 100.0);
  pattern.torqueLimit_Nm = fields.number("torque_limit_nm", 0.001, 100.0);
  pattern.source = fields.text("source");
  if (fields.has("operations")) {
    const nlohmann::json& operations = fields.child("operations");
    if (!operations.is_array()) fields.refuse("operations", "must be a list", "Put it in brackets");
    for (const auto& operation : operations) {
      pattern.operations.push_back(
          readOperation(operation, where + " operation " + std::to_string(pattern.operations.size() + 1)));
    }
    checkOperations(pattern.operations);
  }
  fields.finish();
  return pattern;
}

Instrument readInstrument(const fs::path& assets, const std::string& id) {
  const fs::path file = assets / "instruments" / (id + ".json");
  const nlohmann::json json = readJson(file);
  JsonFields fields(json, file.string());
  Instrument instrument;
  instrument.id = fields.text("id");
  instrument.tipRadius_m = fields.number("tip_radius_mm", 0.5, 20.0) * kMillimetre;
  instrument.shaftLength_m = fields.number("shaft_length_mm", 30.0, 600.0) * kMillimetre;
  instrument.gripReach_m = fields.number("grip_reach_mm", 0.5, 30.0) * kMillimetre;
  return instrument;  // the rest of the file is for views
}

Material findMaterial(const fs::path& assets, const std::string& id, const std::string& where) {
  std::vector<std::string> known;
  for (Material& material : readMaterials(assets)) {
    if (material.id == id) return material;
    known.push_back(material.id);
  }
  throw Error(ErrorCode::kBadData, "no material is called '" + id + "'", where,
              "Choose one of " + listed(known));
}

}  // namespace

std::vector<Material> readMaterials(const fs::path& assets) {
  const fs::path file = assets / "scenes" / "materials.json";
  const nlohmann::json json = readJson(file);
  if (!json.is_array())
    throw Error(ErrorCode::kBadData, "must be a list", file.string(), "Put it in brackets");
  std::vector<Material> materials;
  for (const auto& entry : json) {
    JsonFields fields(entry, file.string() + " material " + std::to_string(materials.size() + 1));
    Material material;
    material.id = fields.text("id");
    material.title = fields.text("title");
    material.lowest_Pa = fields.number("lowest_pa", 1.0, 1e9);
    material.highest_Pa = fields.number("highest_pa", material.lowest_Pa, 1e9);
    material.shearModulus_Pa = fields.number("shear_modulus_pa", material.lowest_Pa, material.highest_Pa);
    material.source = fields.text("source");
    fields.finish();
    materials.push_back(std::move(material));
  }
  return materials;
}

SceneDescription readSceneFile(const fs::path& assets, const std::string& id) {
  const std::vector<std::string> known = sceneIds(assets);
  if (std::find(known.begin(), known.end(), id) == known.end()) {
    throw Error(ErrorCode::kFileMissing, "no scene is called '" + id + "'", (assets / "scenes").string(),
                "Choose one of " + listed(known));
  }
  const fs::path file = assets / "scenes" / (id + ".json");
  const nlohmann::json json = readJson(file);
  JsonFields fields(json, file.string());
  SceneDescription scene;
  scene.id = id;
  scene.title = fields.text("title");
  scene.provenance = fields.text("provenance");
  scene.organ = assets / fields.text("organ");
  scene.organUnit_m = lengthUnit_m(fields.text("organ_unit", "mm"));
  scene.lattice = readLattice(fields);
  scene.material = findMaterial(assets, fields.text("material"), file.string());
  scene.formulation = fields.choice("formulation", {"saint-venant", "paper"}, 0) == 0
                          ? Formulation::kSaintVenant
                          : Formulation::kPaper;
  scene.instrument = readInstrument(assets, fields.text("instrument"));
  const nlohmann::json& patterns = fields.child("patterns");
  if (!patterns.is_array() || patterns.empty())
    fields.refuse("patterns", "must list at least one", "Add a pattern");
  for (const auto& pattern : patterns) {
    scene.patterns.push_back(
        readPattern(pattern, file.string() + " pattern " + std::to_string(scene.patterns.size() + 1)));
  }
  fields.finish();
  return scene;
}

}  // namespace torsio
