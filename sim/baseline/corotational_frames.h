// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "sim/baseline/elastic_body.h"
#include "sim/baseline/stress_laws.h"

namespace torsio {

/// Finite elements as interactive simulators use them: linear tetrahedra, linear elasticity in the turned
/// frame of each. They lock: a coarse bar is much too stiff in torsion.
class CorotationalTetrahedra final : public ElasticBody {
 public:
  /// Prepares the elements. Throws Error{kBadParameter} for the constants.
  CorotationalTetrahedra(SolidMesh mesh, std::span<const Vec3> rest_m, const ElasticConstants& constants);

  [[nodiscard]] std::size_t elements() const noexcept override { return mesh_.cells(); }
  [[nodiscard]] std::span<const int> elementNodes(std::size_t element) const noexcept override {
    return mesh_.cell(element);
  }
  [[nodiscard]] bool elementForces(std::size_t element, std::span<const Vec3> places_m, double& energy_J,
                                   std::span<Vec3> forces_N) const override;
  void elementStiffness(std::size_t element, std::span<const Vec3> places_m,
                        std::span<double> stiffness) const override;

  /// Computes forces and the stiffness that interactive simulators use, R K R^T with the rotation held
  /// still: never indefinite. `blocks`: 16 matrices, the one of nodes a and b at [4 a + b].
  void warpedStiffness(std::size_t element, std::span<const Vec3> places_m, std::span<Vec3> forces_N,
                       std::span<Matrix3> blocks) const;

  [[nodiscard]] double volume_m3(std::size_t element) const noexcept { return volumes_m3_[element]; }

 private:
  [[nodiscard]] Matrix3 gradientOf(std::size_t element, std::span<const Vec3> places_m) const;

  SolidMesh mesh_;
  ElasticConstants constants_;
  std::vector<double> volumes_m3_;
  std::vector<std::array<Vec3, 4>> gradients_;  ///< of the shape functions by the place at rest, 1/m
};

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
