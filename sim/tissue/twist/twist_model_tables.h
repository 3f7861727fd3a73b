// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "sim/geometry/lattice/section_lattice.h"
#include "sim/tissue/twist/twist_model.h"

namespace torsio {

/// Arc length of any point near an organ at rest, such that on the surface it agrees with the lattice's own
/// coordinates. On a curved organ the sections of the lattice are not planes: what a tool touches would lie
/// some millimetres beside what a view draws if the arc length of a free point were simply that of the
/// nearest point of the centreline. The difference is tabled over (nearest arc length, polar angle) and fades
/// towards the axis. Straight lattices: sections are planes, the height itself. Immutable; the query is
/// noexcept, allocation-free, portable arithmetic only.
class ArcField {
 public:
  ArcField() = default;
  ArcField(const TriangleMesh& mesh, const SectionLattice& lattice);

  [[nodiscard]] double arcAt(const SectionLattice& lattice, const Vec3& point_m) const noexcept;

 private:
  struct Node {
    double shift_m = 0.0;   // lattice arc length minus nearest arc length, on the surface
    double radius_m = 0.0;  // distance of the surface from the centreline
  };
  struct Place {  // four nodes round a point, and where it lies between them
    std::size_t node[4] = {};
    double weight[4] = {};
  };
  [[nodiscard]] Place placeOf(double arc_m, double polar_rad) const noexcept;
  void fillGaps(std::vector<Node> sums, std::vector<double> weights);

  double length_m_ = 0.0;
  std::vector<Node> nodes_;  // [arc][angle]; empty: no shift
};

/// The line that a section turns about.
struct TwistLine {
  Vec3 point_m;
  Vec3 direction;
};

/// A vertex of the mesh as the model sees it.
struct TwistVertex {
  Vec3 rest_m;
  TwistLine line;
  double arc_m = 0.0;
  double warp_m2 = 0.0;           ///< psi: displacement along the axis for a twist rate of 1 rad/m
  TorsionTable::Place torsion{};  ///< of arc_m: a tick moves some hundred vertices and looks nothing up
};

/// A vertex between ridge K and the next one, for component kriging (Eq. 15).
struct RidgePlace {
  int ridge = 0;
  double share = 0.0;  ///< towards the next ridge
};

/// Everything that the queries of TwistModel need, computed once; immutable.
struct TwistModel::Tables {
  TorsionTable twist;  ///< over C(s), or H theta of the paper, rad/(N m)
  ArcField arcs;

  HermiteTable radius;           ///< m, of the circle of equal area
  HermiteTable shear;            ///< largest |tau| of the outline for G = 1 and unit twist rate, m
  HermiteTable strainPerTorque;  ///< arc of the grasp -> largest shear strain of the organ for 1 N m there

  double stiffeningStrain = 0.0;  ///< of the options; 0: linear

  bool shiftedCentre = false;
  HermiteTable centreX;  ///< centre of twist in the frame, m (kShearCentre)
  HermiteTable centreY;

  bool poynting = false;
  HermiteTable stretch;  ///< q = (dC/ds)^2 Ip / (2 A): x = (T)^2 q is theta^2 Ip / (2 A)
  /// Integrals of q^k t ds, k = 1..4, from the fixed end to each node of `stretch`.
  std::vector<std::array<Vec3, 4>> elongation_m;

  // The paper's linear displacements.
  bool linear = false;
  HermiteTable lift;  ///< m^2 per N m: dZ = lift h / sqrt(X^2 + Y^2 + h^2)
  double spacing_m = 0.0;
  bool components = false;
  std::vector<Vec3> keyTurn_m;          ///< [section N + ridge]: displacement for one radian of the section
  std::vector<Vec3> keyLift_m;          ///< for 1 N m
  std::vector<RidgePlace> ridgePlaces;  ///< one a vertex
  std::shared_ptr<const KrigingTable> alongRidge;  ///< one row a vertex

  std::vector<TwistVertex> vertices;
  /// What a vertex goes at most; for TwistModel::farthestWay_m.
  struct Reach {
    double radius_m = 0.0;  ///< from its line
    double warp_m2 = 0.0;
    double risingSlope = 0.0;
    double fallingSlope = 0.0;
    bool bounded = false;  ///< no vertex turns further than the grasp, and none is lifted or stretched
  };
  Reach reach;
  std::vector<double> patchArc_m;
  std::vector<double> patchShear_Pa_m;  ///< |tau| for unit twist rate
};

/// Computes the tables of a model. Throws as TwistModel's constructor.
[[nodiscard]] TwistModel::Tables makeTwistTables(const TriangleMesh& mesh, const SectionLattice& lattice,
                                                 const Material& material, const TwistModelOptions& options);

}  // namespace torsio
