// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/scene.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "sim/base/digest.h"
#include "sim/base/error.h"
#include "sim/geometry/mesh_import.h"
#include "sim/scene/scene_file.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

nlohmann::ordered_json toJson(const Vec3& v) {
  return {v.x, v.y, v.z};
}

nlohmann::ordered_json toJson(const TwistOperation& operation) {
  nlohmann::ordered_json json;
  json["axis"] = operation.axis == TwistAxis::kStraight ? "straight" : "centreline";
  json["axis_from_m"] = toJson(operation.axisFrom_m);
  json["axis_to_m"] = toJson(operation.axisTo_m);
  json["coordinate"] = static_cast<int>(operation.coordinate);
  json["profile"] = static_cast<int>(operation.profile);
  json["from"] = operation.from;
  json["to"] = operation.to;
  if (operation.peak) json["peak"] = *operation.peak;
  json["ratio"] = operation.ratio;
  return json;
}

/// Everything that decides what the model answers, in a fixed order: the text is hashed and stored with
/// trials.
std::string parametersOf(const SceneDescription& scene, const TwistPattern& pattern) {
  nlohmann::ordered_json json;
  json["format"] = 1;
  json["formulation"] = scene.formulation == Formulation::kPaper ? "paper" : "saint-venant";
  json["ridges"] = scene.lattice.ridges;
  json["sections"] = scene.lattice.sections;
  json["lattice"] = {{"mode", static_cast<int>(scene.lattice.mode)},
                     {"spacing", static_cast<int>(scene.lattice.spacing)},
                     {"fixed_end_m", toJson(scene.lattice.fixedEnd_m)},
                     {"free_end_m", toJson(scene.lattice.freeEnd_m)},
                     {"fixed_cut", toJson(scene.lattice.fixedCut)},
                     {"free_cut", toJson(scene.lattice.freeCut)},
                     {"cap_radius_m", scene.lattice.capRadius_m},
                     {"ridge_zero", toJson(scene.lattice.ridgeZero)},
                     {"ridge_zero_fraction", scene.lattice.ridgeZeroFraction}};
  json["material"] = {{"id", scene.material.id}, {"shear_modulus_pa", scene.material.shearModulus_Pa}};
  json["instrument"] = {{"id", scene.instrument.id},
                        {"tip_radius_m", scene.instrument.tipRadius_m},
                        {"grip_reach_m", scene.instrument.gripReach_m}};
  json["pattern"] = {{"id", pattern.id},
                     {"ends", pattern.ends == EndCondition::kBothHeld ? "both-held" : "clamped-free"},
                     {"force_limit_n", pattern.forceLimit_N},
                     {"torque_limit_nm", pattern.torqueLimit_Nm}};
  json["operations"] = nlohmann::ordered_json::array();
  for (const TwistOperation& operation : pattern.operations) json["operations"].push_back(toJson(operation));
  return json.dump();
}

TwistPattern chosenPattern(const SceneDescription& scene, const std::string& id) {
  if (id.empty()) return scene.patterns.front();
  std::string names;
  for (const TwistPattern& pattern : scene.patterns) {
    if (pattern.id == id) return pattern;
    names += (names.empty() ? "" : ", ") + pattern.id;
  }
  throw Error(ErrorCode::kBadParameter, "scene '" + scene.id + "' has no pattern '" + id + "'", "",
              "Choose one of " + names);
}

/// A mesh of the user's: its ends are found, and operations that name landmarks of the shipped organ are
/// dropped.
void replaceOrgan(SceneDescription& scene, const SceneRequest& request) {
  scene.organ = *request.organFile;
  scene.organUnit_m = request.organScale_m;
  scene.title = scene.organ.filename().string();
  scene.provenance = "the user's mesh " + scene.organ.filename().string();
  const LatticeOptions shipped = scene.lattice;
  scene.lattice = LatticeOptions{};
  scene.lattice.ridges = shipped.ridges;
  scene.lattice.sections = shipped.sections;
  const auto namesLandmarks = [](const TwistPattern& pattern) {
    return std::any_of(pattern.operations.begin(), pattern.operations.end(),
                       [](const TwistOperation& o) { return o.axis == TwistAxis::kStraight; });
  };
  std::erase_if(scene.patterns, namesLandmarks);
  if (scene.patterns.empty()) {
    throw Error(ErrorCode::kBadParameter,
                "every pattern of scene '" + scene.id + "' turns about its own landmarks",
                scene.organ.string(), "Use the scene 'arm' with your mesh");
  }
}

}  // namespace

std::vector<std::string> sceneIds(const fs::path& assets) {
  std::vector<std::string> ids;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(assets / "scenes", failed)) {
    if (entry.path().extension() == ".json" && entry.path().stem() != "materials") {
      ids.push_back(entry.path().stem().string());
    }
  }
  if (failed) {
    throw Error(ErrorCode::kFileMissing, "no scenes here", (assets / "scenes").string(),
                "Check the assets folder");
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

SceneRequest sceneRequestFor(const std::string& parametersJson) {
  try {
    const auto json = nlohmann::json::parse(parametersJson);
    SceneRequest request;
    request.formulation = json.at("formulation") == "paper" ? Formulation::kPaper : Formulation::kSaintVenant;
    request.ridges = json.at("ridges").get<int>();
    request.sections = json.at("sections").get<int>();
    request.pattern = json.at("pattern").at("id").get<std::string>();
    return request;
  } catch (const nlohmann::json::exception&) {
    throw Error(ErrorCode::kBadData, "the stored model parameters cannot be read", "trial",
                "Check the database");
  }
}

Scene loadScene(const SceneRequest& request) {
  SceneDescription description = readSceneFile(request.assets, request.id);
  if (request.organFile) replaceOrgan(description, request);
  if (request.ridges) description.lattice.ridges = *request.ridges;
  if (request.sections) description.lattice.sections = *request.sections;
  if (request.formulation) description.formulation = *request.formulation;
  const TwistPattern pattern = chosenPattern(description, request.pattern);

  MeshImportOptions import;
  import.scale_m = description.organUnit_m;
  TriangleMesh mesh = importMesh(description.organ, import);
  const SectionLattice lattice(mesh, description.lattice);
  TwistModelOptions options;
  options.formulation = description.formulation;
  options.ends = pattern.ends;
  options.operations = pattern.operations;
  TwistModel model(mesh, lattice, description.material, options);
  CollisionMesh collision(mesh);
  const std::string parameters = parametersOf(description, pattern);
  Digest digest;
  digest.update(parameters);
  std::string organHash = contentHash(mesh);
  return Scene{description.id,
               description.title,
               description.provenance,
               std::move(organHash),
               digest.hex(),
               parameters,
               std::move(mesh),
               std::move(collision),
               std::move(model),
               description.instrument,
               pattern,
               description.patterns};
}

}  // namespace torsio
