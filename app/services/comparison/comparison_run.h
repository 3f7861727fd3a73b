// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/services/base/progress.h"
#include "app/services/comparison/machine_facts.h"
#include "app/services/comparison/measured_markers.h"
#include "app/services/comparison/organ_markers.h"
#include "sim/baseline/lattice_surface.h"
#include "sim/baseline/twist_simulation.h"
#include "sim/core/text.h"
#include "sim/scene/scene.h"

namespace torsio {

/// Default lattice of a comparison; it makes the reference quadratic.
inline constexpr int kComparedRidges = 36;
inline constexpr int kComparedSections = 37;

struct ComparisonOptions {
  std::optional<double> torque_Nm;  ///< empty: usualTorque_Nm()
  double poissonRatio = 0.45;       ///< of the elements; the twist model is incompressible
  double ramp_s = 1.0;              ///< the torque grows linearly for this time, then stays constant
  int rings = 4;                    ///< rings of tetrahedra and springs around the centre
  int referenceRings = 2;           ///< of the reference; an even number
  int courseMarker = 8;             ///< marker whose course is reported (Fig. 14)
  MassSpringOptions springs;
  double poseEvery_s = 0.0;  ///< simulated time between stored poses of a model; 0: none are stored
  /// Position at which a jaw turns the organ, as a fraction of its length, with everything beyond it free;
  /// empty: the last section is turned.
  std::optional<double> grasp{};
  bool unitConfirmed = false;  ///< of the measured markers, although another would fit better
};

/// Positions of the key points at a moment, for display.
struct ModelPose {
  double processing_s = 0.0;  ///< since rest: when a live view would have shown it
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
  double rmse_m = 0.0;                  ///< of the key points, from the reference
  double markerRmse_m = 0.0;            ///< of the markers' displacements (Eq. 24), from the reference
  std::vector<double> displacements_m;  ///< of the markers (Eq. 24)
};

struct ModelResult {
  std::string id;  ///< "pm", "paper", "rod", "fem", "msm", "reference"
  Text title;
  int unknowns = 0;
  double setUp_s = 0.0;
  int frames = 0;              ///< until the twist was at rest
  double frameMedian_s = 0.0;  ///< processing time per frame
  double frameWorst_s = 0.0;
  double deformation_s = 0.0;  ///< processing time of the whole twist (Fig. 10)
  double settle_s = 0.0;       ///< from the last frame to equilibrium; not part of deformation_s
  ModelState moving;           ///< state in the last frame
  Text noEquilibrium;          ///< why no equilibrium was found; `settled` is then `moving`. Empty: found
  ModelState settled;          ///< equilibrium, from which accuracy is measured
  std::vector<CoursePoint> course;
  double courseRmse_m = 0.0;     ///< of the marker's course, from the reference
  std::vector<ModelPose> poses;  ///< from rest to the last frame; see poseEvery_s
  std::vector<ModelPose> film;   ///< at rest and after each quarter of the ramp (Figs. 8, 9 and 12)
  ModelPose atRest;              ///< in equilibrium; without one, the last frame
};

/// Name of the instruction set on which all models of a comparison run.
inline constexpr const char* kComparedInstructions = "portable";

/// Number of equal parts of the ramp between the pictures of the film strip.
inline constexpr std::size_t kFilmSteps = 4;

/// The skin of a compared organ, to draw its models by.
struct ComparedBody {
  ComparedBody(const TriangleMesh& organ, const SectionLattice& lattice)
      : mesh(organ), skin(organ, lattice) {}
  TriangleMesh mesh;
  LatticeSkin skin;
};

/// A model's equilibrium on a mesh of its own.
struct ComparedMesh {
  std::string model;  ///< "reference", "fem", "msm"
  int ridges = 0;
  int sections = 0;
  int rings = 0;
  int unknowns = 0;
  double angle_rad = 0.0;
  std::optional<double>
      markerRmse_m{};  ///< of the markers' displacements, from the reference; none: no markers
  double settle_s = 0.0;
  Text noEquilibrium{};  ///< why there is none, instead of angle and error
};

/// Times of the twist model on the processor's widest instruction set, as the simulator's view runs it.
struct WidestTimes {
  std::string instructionSet;
  double pmFrame_s = 0.0;
  double latticeUpdate_s = 0.0;
};

struct ComparisonResult {
  std::string organ;
  std::vector<OrganWarning> organWarnings;  ///< warnings with which a user's organ was accepted
  int ridges = 0;
  int sections = 0;
  std::size_t vertices = 0;
  double length_m = 0.0;
  double shearModulus_Pa = 0.0;
  double torque_Nm = 0.0;
  ComparisonOptions options;
  MachineFacts machine;
  double latticeUpdate_s = 0.0;  ///< time of the twist model for all key points
  WidestTimes widest;            ///< everything else runs on the base instruction set
  std::shared_ptr<const ComparedBody> body;
  std::vector<OrganMarker> markers;
  std::vector<ModelResult> models;   ///< the reference first
  std::vector<ComparedMesh> meshes;  ///< of each model of elements or springs, from the coarsest
  std::vector<MeasuredSubject> measured;

  /// Returns the model with this id, which must exist (contract).
  [[nodiscard]] const ModelResult& model(const std::string& id) const;
};

/// Returns the root mean square of what the markers of a model in equilibrium are displaced (Eq. 24) beside
/// the measured means, over the markers that were measured; empty: none was, or the model has no equilibrium.
[[nodiscard]] std::optional<double> measuredRmse_m(const ComparisonResult& result, const ModelResult& model);

/// Computes the torque at the free end that turns it by the angle of the scene's pattern, N m, with the twist
/// model about the organ's own axis. Builds that model, which takes a tenth of a second.
[[nodiscard]] double usualTorque_Nm(const Scene& scene);

/// Twists the organ of a scene about its own axis with every model: one end fixed, the same increasing torque
/// on the other end or on a jaw. Takes about a minute on two cores. `measured`: see readMeasuredMarkers.
/// Throws Error{kBadParameter} for options out of range and a torque without equilibrium in some model.
/// `progress`: called several times per second, by one thread at a time; throwing cancels the comparison.
[[nodiscard]] ComparisonResult runComparison(const Scene& scene, const std::vector<OrganMarker>& markers,
                                             const std::vector<MeasuredSubject>& measured,
                                             const ComparisonOptions& options,
                                             const ProgressCallback& progress);

}  // namespace torsio
