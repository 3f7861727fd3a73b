// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/lattice_skin.h"

#include <algorithm>
#include <cmath>

#include "sim/core/contracts.h"
#include "sim/core/portable_math.h"

namespace torsio {

namespace {

/// The point of a patch with these weights, and three unit directions of the patch: along the organ, round
/// it, out.
struct PatchPoint {
  Vec3 place_m;
  Vec3 along;
  Vec3 round;
  Vec3 out;
};

Vec3 direction(const Vec3& v) {
  const double length = norm(v);
  return length > 0.0 ? v / length : Vec3{};
}

PatchPoint patchPoint(const LatticePlaces& places, const std::array<std::size_t, 4>& points,
                      const std::array<double, 4>& weights) {
  const auto corner = [&](std::size_t k) { return places.places_m[points[k]]; };
  PatchPoint point;
  for (std::size_t k = 0; k < points.size(); ++k) {
    point.place_m += weights[k] * corner(k);
  }
  point.along = direction(corner(2) + corner(3) - corner(0) - corner(1));
  const Vec3 round = corner(1) + corner(3) - corner(0) - corner(2);
  point.round = direction(round - dot(round, point.along) * point.along);
  point.out = cross(point.round, point.along);
  return point;
}

}  // namespace

LatticeSkin::LatticeSkin(const TriangleMesh& mesh, const SectionLattice& lattice)
    : rest_(restPlaces(lattice)), end_(lattice.frameAt(lattice.length_m())) {
  const auto index = [this](int section, int ridge) {
    return static_cast<std::size_t>(section) * static_cast<std::size_t>(rest_.ridges) +
           static_cast<std::size_t>(ridge % rest_.ridges);
  };
  vertices_.reserve(mesh.vertices_m.size());
  for (std::size_t i = 0; i < mesh.vertices_m.size(); ++i) {
    CarriedVertex vertex;
    vertex.part = lattice.vertexParts()[i];
    vertex.rest_m = mesh.vertices_m[i];
    const LatticeCoordinate& at = lattice.vertexCoordinates()[i];
    const double along = std::clamp(at.arc_m / lattice.length_m(), 0.0, 1.0) * (rest_.sections - 1);
    const double round = at.angle_rad / (2.0 * kPi) * rest_.ridges;
    const int section = std::min(static_cast<int>(along), rest_.sections - 2);
    const int ridge = static_cast<int>(round);
    const double u = along - section;
    const double v = round - ridge;
    vertex.points = {index(section, ridge), index(section, ridge + 1), index(section + 1, ridge),
                     index(section + 1, ridge + 1)};
    vertex.weights = {(1.0 - u) * (1.0 - v), (1.0 - u) * v, u * (1.0 - v), u * v};
    const PatchPoint patch = patchPoint(rest_, vertex.points, vertex.weights);
    const Vec3 aside = vertex.rest_m - patch.place_m;
    vertex.aside_m = {dot(aside, patch.along), dot(aside, patch.round), dot(aside, patch.out)};
    vertices_.push_back(vertex);
  }
}

void LatticeSkin::deform(const LatticePlaces& now, double angle_rad, std::span<Vec3> out_m) const {
  TORSIO_EXPECTS(out_m.size() == vertices_.size() && now.places_m.size() == rest_.places_m.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const CarriedVertex& vertex = vertices_[i];
    if (vertex.part == LatticePart::kSide) {
      const PatchPoint patch = patchPoint(now, vertex.points, vertex.weights);
      out_m[i] = patch.place_m + vertex.aside_m.x * patch.along + vertex.aside_m.y * patch.round +
                 vertex.aside_m.z * patch.out;
    } else {
      out_m[i] = capPlace_m(vertex.part, vertex.rest_m, end_, angle_rad);
    }
  }
}

}  // namespace torsio
