// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/cli/rod_twist.h"
#include "app/cli/wall_twist.h"
#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/geometry/mesh/mesh_file_check.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/organ_file.h"
#include "sim/scene/pattern_judgement.h"
#include "sim/scene/rod_organ.h"
#include "sim/scene/scene.h"
#include "sim/tissue/hollow/wrung_organ.h"
#include "sim/tissue/rod/fold_check.h"

namespace torsio::cli {

namespace {

using SteadyClock = std::chrono::steady_clock;

struct TwistArguments {
  OrganArguments organ;
  std::optional<double> angle_deg;
  std::optional<double> grasp;
  std::string ends;  // empty: a pattern of the scene
  ModelArguments model;
  std::optional<double> poisson;
  bool jaw = false;
  bool reference = false;
  std::string referenceElements;  // empty: wedges
  std::string wall;               // for a hollow organ; empty: solid
  bool ownWall = false;           // the organ's, which was not asked for
  std::optional<double> pressure_mmHg;
  std::optional<double> restPressure_mmHg;
  bool sealed = false;
  bool allowFold = false;
  std::string out;
  bool json = false;
};

double millisecondsSince(SteadyClock::time_point start) {
  return std::chrono::duration<double, std::milli>(SteadyClock::now() - start).count();
}

double graspOf(const TwistArguments& arguments, const Scene& scene) {
  const double whole = arguments.ends.empty() ? scene.pattern.graspArc : 1.0;
  const double grasp = arguments.grasp.value_or(whole);
  if (!(grasp > 0.0 && grasp <= 1.0)) {
    refuseParameter(Text::verbatim("the grasp must lie in (0, 1], as a fraction of the organ's length"),
                    "--grasp " + std::to_string(grasp), Text::verbatim("Give a fraction such as 0.8"));
  }
  return grasp;
}

double angleOf_rad(const TwistArguments& arguments, const Scene& scene) {
  const double angle_rad =
      arguments.angle_deg ? radians(*arguments.angle_deg) : scene.pattern.targetAngle_rad;
  constexpr double kLargestAngle_deg = 3600.0;
  if (!(std::abs(angle_rad) <= radians(kLargestAngle_deg))) {
    refuseParameter(Text::verbatim("the angle must lie within 3600 degrees"),
                    "--angle " + std::to_string(arguments.angle_deg.value_or(0.0)),
                    Text::verbatim("Give the angle in degrees"));
  }
  return angle_rad;
}

void requireUnfolded(const FoldReport& fold, const TwistArguments& arguments) {
  if (fold.folded() && !arguments.allowFold) {
    throw Error(ErrorCode::kFolded, Text::verbatim("the twist folds the organ: %1", fold.reason()),
                Text::tr("organ %1", arguments.organ.organ),
                Text::verbatim("Twist less far, or give --allow-fold to see it all the same"));
  }
}

void addFold(nlohmann::ordered_json& result, const FoldReport& fold) {
  result["volume_ratio"] = fold.volumeRatio;
  result["det_f_min"] = fold.minDeterminant;
  result["det_f_max"] = fold.maxDeterminant;
  result["crossings"] = fold.crossings;
  result["folded"] = fold.folded();
  if (fold.folded()) {
    result["fold"] = fold.reason().str();
  }
}

/// A wall folds by design, and contents may escape: for a hollow organ `folded` tells whether the wall folds.
void addWallFolds(nlohmann::ordered_json& result, const FoldReport& fold, const HollowOrgan& organ,
                  const OrganState& state) {
  addFold(result, fold);
  result.erase("fold");
  result["folded"] = organ.tube(0) != nullptr &&
                     std::abs(state.twist.graspAngle_rad) > organ.onset_rad(state.hollow.reading.pressure_Pa);
}

/// The limit that the answer passes, and how far a folding wall's torque is off where it passes none.
void addValidity(nlohmann::ordered_json& result, const WallValidity& validity) {
  result["valid"] = validity.beyond.empty();
  if (!validity.beyond.empty()) {
    result["beyond"] = validity.beyond.str();
  } else if (validity.torqueError) {
    result["torque_error_range"] = *validity.torqueError;
  }
}

void addOrgan(nlohmann::ordered_json& result, const Scene& scene, const TwistArguments& arguments) {
  result["organ"] = arguments.organ.organ;
  if (scene.repairs.any()) {
    result["repairs"] = scene.repairs.text();
  }
  for (const OrganWarning& warning : scene.organWarnings) {
    result["organ_warnings"].push_back(coded(warning).str());
  }
}

void writeSurface(const TwistArguments& arguments, TriangleMesh mesh, std::vector<Vec3> vertices_m) {
  if (arguments.out.empty()) {
    return;
  }
  mesh.vertices_m = std::move(vertices_m);
  const std::filesystem::path out = arguments.out;
  lowerExtension(out) == "obj" ? writeObj(out, mesh) : writePly(out, mesh);
}

void print(const nlohmann::ordered_json& result, bool json) {
  if (json) {
    std::cout << jsonText(result) << '\n';
    return;
  }
  for (const auto& [key, value] : result.items()) {
    if (!value.is_array()) {
      std::cout << key << " = " << jsonText(value, -1) << '\n';
    }
  }
}

/// Initial angle of an organ that is twisted already: the given one, or the smallest of its trials.
OrganState hollowState(const TwistArguments& arguments, const Scene& scene) {
  if (arguments.grasp) {
    refuseUsage("the mobile part of this organ turns as a whole", "--grasp", "Leave it out.");
  }
  const InitialTwist& start = scene.hollow->detorsion().start;
  return scene.stateAt(arguments.angle_deg ? angleOf_rad(arguments, scene) : start.sign * start.least_rad);
}

/// Turns the organ as in the pattern's task until the measured angle is reached.
TaskPoint taskPoint(const TwistArguments& arguments, const Scene& scene) {
  const double angle_rad = angleOf_rad(arguments, scene);
  if (!arguments.grasp && reaches(scene.rod->path(), angle_rad)) {
    return atAngle(scene.rod->path(), angle_rad);
  }
  TurnEnd end = TurnEnd::kThere;
  const std::vector<TaskPoint> path =
      scene.rod->follow(graspOf(arguments, scene), angle_rad, arguments.allowFold, &end);
  if (!reaches(path, angle_rad)) {
    throw Error(ErrorCode::kFolded, turnEndsAt(path.back().angle_rad, end),
                Text::tr("organ %1", arguments.organ.organ), Text::verbatim("Twist less far."));
  }
  return atAngle(path, angle_rad);
}

void runPattern(const TwistArguments& arguments, const Scene& scene, double setUp_ms) {
  const double length_m = scene.lattice().length_m();
  OrganState state;
  nlohmann::ordered_json effect;
  const auto deforming = SteadyClock::now();
  if (scene.hollow) {
    state = hollowState(arguments, scene);
    effect = hollowResult(*scene.hollow, state);
  } else if (scene.rod) {
    const TaskPoint point = taskPoint(arguments, scene);
    state = {{graspOf(arguments, scene) * length_m, point.angle_rad}, point.pose};
    effect = taskResult(scene, point);
  } else {
    state.twist = {graspOf(arguments, scene) * length_m, angleOf_rad(arguments, scene)};
    effect = modelResult(scene, state.twist);
  }
  std::vector<Vec3> twisted = scene.mesh.vertices_m;
  scene.deform(state, twisted);
  const double deform_ms = millisecondsSince(deforming);
  const FoldReport fold = foldOf(scene, FoldCheck(scene.mesh, scene.lattice()), state);
  if (!scene.hollow) {
    requireUnfolded(fold, arguments);  // a wall folds by design
  }
  writeSurface(arguments, scene.mesh, std::move(twisted));

  nlohmann::ordered_json result;
  addOrgan(result, scene, arguments);
  result["pattern"] = scene.pattern.id;
  result["formulation"] = scene.model.options().formulation == Formulation::kPaper ? "paper" : "saint-venant";
  result["body"] = scene.hollow ? "hollow" : scene.rod ? "rod" : "bar";
  result["ridges"] = scene.lattice().ridges();
  result["sections"] = scene.lattice().sections();
  result["patches"] = scene.lattice().patches();
  result["length_m"] = length_m;
  result["grasp_s_m"] = state.twist.graspArc_m;
  result.update(effect);
  if (scene.hollow) {
    addWallFolds(result, fold, *scene.hollow, state);
  } else {
    addFold(result, fold);
  }
  addValidity(result, validityOf(scene, fold, state));
  result["peak_shear_pa"] = scene.peakShear_Pa(state);
  result["set_up_ms"] = setUp_ms;
  result["deform_ms"] = deform_ms;
  if (!arguments.out.empty()) {
    result["out"] = arguments.out;
  }
  result["profile"] = scene.hollow ? hollowProfile(scene, state)
                      : scene.rod  ? twistProfile(scene, state.pose)
                                   : angleProfile(scene.model, state.twist);
  print(result, arguments.json);
}

/// Largest difference of two profiles relative to the angle.
double profileError(const RodTwistResult& twist, const TwistReference& reference, double angle_rad) {
  double worst_rad = 0.0;
  for (std::size_t j = 0; j < twist.turn_rad.size(); ++j) {
    worst_rad = std::max(worst_rad, std::abs(twist.turn_rad[j] - reference.turn_rad[j]));
  }
  return worst_rad / std::abs(angle_rad);
}

void addReference(nlohmann::ordered_json& result, const RodTwistResult& twist, double angle_rad) {
  if (!twist.reference) {
    return;
  }
  result["reference_elements"] =
      twist.reference->elements == ReferenceElements::kTetrahedra ? "tetrahedra" : "wedges";
  result["reference_unknowns"] = twist.reference->unknowns;
  result["reference_torque_nm"] = twist.reference->torque_Nm;
  result["reference_energy_j"] = twist.reference->energy_J;
  if (angle_rad != 0.0) {
    result["torque_error"] = twist.torque_Nm / twist.reference->torque_Nm - 1.0;
    result["profile_error"] = profileError(twist, *twist.reference, angle_rad);
  }
}

void checkRodArguments(const TwistArguments& arguments) {
  if (arguments.ends == "clamped-turned" && (arguments.grasp || arguments.jaw)) {
    refuseUsage("with --ends clamped-turned the upper face is turned, nothing is gripped",
                std::string(arguments.jaw ? "--jaw" : "--grasp"),
                "Leave it out, or give --ends clamped-free");
  }
  ModelChoice others = modelChoice(arguments.model);
  others.restrainedEnds = others.taper = false;  // what the held ends of a rod always have
  if (others.ofBar()) {
    refuseUsage("these options change the model of a pattern, not the rod", "--ends " + arguments.ends,
                "Leave out --ends, or the options of the model");
  }
}

RodTwistRequest rodRequest(const TwistArguments& arguments, const Scene& scene) {
  constexpr double kReferencePoisson = 0.45;  // the elements cannot represent 0.5
  RodTwistRequest request;
  request.ends = arguments.ends == "clamped-free" ? RodEnds::kClampedFree : RodEnds::kClampedTurned;
  request.shearModulus_Pa =
      arguments.model.choice.shearModulus_Pa.value_or(scene.model.material().shearModulus_Pa);
  request.poisson = arguments.poisson.value_or(arguments.reference ? kReferencePoisson : request.poisson);
  request.angle_rad = angleOf_rad(arguments, scene);
  request.grasp = graspOf(arguments, scene);
  request.jaw = arguments.jaw;
  request.reference = arguments.reference;
  if (arguments.referenceElements == "tetrahedra") {
    request.referenceElements = ReferenceElements::kTetrahedra;
  }
  if (!arguments.wall.empty()) {
    request.wall = wallMap(arguments.wall);
  }
  if (request.reference && request.ends == RodEnds::kClampedFree) {
    request.jaw = true;  // a single face inside a body cannot be turned, so the reference has a jaw
  }
  return request;
}

/// Adds what a wall does; returns how far its law holds.
WallValidity addWall(nlohmann::ordered_json& result, const TwistArguments& arguments, const Scene& scene,
                     const RodTwistRequest& rod) {
  WallTwistRequest request;
  request.pressure_Pa = pressureOf_Pa("--pressure-mmhg", arguments.pressure_mmHg.value_or(0.0));
  request.restPressure_Pa = pressureOf_Pa(
      "--rest-pressure-mmhg", arguments.restPressure_mmHg.value_or(arguments.pressure_mmHg.value_or(0.0)));
  request.sealed = arguments.sealed;
  request.ofOrgan = arguments.ownWall;
  const WallTwistResult wall = wallTwist(scene, rod, request);
  result["taut_torque_nm"] = result["torque_nm"];
  result["torque_nm"] = wall.torque_Nm;
  result["peak_torque_nm"] = wall.peakTorque_Nm;
  result["pressure_mmhg"] = wall.pressure_Pa / kPascalsPerMmHg;
  result["patency"] = wall.patency;
  result["waist_mm"] = 1000.0 * wall.waist_m;
  result["waist_place"] = wall.waistPlace;
  result["onset_deg"] = degrees(wall.onset_rad);
  result["closing_deg"] = degrees(wall.closing_rad);
  result["shortening_mm"] = 1000.0 * wall.shortening_m;
  result["fold_waves"] = wall.waves;
  result["wall_ms"] = wall.setUp_ms;
  return wall.validity;
}

/// Whether an angle lies within what an accepted organ is asked for: the pattern's target, and half a turn.
/// There held ends always have an answer, valid or not.
bool accepted(const Scene& scene, double angle_rad) {
  return std::abs(angle_rad) <= std::max(kPi, std::abs(scene.pattern.targetAngle_rad));
}

void runRod(const TwistArguments& arguments, const Scene& scene, double setUp_ms) {
  checkRodArguments(arguments);
  const RodTwistRequest request = rodRequest(arguments, scene);
  const auto twisting = SteadyClock::now();
  RodTwistResult twist = rodTwist(scene, request);
  const double twist_ms = millisecondsSince(twisting);
  if (arguments.wall.empty() && !accepted(scene, request.angle_rad)) {
    requireUnfolded(twist.fold, arguments);
  }
  writeSurface(arguments, scene.mesh, std::move(twist.vertices_m));

  nlohmann::ordered_json result;
  addOrgan(result, scene, arguments);
  result["model"] = arguments.wall.empty() ? "rod" : "hollow";
  result["ends"] = arguments.ends;
  result["shear_modulus_pa"] = request.shearModulus_Pa;
  result["nu"] = request.poisson;
  result["elements"] = twist.elements;
  result["sections"] = scene.lattice().sections();
  result["length_m"] = scene.lattice().length_m();
  result["grasp_s_m"] = request.grasp * scene.lattice().length_m();
  result["jaw"] = request.jaw;
  result["angle_rad"] = twist.angle_rad;
  result["torque_nm"] = twist.torque_Nm;
  result["energy_j"] = twist.energy_J;
  result["inverse_m"] = twist.inverse_m;
  WallValidity validity{twist.beyond, {}};
  if (!arguments.wall.empty()) {
    validity = addWall(result, arguments, scene, request);
  }
  addReference(result, twist, twist.angle_rad);
  addFold(result, twist.fold);
  addValidity(result, validity);
  result["set_up_ms"] = setUp_ms;
  result["twist_ms"] = twist_ms;
  if (!arguments.out.empty()) {
    result["out"] = arguments.out;
  }
  result["profile"] = turnProfile(twist);
  print(result, arguments.json);
}

void checkWallArguments(const TwistArguments& arguments) {
  const bool content = arguments.pressure_mmHg || arguments.restPressure_mmHg || arguments.sealed;
  if (arguments.wall.empty() && content) {
    refuseUsage("a pressure needs a wall", "--pressure-mmhg, --rest-pressure-mmhg or --sealed",
                "Give --wall too, or leave it out");
  }
  if (!arguments.wall.empty() && (arguments.ends.empty() || arguments.reference)) {
    throw Error(ErrorCode::kUsage,
                arguments.ends.empty() ? Text::verbatim("a wall requires --ends")
                                       : Text::verbatim("the reference is a solid organ"),
                Text::verbatim("--wall"),
                Text::verbatim("Give --ends, without --reference, or leave out --wall"));
  }
}

void runTwist(TwistArguments arguments) {
  const bool organFile = isOrganFile(arguments.organ.organ);  // it may define its wall
  if (!organFile) {
    checkWallArguments(arguments);
  }
  if (arguments.ends.empty() && arguments.poisson) {
    refuseUsage("a pattern is computed without Poisson's ratio", "--nu", "Give --ends too, or leave it out");
  }
  if (arguments.ends.empty() && (arguments.jaw || arguments.reference)) {
    refuseUsage("a pattern has neither a jaw nor a reference",
                std::string(arguments.jaw ? "--jaw" : "--reference"), "Give --ends too, or leave it out");
  }
  if (!arguments.referenceElements.empty() && !arguments.reference) {
    refuseUsage("there is no reference to make of elements", "--reference-elements", "Give --reference too");
  }
  if (arguments.reference) {
    constexpr int kReferenceRidges = 16;
    constexpr int kReferenceSections = 61;
    arguments.organ.ridges = arguments.organ.ridges.value_or(kReferenceRidges);
    arguments.organ.sections = arguments.organ.sections.value_or(kReferenceSections);
  }
  const auto started = SteadyClock::now();
  SceneRequest request = sceneRequest(arguments.organ);
  if (arguments.ends.empty()) {
    request.model = modelChoice(arguments.model);
  }
  request.tellOnly = arguments.allowFold;
  const Scene scene = loadScene(request);
  for (const OrganWarning& warning : scene.organWarnings) {
    std::cerr << "Warning: " << coded(warning) << '\n';
  }
  if (!arguments.ends.empty() && !arguments.reference && arguments.wall.empty()) {
    arguments.wall = wallWords(scene);
    arguments.ownWall = true;
  }
  if (organFile) {
    checkWallArguments(arguments);
  }
  const double setUp_ms = millisecondsSince(started);
  arguments.ends.empty() ? runPattern(arguments, scene, setUp_ms) : runRod(arguments, scene, setUp_ms);
}

}  // namespace

void addTwist(CLI::App& program) {
  auto arguments = std::make_shared<TwistArguments>();
  CLI::App* command = program.add_subcommand("twist", "Twist an organ and print angles, torque and volume");
  addOrganOptions(*command, arguments->organ);
  addModelOptions(*command, arguments->model);
  command->add_option("--angle", arguments->angle_deg,
                      "Angle at the grasp in degrees; default: the pattern's target");
  command->add_option("--grasp", arguments->grasp,
                      "Position of the grasp, fraction of the length from the fixed end");
  command
      ->add_option(
          "--ends", arguments->ends,
          "Twist the organ as a curved rod: clamped-turned (the upper face is turned about its tangent, "
          "its place held) or clamped-free (the section at --grasp is turned); default: the pattern")
      ->check(CLI::IsMember({"clamped-turned", "clamped-free"}));
  command->add_option("--shear-modulus", arguments->model.choice.shearModulus_Pa,
                      "G in pascal; default: the material's");
  command->add_option("--nu", arguments->poisson,
                      "Poisson's ratio, with --ends: E = 2 G (1 + nu); default: 0.5");
  command->add_flag(
      "--jaw", arguments->jaw,
      "With --ends clamped-free: turn the sections within half a local radius of the grasp as one");
  command->add_flag(
      "--reference", arguments->reference,
      "With --ends: also compute quadratic neo-Hookean elements, and print the difference from the rod");
  command
      ->add_option("--reference-elements", arguments->referenceElements,
                   "With --reference: wedges or tetrahedra on the same points; default: wedges")
      ->check(CLI::IsMember({"wedges", "tetrahedra"}));
  command
      ->add_option("--wall", arguments->wall,
                   "With --ends: the organ is hollow, with a wall of this thickness in mm; or along its "
                   "length, as fractions and mm: 0:2,1:5")
      ->check([](const std::string& text) {
        return std::string(text.empty() ? "an empty word is not a thickness" : "");
      });
  command->add_option("--pressure-mmhg", arguments->pressure_mmHg,
                      "With --wall: pressure inside minus outside; default: 0");
  command->add_option("--rest-pressure-mmhg", arguments->restPressure_mmHg,
                      "With --wall: pressure at which the surface is drawn; default: --pressure-mmhg");
  command->add_flag("--sealed", arguments->sealed,
                    "With --wall: the gas stays inside, so that the pressure rises as the organ is twisted");
  command->add_flag("--allow-fold", arguments->allowFold, "Also show a twist that folds the organ");
  command->add_option("--out", arguments->out,
                      "Write the twisted surface as PLY or OBJ, by its ending (millimetres)");
  command->add_flag("--json", arguments->json, "Print JSON with the angle at every section");
  command->callback([arguments] { runTwist(*arguments); });
}

}  // namespace torsio::cli
