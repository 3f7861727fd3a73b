// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "sim/anatomy/tube.h"
#include "sim/core/vec3.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio {

/// A tube-like organ with the points at which a twist holds it. Metres, LPS.
struct TubeOrgan {
  TriangleMesh surface;
  Vec3 fixedEnd_m;
  Vec3 freeEnd_m;
  Vec3 ridgeZero;  ///< direction from the axis in which ridge 0 lies
  /// Of each vertex: share of the length along the organ, and of a turn about it from ridge 0; both 0..1. The
  /// second jumps from 1 to 0 at ridge 0: unwrap it within a triangle.
  std::vector<std::array<float, 2>> texture;
  double length_mm = 0.0;  ///< of the centreline
  OrganPlaces places;      ///< of the stomach: in WholeStomach
};

/// Makes an organ of a fine surface about `frames`, both in millimetres: fixed at the first frame, remeshed
/// to triangles of this edge length, with its markers on angles from `zero_deg` (of e1).
[[nodiscard]] TubeOrgan organAlong(const TriangleMesh& fine, double edge_mm,
                                   const std::vector<CurveFrame>& frames,
                                   const std::vector<WantedPlace>& markers, double zero_deg = 0.0);

/// A J-shaped stomach without oesophagus: pylorus fixed, fundus free, ridge 0 on the lesser curvature.
/// Centreline 267 mm, about 710 ml; about ten thousand triangles. Older recordings were made on it;
/// makeWholeStomach() draws the one that is used now.
[[nodiscard]] TubeOrgan makeStomach();

/// A loop of small intestine, 200 mm long and about 27 mm wide, with gentle waves: about 20 000 triangles.
/// Its zero line is the antimesenteric border. `edges`: length of the triangles' edges over that of the
/// shipped mesh.
[[nodiscard]] TubeOrgan makeIntestine(double edges = 1.0);

/// The same in 6 724 triangles, which older recordings were made on.
[[nodiscard]] TubeOrgan makeFormerIntestine();

/// Thickness of the wall at a share of the length from the pylorus (0) to the top of the fundus (1).
struct StomachWall {
  double share = 0.0;
  double thickness_mm = 0.0;
};

/// The stomach with what belongs to it. Metres, LPS.
struct WholeStomach {
  TubeOrgan organ;
  double length_mm = 0.0;  ///< of the centreline from the pylorus to the top of the fundus
  Vec3 cardia_m;           ///< middle of the opening of the oesophagus
  Vec3 oesophagus;         ///< direction of its stub, outwards
  /// Ten; angles from the lesser curvature over the front.
  std::vector<OrganPlace> markers;
  std::vector<OrganPlace> landmarks;   ///< others of the anatomy
  std::vector<StomachWall> wall;       ///< ascending shares
  std::vector<Vec3> greaterOmentum_m;  ///< where it is fixed, pylorus to fundus
  std::vector<Vec3> lesserOmentum_m;   ///< pylorus to cardia
  std::vector<Vec3> zeroLine_m;        ///< lesser curvature, pylorus to cardia
};

/// Draws the J-shaped stomach with stub of the oesophagus, cardia, angle of His, a fundus that rises above
/// the cardia, incisura angularis, antrum, pylorus and bulb of the duodenum: fixed at the pylorus, the top of
/// the fundus free. `edges`: as for makeIntestine().
[[nodiscard]] WholeStomach makeWholeStomach(double edges = 1.0);

}  // namespace torsio
