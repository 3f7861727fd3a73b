// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "sim/anatomy/curves.h"
#include "sim/core/vec3.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// Half axes of one section along e1 and e2.
struct SectionSize {
  double e1 = 0.0;
  double e2 = 0.0;
};

/// Heights of the half ellipsoids that close the two ends, as a share of the half axis there.
struct Domes {
  double first = 0.0;
  double last = 0.0;
};

/// Adds the triangles of a closed tube: `rings` of `around` vertices each, one after the other, then the
/// middles of the first and of the last end.
void joinRings(TriangleMesh& mesh, std::uint32_t around, std::uint32_t rings);

/// A closed tube of elliptic sections on `frames`, both ends closed by `domes`. `bump(share, angle)` in file
/// units is added along the section's radius; share 0..1 is the arc length from the first end, angle is
/// measured from e1 to e2. Lengths as in `frames`. Sections do not cross as long as the radius of curvature
/// exceeds the half axis.
[[nodiscard]] TriangleMesh closedTube(const std::vector<CurveFrame>& frames, std::size_t around,
                                      const Domes& domes,
                                      const std::function<SectionSize(double share)>& size,
                                      const std::function<double(double share, double angle_rad)>& bump);

/// Computes the texture coordinates of a surface about `frames` (TubeOrgan::texture), in the unit of the
/// frames: the share of the length from the first frame, and of a turn from e1 over e2.
[[nodiscard]] std::vector<std::array<float, 2>> textureAlong(const TriangleMesh& surface,
                                                             const std::vector<CurveFrame>& frames);

struct CurveFrame;
struct TriangleMesh;

/// A place on the outer surface, by the way along the centreline from the fixed end and the angle about it,
/// right-handed in that direction from the organ's zero line.
struct OrganPlace {
  std::string name;
  double arc_mm = 0.0;
  double angle_deg = 0.0;  ///< [0, 360)
  Vec3 position_m;
};

/// A requested place: a share of the length and an angle.
struct WantedPlace {
  const char* name;
  double share;
  double angle_deg;
};

/// Named places and the zero line of an organ along a curve; metres, LPS.
struct OrganPlaces {
  std::vector<OrganPlace> markers;
  std::vector<Vec3> zeroLine_m;  ///< on the skin, every 10 mm
};

/// Finds places on a surface in metres that surrounds the curve `frames` (millimetres). The zero line runs
/// `zero_deg` from e1. Every place lies on the surface.
[[nodiscard]] OrganPlaces placesOn(const TriangleMesh& surface, const std::vector<CurveFrame>& frames,
                                   double zero_deg, const std::vector<WantedPlace>& wanted);

}  // namespace torsio
