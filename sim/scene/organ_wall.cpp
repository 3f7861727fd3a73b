// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/organ_wall.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/contracts.h"
#include "sim/core/portable_math.h"
#include "sim/imaging/surface/scan_request.h"

namespace torsio {

namespace {

constexpr double kLeastSeen = 0.2;    // of the patches
constexpr double kMaxOfRadius = 0.4;  // what a closed wall is computed up to
constexpr int kFillingSweeps = 400;   // a gap of a quarter of the organ is even to a hundredth then

/// The vertices of a mesh sorted along z, for the nearest one to a point.
class NearestVertex {
 public:
  explicit NearestVertex(const TriangleMesh& mesh) : mesh_(mesh) {
    order_.resize(mesh.vertices_m.size());
    for (std::uint32_t v = 0; v < order_.size(); ++v) {
      order_[v] = v;
    }
    std::stable_sort(order_.begin(), order_.end(), [&mesh](std::uint32_t a, std::uint32_t b) {
      return mesh.vertices_m[a].z < mesh.vertices_m[b].z;
    });
  }

  [[nodiscard]] std::uint32_t to(const Vec3& p) const {
    const auto from = std::lower_bound(order_.begin(), order_.end(), p.z, [this](std::uint32_t v, double z) {
      return mesh_.vertices_m[v].z < z;
    });
    std::uint32_t best = order_.front();
    double least_m = std::numeric_limits<double>::infinity();
    const auto tryOne = [&](std::uint32_t v) {
      const double away_m = norm(mesh_.vertices_m[v] - p);
      if (away_m < least_m) {
        least_m = away_m;
        best = v;
      }
      return std::abs(mesh_.vertices_m[v].z - p.z) < least_m;
    };
    for (auto up = from; up != order_.end() && tryOne(*up); ++up) {
    }
    for (auto down = from; down != order_.begin() && tryOne(*(down - 1)); --down) {
    }
    return best;
  }

 private:
  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> order_;
};

/// Fills gaps evenly from what lies around them.
void fillGaps(OrganWallMap& map) {
  const auto at = [&map](int band, int ridge) {
    return static_cast<std::size_t>(band) * static_cast<std::size_t>(map.ridges) +
           static_cast<std::size_t>((ridge + map.ridges) % map.ridges);
  };
  double sum_m = 0.0;
  for (std::size_t n = 0; n < map.seen.size(); ++n) {
    sum_m += map.seen[n] != 0 ? map.thickness_m[n] : 0.0;
  }
  const double mean_m = sum_m / static_cast<double>(map.seenPatches());
  for (std::size_t n = 0; n < map.seen.size(); ++n) {
    map.thickness_m[n] = map.seen[n] != 0 ? map.thickness_m[n] : mean_m;
  }
  for (int sweep = 0; sweep < kFillingSweeps; ++sweep) {
    for (int band = 0; band < map.bands; ++band) {
      for (int ridge = 0; ridge < map.ridges; ++ridge) {
        if (map.seen[at(band, ridge)] == 0) {
          map.thickness_m[at(band, ridge)] =
              0.25 * (map.thickness_m[at(band, ridge - 1)] + map.thickness_m[at(band, ridge + 1)] +
                      map.thickness_m[at(std::max(band - 1, 0), ridge)] +
                      map.thickness_m[at(std::min(band + 1, map.bands - 1), ridge)]);
        }
      }
    }
  }
}

/// Mean radius of the section in the middle of a band, by its area.
double radiusOf_m(const SectionLattice& lattice, int band) {
  double area_m2 = 0.0;
  for (const int j : {band, band + 1}) {
    const std::span<const Point2> outline = lattice.outline_m(j);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Point2& next = outline[(i + 1) % outline.size()];
      area_m2 += 0.25 * (outline[i][0] * next[1] - next[0] * outline[i][1]);
    }
  }
  return std::sqrt(std::max(area_m2, 0.0) / kPi);
}

}  // namespace

std::size_t OrganWallMap::seenPatches() const noexcept {
  return static_cast<std::size_t>(
      std::count_if(seen.begin(), seen.end(), [](std::uint8_t one) { return one != 0; }));
}

std::optional<OrganWallMap> wallMapOf(std::span<const WallRay> rays, const TriangleMesh& mesh,
                                      const SectionLattice& lattice) {
  TORSIO_EXPECTS(lattice.vertexCoordinates().size() == mesh.vertices_m.size());
  OrganWallMap map{lattice.sections() - 1, lattice.ridges(), {}, {}};
  const auto patches = static_cast<std::size_t>(map.bands) * static_cast<std::size_t>(map.ridges);
  std::vector<std::vector<double>> found_m(patches);
  const NearestVertex nearest(mesh);
  for (const WallRay& ray : rays) {
    if (!isFinite(ray.place_mm) || !std::isfinite(ray.thickness_mm) || ray.thickness_mm <= 0.0) {
      continue;  // it comes from another process
    }
    const std::uint32_t v = nearest.to(1e-3 * ray.place_mm);
    if (lattice.vertexParts()[v] != LatticePart::kSide) {
      continue;  // the flat end of an organ is not a wall around its axis
    }
    const LatticeCoordinate& at = lattice.vertexCoordinates()[v];
    const auto band = std::min(static_cast<std::size_t>(at.arc_m / lattice.length_m() * map.bands),
                               static_cast<std::size_t>(map.bands - 1));
    const auto ridge = std::min(static_cast<std::size_t>(at.angle_rad / (2.0 * kPi) * map.ridges),
                                static_cast<std::size_t>(map.ridges - 1));
    found_m[band * static_cast<std::size_t>(map.ridges) + ridge].push_back(1e-3 * ray.thickness_mm);
  }
  map.thickness_m.assign(patches, 0.0);
  map.seen.assign(patches, 0);
  for (std::size_t n = 0; n < patches; ++n) {
    std::vector<double>& here_m = found_m[n];
    if (!here_m.empty()) {
      const auto middle = here_m.begin() + static_cast<std::ptrdiff_t>(here_m.size() / 2);
      std::nth_element(here_m.begin(), middle, here_m.end());
      map.thickness_m[n] = *middle;
      map.seen[n] = 1;
    }
  }
  if (static_cast<double>(map.seenPatches()) < kLeastSeen * static_cast<double>(patches)) {
    return std::nullopt;
  }
  fillGaps(map);
  for (std::size_t n = 0; n < patches; ++n) {
    const int band = static_cast<int>(n / static_cast<std::size_t>(map.ridges));
    map.thickness_m[n] = std::min(map.thickness_m[n], kMaxOfRadius * radiusOf_m(lattice, band));
  }
  return map;
}

std::vector<std::array<double, 2>> thicknessAlong_m(const OrganWallMap& map) {
  std::vector<std::array<double, 2>> along;
  for (int band = 0; band < map.bands; ++band) {
    double softness = 0.0;
    for (int ridge = 0; ridge < map.ridges; ++ridge) {
      softness +=
          1.0 / map.thickness_m[static_cast<std::size_t>(band) * static_cast<std::size_t>(map.ridges) +
                                static_cast<std::size_t>(ridge)];
    }
    along.push_back({(band + 0.5) / map.bands, map.ridges / softness});
  }
  return along;
}

std::vector<WallPlace> wallPlaces(const SectionLattice& lattice, const WallMap& wall, double from_m,
                                  double to_m) {
  constexpr int kPlaces = 41;
  const auto [low_m, high_m] = std::minmax(from_m, to_m);
  std::vector<double> arcs_m;
  for (int i = 0; i < kPlaces; ++i) {
    arcs_m.push_back(std::min(high_m, low_m + (high_m - low_m) * i / (kPlaces - 1)));
  }
  std::vector<WallPlace> places;
  const std::vector<LatticeOutline> outlines = lattice.outlinesAt(arcs_m);
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    const double thickness_m = wall.thickness_m(arcs_m[i] / lattice.length_m());
    places.push_back(
        {wallSection(outlines[i].points_m, {&thickness_m, 1}, kSaidInMillimetres).radius, thickness_m});
  }
  if (from_m > to_m) {
    std::reverse(places.begin(), places.end());
  }
  return places;
}

}  // namespace torsio
