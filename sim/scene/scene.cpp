// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/scene.h"

#include <algorithm>
#include <future>
#include <system_error>
#include <utility>

#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/geometry/apart/mesh_process.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/mesh/mesh_space.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/organ_file.h"
#include "sim/scene/organ_import.h"
#include "sim/scene/pattern_judgement.h"
#include "sim/scene/rod_organ.h"
#include "sim/scene/scene_file.h"
#include "sim/scene/scene_parameters.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> idsOf(const SceneDescription& scene) {
  std::vector<std::string> ids;
  for (const PatternDescription& description : scene.patterns) {
    ids.push_back(description.pattern.id);
  }
  return ids;
}

/// Index of the requested pattern in the scene; the number of patterns if it has no such one.
std::size_t placeOfPattern(const SceneDescription& scene, const std::string& id) {
  if (id.empty()) {
    return 0;
  }
  const std::vector<std::string> ids = idsOf(scene);
  return static_cast<std::size_t>(std::find(ids.begin(), ids.end(), id) - ids.begin());
}

/// An organ of the user's, checked and judged.
struct UsersOrgan {
  OrganFile file;
  MeshRepairs repairs;
  bool anatomyKnown = false;  ///< an organ file says what it is, or that nothing is known
};

/// Judges a user's organ, finds its ends and the patterns that leave it whole. Its faults are warnings, or
/// the reason to refuse it, or the pattern that is asked for.
void judge(OrganFile& organ, const SceneRequest& request) {
  FittedOrgan fitted = fitOrgan(organ, request.assets);
  organ.ends = fitted.ends;
  organ.patterns = acceptedAmong(fitted.patterns);
  std::vector<OrganFinding>& findings = fitted.judgement.findings;
  for (const PatternJudgement& one : fitted.patterns) {
    if (one.id == request.pattern && !one.accepted) {
      findings.insert(findings.begin(), brokenFinding(one));
    }
  }
  for (OrganFinding& finding : findings) {
    if (finding.weight == FindingWeight::kRefusal) {
      if (!request.tellOnly) {
        throw refusalOf(finding, request.organFile->string());
      }
      finding.weight = FindingWeight::kWarning;
    }
  }
  organ.warnings = warningsAmong(findings);
}

UsersOrgan loadUsersOrgan(const SceneRequest& request) {
  const fs::path& file = *request.organFile;
  if (request.fixedEnd_m.has_value() != request.freeEnd_m.has_value()) {
    throw Error(ErrorCode::kUsage, Text::tr("one end of the organ is given without the other"), "",
                Text::tr("Give both ends."));
  }
  UsersOrgan organ;
  organ.anatomyKnown = isOrganFile(file);
  if (organ.anatomyKnown) {
    organ.file = readOrganFile(file);
  } else {
    MeshImportOptions import;
    import.scale_m = request.organScale_m;
    import.unitStated = meshSpaceOf(file).unit_m.has_value();
    requireUnit(import.scale_m, file.string());
    organ.file.mesh =
        checkedMesh(readMeshApart(file, import.scale_m).mesh, file.string(), import, &organ.repairs);
  }
  if (request.fixedEnd_m) {
    organ.file.patterns.clear();  // it was judged at other ends
    organ.file.ends = {.fixedEnd_m = request.fixedEnd_m,
                       .freeEnd_m = request.freeEnd_m,
                       .fixedCut = request.fixedCut,
                       .freeCut = request.freeCut,
                       .capRadius_m = request.capRadius_m,
                       .straight = false,
                       .branchRoot_m = request.branchRoot_m,
                       .branchCut = request.branchCut};
  }
  if (request.asRecorded) {
    organ.file.patterns.clear();
    organ.file.warnings = request.organWarnings;
  }
  return organ;
}

bool hasPattern(const SceneDescription& scene, const std::string& pattern) {
  return placeOfPattern(scene, pattern) < scene.patterns.size();
}

[[noreturn]] void refusePattern(const Text& what, const std::vector<std::string>& known) {
  throw Error(ErrorCode::kBadParameter, what, "", Text::tr("Choose one of %1.", listed(known)));
}

/// The scene whose patterns suit an organ of the user's.
SceneDescription describeOwn(const SceneRequest& request, const UsersOrgan& organ) {
  const std::string suiting = organ.file.anatomy.empty() ? kOwnOrganScene : organ.file.anatomy;
  SceneDescription own = readSceneFile(request.assets, suiting);
  if (hasPattern(own, request.pattern)) {
    const std::vector<std::string>& left = organ.file.patterns;
    if (!request.pattern.empty() && !left.empty() && !request.tellOnly &&
        std::find(left.begin(), left.end(), request.pattern) == left.end()) {
      refusePattern(Text::tr("the pattern '%1' does not leave this organ whole", request.pattern), left);
    }
    return own;
  }
  if (organ.anatomyKnown && !request.asRecorded) {
    refusePattern(
        Text::tr("the pattern '%1' needs an anatomy that this organ is not known to have", request.pattern),
        idsOf(own));
  }
  std::vector<std::string> known = idsOf(own);
  for (const std::string& id : sceneIds(request.assets)) {
    SceneDescription other = readSceneFile(request.assets, id);
    if (hasPattern(other, request.pattern)) {
      return other;
    }
    for (std::string& pattern : idsOf(other)) {
      known.push_back(std::move(pattern));
    }
  }
  refusePattern(Text::tr("no scene has a pattern '%1'", request.pattern), known);
}

/// An organ of the user's: its ends are found unless they are given.
void replaceOrgan(SceneDescription& scene, const SceneRequest& request, const UsersOrgan& organ) {
  scene.organ = *request.organFile;
  scene.organUnit_m = request.organScale_m;
  scene.title = scene.organ.filename().string();
  scene.provenance = "the user's mesh " + scene.organ.filename().string();
  LatticeOptions lattice = latticeFor(organ.file.ends);
  lattice.ridges = scene.lattice.ridges;
  lattice.sections = scene.lattice.sections;
  scene.lattice = lattice;
  scene.organWarnings = organ.file.warnings;
  if (organ.file.wallMap) {
    for (PatternDescription& one : scene.patterns) {
      if (one.pattern.detorsion && !one.pattern.detorsion->wall.thickness_m.empty()) {
        auto detorsion = std::make_shared<Detorsion>(*one.pattern.detorsion);
        detorsion->wall.thickness_m = thicknessAlong_m(*organ.file.wallMap);
        one.pattern.detorsion = std::move(detorsion);
      }
    }
  }
  for (Restraint& restraint : scene.restraints) {
    restraint.point_m.reset();  // landmarks of the shipped organ
    restraint.anchor_m.reset();
  }
}

void applyWishes(SceneDescription& scene, const SceneRequest& request) {
  if (request.ridges) {
    scene.lattice.ridges = *request.ridges;
  }
  if (request.sections) {
    scene.lattice.sections = *request.sections;
  }
  if (request.latticeMode) {
    scene.lattice.mode = *request.latticeMode;
  }
  if (request.formulation) {
    scene.formulation = *request.formulation;
  }
  scene.model = request.model.any() ? request.model : choiceFor(scene.model, scene.formulation);
  if (!request.material.empty()) {
    if (request.material != scene.material.id && !request.model.any()) {
      scene.model.shearModulus_Pa.reset();  // it was that of the scene's tissue
    }
    scene.material = findMaterial(request.assets, request.material, ErrorCode::kBadParameter, "");
  }
}

/// Tells whether a recording with these parameters was made on the scene.
bool madeOn(SceneDescription scene, const SceneRequest& request) {
  const std::size_t place = placeOfPattern(scene, request.pattern);
  if (place >= scene.patterns.size()) {
    return false;
  }
  applyWishes(scene, request);
  return parametersText(scene, scene.patterns[place].pattern, request.organFile.has_value(),
                        request.tissue) == withoutValidity(request.recorded);
}

/// The scene asked for, or its former state where a recording was made on that. `former`: whether its organ
/// is another one than today's.
SceneDescription describe(const SceneRequest& request, bool& former) {
  SceneDescription scene = readSceneFile(request.assets, request.id);
  if (request.former || (!request.recorded.empty() && !madeOn(scene, request))) {
    for (SceneDescription& before : readFormerScenes(request.assets, request.id)) {
      if (request.former || madeOn(before, request)) {
        former = before.organ != scene.organ;
        scene = std::move(before);
        break;
      }
    }
  }
  if (scene.organ.empty()) {
    throw Error(ErrorCode::kFileMissing,
                Text::tr("this was done on a mesh of the user's, which is not given"), "",
                Text::tr("Give the mesh or organ file"));
  }
  if (!hasPattern(scene, request.pattern)) {
    refusePattern(Text::tr("scene '%1' has no pattern '%2'", scene.id, request.pattern), idsOf(scene));
  }
  return scene;
}

/// The wall of an organ that came twisted; null where the pattern is to be twisted.
std::shared_ptr<const HollowOrgan> hollowOf(const SceneDescription& scene, const SceneRequest& request,
                                            const TwistPattern& pattern, const TwistModel& model,
                                            const TriangleMesh& mesh, const CollisionMesh& collision) {
  if (!pattern.detorsion) {
    return nullptr;
  }
  if (runsAsync(request.tissue) || scene.formulation == Formulation::kPaper) {
    throw Error(ErrorCode::kBadParameter,
                Text::tr("the pattern '%1' starts twisted, which only the twist model with a wall supports",
                         pattern.id),
                Text::tr("scene %1", scene.id),
                Text::tr("Choose another pattern, or leave out the other model."));
  }
  auto hollow = std::make_shared<HollowOrgan>(
      HollowOrgan::Parts{.lattice = &model.lattice(),
                         .shearModulus_Pa = model.material().shearModulus_Pa,
                         .graspArc = pattern.graspArc,
                         .detorsion = *pattern.detorsion,
                         .vertices_m = mesh.vertices_m,
                         .patches = pattern.task ? nullptr : &collision.patches()});
  if (pattern.task) {
    hollow->swingOn(std::make_shared<const RodOrgan>(RodOrgan::Parts{.mesh = &mesh,
                                                                     .model = &model,
                                                                     .restraints = scene.restraints,
                                                                     .task = *pattern.task,
                                                                     .graspArc = pattern.graspArc,
                                                                     .wall = hollow->wallMap(model.lattice()),
                                                                     .laws = hollow->twistLaws()}));
  }
  return hollow;
}

constexpr double kStraight = 0.01;  // of the length: an axis that bends less has no inside

/// Tells whether the axis lies along the line between its ends.
bool isStraight(const SectionLattice& lattice) {
  const Vec3 from_m = lattice.frameAt(0.0).centre_m;
  const Vec3 along = normalized(lattice.frameAt(lattice.length_m()).centre_m - from_m);
  double aside_m = 0.0;
  for (int j = 0; j < lattice.sections(); ++j) {
    aside_m =
        std::max(aside_m, norm(cross(lattice.frameAt(lattice.sectionArc_m(j)).centre_m - from_m, along)));
  }
  return aside_m <= kStraight * lattice.length_m();
}

/// Radius of the section's extent in a direction of its plane.
double reach_m(const SectionLattice& lattice, int j, const AxisFrame& frame, const Vec3& direction) {
  double most = 0.0;
  for (const Point2& p : lattice.outline_m(j)) {
    most = std::max(most, p[0] * dot(direction, frame.e1) + p[1] * dot(direction, frame.e2));
  }
  return most;
}

void throughEnds(TurnTask& task, const SectionLattice& lattice) {
  task.axisFrom_m = lattice.frameAt(0.0).centre_m;
  task.axisTo_m = lattice.frameAt(lattice.length_m()).centre_m;
}

void acrossBend(TurnTask& task, const SectionLattice& lattice) {
  const int j = lattice.sections() / 2;
  const AxisFrame middle = lattice.frameAt(lattice.sectionArc_m(j));
  const Vec3 chord = 0.5 * (lattice.frameAt(0.0).centre_m + lattice.frameAt(lattice.length_m()).centre_m);
  const Vec3 towards = chord - middle.centre_m;
  const Vec3 across = towards - dot(towards, middle.tangent) * middle.tangent;
  const Vec3 inside = norm(across) > kStraight * lattice.length_m() ? normalized(across) : middle.e1;
  task.axisFrom_m = middle.centre_m + reach_m(lattice, j, middle, inside) * inside;
  task.axisTo_m = middle.centre_m - reach_m(lattice, j, middle, -inside) * inside;
}

/// Puts the task of a pattern, written for the landmarks of a shipped organ, into another organ: the line of
/// a task runs through the organ's ends or across its bend at half length, from the inside (an organ without
/// a bend has it along e1 of its middle section); the turn that counts is that of the gripped section. A
/// straight organ of which nothing is known is a bar, without a task.
TwistPattern patternFor(const SceneDescription& scene, const SectionLattice& lattice,
                        const PatternDescription& description) {
  TwistPattern pattern = description.pattern;
  if (scene.id == kOwnOrganScene && isStraight(lattice)) {
    pattern.task.reset();
  }
  if (!pattern.task) {
    return pattern;
  }
  pattern.task->measured.reset();
  if (pattern.task->axis == GripAxis::kLine) {
    description.elsewhere == AxisElsewhere::kEnds ? throughEnds(*pattern.task, lattice)
                                                  : acrossBend(*pattern.task, lattice);
  }
  return pattern;
}

/// Leaves the patterns that do the organ no harm, and the one that is asked for.
void offerAccepted(SceneDescription& scene, const std::vector<std::string>& accepted,
                   const std::string& wanted) {
  if (accepted.empty()) {
    return;
  }
  std::erase_if(scene.patterns, [&](const PatternDescription& one) {
    const std::string& id = one.pattern.id;
    return id != wanted && std::find(accepted.begin(), accepted.end(), id) == accepted.end();
  });
}

/// `former`: the description is that of before, for a recording that was made on it. `same`: a scene of the
/// same organ with the same lattice; null: none.
Scene builtScene(const SceneRequest& request, SceneDescription description, UsersOrgan own, bool former,
                 const Scene* same) {
  applyWishes(description, request);
  TriangleMesh mesh = std::move(own.file.mesh);
  std::future<CollisionMesh> cutting;  // needs nothing of the lattice: at the same time
  if (same == nullptr) {
    cutting = std::async(std::launch::async, [&mesh] { return CollisionMesh(mesh); });
  }
  const SectionLattice lattice = same ? same->lattice() : SectionLattice(mesh, description.lattice);
  std::vector<TwistPattern> patterns;
  for (const PatternDescription& pattern : description.patterns) {
    patterns.push_back(request.organFile ? patternFor(description, lattice, pattern) : pattern.pattern);
  }
  const TwistPattern& pattern = patterns[placeOfPattern(description, request.pattern)];

  TwistModelOptions options;
  options.formulation = description.formulation;
  options.ends = pattern.ends;
  applyChoice(description.model, lattice.sections(), options, description.material);
  TwistModel model(mesh, lattice, description.material, options);
  CollisionMesh collision = same ? same->collision : cutting.get();
  std::shared_ptr<const RodOrgan> rod;
  const bool bar = request.noRod || description.model.ofBar() || runsAsync(request.tissue);
  if (pattern.task && !pattern.detorsion && !bar && description.formulation != Formulation::kPaper) {
    rod = std::make_shared<const RodOrgan>(RodOrgan::Parts{.mesh = &mesh,
                                                           .model = &model,
                                                           .restraints = description.restraints,
                                                           .task = *pattern.task,
                                                           .graspArc = pattern.graspArc,
                                                           .targetAngle_rad = pattern.targetAngle_rad});
  }
  std::shared_ptr<const HollowOrgan> hollow = hollowOf(description, request, pattern, model, mesh, collision);
  std::string parameters =
      parametersText(description, pattern, request.organFile.has_value(), request.tissue);
  Digest digest;
  digest.update(parameters);
  if (request.model.any()) {
    digest.update("another model");  // no recording was made with it
  }
  if (hollow) {
    parameters = withValidity(parameters, *hollow);
  }
  std::string organHash = same ? same->organHash : contentHash(mesh);
  TwistPattern chosen = pattern;
  return Scene{description.id,
               description.title,
               description.provenance,
               std::move(organHash),
               digest.hex(),
               std::move(parameters),
               std::move(mesh),
               std::move(collision),
               std::move(model),
               description.instrument,
               std::move(chosen),
               std::move(patterns),
               own.repairs,
               std::move(rod),
               description.model,
               request.tissue,
               std::move(hollow),
               description.organWarnings,
               own.file.wall_m,
               own.file.wallMap ? thicknessAlong_m(*own.file.wallMap) : std::vector<std::array<double, 2>>{},
               former};
}

/// The scene of a user's organ: that of its patterns, or its former state if a recording was made on it.
Scene sceneOf(const SceneRequest& request, SceneDescription scene, UsersOrgan own, const Scene* same) {
  replaceOrgan(scene, request, own);
  offerAccepted(scene, own.file.patterns, request.tellOnly ? request.pattern : "");
  bool former = false;
  if (scene.id == kOwnOrganScene && !request.recorded.empty() && !madeOn(scene, request)) {
    for (SceneDescription& before : readFormerScenes(request.assets, scene.id)) {
      replaceOrgan(before, request, own);
      if (madeOn(before, request)) {
        former = true;
        scene = std::move(before);
        break;
      }
    }
  }
  return builtScene(request, std::move(scene), std::move(own), former, same);
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
    throw Error(ErrorCode::kFileMissing, Text::tr("no scenes here"), (assets / "scenes").string(),
                Text::tr("Check the assets folder."));
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

std::vector<std::string> patternIds(const fs::path& assets, const std::string& id) {
  return idsOf(readSceneFile(assets, id));
}

Scene loadScene(const SceneRequest& request) {
  if (request.organFile) {
    UsersOrgan own = loadUsersOrgan(request);
    SceneDescription theirs = describeOwn(request, own);
    if (!request.asRecorded && own.file.patterns.empty()) {
      own.file.anatomy = theirs.id == kOwnOrganScene ? std::string() : theirs.id;
      judge(own.file, request);
    }
    return sceneOf(request, std::move(theirs), std::move(own), nullptr);
  }
  bool former = false;
  SceneDescription description = describe(request, former);
  MeshImportOptions import;
  import.scale_m = description.organUnit_m;
  UsersOrgan shipped;
  shipped.file.mesh = importMesh(description.organ, import, &shipped.repairs);
  return builtScene(request, std::move(description), std::move(shipped), former, nullptr);
}

Scene sceneOfOrgan(const SceneRequest& request, OrganFile organ, const Scene* same) {
  UsersOrgan own;
  own.file = std::move(organ);
  own.anatomyKnown = true;
  SceneDescription description = describeOwn(request, own);
  return sceneOf(request, std::move(description), std::move(own), same);
}

}  // namespace torsio
