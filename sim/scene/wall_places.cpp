// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/wall_places.h"

#include <algorithm>

namespace torsio {

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
    places.push_back({wallSection(outlines[i].points_m, {&thickness_m, 1}).radius, thickness_m});
  }
  if (from_m > to_m) {
    std::reverse(places.begin(), places.end());
  }
  return places;
}

}  // namespace torsio
