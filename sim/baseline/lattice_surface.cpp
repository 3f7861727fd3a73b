// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/lattice_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "sim/core/contracts.h"
#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/nearest_on_triangle.h"

namespace torsio {

namespace {

Vec3 sectionMean(const LatticePlaces& places, int section) {
  Vec3 mean;
  for (int k = 0; k < places.ridges; ++k) {
    mean += places.at(section, k) / places.ridges;
  }
  return mean;
}

/// Distance of every key point from the mean of its section.
std::vector<double> radii(const LatticePlaces& places) {
  std::vector<double> values;
  values.reserve(places.places_m.size());
  for (int j = 0; j < places.sections; ++j) {
    const Vec3 mean = sectionMean(places, j);
    for (int k = 0; k < places.ridges; ++k) {
      values.push_back(norm(places.at(j, k) - mean));
    }
  }
  return values;
}

/// Centre, normal and the direction of ridge 0 of the last section.
AxisFrame lastSectionFrame(const LatticePlaces& places) {
  const int last = places.sections - 1;
  AxisFrame frame;
  frame.centre_m = sectionMean(places, last);
  Vec3 normal;
  for (int k = 0; k < places.ridges; ++k) {
    normal += cross(places.at(last, k) - frame.centre_m, places.at(last, k + 1) - frame.centre_m);
  }
  frame.tangent = normalized(normal);
  const Vec3 arm = places.at(last, 0) - frame.centre_m;
  frame.e1 = normalized(arm - dot(arm, frame.tangent) * frame.tangent);
  frame.e2 = cross(frame.tangent, frame.e1);
  return frame;
}

/// Carries a place along with the last section as with a rigid body.
Vec3 withLastSection(const Vec3& place_m, const AxisFrame& before, const AxisFrame& after) {
  const Vec3 arm = place_m - before.centre_m;
  return after.centre_m + dot(arm, before.tangent) * after.tangent + dot(arm, before.e1) * after.e1 +
         dot(arm, before.e2) * after.e2;
}

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

CarriedKeyPoints::CarriedKeyPoints(const TriangleMesh& mesh, const SectionLattice& lattice)
    : ridges_(lattice.ridges()), sections_(lattice.sections()) {
  TORSIO_EXPECTS(lattice.vertexCoordinates().size() == mesh.vertices_m.size());
  for (int j = 0; j < sections_; ++j) {
    for (int k = 0; k < ridges_; ++k) {
      points_.push_back(lattice.surfacePoint({lattice.sectionArc_m(j), 2.0 * kPi * k / ridges_}));
    }
  }
}

LatticePlaces CarriedKeyPoints::at(const TriangleMesh& mesh, std::span<const Vec3> vertices_m) const {
  LatticePlaces places{ridges_, sections_, {}};
  for (const LatticePoint& point : points_) {
    const TriangleMesh::Triangle& corners = mesh.triangles[point.triangle];
    Vec3 place;
    for (std::size_t c = 0; c < 3; ++c) {
      place += point.barycentric[c] * vertices_m[corners[c]];
    }
    places.places_m.push_back(place);
  }
  return places;
}

LatticePlaces restPlaces(const SectionLattice& lattice) {
  LatticePlaces places{lattice.ridges(), lattice.sections(), {}};
  for (int j = 0; j < lattice.sections(); ++j) {
    for (int k = 0; k < lattice.ridges(); ++k) {
      places.places_m.push_back(lattice.keyPoint_m(k, j));
    }
  }
  return places;
}

double rootMeanSquareDistance_m(const LatticePlaces& a, const LatticePlaces& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.places_m.size(); ++i) {
    const Vec3 apart = a.places_m[i] - b.places_m[i];
    sum += dot(apart, apart);
  }
  return std::sqrt(sum / static_cast<double>(a.places_m.size()));
}

double latticeVolume_m3(const LatticePlaces& places) {
  double six = 0.0;
  const auto add = [&six](const Vec3& a, const Vec3& b, const Vec3& c) { six += dot(a, cross(b, c)); };
  const Vec3 first = sectionMean(places, 0);
  const Vec3 last = sectionMean(places, places.sections - 1);
  for (int k = 0; k < places.ridges; ++k) {
    add(first, places.at(0, k + 1), places.at(0, k));
    add(last, places.at(places.sections - 1, k), places.at(places.sections - 1, k + 1));
    for (int j = 0; j + 1 < places.sections; ++j) {
      const std::array<Vec3, 4> corners{places.at(j, k), places.at(j, k + 1), places.at(j + 1, k + 1),
                                        places.at(j + 1, k)};
      const Vec3 middle = 0.25 * (corners[0] + corners[1] + corners[2] + corners[3]);
      for (std::size_t c = 0; c < 4; ++c) {
        add(middle, corners[c], corners[(c + 1) % 4]);
      }
    }
  }
  return six / 6.0;
}

double largestRadiusChange(const LatticePlaces& rest, const LatticePlaces& now) {
  const std::vector<double> before = radii(rest);
  const std::vector<double> after = radii(now);
  double largest = 0.0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    largest = std::max(largest, std::abs(after[i] / before[i] - 1.0));
  }
  return largest;
}

double roughness_m(const LatticePlaces& rest, const LatticePlaces& now) {
  std::vector<double> change = radii(now);
  const std::vector<double> before = radii(rest);
  std::transform(change.begin(), change.end(), before.begin(), change.begin(),
                 [](double after, double at) { return after - at; });
  const auto at = [&](int section, int ridge) {
    return change[static_cast<std::size_t>(section) * static_cast<std::size_t>(rest.ridges) +
                  static_cast<std::size_t>((ridge + rest.ridges) % rest.ridges)];
  };
  double sum = 0.0;
  for (int j = 1; j + 1 < rest.sections; ++j) {
    for (int k = 0; k < rest.ridges; ++k) {
      const double rough = at(j, k) - 0.25 * (at(j - 1, k) + at(j + 1, k) + at(j, k - 1) + at(j, k + 1));
      sum += rough * rough;
    }
  }
  return std::sqrt(sum / std::max(1, (rest.sections - 2) * rest.ridges));
}

MarkerAnchor anchorMarker(const TriangleMesh& mesh, const SectionLattice& lattice, const Vec3& position_m) {
  const auto nearer = [&](const Vec3& a, const Vec3& b) {
    return norm(a - position_m) < norm(b - position_m);
  };
  const auto nearest = static_cast<std::size_t>(
      std::min_element(mesh.vertices_m.begin(), mesh.vertices_m.end(), nearer) - mesh.vertices_m.begin());
  MarkerAnchor marker;
  marker.rest_m = position_m;
  marker.part = lattice.vertexParts()[nearest];
  if (marker.part != LatticePart::kSide) {
    return marker;
  }
  const LatticePlaces rest = restPlaces(lattice);
  double best_m2 = std::numeric_limits<double>::infinity();
  const auto index = [&](int section, int ridge) {
    return static_cast<std::size_t>(section) * static_cast<std::size_t>(rest.ridges) +
           static_cast<std::size_t>(ridge % rest.ridges);
  };
  for (int j = 0; j + 1 < rest.sections; ++j) {
    for (int k = 0; k < rest.ridges; ++k) {
      const std::array<std::array<std::size_t, 3>, 2> halves{
          {{index(j, k), index(j, k + 1), index(j + 1, k + 1)},
           {index(j, k), index(j + 1, k + 1), index(j + 1, k)}}};
      for (const std::array<std::size_t, 3>& half : halves) {
        const NearestOnTriangle found = nearestOnTriangle(
            position_m, {rest.places_m[half[0]], rest.places_m[half[1]], rest.places_m[half[2]]});
        if (found.distance2 < best_m2) {
          best_m2 = found.distance2;
          marker.points = half;
          marker.weights = {found.u, found.v, found.w};
        }
      }
    }
  }
  return marker;
}

Vec3 capPlace_m(LatticePart part, const Vec3& rest_m, const AxisFrame& end, double angle_rad) {
  TORSIO_EXPECTS(part != LatticePart::kSide);
  if (part == LatticePart::kFixedCap) {
    return rest_m;
  }
  const SinCos turn = portableSinCos(angle_rad);
  const Vec3 arm = rest_m - end.centre_m;
  const Vec3 along = dot(arm, end.tangent) * end.tangent;
  return end.centre_m + along + turn.cos * (arm - along) + turn.sin * cross(end.tangent, arm);
}

Vec3 markerPlace_m(const MarkerAnchor& marker, const LatticePlaces& rest, const LatticePlaces& now,
                   const AxisFrame& end, double angle_rad) {
  if (marker.part != LatticePart::kSide) {
    return capPlace_m(marker.part, marker.rest_m, end, angle_rad);
  }
  return markerPlace_m(marker, rest, now);
}

Vec3 markerPlace_m(const MarkerAnchor& marker, const LatticePlaces& rest, const LatticePlaces& now) {
  if (marker.part == LatticePart::kFixedCap) {
    return marker.rest_m;
  }
  if (marker.part == LatticePart::kFreeCap) {
    return withLastSection(marker.rest_m, lastSectionFrame(rest), lastSectionFrame(now));
  }
  Vec3 place = marker.rest_m;
  for (std::size_t k = 0; k < 3; ++k) {
    place += marker.weights[k] * (now.places_m[marker.points[k]] - rest.places_m[marker.points[k]]);
  }
  return place;
}

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

void LatticeSkin::deform(const LatticePlaces& now, std::optional<double> turned_rad,
                         std::span<Vec3> out_m) const {
  TORSIO_EXPECTS(out_m.size() == vertices_.size() && now.places_m.size() == rest_.places_m.size());
  const AxisFrame before = lastSectionFrame(rest_);
  const AxisFrame after = lastSectionFrame(now);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const CarriedVertex& vertex = vertices_[i];
    if (vertex.part == LatticePart::kSide) {
      const PatchPoint patch = patchPoint(now, vertex.points, vertex.weights);
      out_m[i] = patch.place_m + vertex.aside_m.x * patch.along + vertex.aside_m.y * patch.round +
                 vertex.aside_m.z * patch.out;
    } else if (vertex.part == LatticePart::kFreeCap && !turned_rad) {
      out_m[i] = withLastSection(vertex.rest_m, before, after);
    } else {
      out_m[i] = capPlace_m(vertex.part, vertex.rest_m, end_, turned_rad.value_or(0.0));
    }
  }
}

}  // namespace torsio
