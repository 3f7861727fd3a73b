// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/organ/organ_trial.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_thinning.h"
#include "sim/imaging/apart/scan_process.h"
#include "sim/imaging/surface/scan_surface.h"
#include "sim/scene/organ_file.h"
#include "sim/scene/organ_judgement.h"
#include "sim/scene/rod_organ.h"
#include "sim/scene/scene.h"
#include "sim/scene/tissue_look.h"

namespace torsio::gui {

namespace {

constexpr int kAxisPoints = 96;

/// Makes a scene that twists the organ about its own axis, whatever its anatomy, or on its stalk. Null if it
/// has no axis.
std::shared_ptr<const Scene> ownAxisScene(const OrganImport& import, TriangleMesh shown,
                                          const std::filesystem::path& assets) {
  if (import.measures.length_m == 0.0) {
    return nullptr;
  }
  OrganFile organ = import.organ;
  organ.mesh = std::move(shown);
  if (wrungShare(assets, organ.anatomy) == 1.0) {
    organ.anatomy.clear();
  }
  SceneRequest request;
  request.assets = assets;
  organ.patterns.clear();  // shown although it is refused
  request.organFile = import.organ.source;
  try {
    return std::make_shared<const Scene>(sceneOfOrgan(request, std::move(organ)));
  } catch (const Error&) {
    return nullptr;  // the findings explain why
  }
}

void findAxis(OrganTrial& trial) {
  const SectionLattice& lattice = trial.scene->lattice();
  const double length_m = lattice.length_m();
  for (int i = 0; i <= kAxisPoints; ++i) {
    trial.axis_m.push_back(lattice.frameAt(length_m * i / kAxisPoints).centre_m);
  }
  const OrganMeasures& measures = trial.import.measures;
  const auto mark = [&](OrganLandmark::Kind kind, double share) {
    trial.landmarks.push_back({kind, lattice.frameAt(share * length_m).centre_m});
  };
  mark(OrganLandmark::Kind::kFixedEnd, 0.0);
  mark(OrganLandmark::Kind::kFreeEnd, 1.0);
  if (measures.widthRatio > 1.0) {
    mark(OrganLandmark::Kind::kWidest, measures.widestAt);
    mark(OrganLandmark::Kind::kNarrowest, measures.narrowestAt);
  }
}

/// Maps the progress of the scan reader to a part of the whole.
ScanProgress partialProgress(const ProgressCallback& progress, double whole) {
  return [&progress, whole](ScanStep step, double fraction) {
    const ScanStepShare share = shareOf(step);
    tellProgress(progress, share.words, whole * share.at(fraction));
  };
}

/// Makes a static view of a surface without axis.
ViewScene staticView(const TriangleMesh& mesh, const std::string& anatomy) {
  ViewScene view;
  view.look = tissueLook(anatomy);
  view.surface = OrganSurface(mesh);
  view.deform = [rest = mesh.vertices_m](const OrganState&, std::span<Vec3> out_m) {
    std::copy(rest.begin(), rest.end(), out_m.begin());
  };
  return view;
}

}  // namespace

OrganState OrganTrial::stateAt(double angle_rad) const {
  if (!scene || !scene->rod) {
    return scene ? scene->stateAt(angle_rad) : OrganState{};
  }
  const TaskPoint point = atAngle(angle_rad < 0.0 ? back : forth, angle_rad);
  return {{scene->grasp_m(), point.angle_rad}, point.angle_rad == 0.0 ? RodPose{} : point.pose};
}

OrganTrial trialOf(OrganImport import, const std::filesystem::path& assets) {
  OrganTrial trial;
  trial.import = std::move(import);
  const TriangleMesh& whole = trial.import.organ.mesh;
  if (whole.triangles.empty()) {
    return trial;
  }
  TriangleMesh shown = trial.import.shown ? *trial.import.shown : thinned(whole, kJudgedTriangles);
  trial.scene = ownAxisScene(trial.import, shown, assets);
  if (trial.scene == nullptr) {
    trial.view = staticView(shown, trial.import.organ.anatomy);
    trial.shown = std::make_shared<const TriangleMesh>(std::move(shown));
    return trial;
  }
  trial.view = makeViewScene(trial.scene, trial.import.organ.anatomy);
  trial.view.surroundings = Surroundings::kDrape;  // it is not placed like the patient's own
  trial.shown = std::shared_ptr<const TriangleMesh>(trial.scene, &trial.scene->mesh);
  if (const auto& rod = trial.scene->rod) {
    trial.forth.assign(rod->path().begin(), rod->path().end());
    trial.back = rod->follow(trial.scene->pattern.graspArc, -trial.scene->pattern.targetAngle_rad);
  }
  findAxis(trial);
  return trial;
}

ScanPreview previewOf(const ScanRequest& scan, bool find, const ProgressCallback& progress) {
  return previewApart(scan, find, partialProgress(progress, 1.0));
}

OrganTrial trialOfScan(const OrganImportRequest& request, const ScanRequest& scan, ScanSurface& surface,
                       const ProgressCallback& progress) {
  OrganReconstruction made = reconstructOrgan(request, scan, partialProgress(progress, 0.8));
  surface = std::move(made.scan);
  tellProgress(progress, Text::tr("Drawing the organ"), 0.8);
  return trialOf(std::move(made.import), request.assets);
}

OrganTrial trialOfSurface(const OrganImportRequest& request, const ScanRequest& scan,
                          const ScanSurface& surface, const ProgressCallback& progress) {
  tellProgress(progress, Text::tr("Checking the organ"), 0.0);
  OrganImport import = judgedSurface(request, scan, surface);
  tellProgress(progress, Text::tr("Drawing the organ"), 0.8);
  return trialOf(std::move(import), request.assets);
}

OrganTrial trialOfMesh(const OrganImportRequest& request, const ProgressCallback& progress) {
  tellProgress(progress, Text::tr("Reading the mesh"), 0.0);
  OrganImport import = importOrgan(request, [&] {
    RawMesh read = readMeshApart(request.file, request.scale_m, request.reading);
    tellProgress(progress, Text::tr("Checking the organ"), 0.2);
    return read;
  });
  tellProgress(progress, Text::tr("Drawing the organ"), 0.8);
  return trialOf(std::move(import), request.assets);
}

}  // namespace torsio::gui
