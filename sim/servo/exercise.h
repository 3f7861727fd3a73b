// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "sim/core/live_types.h"
#include "sim/core/time_units.h"
#include "sim/scene/scene.h"
#include "sim/servo/contact_coupling.h"
#include "sim/servo/grasp.h"
#include "sim/servo/grasped_tissue.h"
#include "sim/servo/tool_touch.h"

namespace torsio {

/// Stiffness that a steady push meets, softer than any device's limit, which caps it: that of the
/// coupling (contact_coupling.h).
inline constexpr double kContactStiffness_N_per_m = 400.0;
static_assert(kSurfaceStiffness_N_per_m * kCouplingRatio / (1.0 + kCouplingRatio) ==
              kContactStiffness_N_per_m);
/// Spring that keeps the jaw on the grasped section: along the axis and towards or away from it. Round the
/// axis the tip is free: there the twist itself pulls back.
inline constexpr double kGripStiffness_N_per_m = 100.0;
/// Height above the surface at which a contact ends, so that tremor does not end it; the force ends at the
/// surface.
inline constexpr double kContactHysteresis_m = 0.0005;
/// Closure above which the jaw counts as closed.
inline constexpr double kJawCloses = 0.5;
/// Closure below which the jaw counts as open.
inline constexpr double kJawOpens = 0.4;
struct ExerciseOptions {
  TwistDrive drive = TwistDrive::kTangential;
  double maxStiffness_N_per_m = 500.0;          ///< of the device; > 0
  std::int64_t tickPeriod_us = kTickPeriod_us;  ///< > 0
  std::uint32_t rules = kServoRules;            ///< 1 .. kServoRules: older ones replay older trials
};

/// Answer of the exercise in one tick.
struct ExerciseStep {
  TwistResponse response;
  ExercisePhase phase = ExercisePhase::kTracking;
  std::uint32_t events = kEventNone;      ///< ExerciseEvent bits
  std::uint32_t contact = kContactNone;   ///< ToolContact bits
  std::uint32_t limits = kForceFull;      ///< kForceModelLate, if so
  std::array<ContactPatch, 2> patches{};  ///< under the jaw and under the shaft
  /// Energy that the tissue brings along into the grip, of an organ that came twisted.
  double lent_J = 0.0;
};

/// The flow of paper Fig. 6 as a state machine: tracking, contact, twisting, released. Outside contact there
/// is no force and no deformation; while the jaw holds the organ, the hand prescribes the angle of the
/// grasped section and the model answers with the torque (docs/model.md). A jaw grips only by closing with
/// tissue between its blades, never by arriving closed. Jaw and shaft collide with the organ as the twist has
/// left it, each through a virtual coupling of its own; the blades do not while they hold tissue
/// (docs/contact.md). A device without torque feels the push on the shaft as a force at the tip.
///
/// A plain value: a copy continues on its own. An exercise knows neither time nor thread; one step is one
/// tick. Its computations consist of IEEE basic operations and portable functions, so that a replay repeats
/// it bit for bit. What the organ under the jaw does is GraspedTissue's.
class Exercise {
 public:
  /// Begins with the organ as it lies in the trial of this seed. `scene` outlives the exercise. Throws
  /// Error{kBadParameter}.
  Exercise(const ExerciseOptions& options, const Scene& scene, std::uint64_t seed = 0);

  /// Takes a command for the next step: kReleaseTissue lets go as if the jaw had opened, which must open and
  /// close to grip again; the tissue takes what concerns it.
  void apply(const ServoCommand& command) noexcept;
  /// Takes what a model outside the servo has answered before the next step, if anything; once a tick.
  void takeAnswer(const AsyncAnswer& answer) noexcept { tissue_.takeAnswer(answer); }
  /// Steps the exercise by one tick. Servo thread; noexcept, no allocation.
  [[nodiscard]] ExerciseStep step(const ToolState& tool) noexcept;

  [[nodiscard]] ExercisePhase phase() const noexcept { return phase_; }
  /// Returns how the organ lies.
  [[nodiscard]] const OrganState& organ() const noexcept { return organ_; }
  /// Returns how often the jaw has gripped the organ.
  [[nodiscard]] std::int64_t grips() const noexcept { return grips_; }

  /// Tells whether nothing of the steps before bears on the next ones but whether the jaw is closed: nothing
  /// is touched, and the organ lies at rest.
  [[nodiscard]] bool settled() const noexcept;
  /// Tells whether the exercise ever is settled() again after a grip.
  [[nodiscard]] bool settles() const noexcept { return tissue_.forgets(); }
  [[nodiscard]] bool jawClosed() const noexcept { return jawClosed_; }
  /// Closes or opens the jaw of an exercise that is settled(), without a step.
  void setJaw(bool closed) noexcept { jawClosed_ = closed; }
  /// Tells whether a jaw is closed by `tool`, by whether it was before.
  [[nodiscard]] static bool jawCloses(bool wasClosed, const ToolState& tool) noexcept;

 private:
  [[nodiscard]] bool updateJaw(const ToolState& tool) noexcept;
  [[nodiscard]] JawState jawState(const ToolState& tool) const noexcept;
  [[nodiscard]] bool grip(const Vec3& held_m, const ToolState& tool) noexcept;
  /// Turns the organ with the tool. Returns the event that ends the grip, kEventNone while it holds.
  [[nodiscard]] std::uint32_t follow(const ToolState& tool) noexcept;
  void letGo(std::uint32_t why, std::uint32_t& events) noexcept;
  void relax(bool touching, std::uint32_t& events) noexcept;
  /// Returns the tool as it lies against the tissue: what a rolling hand holds carries its tool round.
  [[nodiscard]] ToolState onTissue(const ToolState& tool) const noexcept;
  /// Returns the way of the tip that the grip's spring draws back.
  [[nodiscard]] Vec3 drift_m(const ToolState& tool) const noexcept;
  /// Makes the transition of this tick, if any.
  void moveOn(double gap_m, const std::optional<SurfacePoint>& held, const ToolState& tool,
              std::uint32_t& events) noexcept;
  void noteContacts(const ToolTouch& at, ExerciseStep& answer) noexcept;
  /// Steps both couplings and returns the force of the touched parts.
  [[nodiscard]] Vec3 pushBack(const ToolTouch& at, std::array<ContactPatch, 2>& patches) noexcept;
  /// What the grip lets the hand feel: torque, and the force of it.
  void feelGrip(const ToolState& tool, TwistResponse& response, std::uint32_t& limits) const noexcept;
  [[nodiscard]] TwistResponse responseTo(const ToolTouch& at, const ToolState& tool,
                                         ExerciseStep& answer) noexcept;

  ExerciseOptions options_;
  const Scene* scene_;
  GraspedTissue tissue_;
  OrganState organ_;
  ExercisePhase phase_ = ExercisePhase::kTracking;
  JawMotion motion_;  // of the present grip
  std::int64_t grips_ = 0;
  double lastPull_N_ = 0.0;  // of the hand on the organ, in the tick before
  TouchMemory memory_;
  ContactCoupling jaw_;
  ContactCoupling shaft_;
  bool shaftTouched_ = false;
  bool jawOpens_ = false;  // it has let go in this tick, and touches anew from where it is
  bool jawClosed_ = true;  // a jaw that is closed at the start grips nothing
  bool gripPending_ = false;
  bool releaseAsked_ = false;
};
static_assert(std::is_trivially_copyable_v<Exercise>);

}  // namespace torsio
