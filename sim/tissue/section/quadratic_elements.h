// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "sim/tissue/section/plane_mesh.h"

namespace torsio {

/// Both fields of one section on six-node triangles, for G = 1, unit twist rate, q/f = 1, about the origin.
struct QuadraticFields {
  std::vector<Point2> nodes;                 ///< mesh points, then edge middles
  std::vector<std::array<int, 6>> elements;  ///< corners 0, 1, 2, then the middles facing them
  std::vector<int> loop;                     ///< per node: boundary loop or -1
  std::vector<double> arc;                   ///< per node: way along its loop
  std::vector<double> membrane;              ///< z: lap z = -1, 0 on the outline, level on each hole
  std::vector<double> warping;               ///< psi, mean over the section 0
  std::vector<double> edgeForce;             ///< per node: integral of -dz/dn times its shape function
  std::vector<double> gap;                   ///< per element: its share of upper - lower (hypercircle)
  double lower = 0.0;                        ///< J from the stress function: never above the true one
  double upper = 0.0;                        ///< J from the warping function: never below the true one
};

/// Quadratic finite elements for the membrane (Eqs. 10-12) and the warping function. Keeps the ordering and
/// symbolic factorisation of the last mesh: meshes of the same topology cost the numbers only. One thread.
class QuadraticElements {
 public:
  QuadraticElements();
  ~QuadraticElements();
  QuadraticElements(QuadraticElements&&) noexcept;
  QuadraticElements& operator=(QuadraticElements&&) noexcept;

  /// Solves both fields on `mesh`. `holeAreas`: one a hole of the mesh, positive.
  [[nodiscard]] QuadraticFields solve(const PlaneMesh& mesh, std::span<const double> holeAreas);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace torsio
