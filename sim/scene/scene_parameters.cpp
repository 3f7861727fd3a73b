// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/scene_parameters.h"

#include <algorithm>
#include <array>

#include <nlohmann/json.hpp>

#include "sim/core/error.h"
#include "sim/core/foreign_recording.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/hollow_validity.h"
#include "sim/scene/json_fields.h"

namespace torsio {

namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr const char* kValidity = "validity";

constexpr std::array kModes{"harmonic", "straight-axis", "automatic"};
constexpr std::array kSpacings{"angle", "arc-length"};
constexpr std::array kAxes{"own", "line", "instrument"};
constexpr std::array kSides{"centre", "inner", "outer"};
constexpr std::array kFormulations{"saint-venant", "paper"};
constexpr std::array kEnds{"clamped-free", "both-held"};
constexpr std::array kInterpolations{"angle", "components"};
constexpr std::array kDrifts{"constant", "linear"};

template <typename Names, typename Enum>
const char* nameOf(const Names& names, Enum value) {
  return names.at(static_cast<std::size_t>(value));
}

Json toJson(const Vec3& v) {
  return {v.x, v.y, v.z};
}

Json toJson(const LatticeOptions& lattice) {
  Json json{{"mode", nameOf(kModes, lattice.mode)},
            {"spacing", nameOf(kSpacings, lattice.spacing)},
            {"fixed_end_m", toJson(lattice.fixedEnd_m)},
            {"free_end_m", toJson(lattice.freeEnd_m)},
            {"fixed_cut", toJson(lattice.fixedCut)},
            {"free_cut", toJson(lattice.freeCut)},
            {"cap_radius_m", lattice.capRadius_m},
            {"ridge_zero", toJson(lattice.ridgeZero)},
            {"ridge_zero_fraction", lattice.ridgeZeroFraction}};
  if (lattice.branchCut != Vec3{}) {  // of none nothing is said, so that the hashes of older trials stay true
    json["branch_root_m"] = toJson(lattice.branchRoot_m);
    json["branch_cut"] = toJson(lattice.branchCut);
  }
  return json;
}

Json toJson(const TurnTask& task) {
  Json json;
  json["axis"] = nameOf(kAxes, task.axis);
  if (task.axis == GripAxis::kLine) {
    json["axis_from_m"] = toJson(task.axisFrom_m);
    json["axis_to_m"] = toJson(task.axisTo_m);
  }
  if (task.measured) {
    json["measured_from_m"] = toJson(task.measured->from);
    json["measured_point_m"] = toJson(task.measured->point);
    json["measured_to_m"] = toJson(task.measured->to);
  }
  return json;
}

Json toJson(const Restraint& restraint) {
  Json json{{"id", restraint.id},
            {"from", restraint.from},
            {"to", restraint.to},
            {"count", restraint.count},
            {"side", nameOf(kSides, restraint.side)}};
  if (restraint.point_m) {
    json["point_m"] = toJson(*restraint.point_m);
  }
  if (restraint.anchor_m) {
    json["anchor_m"] = toJson(*restraint.anchor_m);
  }
  json["towards_chord"] = restraint.towardsChord;
  json["slack_m"] = restraint.slack_m;
  json["half_width_m"] = restraint.halfWidth_m;
  json["stiffness_n_per_m"] = restraint.stiffness_N_per_m;
  json["turn_nm_per_rad"] = restraint.turn_Nm_per_rad;
  return json;
}

Json toJson(const Instrument& instrument) {
  Json json{{"id", instrument.id},
            {"tip_radius_m", instrument.tipRadius_m},
            {"grip_reach_m", instrument.gripReach_m}};
  // Trials recorded before the shaft could touch know of no length: the usual one goes unsaid, so that their
  // hashes stay true.
  if (instrument.shaftLength_m != Instrument{}.shaftLength_m) {
    json["shaft_length_m"] = instrument.shaftLength_m;
  }
  return json;
}

Json toJson(const ModelChoice& model) {
  Json json = Json::object();
  const auto put = [&json](const char* name, const auto& value) {
    if (value) {
      json[name] = *value;
    }
  };
  const auto say = [&json](const char* name, bool chosen) {
    if (chosen) {
      json[name] = true;
    }
  };
  if (model.interpolation) {
    json["interpolation"] = nameOf(kInterpolations, *model.interpolation);
  }
  if (model.drift) {
    json["drift"] = nameOf(kDrifts, *model.drift);
  }
  put("beta", model.beta);
  say("clamp_lift", model.clampLift);
  say("poynting", model.poynting);
  if (model.restrainedEnds) {  // formerly true: each end as if a tenth of its radius shorter
    json["restrained_ends"] = "warping";
  }
  say("taper", model.taper);
  say("shear_centre", model.shearCentre);
  put("foundation", model.foundationLengths);
  put("stiffening", model.stiffeningStrain);
  put("shear_modulus_pa", model.shearModulus_Pa);
  return json;
}

Json toJson(const HollowWall& wall) {
  Json thickness = Json::array();
  for (const auto& [share, thickness_m] : wall.thickness_m) {
    thickness.push_back({share, thickness_m});
  }
  Json json = {{"thickness_m", thickness},
               {"gent_limit", wall.gentLimit},
               {"rest_pressure_pa", wall.restPressure_Pa},
               {"pressure_pa", wall.pressure_Pa},
               {"vent", wall.vent},
               {"vented_pressure_pa", wall.ventedPressure_Pa}};
  if (wall.sealed) {  // else as in recordings from before there was a choice
    json["sealed"] = true;
  }
  if (wall.foldsNeedRoom) {  // likewise
    json["folds_need_room"] = true;
  }
  return json;
}

Json toJson(const InitialTwist& start) {
  return {{"least_rad", start.least_rad},
          {"most_rad", start.most_rad},
          {"step_rad", start.step_rad},
          {"sign", start.sign},
          {"opposite_share", start.oppositeShare},
          {"since_s", start.since_s}};
}

Json toJson(const PerfusionParameters& vessels) {
  return {{"arterial_mmhg", vessels.arterial_mmHg},
          {"venous_mmhg", vessels.venous_mmHg},
          {"shut_at_turn_mmhg", vessels.shutAtTurn_mmHg},
          {"shut_power", vessels.shutPower},
          {"pedicle_m", vessels.pedicle_m},
          {"pedicle_reference_m", vessels.pedicleReference_m},
          {"pedicle_share", vessels.pedicleShare},
          {"lumen_threshold_mmhg", vessels.lumenThreshold_mmHg},
          {"lumen_floor", vessels.lumenFloor},
          {"flow_time_s", vessels.flowTime_s},
          {"loss_time_s", vessels.lossTime_s},
          {"enough_flow", vessels.enoughFlow}};
}

Json toJson(const DetorsionLimits& limits) {
  return {{"jaw_area_m2", limits.jawArea_m2},
          {"jaw_force_n", limits.jawForce_N},
          {"bruise_pa", limits.bruise_Pa},
          {"bruise_s", limits.bruise_s},
          {"tear_pa", limits.tear_Pa},
          {"pull_n", limits.pull_N},
          {"residual_rad", limits.residual_rad},
          {"patency", limits.patency},
          {"flow", limits.flow},
          {"hands_off_s", limits.handsOff_s}};
}

Json toJson(const Detorsion& detorsion) {
  Json json;
  if (detorsion.wall.thickness_m.empty()) {
    json["cord_stiffness_nm_per_rad"] = detorsion.cordStiffness_Nm_per_rad;
  } else {
    json["wall"] = toJson(detorsion.wall);
  }
  json["spans"] = Json::array();
  for (const WrungSpan& span : detorsion.spans) {
    json["spans"].push_back({span.held, span.mobile});
  }
  json["initial_twist"] = toJson(detorsion.start);
  json["pedicle"] = toJson(detorsion.vessels);
  json["base"] = {{"stick_share", detorsion.base.stickShare},
                  {"relapse_share", detorsion.base.relapseShare},
                  {"relapse_from_rad", detorsion.base.relapseFrom_rad},
                  {"relapse_time_s", detorsion.base.relapseTime_s}};
  json["limits"] = toJson(detorsion.limits);
  if (detorsion.stages.asked()) {
    json["stages"] = {{"turn_rad", detorsion.stages.turn_rad}, {"rest_s", detorsion.stages.rest_s}};
  }
  json["time_scale"] = detorsion.timeScale;
  return json;
}

Vec3 vectorOf(const nlohmann::json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

LatticeMode modeOf(const std::string& name) {
  const auto found = std::find(kModes.begin(), kModes.end(), name);
  if (found == kModes.end()) {
    throw Error(ErrorCode::kBadData, Text::tr("lattice mode '%1'", name), "", "");
  }
  return static_cast<LatticeMode>(found - kModes.begin());
}

}  // namespace

std::string parametersText(const SceneDescription& scene, const TwistPattern& pattern, bool usersOrgan,
                           TissueModel tissue) {
  Json json;
  json["format"] = kFormat;
  json["formulation"] = nameOf(kFormulations, scene.formulation);
  json["ridges"] = scene.lattice.ridges;
  json["sections"] = scene.lattice.sections;
  json["organ"] = usersOrgan ? "file" : "scene";
  json["organ_unit_m"] = scene.organUnit_m;
  if (!scene.organWarnings
           .empty()) {  // of none nothing is said, so that the hashes of older trials stay true
    json["organ_warnings"] = warningsJson(scene.organWarnings);
  }
  json["lattice"] = toJson(scene.lattice);
  json["material"] = {{"id", scene.material.id}, {"shear_modulus_pa", scene.material.shearModulus_Pa}};
  if (scene.model.any()) {
    json["model"] = toJson(scene.model);
  }
  json["instrument"] = toJson(scene.instrument);
  json["pattern"] = {{"id", pattern.id},
                     {"ends", nameOf(kEnds, pattern.ends)},
                     {"force_limit_n", pattern.forceLimit_N},
                     {"torque_limit_nm", pattern.torqueLimit_Nm}};
  if (pattern.task) {
    json["grasp"] = pattern.graspArc;
    json["task"] = toJson(*pattern.task);
    json["restraints"] = Json::array();
    for (const Restraint& restraint : scene.restraints) {
      json["restraints"].push_back(toJson(restraint));
    }
  }
  if (pattern.detorsion) {
    json["grasp"] = pattern.graspArc;
    json["goal"] = "detorse";
    json["detorsion"] = toJson(*pattern.detorsion);
  }
  // The model of the product goes unsaid, so that the hashes of older trials stay true.
  if (runsAsync(tissue)) {
    json["tissue_model"] = std::string(tissueModelId(tissue));
  }
  return json.dump();
}

std::string withValidity(const std::string& parameters, const HollowOrgan& organ) {
  if (organ.tube(0) == nullptr) {
    return parameters;
  }
  Json json = Json::parse(parameters);
  const ValidTurn valid = validTurn(organ);
  json[kValidity] = {{"valid_to_rad", valid.to_rad}, {"beyond", valid.beyond.str()}};
  return json.dump();
}

std::string withoutValidity(const std::string& parameters) {
  Json json = Json::parse(parameters, nullptr, false);
  if (!json.is_object() || json.erase(kValidity) == 0) {
    return parameters;
  }
  return json.dump();
}

SceneRequest sceneRequestFor(const std::string& parametersJson) {
  const auto json = nlohmann::json::parse(parametersJson, nullptr, false);
  if (json.contains(kForeignParameters)) {
    throw Error(ErrorCode::kBadData,
                Text::tr("other equipment made this recording: there is no organ to show or to recompute"),
                Text::tr("run"), Text::tr("Look at its metrics and at its path in a data set"));
  }
  try {
    SceneRequest request;
    request.recorded = parametersJson;
    request.formulation = json.at("formulation") == nameOf(kFormulations, Formulation::kPaper)
                              ? Formulation::kPaper
                              : Formulation::kSaintVenant;
    request.ridges = json.at("ridges").get<int>();
    request.sections = json.at("sections").get<int>();
    request.pattern = json.at("pattern").at("id").get<std::string>();
    request.material = json.at("material").at("id").get<std::string>();
    request.tissue =
        tissueModelOf(json.value("tissue_model", std::string(tissueModelId(TissueModel::kTwist))));
    const nlohmann::json& lattice = json.at("lattice");
    request.latticeMode = modeOf(lattice.at("mode").get<std::string>());
    if (json.at("organ") == "file") {
      request.organScale_m = json.at("organ_unit_m").get<double>();
      request.asRecorded = true;
      if (json.contains("organ_warnings")) {
        request.organWarnings = warningsOf(json.at("organ_warnings"));
      }
      request.fixedCut = vectorOf(lattice.at("fixed_cut"));
      request.freeCut = vectorOf(lattice.at("free_cut"));
      request.capRadius_m = lattice.value("cap_radius_m", 0.0);
      if (lattice.contains("branch_cut")) {
        request.branchRoot_m = vectorOf(lattice.at("branch_root_m"));
        request.branchCut = vectorOf(lattice.at("branch_cut"));
      }
      const Vec3 fixedEnd = vectorOf(lattice.at("fixed_end_m"));
      const Vec3 freeEnd = vectorOf(lattice.at("free_end_m"));
      if (fixedEnd != freeEnd) {
        request.fixedEnd_m = fixedEnd;
        request.freeEnd_m = freeEnd;
      }
    }
    return request;
  } catch (const std::exception&) {
    throw Error(ErrorCode::kBadData, Text::tr("the stored model parameters cannot be read"), Text::tr("run"),
                Text::tr("Check the database."));
  }
}

std::vector<OrganWarning> recordedOrganWarnings(const std::string& parametersJson) {
  try {
    return sceneRequestFor(parametersJson).organWarnings;
  } catch (const Error&) {
    return {};  // of a later version: the recording counts all the same
  }
}

std::vector<Text> recordedConfirmations(const std::string& parametersJson) {
  constexpr std::array kSentences = {
      std::pair(kUnitConfirmed,
                Text::tr("the unit of the positions, although another would fit a hand better")),
      std::pair(kTimeConfirmed, Text::tr("the unit of the times, although another would fit better")),
      std::pair(kScaleConfirmed, Text::tr("the scale of the scores, although they use hardly any of it"))};
  const auto json = nlohmann::json::parse(parametersJson, nullptr, false);
  std::vector<Text> confirmed;
  if (json.is_object() && json.contains(kForeignParameters)) {
    for (const auto& [key, sentence] : kSentences) {
      if (json.at(kForeignParameters).value(key, false)) {
        confirmed.emplace_back(sentence);
      }
    }
  }
  return confirmed;
}

std::optional<RecordedValidity> recordedValidity(const std::string& parametersJson) {
  const auto json = nlohmann::json::parse(parametersJson, nullptr, false);
  if (!json.is_object() || !json.contains(kValidity)) {
    return std::nullopt;
  }
  const nlohmann::json& validity = json.at(kValidity);
  try {
    return RecordedValidity{validity.at("valid_to_rad").get<double>(),
                            validity.at("beyond").get<std::string>()};
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;  // of a later version
  }
}

}  // namespace torsio
