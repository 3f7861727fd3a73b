// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "sim/baseline/corotational_tetrahedra.h"
#include "sim/baseline/twist_dynamics.h"

namespace torsio {

/// Finite elements in motion, as interactive simulators compute a frame: corotational linear tetrahedra, one
/// linearised step of implicit Euler, conjugate gradients with the diagonal blocks as preconditioner, stopped
/// at a thousandth of the right side or 200 steps. The turned part is a rigid body with one freedom, four
/// where its place is free. One thread.
class CorotationalFrames {
 public:
  /// Prepares masses and the pattern of the matrix. Throws Error{kBadParameter} as CorotationalTetrahedra.
  CorotationalFrames(const SweptSolid& solid, TwistEnds ends, const ElasticConstants& constants,
                     const DynamicsOptions& options);

  /// Computes the next frame under a torque on the turned part, N m.
  void step(double torque_Nm);
  /// Computes the next frame with the turned part led to this angle, rad: a small turn a frame.
  void stepTo(double angle_rad);

  [[nodiscard]] const TwistEnds& ends() const noexcept { return ends_; }
  [[nodiscard]] const TwistPose& pose() const noexcept { return pose_; }
  [[nodiscard]] const CorotationalTetrahedra& body() const noexcept { return body_; }
  /// Returns the steps of the conjugate gradients in the last frame.
  [[nodiscard]] int gradientSteps() const noexcept { return gradientSteps_; }

 private:
  /// One number for each number of each node, then the angle's and the three of the turned part's way.
  using Field = std::vector<double>;

  /// Computes the next frame, the turned part under a torque or led by `turn_rad`.
  void advance(double torque_Nm, std::optional<double> turn_rad);
  void makePattern(const SolidMesh& mesh);
  void assemble();
  void makePreconditioner();
  /// Applies the reduced matrix: held nodes stay, turned ones follow the last numbers.
  void apply(const Field& in, Field& out);
  void reduce(Field& field) const;
  void expand(Field& field) const;
  void precondition(const Field& in, Field& out) const;

  TwistEnds ends_;
  DynamicsOptions options_;
  std::vector<Vec3> rest_m_;
  CorotationalTetrahedra body_;
  std::vector<double> masses_kg_;
  std::size_t turn_ = 0;       ///< where the numbers of the turned part begin in a field
  std::vector<int> kind_;      ///< of a node: 0 free, 1 held, 2 turned
  std::vector<int> rowStart_;  ///< block rows of the matrix
  std::vector<int> column_;
  std::vector<int> placeOf_;  ///< [16 cell + 4 a + b]: which block
  std::vector<Matrix3> blocks_;
  std::vector<Matrix3> inverse_;           ///< of the diagonal blocks
  std::array<double, 4> inverseTurned_{};  ///< of the diagonal of the turned part's freedoms
  std::vector<Vec3> motion_m_;             ///< d place / d angle of the turned nodes, else 0
  std::vector<Vec3> forces_N_;
  TwistPose pose_;
  Field velocity_;
  Field full_;  ///< scratch of apply
  int gradientSteps_ = 0;
};

}  // namespace torsio
