// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>

#include "sim/baseline/elastic_body.h"
#include "sim/baseline/lattice_surface.h"
#include "sim/baseline/spring_lattice.h"
#include "sim/tissue/twist/twist_model.h"
#include "sim/tissue/view/cpu_isa.h"

namespace torsio {

/// One model of an organ with one end held and a torque on the other, or on a jaw: the twist model, the rod,
/// finite elements or springs. Making one is its set-up; then frames are stepped as a view would ask for
/// them, and at any time the model can be brought to equilibrium. One thread.
class TwistSimulation {
 public:
  TwistSimulation() = default;
  TwistSimulation(const TwistSimulation&) = delete;
  TwistSimulation& operator=(const TwistSimulation&) = delete;
  virtual ~TwistSimulation() = default;

  /// Computes the next frame under a torque at the turned end or jaw, N m. Models in motion move on by a
  /// frame's time; the others are in equilibrium at once.
  virtual void step(double torque_Nm) = 0;
  /// Brings the model to equilibrium with the torque. Throws Error{kBadParameter} when there is none near.
  virtual void settle(double torque_Nm) = 0;
  /// Returns how far the turned end or jaw has turned, rad.
  [[nodiscard]] virtual double angle_rad() const = 0;
  /// Returns the stored elastic energy, J.
  [[nodiscard]] virtual double energy_J() const = 0;
  /// Returns the key points where they now are.
  [[nodiscard]] virtual LatticePlaces surface() const = 0;
  /// Returns how many numbers the model solves for.
  [[nodiscard]] virtual int unknowns() const = 0;
};

/// What the models have in common. Lattice, mesh and model outlive the simulations.
struct ComparedOrgan {
  const TriangleMesh* mesh = nullptr;
  const SectionLattice* lattice = nullptr;
  ElasticConstants constants;
  DynamicsOptions dynamics;
  TwistHold hold{};
  /// Called many times a second while a model looks for its equilibrium; what it throws ends that. Empty:
  /// none.
  std::function<void()> check{};

  /// Returns the arc length of what is turned: the jaw, or the free end.
  [[nodiscard]] double graspArc_m() const { return hold.grasp.value_or(1.0) * lattice->length_m(); }
};

/// Makes the twist model's simulation: a frame moves every vertex of the mesh as the view does, the key
/// points lie on it, with the kernels of an instruction set. `model`: of this organ, clamped and free,
/// twisted about its own axis.
[[nodiscard]] std::unique_ptr<TwistSimulation> twistModelSimulation(const ComparedOrgan& organ,
                                                                    const TwistModel& model, Isa isa);
/// Makes corotational linear tetrahedra with `rings` rings of elements.
[[nodiscard]] std::unique_ptr<TwistSimulation> finiteElementSimulation(const ComparedOrgan& organ, int rings);
struct MassSpringOptions {
  int substeps = 10;                                    ///< of XPBD, a frame's
  Calibration calibration = Calibration::kEquilibrium;  ///< the better one
};

/// Makes the mass-spring model with `rings` rings, calibrated by `model`.
[[nodiscard]] std::unique_ptr<TwistSimulation> massSpringSimulation(const ComparedOrgan& organ,
                                                                    const TwistModel& model, int rings,
                                                                    const MassSpringOptions& options);
/// Makes the accuracy reference: neo-Hookean wedges, quadratic ones if the lattice has an even number of
/// ridges and an odd number of sections, else linear ones. A step finds the equilibrium from the last one.
[[nodiscard]] std::unique_ptr<TwistSimulation> referenceSimulation(const ComparedOrgan& organ, int rings);

/// Returns how many elements a rod needs that stands on a lattice beside elements: one a step between
/// sections, so that a jaw has the same sections in both, within what a rod bears (31 to 63).
[[nodiscard]] int rodElementsOn(const SectionLattice& lattice);

/// Returns the part of an organ that a rod of the sections of `model` deforms (TwistHold::span): where an end
/// rounds off to a tip, the tip is rigid.
[[nodiscard]] std::array<double, 2> rodSpan(const SectionLattice& lattice, const TwistModel& model);

/// Makes the organ as a curved rod, of the sections that `model` has: a frame is ticks of the rod, in which
/// the hand goes ahead until its coupling gives the torque, and the skin drawn from it. Ends and Poisson's
/// ratio as those of the elements.
[[nodiscard]] std::unique_ptr<TwistSimulation> rodSimulation(const ComparedOrgan& organ,
                                                             const TwistModel& model);

}  // namespace torsio
