// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "sim/baseline/elastic_body.h"
#include "sim/tissue/twist/twist_model.h"

namespace torsio {

/// A spring between two nodes: energy stiffness / 2 (length - rest)^2.
struct LengthSpring {
  std::array<int, 2> nodes{};
  double rest_m = 0.0;
  double stiffness_N_per_m = 0.0;
};

/// A spring that keeps the volume of a tetrahedron: energy stiffness / 2 (volume - rest)^2.
struct VolumeSpring {
  std::array<int, 4> nodes{};
  double rest_m3 = 0.0;
  double stiffness_J_per_m6 = 0.0;
};

/// A mass-spring model: structural springs along all edges of the prisms of a solid, shear springs along
/// both diagonals of each side (one alone would make the bar chiral), volume springs in the tetrahedra. A
/// length spring has G times its share of the volume over its length squared, a volume spring lambda over
/// its volume; one factor common to all, calibrated as a whole (calibrated).
class SpringLattice final : public ElasticBody {
 public:
  /// Makes springs of factor 1. Throws Error{kBadParameter} for the constants.
  SpringLattice(const SweptSolid& solid, const ElasticConstants& constants);

  /// Returns the same springs with a common factor such that the displaced `places_m` hold `energy_J`. Throws
  /// Error{kBadParameter} when the displacement holds no energy.
  [[nodiscard]] SpringLattice calibrated(std::span<const Vec3> places_m, double energy_J) const;
  /// Returns the same springs, all stiffer by a factor > 0 (contract).
  [[nodiscard]] SpringLattice scaled(double factor) const;

  [[nodiscard]] std::span<const LengthSpring> lengthSprings() const noexcept { return lengths_; }
  [[nodiscard]] std::span<const VolumeSpring> volumeSprings() const noexcept { return volumes_; }

  [[nodiscard]] std::size_t elements() const noexcept override { return lengths_.size() + volumes_.size(); }
  [[nodiscard]] std::span<const int> elementNodes(std::size_t element) const noexcept override;
  [[nodiscard]] bool elementForces(std::size_t element, std::span<const Vec3> places_m, double& energy_J,
                                   std::span<Vec3> forces_N) const override;
  void elementStiffness(std::size_t element, std::span<const Vec3> places_m,
                        std::span<double> stiffness) const override;

 private:
  std::vector<LengthSpring> lengths_;
  std::vector<VolumeSpring> volumes_;
};

/// Volume of a tetrahedron and its derivatives by the places of its corners (m^2).
struct VolumeGradient {
  double volume_m3 = 0.0;
  std::array<Vec3, 4> byPlace;
};
[[nodiscard]] VolumeGradient volumeGradient(const std::array<Vec3, 4>& corners_m) noexcept;

/// Adds up the energy of a body, J; the places must not turn an element inside out (contract).
[[nodiscard]] double elasticEnergy_J(const ElasticBody& body, std::span<const Vec3> places_m);

/// How the common stiffness of all springs is found.
enum class Calibration {
  /// Turning every section as the membrane analogy says for a small torque T takes T^2 / (2 K), the energy it
  /// gives: the usual way. The springs then give way further, and are too soft.
  kAffine,
  /// In equilibrium the free end turns as far under a small torque as the membrane analogy says.
  kEquilibrium,
};

/// Returns the springs of a solid with the stiffness that `model` calibrates: of this organ, clamped and
/// free, twisted about its own axis. `check`: see Equilibrium. Throws as SpringLattice and Equilibrium.
[[nodiscard]] SpringLattice calibratedSprings(const SweptSolid& solid, const SectionLattice& lattice,
                                              const ElasticConstants& constants, const TwistModel& model,
                                              Calibration calibration,
                                              const std::function<void()>& check = {});

/// Springs in motion by extended position-based dynamics (Macklin, Mueller and Chentanez 2016): small
/// substeps, one pass over all springs each. The turned part is a rigid body with one freedom, four where its
/// place is free. Quick and never unstable; its stiffness depends on substeps and masses, and only many
/// substeps approach the equilibrium of the springs. One thread.
class XpbdFrames {
 public:
  /// Prepares masses. `substeps`: a frame's, 1 or more (Error{kBadParameter}).
  XpbdFrames(const SweptSolid& solid, TwistEnds ends, SpringLattice springs, const DynamicsOptions& options,
             int substeps);

  /// Computes the next frame under a torque on the turned part, N m.
  void step(double torque_Nm);
  /// Computes the next frame with the turned part led to this angle, rad: a small turn a frame.
  void stepTo(double angle_rad);

  [[nodiscard]] const TwistEnds& ends() const noexcept { return ends_; }
  [[nodiscard]] const TwistPose& pose() const noexcept { return pose_; }
  [[nodiscard]] const SpringLattice& body() const noexcept { return springs_; }

 private:
  void substep(double torque_Nm, double time_s);
  /// Moves the nodes of one spring so that it does what its stiffness says. `excess`: length or volume over
  /// that at rest; `gradients`: its derivatives by the places.
  void project(std::span<const int> nodes, std::span<const Vec3> gradients, double excess,
               double inverseStiffness_per_s2);
  [[nodiscard]] Vec3 endPlace(std::size_t node) const noexcept;

  TwistEnds ends_;
  DynamicsOptions options_;
  std::vector<Vec3> rest_m_;
  SpringLattice springs_;
  int substeps_ = 10;
  std::vector<double> inverseMass_;  ///< of a node; 0 held or turned
  std::vector<char> turned_;         ///< whether the node belongs to the turned part
  double inverseInertia_ = 0.0;      ///< of the turned part about its axis
  double inverseTurnedMass_ = 0.0;   ///< of the turned part; 0 where its place is held
  double angle_rad_ = 0.0;           ///< of the turned part within a substep
  double cosine_ = 1.0;
  double sine_ = 0.0;
  double spin_rad_per_s_ = 0.0;
  Vec3 turnedVelocity_;
  std::vector<Vec3> velocity_;
  std::vector<Vec3> before_m_;
  TwistPose pose_;
};

}  // namespace torsio
