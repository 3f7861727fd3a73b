// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/compared_meshes.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <future>
#include <memory>

#include "sim/core/error.h"

namespace torsio {

namespace {

using MeshClock = std::chrono::steady_clock;
constexpr std::array kShares{0.5, 2.0 / 3.0};  // of ridges, steps and rings
constexpr int kLeastRidges = 6;
constexpr int kLeastSteps = 3;

/// A share of a number, even where that is.
int shareOf(int count, double share) {
  const int part = static_cast<int>(std::lround(count * share));
  return count % 2 == 0 && part % 2 != 0 ? part + 1 : part;
}

/// One model on one mesh of an organ.
class MeshRun {
 public:
  MeshRun(const Scene& scene, const ComparedOrgan& organ, const TwistModel& twist,
          const ComparisonResult& result)
      : organ_(organ),
        twist_(twist),
        result_(result),
        rest_(restPlaces(*organ.lattice)),
        end_(organ.lattice->frameAt(organ.hold.span[1] * organ.lattice->length_m())) {
    for (const OrganMarker& marker : result.markers) {
      anchors_.push_back(anchorMarker(scene.mesh, *organ.lattice, marker.position_m));
    }
  }

  [[nodiscard]] ComparedMesh operator()(const std::string& id, int rings) const {
    ComparedMesh mesh{id, organ_.lattice->ridges(), organ_.lattice->sections(), rings};
    const auto start = MeshClock::now();
    try {
      const auto model = made(id, rings);
      mesh.unknowns = model->unknowns();
      model->settle(result_.torque_Nm);
      mesh.angle_rad = model->angle_rad();
      mesh.markerRmse_m = markerRmse_m(model->surface(), mesh.angle_rad);
    } catch (const Error& none) {
      mesh.noEquilibrium = none.happenedText();
    }
    mesh.settle_s = std::chrono::duration<double>(MeshClock::now() - start).count();
    return mesh;
  }

 private:
  [[nodiscard]] std::unique_ptr<TwistSimulation> made(const std::string& id, int rings) const {
    if (id == "reference") {
      return referenceSimulation(organ_, rings);
    }
    return id == "fem" ? finiteElementSimulation(organ_, rings)
                       : massSpringSimulation(organ_, twist_, rings, result_.options.springs);
  }

  [[nodiscard]] std::optional<double> markerRmse_m(const LatticePlaces& now, double angle_rad) const {
    const std::vector<double>& wanted = result_.model("reference").settled.displacements_m;
    double sum_m2 = 0.0;
    for (std::size_t i = 0; i < anchors_.size(); ++i) {
      const Vec3 place_m = result_.options.grasp ? markerPlace_m(anchors_[i], rest_, now)
                                                 : markerPlace_m(anchors_[i], rest_, now, end_, angle_rad);
      const double apart_m = norm(place_m - anchors_[i].rest_m) - wanted[i];
      sum_m2 += apart_m * apart_m;
    }
    return anchors_.empty() ? std::nullopt
                            : std::optional(std::sqrt(sum_m2 / static_cast<double>(anchors_.size())));
  }

  const ComparedOrgan& organ_;
  const TwistModel& twist_;
  const ComparisonResult& result_;
  LatticePlaces rest_;
  AxisFrame end_;
  std::vector<MarkerAnchor> anchors_;
};

/// The mesh of the comparison itself.
ComparedMesh asCompared(const ComparisonResult& result, const std::string& id, int rings) {
  const ModelResult& model = result.model(id);
  ComparedMesh mesh{id, result.ridges, result.sections, rings, model.unknowns};
  mesh.angle_rad = model.settled.angle_rad;
  mesh.settle_s = id == "reference" ? model.deformation_s : model.settle_s;
  mesh.noEquilibrium = model.noEquilibrium;
  if (!result.markers.empty()) {
    mesh.markerRmse_m = model.settled.markerRmse_m;
  }
  return mesh;
}

}  // namespace

std::vector<ComparedMesh> comparedMeshes(const Scene& scene, const ComparedOrgan& organ,
                                         const TwistModel& twist, const ComparisonResult& result) {
  struct Coarser {
    double share;
    TwistModel twist;
  };
  std::vector<Coarser> lattices;
  for (const double share : kShares) {
    LatticeOptions coarse = organ.lattice->options();
    coarse.ridges = shareOf(coarse.ridges, share);
    coarse.sections = shareOf(coarse.sections - 1, share) + 1;
    if (coarse.ridges >= kLeastRidges && coarse.sections > kLeastSteps) {
      lattices.push_back(
          {share, TwistModel(scene.mesh, SectionLattice(scene.mesh, coarse), twist.material(), {})});
    }
  }
  const auto all = [&](const std::string& id, int rings) {
    std::vector<ComparedMesh> meshes;
    for (const Coarser& lattice : lattices) {
      ComparedOrgan coarser = organ;
      coarser.lattice = &lattice.twist.lattice();
      const int fewer = id == "reference" ? shareOf(rings, lattice.share)
                                          : static_cast<int>(std::lround(rings * lattice.share));
      meshes.push_back(MeshRun(scene, coarser, lattice.twist, result)(id, std::max(1, fewer)));
    }
    meshes.push_back(asCompared(result, id, rings));
    return meshes;
  };
  auto waiting = std::async(std::launch::async, [&] { return all("fem", result.options.rings); });
  std::vector<ComparedMesh> meshes = all("reference", result.options.referenceRings);
  const std::vector<ComparedMesh> springs = all("msm", result.options.rings);
  const std::vector<ComparedMesh> elements = waiting.get();
  meshes.insert(meshes.end(), elements.begin(), elements.end());
  meshes.insert(meshes.end(), springs.begin(), springs.end());
  return meshes;
}

}  // namespace torsio
