// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/twist_model_arc.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim/core/portable_math.h"

namespace torsio {

namespace {

constexpr std::size_t kArcs = 97;
constexpr std::size_t kAngles = 48;
constexpr double kSmoothing = 0.05;  // pull of the neighbours, in vertices a node
constexpr double kBeyondEnd = 0.25;  // of the radius: there the shift has died away
constexpr int kSweeps = 200;         // carry values across the widest gap between vertices

struct Polar {
  double angle_rad = 0.0;
  double radius_m = 0.0;
};

Polar polarOf(const AxisFrame& frame, const Vec3& point_m) {
  const Vec3 u = point_m - frame.centre_m;
  const double x = dot(u, frame.e1);
  const double y = dot(u, frame.e2);
  return {portableAtan2(y, x), std::sqrt(x * x + y * y)};
}

}  // namespace

ArcField::ArcField(const TriangleMesh& mesh, const SectionLattice& lattice) : length_m_(lattice.length_m()) {
  if (lattice.straight()) {
    return;
  }
  std::vector<Node> sums(kArcs * kAngles);
  std::vector<double> weights(kArcs * kAngles, 0.0);
  for (std::size_t v = 0; v < mesh.vertices_m.size(); ++v) {
    const double nearest = lattice.nearestArc_m(mesh.vertices_m[v]);
    const bool beyondEnd = nearest <= 0.0 || nearest >= length_m_;
    if (beyondEnd) {
      continue;  // a cap: its arc length is that of the end
    }
    const Polar polar = polarOf(lattice.frameAt(nearest), mesh.vertices_m[v]);
    const Place place = placeOf(nearest, polar.angle_rad);
    for (std::size_t i = 0; i < 4; ++i) {
      sums[place.node[i]].shift_m += place.weight[i] * (lattice.vertexCoordinates()[v].arc_m - nearest);
      sums[place.node[i]].radius_m += place.weight[i] * polar.radius_m;
      weights[place.node[i]] += place.weight[i];
    }
  }
  fillGaps(std::move(sums), std::move(weights));
}

// Each node takes the mean of its vertices and, lightly, of its neighbours: nodes without a vertex take
// theirs from around.
void ArcField::fillGaps(std::vector<Node> sums, std::vector<double> weights) {
  nodes_.assign(kArcs * kAngles, Node{});
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (std::size_t i = 0; i < kArcs; ++i) {
      for (std::size_t a = 0; a < kAngles; ++a) {
        const std::size_t here = i * kAngles + a;
        Node sum = sums[here];
        double weight = weights[here];
        const auto pull = [&](std::size_t other) {
          sum.shift_m += kSmoothing * nodes_[other].shift_m;
          sum.radius_m += kSmoothing * nodes_[other].radius_m;
          weight += kSmoothing;
        };
        pull(i * kAngles + (a + 1) % kAngles);
        pull(i * kAngles + (a + kAngles - 1) % kAngles);
        if (i > 0) {
          pull(here - kAngles);
        }
        if (i + 1 < kArcs) {
          pull(here + kAngles);
        }
        nodes_[here] = {sum.shift_m / weight, sum.radius_m / weight};
      }
    }
  }
}

ArcField::Place ArcField::placeOf(double arc_m, double polar_rad) const noexcept {
  const double along = std::clamp(arc_m / length_m_, 0.0, 1.0) * static_cast<double>(kArcs - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(along), kArcs - 2);
  const double t = along - static_cast<double>(i);
  double round = polar_rad / (2.0 * kPi);
  round = (round - std::floor(round)) * static_cast<double>(kAngles);
  const std::size_t a = std::min(static_cast<std::size_t>(round), kAngles - 1);
  const double u = round - static_cast<double>(a);
  const std::size_t b = a + 1 < kAngles ? a + 1 : 0;
  Place place;
  place.node[0] = i * kAngles + a, place.weight[0] = (1.0 - t) * (1.0 - u);
  place.node[1] = i * kAngles + b, place.weight[1] = (1.0 - t) * u;
  place.node[2] = (i + 1) * kAngles + a, place.weight[2] = t * (1.0 - u);
  place.node[3] = (i + 1) * kAngles + b, place.weight[3] = t * u;
  return place;
}

double ArcField::arcAt(const SectionLattice& lattice, const Vec3& point_m) const noexcept {
  const double nearest = lattice.nearestArc_m(point_m);
  if (nodes_.empty()) {
    return nearest;
  }
  const AxisFrame frame = lattice.frameAt(nearest);
  const Polar polar = polarOf(frame, point_m);
  const Place place = placeOf(nearest, polar.angle_rad);
  double shift = 0.0;
  double radius = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    shift += place.weight[i] * nodes_[place.node[i]].shift_m;
    radius += place.weight[i] * nodes_[place.node[i]].radius_m;
  }
  double fade = polar.radius_m < radius ? polar.radius_m / radius : 1.0;
  if (nearest <= 0.0 || nearest >= length_m_) {  // what lies beyond an end follows it rigidly
    const double beyond = std::abs(dot(point_m - frame.centre_m, frame.tangent));
    fade *= std::max(0.0, 1.0 - beyond / (kBeyondEnd * radius));
  }
  return std::clamp(nearest + fade * shift, 0.0, length_m_);
}

}  // namespace torsio
