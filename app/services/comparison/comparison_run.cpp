// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/comparison/comparison_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <future>
#include <memory>
#include <mutex>
#include <thread>
#include <tuple>
#include <utility>

#include "app/services/comparison/compared_meshes.h"
#include "assessment/statistics/descriptive.h"
#include "sim/baseline/lattice_update.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/tissue/view/cpu_features.h"

namespace torsio {

namespace {

using RunClock = std::chrono::steady_clock;
constexpr int kReferenceSteps = 12;   ///< of the ramp
constexpr double kMaxTime_s = 6.0;    ///< simulated time after which a model counts as at rest
constexpr int kRestFrames = 10;       ///< number of frames for the criterion of rest
constexpr double kRestChange = 1e-3;  ///< relative change of the angle below which a model is at rest
constexpr double kMaxTorque_Nm = 100.0;

double secondsSince(RunClock::time_point start) {
  return std::chrono::duration<double>(RunClock::now() - start).count();
}

void checkOptions(const ComparisonOptions& options) {
  if (options.torque_Nm && !(std::abs(*options.torque_Nm) <= kMaxTorque_Nm && *options.torque_Nm != 0.0)) {
    refuseParameter(Text::tr("The torque must not be 0 and lie within 100 N m"), Text::tr("torque"),
                    Text::tr("Give newton metres, such as 0.03"));
  }
  if (!(options.ramp_s >= 0.1 && options.ramp_s <= 5.0)) {
    refuseParameter(Text::tr("The torque must grow for 0.1 to 5 s"), Text::tr("growth of the torque"),
                    Text::tr("Give seconds, such as 1"));
  }
  if (options.rings < 1 || options.rings > 12) {
    refuseParameter(Text::tr("Elements need 1 to 12 rings"), Text::tr("rings"),
                    Text::tr("Give a whole number such as 4"));
  }
  if (options.springs.substeps < 1 || options.springs.substeps > 1000) {
    refuseParameter(Text::tr("A frame of the springs needs 1 to 1000 substeps"), Text::tr("substeps"),
                    Text::tr("Give a whole number such as 10"));
  }
  if (options.grasp && !(*options.grasp > 0.0 && *options.grasp <= 1.0)) {
    refuseParameter(Text::tr("The grasp must lie in (0, 1], as a fraction of the organ's length"),
                    Text::tr("grasp"), Text::tr("Give a fraction such as 0.8"));
  }
}

/// Repeats the last progress report while there is nothing new, so that the listener can cancel. Thread-safe.
class Heartbeat {
 public:
  explicit Heartbeat(const ProgressCallback& progress) : progress_(progress) {}

  /// Reports a new step.
  void tell(const Text& step, double fraction) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool another = !(step == now_.step);
    now_ = {step, std::max(now_.fraction, fraction), -1.0};
    pass(another);
  }
  /// Repeats the last report unless it is recent.
  void beat() {
    const std::lock_guard<std::mutex> lock(mutex_);
    pass(false);
  }
  /// Returns the callback of a step that covers `from` to `to` of the whole.
  [[nodiscard]] ProgressCallback part(double from, double to) {
    return partOf([this](const Progress& progress) { tell(progress.step, progress.fraction); }, from, to);
  }

 private:
  void pass(bool atOnce) {
    constexpr double kEvery_s = 0.1;
    if (progress_ && (atOnce || secondsSince(passed_) >= kEvery_s)) {
      passed_ = RunClock::now();
      progress_(now_);
    }
  }

  const ProgressCallback& progress_;
  std::mutex mutex_;
  Progress now_;
  RunClock::time_point passed_ = RunClock::now();
};

/// One organ with the data and measurements common to all models.
class ComparisonBench {
 public:
  ComparisonBench(const Scene& scene, const ComparedOrgan& organ, ComparisonResult& result)
      : result_(result),
        rest_(restPlaces(scene.lattice())),
        end_(scene.lattice().frameAt(organ.hold.span[1] * scene.lattice().length_m())) {
    for (const OrganMarker& marker : result.markers) {
      anchors_.push_back(anchorMarker(scene.mesh, scene.lattice(), marker.position_m));
    }
  }

  [[nodiscard]] double displacement_m(const MarkerAnchor& anchor, const LatticePlaces& now,
                                      double angle_rad) const {
    const Vec3 place = result_.options.grasp ? markerPlace_m(anchor, rest_, now)
                                             : markerPlace_m(anchor, rest_, now, end_, angle_rad);
    return norm(place - anchor.rest_m);
  }

  [[nodiscard]] CoursePoint coursePoint(const TwistSimulation& model, double time_s, double torque_Nm) const {
    CoursePoint point{time_s, torque_Nm, model.angle_rad(), 0.0};
    const auto marker = static_cast<std::size_t>(result_.options.courseMarker - 1);
    if (marker < anchors_.size()) {
      point.displacement_m = displacement_m(anchors_[marker], model.surface(), point.angle_rad);
    }
    return point;
  }

  /// Stores a model's picture of the film strip if the ramp has come to the next one.
  void film(const TwistSimulation& model, ModelResult& run) const {
    const double share = run.course.back().time_s / result_.options.ramp_s;
    constexpr double kRounding = 1e-9;
    if (run.film.size() <= kFilmSteps &&
        share + kRounding >= static_cast<double>(run.film.size()) / kFilmSteps) {
      run.film.push_back({0.0, model.angle_rad(), model.surface()});
    }
  }

  /// Stores a model's pose if the next one is due.
  void keep(const TwistSimulation& model, double processing_s, ModelResult& run) const {
    const double every_s = result_.options.poseEvery_s;
    const auto due = static_cast<double>(run.poses.size()) * every_s;
    if (every_s > 0.0 && run.course.back().time_s >= due) {
      run.poses.push_back({processing_s, model.angle_rad(), model.surface()});
    }
  }

  [[nodiscard]] ModelState state(const TwistSimulation& model) const {
    const LatticePlaces now = model.surface();
    ModelState state;
    state.angle_rad = model.angle_rad();
    state.energy_J = model.energy_J();
    state.volumeRatio = latticeVolume_m3(now) / latticeVolume_m3(rest_);
    state.radiusChange = largestRadiusChange(rest_, now);
    state.roughness_m = roughness_m(rest_, now);
    for (const MarkerAnchor& anchor : anchors_) {
      state.displacements_m.push_back(displacement_m(anchor, now, state.angle_rad));
    }
    if (!result_.models.empty()) {
      state.rmse_m = rootMeanSquareDistance_m(now, reference_);
      state.markerRmse_m = markerRmse_m(state.displacements_m);
    }
    return state;
  }

  /// The reference runs first: it computes only equilibria, a few along the ramp.
  void runReference(const ComparedOrgan& organ, const ProgressCallback& progress) {
    const auto start = RunClock::now();
    const auto model = referenceSimulation(organ, result_.options.referenceRings);
    ModelResult run =
        opened("reference", Text::tr("Reference (quadratic elements, neo-Hookean)"), *model, start);
    std::vector<double> times_s;
    run.course.push_back({});
    film(*model, run);
    for (int step = 1; step <= kReferenceSteps; ++step) {
      const double share = static_cast<double>(step) / kReferenceSteps;
      tellProgress(progress, Text::tr("Reference"), share);
      const auto stepStart = RunClock::now();
      model->step(share * result_.torque_Nm);
      times_s.push_back(secondsSince(stepStart));
      run.course.push_back(coursePoint(*model, share * result_.options.ramp_s, share * result_.torque_Nm));
      film(*model, run);
    }
    close(run, times_s);
    run.settled = run.moving = state(*model);
    reference_ = model->surface();
    run.atRest = {0.0, model->angle_rad(), reference_};
    result_.models.push_back(std::move(run));
  }

  /// Runs frames until the torque is reached and the end is at rest.
  [[nodiscard]] ModelResult runFrames(const std::string& id, const Text& title, const ComparedOrgan& organ,
                                      TwistSimulation& model, RunClock::time_point start,
                                      const ProgressCallback& progress) const {
    ModelResult run = opened(id, title, model, start);
    std::vector<double> times_s;
    double processing_s = 0.0;
    run.course.push_back({});
    keep(model, processing_s, run);
    film(model, run);
    const double frame_s = organ.dynamics.frame_s;
    const int ramp = static_cast<int>(std::lround(result_.options.ramp_s / frame_s));
    const int most = static_cast<int>((result_.options.ramp_s + kMaxTime_s) / frame_s);
    for (int frame = 1; frame <= most; ++frame) {
      const double torque_Nm = result_.torque_Nm * std::min(1.0, static_cast<double>(frame) / ramp);
      const auto stepStart = RunClock::now();
      model.step(torque_Nm);
      times_s.push_back(secondsSince(stepStart));
      processing_s += times_s.back();
      run.course.push_back(coursePoint(model, frame * frame_s, torque_Nm));
      keep(model, processing_s, run);
      film(model, run);
      tellProgress(progress, title, std::min(1.0, 0.5 * frame / ramp));
      if (frame >= ramp + kRestFrames ||
          (frame >= ramp && run.course.size() > 1 && reachesRestImmediately(id))) {
        const double before = run.course[run.course.size() - 1 - kRestFrames].angle_rad;
        const double now = run.course.back().angle_rad;
        if (reachesRestImmediately(id) || std::abs(now - before) <= kRestChange * std::abs(now)) {
          break;
        }
      }
    }
    close(run, times_s);
    if (!run.poses.empty()) {
      run.poses.push_back({processing_s, model.angle_rad(), model.surface()});
    }
    run.moving = state(model);
    run.atRest = {processing_s, model.angle_rad(), model.surface()};
    run.courseRmse_m = courseRmse_m(run);
    return run;
  }

 private:
  static bool reachesRestImmediately(const std::string& id) { return id == "pm" || id == "paper"; }

  static ModelResult opened(const std::string& id, const Text& title, const TwistSimulation& model,
                            RunClock::time_point start) {
    ModelResult run;
    run.setUp_s = secondsSince(start);
    run.id = id;
    run.title = title;
    run.unknowns = model.unknowns();
    return run;
  }

  static void close(ModelResult& run, const std::vector<double>& times_s) {
    run.frames = static_cast<int>(times_s.size());
    run.frameMedian_s = medianOf(times_s);
    run.frameWorst_s = *std::max_element(times_s.begin(), times_s.end());
    for (const double t : times_s) {
      run.deformation_s += t;
    }
  }

  [[nodiscard]] double markerRmse_m(const std::vector<double>& displacements_m) const {
    const std::vector<double>& wanted = result_.models.front().settled.displacements_m;
    double sum = 0.0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      sum += (displacements_m[i] - wanted[i]) * (displacements_m[i] - wanted[i]);
    }
    return wanted.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(wanted.size()));
  }

  /// Returns the error of the marker's course at the moments of the reference's course.
  [[nodiscard]] double courseRmse_m(const ModelResult& run) const {
    const std::vector<CoursePoint>& wanted = result_.models.front().course;
    double sum = 0.0;
    for (const CoursePoint& point : wanted) {
      const auto nearer = [&](const CoursePoint& a, const CoursePoint& b) {
        return std::abs(a.time_s - point.time_s) < std::abs(b.time_s - point.time_s);
      };
      const double there = std::min_element(run.course.begin(), run.course.end(), nearer)->displacement_m;
      sum += (there - point.displacement_m) * (there - point.displacement_m);
    }
    return std::sqrt(sum / static_cast<double>(wanted.size()));
  }

  ComparisonResult& result_;
  LatticePlaces rest_;
  LatticePlaces reference_;
  AxisFrame end_;
  std::vector<MarkerAnchor> anchors_;
};

/// Brings a model to equilibrium and measures it there; stores the reason if there is none.
void settleAndRead(TwistSimulation& model, double torque_Nm, const ComparisonBench& bench, ModelResult& run) {
  const auto start = RunClock::now();
  try {
    model.settle(torque_Nm);
    run.settled = bench.state(model);
    run.atRest = {0.0, model.angle_rad(), model.surface()};
  } catch (const Error& none) {
    run.noEquilibrium = none.happenedText();
    run.settled = run.moving;
  }
  run.settle_s = secondsSince(start);
}

/// Runs the curved rod: frames of its ticks, then its equilibrium.
void runRod(const ComparedOrgan& organ, const TwistModel& twist, const ComparisonBench& bench,
            ComparisonResult& result) {
  const auto start = RunClock::now();
  const auto rod = rodSimulation(organ, twist);
  ModelResult run =
      bench.runFrames("rod", Text::tr("Rod (ticks of the simulator, and its skin)"), organ, *rod, start, {});
  settleAndRead(*rod, result.torque_Nm, bench, run);
  result.models.push_back(std::move(run));
}

/// Makes the springs; those that find no equilibrium to be calibrated by are calibrated by their energy.
std::unique_ptr<TwistSimulation> springsOf(const ComparedOrgan& organ, const TwistModel& twist,
                                           ComparisonOptions& options) {
  try {
    return massSpringSimulation(organ, twist, options.rings, options.springs);
  } catch (const Error& none) {
    if (none.code() != ErrorCode::kBadParameter || options.springs.calibration == Calibration::kAffine) {
      throw;
    }
    options.springs.calibration = Calibration::kAffine;
    return massSpringSimulation(organ, twist, options.rings, options.springs);
  }
}

/// Runs finite elements and springs: frames one after the other for undisturbed timing, then both equilibria
/// in parallel.
void runMovingModels(const ComparedOrgan& organ, const TwistModel& twist, const ComparisonBench& bench,
                     ComparisonResult& result, Heartbeat& heart) {
  ComparisonOptions& options = result.options;
  auto start = RunClock::now();
  const auto elements = finiteElementSimulation(organ, options.rings);
  ModelResult fem = bench.runFrames("fem", Text::tr("FEM (corotational linear tetrahedra)"), organ, *elements,
                                    start, heart.part(0.15, 0.45));
  start = RunClock::now();
  const auto springs = springsOf(organ, twist, options);
  ModelResult msm =
      bench.runFrames("msm", Text::tr("MSM (springs, XPBD)"), organ, *springs, start, heart.part(0.45, 0.6));
  heart.tell(Text::tr("Equilibrium of elements and springs"), 0.6);
  auto waiting =
      std::async(std::launch::async, [&] { settleAndRead(*elements, result.torque_Nm, bench, fem); });
  settleAndRead(*springs, result.torque_Nm, bench, msm);
  waiting.get();
  result.models.push_back(std::move(fem));
  result.models.push_back(std::move(msm));
}

/// Times the twist model as the simulator's view runs it.
WidestTimes widestTimes(const ComparedOrgan& organ, const TwistModel& twist, double torque_Nm) {
  constexpr int kFrames = 61;
  const auto simulation = twistModelSimulation(organ, twist, bestIsa());
  std::vector<double> times_s;
  for (int frame = 1; frame <= kFrames; ++frame) {
    const auto start = RunClock::now();
    simulation->step(torque_Nm * frame / kFrames);
    times_s.push_back(secondsSince(start));
  }
  return {std::string(isaName(bestIsa())), medianOf(times_s), latticeUpdateTime_s(twist, bestIsa())};
}

double usualTorque_Nm(const Scene& scene, const TwistModel& twist, double arc_m) {
  return scene.pattern.targetAngle_rad / twist.graspCompliance(arc_m);
}

}  // namespace

double usualTorque_Nm(const Scene& scene) {
  const TwistModel twist(scene.mesh, scene.lattice(), scene.model.material(), {});
  return usualTorque_Nm(scene, twist, scene.lattice().length_m());
}

const ModelResult& ComparisonResult::model(const std::string& id) const {
  const auto found =
      std::find_if(models.begin(), models.end(), [&](const ModelResult& m) { return m.id == id; });
  TORSIO_EXPECTS(found != models.end());
  return *found;
}

std::optional<double> measuredRmse_m(const ComparisonResult& result, const ModelResult& model) {
  double sum_m2 = 0.0;
  int markers = 0;
  for (std::size_t i = 0; i < result.markers.size() && model.noEquilibrium.empty(); ++i) {
    const MeasuredDisplacement found = finalDisplacement(result.measured, result.markers[i].number);
    if (found.subjects > 0) {
      const double apart_m = model.settled.displacements_m[i] - found.mean_m;
      sum_m2 += apart_m * apart_m;
      ++markers;
    }
  }
  return markers > 0 ? std::optional(std::sqrt(sum_m2 / markers)) : std::nullopt;
}

ComparisonResult runComparison(const Scene& scene, const std::vector<OrganMarker>& markers,
                               const std::vector<MeasuredSubject>& measured, const ComparisonOptions& options,
                               const ProgressCallback& progress) {
  checkOptions(options);
  ComparisonResult result;
  result.organ = scene.title;
  result.organWarnings = scene.organWarnings;
  result.ridges = scene.lattice().ridges();
  result.sections = scene.lattice().sections();
  result.vertices = scene.mesh.vertices_m.size();
  result.length_m = scene.lattice().length_m();
  result.options = options;
  result.machine = machineFacts();
  result.markers = markers;
  result.measured = measured;
  result.body = std::make_shared<const ComparedBody>(scene.mesh, scene.lattice());
  const Material& material = scene.model.material();
  result.shearModulus_Pa = material.shearModulus_Pa;

  Heartbeat heart(progress);
  heart.tell(Text::tr("Twist model"), 0.0);
  auto start = RunClock::now();
  TwistModelOptions twistOptions;  // about the organ's own axis, one end clamped, the other free
  const TwistModel twist(scene.mesh, scene.lattice(), material, twistOptions);
  const double twistSetUp_s = secondsSince(start);
  start = RunClock::now();
  twistOptions.formulation = Formulation::kPaper;
  const TwistModel paper(scene.mesh, scene.lattice(), material, twistOptions);
  const double paperSetUp_s = secondsSince(start);
  result.latticeUpdate_s = latticeUpdateTime_s(twist, Isa::kPortable);

  ComparedOrgan organ{&scene.mesh,
                      &scene.lattice(),
                      {material.shearModulus_Pa, options.poissonRatio},
                      {},
                      {rodSpan(scene.lattice(), twist), options.grasp},
                      [&heart] { heart.beat(); }};
  result.torque_Nm = options.torque_Nm.value_or(usualTorque_Nm(scene, twist, organ.graspArc_m()));
  organ.dynamics.drag_per_s =
      criticalDrag_per_s(organ.constants, organ.dynamics.density_kg_per_m3, result.length_m);
  ComparisonBench bench(scene, organ, result);
  bench.runReference(organ, heart.part(0.02, 0.15));
  for (const auto& [id, title, model, setUp_s] :
       {std::tuple{"pm", Text::tr("PM (twist model, Saint-Venant)"), &twist, twistSetUp_s},
        std::tuple{"paper", Text::tr("PM as printed (linear rotation, cone)"), &paper, paperSetUp_s}}) {
    start = RunClock::now();
    const auto simulation = twistModelSimulation(organ, *model, Isa::kPortable);
    ModelResult run = bench.runFrames(id, title, organ, *simulation, start, {});
    run.setUp_s += setUp_s;
    run.settled = run.moving;
    result.models.push_back(std::move(run));
  }
  result.widest = widestTimes(organ, twist, result.torque_Nm);
  runRod(organ, twist, bench, result);
  runMovingModels(organ, twist, bench, result, heart);
  heart.tell(Text::tr("Coarser meshes"), 0.9);
  result.meshes = comparedMeshes(scene, organ, twist, result);
  heart.tell(Text::tr("Writing"), 1.0);
  return result;
}

}  // namespace torsio
