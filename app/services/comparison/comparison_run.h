// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/services/base/progress.h"
#include "app/services/comparison/measured_markers.h"
#include "app/services/comparison/organ_markers.h"
#include "sim/baseline/twist_simulation.h"
#include "sim/core/text.h"
#include "sim/scene/scene.h"

namespace torsio {

/// What a time depends on besides the program; stands in every result that holds times.
struct MachineFacts {
  std::string processor;       ///< as the system names it; "unknown"
  int cores = 0;               ///< that the program may use; 0: unknown
  double loadAverage = -1.0;   ///< over the last minute; -1: unknown
  std::string instructionSet;  ///< that the view's kernels use; all else is built for the plain processor
  std::string compiler;        ///< "GNU 12.2.0"
  std::string flags;           ///< that decide about speed and rounding
};

/// Reads the facts of this machine now.
[[nodiscard]] MachineFacts machineFacts();

/// The lattice of a comparison unless another is asked for: the reference is then quadratic.
inline constexpr int kComparedRidges = 36;
inline constexpr int kComparedSections = 37;

struct ComparisonOptions {
  std::optional<double> torque_Nm;  ///< none: usualTorque_Nm()
  double poissonRatio = 0.45;       ///< of the elements; the twist model is incompressible
  double ramp_s = 1.0;              ///< the torque grows evenly for so long, then stays
  int rings = 4;                    ///< of tetrahedra and springs round the centre
  int referenceRings = 2;           ///< of the reference, even
  int courseMarker = 8;             ///< whose way over time is told (Fig. 14)
  MassSpringOptions springs;
  double poseEvery_s = 0.0;  ///< simulated time between the poses that a model keeps; 0: it keeps none
  /// Where a jaw turns the organ, a fraction of its length, all beyond it free; none: the last section is
  /// turned in its place.
  std::optional<double> grasp{};
};

/// Where the key points were at a moment of a model's course, to be shown.
struct ModelPose {
  double processing_s = 0.0;  ///< since rest: when a view would have had it
  double angle_rad = 0.0;     ///< of the free end
  LatticePlaces places;
};

/// A moment of a model's course.
struct CoursePoint {
  double time_s = 0.0;
  double torque_Nm = 0.0;
  double angle_rad = 0.0;       ///< of the turned end or jaw
  double displacement_m = 0.0;  ///< of the chosen marker (Eq. 24); 0 without markers
};

/// A state of a model, measured on the lattice.
struct ModelState {
  double angle_rad = 0.0;
  double energy_J = 0.0;
  double volumeRatio = 1.0;
  double radiusChange = 0.0;
  double roughness_m = 0.0;
  double rmse_m = 0.0;                  ///< of the key points against the reference
  double markerRmse_m = 0.0;            ///< of the markers' displacements (Eq. 24) against the reference
  std::vector<double> displacements_m;  ///< of the markers (Eq. 24)
};

struct ModelResult {
  std::string id;  ///< "pm", "paper", "rod", "fem", "msm", "reference"
  Text title;
  int unknowns = 0;
  double setUp_s = 0.0;
  int frames = 0;              ///< until the twist stood still
  double frameMedian_s = 0.0;  ///< processing time of a frame
  double frameWorst_s = 0.0;
  double deformation_s = 0.0;  ///< processing time of the whole twist (Fig. 10)
  double settle_s = 0.0;       ///< from the last frame to equilibrium; not part of the deformation time
  ModelState moving;           ///< as the last frame showed it
  Text noEquilibrium;          ///< why none was found; then `settled` is as `moving`. Empty: found
  ModelState settled;          ///< in equilibrium: what accuracy is read from
  std::vector<CoursePoint> course;
  double courseRmse_m = 0.0;     ///< of the marker's course against the reference's
  std::vector<ModelPose> poses;  ///< from rest to the last frame; see poseEvery_s
};

struct ComparisonResult {
  std::string organ;
  std::vector<OrganWarning> organWarnings;  ///< with which a user's organ was accepted
  int ridges = 0;
  int sections = 0;
  std::size_t vertices = 0;
  double length_m = 0.0;
  double shearModulus_Pa = 0.0;
  double torque_Nm = 0.0;
  ComparisonOptions options;
  MachineFacts machine;
  double latticeUpdate_s = 0.0;  ///< of the twist model, all key points
  std::vector<OrganMarker> markers;
  std::vector<ModelResult> models;  ///< the reference first
  std::vector<MeasuredSubject> measured;

  /// Returns the model with this id, which must be among them (contract).
  [[nodiscard]] const ModelResult& model(const std::string& id) const;
};

/// Computes the torque at the free end that turns it by the angle of the scene's pattern, N m, as the twist
/// model about the organ's own axis says. Builds that model: a tenth of a second.
[[nodiscard]] double usualTorque_Nm(const Scene& scene);

/// Twists the organ of a scene about its own axis by every model: one end held, the same torque growing on
/// the other, or on a jaw. Takes about a minute on two cores. `measured`: see readMeasuredMarkers. Throws
/// Error{kBadParameter} for options out of range and a torque that a model finds no equilibrium for.
/// `progress`: called several times a second all the while, from one thread at a time; what it throws ends
/// the comparison.
[[nodiscard]] ComparisonResult runComparison(const Scene& scene, const std::vector<OrganMarker>& markers,
                                             const std::vector<MeasuredSubject>& measured,
                                             const ComparisonOptions& options,
                                             const ProgressCallback& progress);

}  // namespace torsio
