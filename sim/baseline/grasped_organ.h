// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "sim/baseline/elastic_body.h"
#include "sim/baseline/lattice_surface.h"
#include "sim/core/tissue_model.h"
#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/tissue/twist/twist_model.h"

namespace torsio {

/// Rings of tetrahedra and springs round the centre of an organ in a hand: a coarser body than that of a
/// comparison, which has time.
inline constexpr int kGraspedRings = 2;
/// Poisson's ratio of the elements in a hand, as in a comparison.
inline constexpr double kGraspedPoisson = 0.45;
/// Turn of the jaw above which an elastic model gives up following at once: a faster hand is followed with
/// this turn a frame.
inline constexpr double kMaxTurn_rad = 0.15;

/// What the models of an organ in a hand have in common, whichever it is: the twist model, finite elements or
/// springs. A jaw turns one section in its place; every call moves the model on by one frame. One thread.
class GraspedOrgan {
 public:
  GraspedOrgan() = default;
  GraspedOrgan(const GraspedOrgan&) = delete;
  GraspedOrgan& operator=(const GraspedOrgan&) = delete;
  virtual ~GraspedOrgan() = default;

  /// Computes the next frame, the jaw being led to this angle. A model in motion comes nearer by
  /// kMaxTurn_rad at most.
  virtual void turnTo(double angle_rad) = 0;
  /// Returns how far the jaw has turned, rad.
  [[nodiscard]] virtual double angle_rad() const = 0;
  /// Returns the torque with which the organ resists the jaw, N m.
  [[nodiscard]] virtual double torque_Nm() const = 0;
  /// Returns the torque over the angle: between rest and here, so that what continues along it is at rest
  /// where the organ is. Near rest that of a small turn, N m/rad.
  [[nodiscard]] virtual double slope_Nm_per_rad() const = 0;
  /// Returns the key points where they now are.
  [[nodiscard]] virtual LatticePlaces surface() const = 0;
};

/// An organ and where the jaw holds it. All pointees outlive the model of it.
struct Grasp {
  const TriangleMesh* mesh = nullptr;
  const SectionLattice* lattice = nullptr;
  const TwistModel* model = nullptr;  ///< of the organ, as its exercise holds its ends
  double arc_m = 0.0;                 ///< of the jaw, from the fixed end
};

/// Makes the model of an organ in a hand, at rest. Takes fractions of a second. Throws Error{kBadParameter}
/// where the jaw reaches what is held.
[[nodiscard]] std::unique_ptr<GraspedOrgan> graspedOrgan(TissueModel model, const Grasp& grasp);

/// Returns the torque with which a body resists its turned part in a pose, N m about the axis of the ends:
/// in equilibrium that of Equilibrium::keepAngle().
[[nodiscard]] double turningMoment_Nm(const ElasticBody& body, const TwistEnds& ends, const TwistPose& pose);

}  // namespace torsio
