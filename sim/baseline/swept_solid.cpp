// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/baseline/swept_solid.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

#include "sim/core/error.h"

namespace torsio {

namespace {

/// Above this a factorisation takes gigabytes.
constexpr double kMaxSolidPoints = 200'000.0;

double sixVolumes(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return dot(b - a, cross(c - a, d - a));
}

std::string sectionName(std::size_t section) {
  return "section " + std::to_string(section + 1);
}

void checkOutlines(std::span<const std::vector<Vec3>> outlines_m, int rings) {
  if (outlines_m.size() < 2) {
    refuseParameter(Text::tr("A solid needs at least 2 sections"), Text::tr("sections"),
                    Text::tr("Give 2 or more"));
  }
  if (rings < 1) {
    refuseParameter(Text::tr("A solid needs at least 1 ring"), Text::tr("rings"), Text::tr("Give 1 or more"));
  }
  const std::size_t count = outlines_m.front().size();
  if (count < 3) {
    refuseParameter(Text::tr("An outline needs at least 3 points"), Text::tr("ridges"),
                    Text::tr("Give 3 or more"));
  }
  const double points = static_cast<double>(outlines_m.size()) * (1.0 + static_cast<double>(count) * rings);
  if (points > kMaxSolidPoints) {
    refuseParameter(Text::tr("The solid would have more than 200000 points"), Text::tr("rings"),
                    Text::tr("Give fewer ridges, sections or rings"));
  }
  for (std::size_t j = 0; j < outlines_m.size(); ++j) {
    if (outlines_m[j].size() != count) {
      refuseParameter(Text::tr("The outlines have different numbers of points"), sectionName(j),
                      Text::tr("Give each section as many points as the first"));
    }
    if (!std::all_of(outlines_m[j].begin(), outlines_m[j].end(), [](const Vec3& p) { return isFinite(p); })) {
      refuseParameter(Text::tr("A coordinate is not a finite number"), sectionName(j),
                      Text::tr("Give finite coordinates in metres"));
    }
  }
}

/// Centroid of the area of an outline that is nearly plane.
Vec3 areaCentroid(const std::vector<Vec3>& outline) {
  Vec3 mean;
  for (const Vec3& p : outline) {
    mean += p / static_cast<double>(outline.size());
  }
  Vec3 normal;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    normal += cross(outline[k] - mean, outline[(k + 1) % outline.size()] - mean);
  }
  normal = normalized(normal);
  Vec3 moment;
  double area = 0.0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec3 a = outline[k] - mean;
    const Vec3 b = outline[(k + 1) % outline.size()] - mean;
    const double part = dot(normal, cross(a, b));
    area += part;
    moment += (part / 3.0) * (a + b);
  }
  return area != 0.0 ? mean + moment / area : mean;
}

/// Triangles of a section as (ring, ridge) pairs, anticlockwise, over a grid of `rings` x `count`; the
/// diagonals alternate like the squares of a chessboard.
using GridPoint = std::array<int, 2>;
std::vector<std::array<GridPoint, 3>> sectionTriangles(int count, int rings) {
  std::vector<std::array<GridPoint, 3>> triangles;
  for (int i = 0; i < count; ++i) {
    triangles.push_back({GridPoint{0, 0}, GridPoint{1, i}, GridPoint{1, i + 1}});
    for (int ring = 1; ring < rings; ++ring) {
      const GridPoint inner{ring, i};
      const GridPoint outer{ring + 1, i};
      const GridPoint outerNext{ring + 1, i + 1};
      const GridPoint innerNext{ring, i + 1};
      if ((i + ring) % 2 == 1) {
        triangles.push_back({inner, outer, outerNext});
        triangles.push_back({inner, outerNext, innerNext});
      } else {
        triangles.push_back({inner, outer, innerNext});
        triangles.push_back({outer, outerNext, innerNext});
      }
    }
  }
  return triangles;
}

void requireNoFold(const SweptSolid& solid) {
  const SolidMesh mesh = tetrahedra(solid);
  const std::vector<double> volumes = tetrahedronVolumes(mesh, solid.points_m);
  const std::size_t perLayer = mesh.cells() / static_cast<std::size_t>(solid.sections - 1);
  for (std::size_t c = 0; c < volumes.size(); ++c) {
    if (!(volumes[c] > 0.0)) {
      throw Error(
          ErrorCode::kBadMesh,
          Text::tr(
              "The organ cannot be filled with elements: an outline is not star-shaped about its centre, or "
              "two sections cross"),
          sectionName(c / perLayer) + " to the next", Text::tr("Give other ends, or fewer sections"));
    }
  }
}

}  // namespace

SweptSolid sweptSolid(std::span<const std::vector<Vec3>> outlines_m, const Vec3& endTangent, int rings) {
  checkOutlines(outlines_m, rings);
  SweptSolid solid;
  solid.ridges = static_cast<int>(outlines_m.front().size());
  solid.sections = static_cast<int>(outlines_m.size());
  solid.rings = rings;
  solid.endTangent = normalized(endTangent);
  for (const std::vector<Vec3>& outline : outlines_m) {
    const Vec3 centre = areaCentroid(outline);
    solid.points_m.push_back(centre);
    for (int ring = 1; ring <= rings; ++ring) {
      const double share = static_cast<double>(ring) / rings;
      for (const Vec3& p : outline) {
        solid.points_m.push_back(centre + share * (p - centre));
      }
    }
    solid.endCentre_m = centre;
  }
  requireNoFold(solid);
  return solid;
}

SweptSolid sweptSolid(const SectionLattice& lattice, int rings) {
  std::vector<std::vector<Vec3>> outlines;
  for (int j = 0; j < lattice.sections(); ++j) {
    std::vector<Vec3> outline;
    for (int ridge = 0; ridge < lattice.ridges(); ++ridge) {
      outline.push_back(lattice.keyPoint_m(ridge, j));
    }
    outlines.push_back(std::move(outline));
  }
  return sweptSolid(outlines, lattice.frameAt(lattice.length_m()).tangent, rings);
}

Vec3 sectionTangent(const SweptSolid& solid, int section) {
  if (section == solid.sections - 1) {
    return solid.endTangent;
  }
  const int middle = section == 0 && solid.sections > 2 ? 1 : section;
  const Vec3 after = solid.centre_m(middle + 1) - solid.centre_m(middle);
  if (middle == 0) {
    return normalized(after);
  }
  const Vec3 before = solid.centre_m(middle) - solid.centre_m(middle - 1);
  const double a = norm(before);
  const double b = norm(after);
  const Vec3 slope = (b * b) * before + (a * a) * after;  // at the middle, times a b (a + b)
  const Vec3 bend = a * after - b * before;               // half the second derivative, likewise
  return normalized(section == middle ? slope : slope - (2.0 * a) * bend);
}

double sectionArea_m2(const SweptSolid& solid, int section) {
  Vec3 twice;
  for (int k = 0; k < solid.ridges; ++k) {
    const auto arm = [&](int ridge) {
      return solid.points_m[static_cast<std::size_t>(solid.point(section, solid.rings, ridge))] -
             solid.centre_m(section);
    };
    twice += cross(arm(k), arm(k + 1));
  }
  return 0.5 * norm(twice);
}

namespace {

/// A corner of a prism: which of its three edges along the organ, and whether at the upper end.
struct PrismCorner {
  std::size_t edge = 0;
  bool up = false;
};

/// Divides a prism into three tetrahedra of positive volume. `below`: numbers of its lower corners,
/// anticlockwise. Numbers grow with the section, so on each side face the lowest is the lower of the two
/// below, and two prisms that share a face agree on its diagonal. The three are put in order by turning and,
/// if need be, swapping, which the sign of the volume undoes.
std::array<std::array<PrismCorner, 4>, 3> prismTetrahedra(const std::array<int, 3>& below) {
  std::array<std::size_t, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](std::size_t p, std::size_t q) { return below[p] < below[q]; });
  const auto [a, b, c] = order;
  const bool turned = b == (a + 1) % 3;
  std::array<std::array<PrismCorner, 4>, 3> all{{{{{a, false}, {b, false}, {c, false}, {c, true}}},
                                                 {{{a, false}, {b, false}, {c, true}, {b, true}}},
                                                 {{{a, false}, {b, true}, {c, true}, {a, true}}}}};
  for (auto& tetrahedron : all) {
    if (!turned) {
      std::swap(tetrahedron[1], tetrahedron[2]);
    }
  }
  return all;
}

/// Number of the node of a quadratic wedge in the middle of two of its corners, or of one of them.
std::size_t wedgeMiddle(const PrismCorner& p, const PrismCorner& q) {
  constexpr std::size_t kNodesOfALevel = 6;
  const std::size_t level = (p.up ? 1 : 0) + (q.up ? 1 : 0);
  // Middles 3, 4, 5 of the sides 01, 12, 20.
  const std::size_t side = p.edge + q.edge == 1 ? 3 : p.edge + q.edge == 3 ? 4 : 5;
  return level * kNodesOfALevel + (p.edge == q.edge ? p.edge : side);
}

}  // namespace

SolidMesh tetrahedra(const SweptSolid& solid) {
  SolidMesh mesh;
  const int step = solid.pointsPerSection();
  const auto triangles = sectionTriangles(solid.ridges, solid.rings);
  for (int j = 0; j + 1 < solid.sections; ++j) {
    for (const auto& triangle : triangles) {
      std::array<int, 3> below{};
      for (std::size_t k = 0; k < 3; ++k) {
        below[k] = solid.point(j, triangle[k][0], triangle[k][1]);
      }
      for (const auto& tetrahedron : prismTetrahedra(below)) {
        for (const auto& [corner, up] : tetrahedron) {
          mesh.nodes.push_back(below[corner] + (up ? step : 0));
        }
      }
    }
  }
  return mesh;
}

SolidMesh linearWedges(const SweptSolid& solid) {
  SolidMesh mesh;
  mesh.nodesPerCell = 6;
  const auto triangles = sectionTriangles(solid.ridges, solid.rings);
  for (int j = 0; j + 1 < solid.sections; ++j) {
    for (const auto& triangle : triangles) {
      for (int up = 0; up < 2; ++up) {
        for (const GridPoint& p : triangle) {
          mesh.nodes.push_back(solid.point(j + up, p[0], p[1]));
        }
      }
    }
  }
  return mesh;
}

SolidMesh quadraticWedges(const SweptSolid& solid) {
  if (solid.ridges % 2 != 0 || solid.rings % 2 != 0 || solid.sections % 2 != 1) {
    refuseParameter(Text::tr("Quadratic elements reach over two ridges, two rings and two sections"),
                    Text::tr("lattice"),
                    Text::tr("Give an even number of ridges and rings and an odd number of sections"));
  }
  SolidMesh mesh;
  mesh.nodesPerCell = 18;
  const auto triangles = sectionTriangles(solid.ridges / 2, solid.rings / 2);
  for (int j = 0; j + 2 < solid.sections; j += 2) {
    for (const auto& triangle : triangles) {
      for (int up = 0; up < 3; ++up) {
        for (const GridPoint& p : triangle) {
          mesh.nodes.push_back(solid.point(j + up, 2 * p[0], 2 * p[1]));
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const GridPoint& p = triangle[k];
          const GridPoint& q = triangle[(k + 1) % 3];
          // The centre lies on every ridge: a side that leaves it stays on the ridge of its other end.
          const int ridge = p[0] == 0 ? 2 * q[1] : q[0] == 0 ? 2 * p[1] : p[1] + q[1];
          mesh.nodes.push_back(solid.point(j + up, p[0] + q[0], ridge));
        }
      }
    }
  }
  return mesh;
}

SolidMesh quadraticTetrahedra(const SweptSolid& solid) {
  const SolidMesh wedges = quadraticWedges(solid);
  SolidMesh mesh;
  mesh.nodesPerCell = kQuadraticTetrahedronNodes;
  for (std::size_t cell = 0; cell < wedges.cells(); ++cell) {
    const std::span<const int> nodes = wedges.cell(cell);
    for (const auto& corners : prismTetrahedra({nodes[0], nodes[1], nodes[2]})) {
      for (const PrismCorner& corner : corners) {
        mesh.nodes.push_back(nodes[wedgeMiddle(corner, corner)]);
      }
      for (std::size_t k = 0; k < corners.size(); ++k) {
        for (std::size_t m = k + 1; m < corners.size(); ++m) {
          mesh.nodes.push_back(nodes[wedgeMiddle(corners[k], corners[m])]);
        }
      }
    }
  }
  return mesh;
}

std::vector<double> tetrahedronVolumes(const SolidMesh& mesh, std::span<const Vec3> points_m) {
  std::vector<double> volumes;
  volumes.reserve(mesh.cells());
  for (std::size_t c = 0; c < mesh.cells(); ++c) {
    const std::span<const int> cell = mesh.cell(c);
    const auto at = [&](std::size_t k) { return points_m[static_cast<std::size_t>(cell[k])]; };
    volumes.push_back(sixVolumes(at(0), at(1), at(2), at(3)) / 6.0);
  }
  return volumes;
}

}  // namespace torsio
