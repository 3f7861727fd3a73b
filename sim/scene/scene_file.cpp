// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/scene_file.h"

#include <algorithm>
#include <optional>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/scene/detorsion_file.h"
#include "sim/scene/json_fields.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr double kMillimetre = 1e-3;
constexpr double kLargestAngle_deg = 3600.0;
constexpr double kLeastLine_m = 1e-3;
constexpr int kMaxSprings = 30;
constexpr double kShortestFoundation = 0.05;  // organ lengths: below it a turn does not leave the grasp

nlohmann::json readJson(const fs::path& file) {
  return nlohmann::json::parse(jsonTextIn(file));
}

/// A direction; its length does not matter, but it has one.
Vec3 readDirection(JsonFields& fields, const std::string& name) {
  const Vec3 direction = normalized(fields.vector(name));
  if (direction == Vec3{}) {
    fields.refuse(name, Text::tr("points nowhere"), Text::tr("Give a direction that is not zero."));
  }
  return direction;
}

LatticeOptions readLattice(JsonFields& parent) {
  constexpr LatticeMode kModes[] = {LatticeMode::kHarmonic, LatticeMode::kStraightAxis,
                                    LatticeMode::kAutomatic};
  JsonFields fields(parent.child("lattice"), parent.where() + " lattice");
  LatticeOptions lattice;
  lattice.ridges = fields.integer("ridges", kMinRidges, kMaxRidges, lattice.ridges);
  lattice.sections = fields.integer("sections", kMinSections, kMaxSections, lattice.sections);
  lattice.mode = kModes[fields.choice("mode", {"harmonic", "straight-axis", "automatic"}, 0)];
  lattice.spacing = fields.choice("spacing", {"arc-length", "angle"}, 0) == 0 ? RidgeSpacing::kArcLength
                                                                              : RidgeSpacing::kAngle;
  if (fields.has("fixed_end_mm") || fields.has("free_end_mm")) {
    lattice.fixedEnd_m = fields.vector("fixed_end_mm") * kMillimetre;
    lattice.freeEnd_m = fields.vector("free_end_mm") * kMillimetre;
  }
  if (fields.has("fixed_cut")) {
    lattice.fixedCut = readDirection(fields, "fixed_cut");
  }
  if (fields.has("free_cut")) {
    lattice.freeCut = readDirection(fields, "free_cut");
  }
  if (fields.has("branch_root_mm") || fields.has("branch_cut")) {
    lattice.branchRoot_m = fields.vector("branch_root_mm") * kMillimetre;
    lattice.branchCut = readDirection(fields, "branch_cut");
  }
  lattice.capRadius_m = fields.number("cap_radius_mm", 0.0, 200.0, 0.0) * kMillimetre;
  if (fields.has("ridge_zero")) {
    lattice.ridgeZero = readDirection(fields, "ridge_zero");
  }
  lattice.ridgeZeroFraction = fields.number("ridge_zero_fraction", 0.0, 1.0, 0.0);
  fields.finish();
  return lattice;
}

Landmarks readLandmarks(JsonFields& parent, const std::string& where) {
  JsonFields fields(parent.child("measured"), where + " measured");
  Landmarks marks;
  marks.from = fields.vector("from_mm") * kMillimetre;
  marks.point = fields.vector("point_mm") * kMillimetre;
  marks.to = fields.vector("to_mm") * kMillimetre;
  if (norm(cross(marks.to - marks.from, marks.point - marks.from)) < kLeastLine_m * kLeastLine_m) {
    fields.refuse("point_mm", Text::tr("lies on the line from from_mm to to_mm"),
                  Text::tr("Choose landmarks at least a millimetre apart."));
  }
  fields.finish();
  return marks;
}

TurnTask readTask(JsonFields& pattern, AxisElsewhere& elsewhere) {
  constexpr GripAxis kAxes[] = {GripAxis::kOwn, GripAxis::kLine, GripAxis::kInstrument};
  const std::string where = pattern.where() + " task";
  JsonFields fields(pattern.child("task"), where);
  TurnTask task;
  task.axis = kAxes[fields.choice("axis", {"own", "line", "instrument"}, 0)];
  if (task.axis == GripAxis::kLine) {
    task.axisFrom_m = fields.vector("axis_from_mm") * kMillimetre;
    task.axisTo_m = fields.vector("axis_to_mm") * kMillimetre;
    if (norm(task.axisTo_m - task.axisFrom_m) < kLeastLine_m) {
      fields.refuse("axis_to_mm", Text::tr("is less than a millimetre from axis_from_mm"),
                    Text::tr("Choose landmarks farther apart."));
    }
    elsewhere =
        fields.choice("elsewhere", {"ends", "bend"}, 0) == 0 ? AxisElsewhere::kEnds : AxisElsewhere::kBend;
  }
  if (fields.has("measured")) {
    task.measured = readLandmarks(fields, where);
  }
  fields.finish();
  return task;
}

Restraint readRestraint(const nlohmann::json& json, const std::string& where) {
  constexpr SectionSide kSides[] = {SectionSide::kCentre, SectionSide::kInner, SectionSide::kOuter};
  JsonFields fields(json, where);
  Restraint restraint;
  restraint.id = fields.text("id");
  if (fields.has("at")) {
    restraint.from = fields.number("at", 0.0, 1.0);
    restraint.to = restraint.from;
  } else {
    restraint.from = fields.number("from", 0.0, 1.0);
    restraint.to = fields.number("to", restraint.from, 1.0);
    restraint.count = fields.integer("count", 1, kMaxSprings, 1);
  }
  restraint.side = kSides[fields.choice("side", {"centre", "inner", "outer"}, 0)];
  if (fields.has("point_mm")) {
    restraint.point_m = fields.vector("point_mm") * kMillimetre;
  }
  if (fields.has("anchor_mm")) {
    restraint.anchor_m = fields.vector("anchor_mm") * kMillimetre;
  }
  restraint.towardsChord = fields.choice("towards", {"itself", "chord"}, 0) == 1;
  restraint.slack_m = fields.number("slack_mm", 0.0, 500.0, 0.0) * kMillimetre;
  restraint.halfWidth_m = fields.number("half_width_mm", 0.0, 100.0, 0.0) * kMillimetre;
  restraint.stiffness_N_per_m = fields.number("stiffness_n_per_mm", 0.0, 100.0, 0.0) / kMillimetre;
  restraint.turn_Nm_per_rad = fields.number("turn_nmm_per_rad", 0.0, 10'000.0, 0.0) * kMillimetre;
  restraint.source = fields.text("source");
  if (restraint.point_m && restraint.count > 1) {
    fields.refuse("point_mm", Text::tr("is one point for several springs"),
                  Text::tr("Give 'side' instead, or one spring."));
  }
  fields.finish();
  return restraint;
}

/// The parts of the model that are named after equations; those that the formulation does not know are
/// refused.
ModelChoice readModel(JsonFields& scene, Formulation formulation) {
  ModelChoice model;
  if (!scene.has("model")) {
    return model;
  }
  JsonFields fields(scene.child("model"), scene.where() + " model");
  const bool paper = formulation == Formulation::kPaper;
  for (const char* name :
       {"poynting", "restrained_ends", "taper", "shear_centre", "foundation", "stiffening"}) {
    if (paper && fields.has(name)) {
      fields.refuse(name, Text::tr("is not known to the formulation 'paper'"),
                    Text::tr("Leave it out, or choose the formulation saint-venant"));
    }
  }
  for (const char* name : {"interpolation", "beta", "clamp_lift"}) {
    if (!paper && fields.has(name)) {
      fields.refuse(name, Text::tr("is known to the formulation 'paper' only"),
                    Text::tr("Leave it out, or choose the formulation paper"));
    }
  }
  const auto numberOf = [&fields](const char* name, double low, double high) {
    return fields.has(name) ? std::optional(fields.number(name, low, high)) : std::nullopt;
  };
  if (fields.choice("interpolation", {"angle", "components"}, 0) == 1) {
    model.interpolation = PaperInterpolation::kComponents;
  }
  if (fields.choice("drift", {"linear", "constant"}, 0) == 1) {
    model.drift = Drift::kConstant;
  }
  model.beta = numberOf("beta", -1e6, 1e6);
  if (model.beta == 0.0) {
    fields.refuse("beta", Text::tr("is 0"), Text::tr("Give a number of sections, or leave it out"));
  }
  model.clampLift = fields.flag("clamp_lift", false);
  model.poynting = fields.flag("poynting", false);
  model.restrainedEnds = fields.flag("restrained_ends", false);
  model.taper = fields.flag("taper", false);
  model.shearCentre = fields.flag("shear_centre", false);
  model.foundationLengths = numberOf("foundation", kShortestFoundation, 100.0);
  model.stiffeningStrain = numberOf("stiffening", 1e-3, 100.0);
  model.shearModulus_Pa = numberOf("shear_modulus_pa", kSoftest_Pa, kStiffest_Pa);
  fields.finish();
  return model;
}

std::vector<Restraint> readRestraints(JsonFields& scene) {
  std::vector<Restraint> restraints;
  if (!scene.has("restraints")) {
    return restraints;
  }
  const nlohmann::json& list = scene.child("restraints");
  if (!list.is_array()) {
    scene.refuse("restraints", Text::tr("must be a list"), Text::tr("Put it in brackets."));
  }
  for (const auto& entry : list) {
    restraints.push_back(
        readRestraint(entry, scene.where() + " restraint " + std::to_string(restraints.size() + 1)));
  }
  return restraints;
}

PatternDescription readPattern(const nlohmann::json& json, const std::string& where) {
  JsonFields fields(json, where);
  PatternDescription description;
  TwistPattern& pattern = description.pattern;
  pattern.id = fields.text("id");
  pattern.title = fields.text("title");
  pattern.ends = fields.choice("ends", {"clamped-free", "both-held"}, 0) == 0 ? EndCondition::kClampedFree
                                                                              : EndCondition::kBothHeld;
  pattern.graspArc = fields.number("grasp", 0.01, 1.0);
  pattern.targetAngle_rad = radians(fields.number("angle_deg", -kLargestAngle_deg, kLargestAngle_deg));
  pattern.tolerance_rad = radians(fields.number("tolerance_deg", 0.1, 90.0));
  pattern.forceLimit_N = fields.number("force_limit_n", 0.1, 100.0);
  pattern.torqueLimit_Nm = fields.number("torque_limit_nm", 0.001, 100.0);
  pattern.source = fields.text("source");
  if (fields.has("task")) {
    pattern.task = readTask(fields, description.elsewhere);
  }
  pattern.detorsion = readGoal(fields);
  if (pattern.detorsion && pattern.targetAngle_rad != 0.0) {
    fields.refuse("angle_deg", Text::tr("is not 0, but the organ comes twisted"),
                  Text::tr("Give 'angle_deg' 0."));
  }
  const bool asRod = pattern.task && pattern.detorsion;
  if (asRod && (pattern.task->axis != GripAxis::kLine || pattern.task->measured)) {
    fields.refuse("task", Text::tr("turns an organ that comes twisted otherwise than about a line"),
                  Text::tr("Give 'axis' line, and leave out 'measured'."));
  }
  fields.finish();
  return description;
}

std::vector<PatternDescription> readPatterns(JsonFields& scene) {
  const nlohmann::json& list = scene.child("patterns");
  if (!list.is_array() || list.empty()) {
    scene.refuse("patterns", Text::tr("must list at least one"), Text::tr("Add a pattern."));
  }
  std::vector<PatternDescription> patterns;
  for (const auto& entry : list) {
    const std::string where = scene.where() + " pattern " + std::to_string(patterns.size() + 1);
    PatternDescription next = readPattern(entry, where);
    for (const PatternDescription& other : patterns) {
      if (other.pattern.id == next.pattern.id) {
        throw Error(ErrorCode::kBadData, Text::tr("the id '%1' is used twice", next.pattern.id), where,
                    Text::tr("Rename one."));
      }
    }
    patterns.push_back(std::move(next));
  }
  return patterns;
}

SceneDescription readScene(const fs::path& assets, const fs::path& file, const std::string& id) {
  const nlohmann::json json = readJson(file);
  JsonFields fields(json, file.string());
  SceneDescription scene;
  scene.id = id;
  scene.title = fields.text("title");
  scene.provenance = fields.text("provenance");
  if (id != kOwnOrganScene) {
    scene.organ = assets / fields.text("organ");
  }
  scene.organUnit_m = lengthUnit_m(fields.text("organ_unit", "mm"));
  scene.lattice = readLattice(fields);
  scene.material = findMaterial(assets, fields.text("material"), ErrorCode::kBadData, file.string());
  scene.formulation = fields.choice("formulation", {"saint-venant", "paper"}, 0) == 0
                          ? Formulation::kSaintVenant
                          : Formulation::kPaper;
  scene.model = readModel(fields, scene.formulation);
  scene.instrument = readInstrument(assets, fields.text("instrument"));
  scene.restraints = readRestraints(fields);
  scene.patterns = readPatterns(fields);
  fields.finish();
  return scene;
}

}  // namespace

Instrument readInstrument(const fs::path& assets, const std::string& id) {
  const fs::path file = assets / "instruments" / (id + ".json");
  const nlohmann::json json = readJson(file);
  JsonFields fields(json, file.string());
  Instrument instrument;
  instrument.id = fields.text("id");
  instrument.tipRadius_m =
      fields.number("tip_radius_mm", kInstrumentTip_mm.least, kInstrumentTip_mm.most) * kMillimetre;
  instrument.shaftLength_m =
      fields.number("shaft_length_mm", instrumentLength_mm().least, instrumentLength_mm().most) * kMillimetre;
  instrument.gripReach_m =
      fields.number("grip_reach_mm", kInstrumentReach_mm.least, kInstrumentReach_mm.most) * kMillimetre;
  return instrument;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

Material findMaterial(const fs::path& assets, const std::string& id, ErrorCode code,
                      const std::string& where) {
  std::vector<std::string> known;
  for (Material& material : readMaterials(assets)) {
    if (material.id == id) {
      return material;
    }
    known.push_back(material.id);
  }
  throw Error(code, Text::tr("no material is called '%1'", id), where,
              Text::tr("Choose one of %1.", listed(known)));
}

std::vector<Material> readMaterials(const fs::path& assets) {
  const fs::path file = assets / "scenes" / "materials.json";
  const nlohmann::json json = readJson(file);
  if (!json.is_array()) {
    throw Error(ErrorCode::kBadData, Text::tr("must be a list"), file.string(),
                Text::tr("Put it in brackets."));
  }
  std::vector<Material> materials;
  for (const auto& entry : json) {
    JsonFields fields(entry, file.string() + " material " + std::to_string(materials.size() + 1));
    Material material;
    material.id = fields.text("id");
    material.title = fields.text("title");
    material.lowest_Pa = fields.number("lowest_pa", kSoftest_Pa, kStiffest_Pa);
    material.highest_Pa = fields.number("highest_pa", material.lowest_Pa, kStiffest_Pa);
    material.shearModulus_Pa = fields.number("shear_modulus_pa", material.lowest_Pa, material.highest_Pa);
    material.source = fields.text("source");
    fields.finish();
    materials.push_back(std::move(material));
  }
  return materials;
}

SceneDescription readSceneFile(const fs::path& assets, const std::string& id) {
  const bool own = id == kOwnOrganScene;
  const std::vector<std::string> known = sceneIds(assets);
  if (!own && std::find(known.begin(), known.end(), id) == known.end()) {
    throw Error(ErrorCode::kFileMissing, Text::tr("no scene is called '%1'", id),
                (assets / "scenes").string(), Text::tr("Choose one of %1.", listed(known)));
  }
  return readScene(assets, assets / "scenes" / (own ? "own" : "") / (id + ".json"), id);
}

fs::path organMarkersFile(const fs::path& assets, const Scene& scene) {
  const std::vector<std::string> known = sceneIds(assets);
  if (scene.former || std::find(known.begin(), known.end(), scene.id) == known.end()) {
    return {};
  }
  const SceneDescription description = readSceneFile(assets, scene.id);
  if (scene.provenance != description.provenance) {
    return {};  // an organ of the user's with the patterns of this scene
  }
  fs::path file = description.organ;
  file.replace_filename(description.organ.stem().string() + "_markers.json");
  return file;
}

std::vector<SceneDescription> readFormerScenes(const fs::path& assets, const std::string& id) {
  std::vector<SceneDescription> scenes;
  std::string name = id;
  std::error_code failed;
  while (fs::exists(assets / "scenes" / "former" / (name + ".json"), failed)) {
    scenes.push_back(readScene(assets, assets / "scenes" / "former" / (name + ".json"), id));
    name = id + "-" + std::to_string(scenes.size() + 1);
  }
  return scenes;
}

}  // namespace torsio
