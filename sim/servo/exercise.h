// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <type_traits>

#include "sim/core/angle.h"
#include "sim/core/live_types.h"
#include "sim/core/tick_period.h"
#include "sim/scene/scene.h"
#include "sim/servo/beside_tissue.h"
#include "sim/servo/contact_coupling.h"
#include "sim/servo/detorsion.h"
#include "sim/servo/rod_grasp.h"
#include "sim/servo/tool_touch.h"

namespace torsio {

/// What happened in one tick; bits of ExerciseStep::events.
enum ExerciseEvent : std::uint32_t {
  kEventNone = 0,
  kEventTouched = 1U << 0,   ///< Tracking to Contact
  kEventLeft = 1U << 1,      ///< Contact to Tracking
  kEventGripped = 1U << 2,   ///< Contact to Twisting: the jaw holds the organ
  kEventReleased = 1U << 3,  ///< Twisting to Released: the jaw opened, or a view or a lost device let go
  kEventSlipped = 1U << 4,   ///< with kEventReleased: the tool pulled itself free
  kEventReturned = 1U << 5,  ///< the organ is at rest again
  kEventShaftTouched = 1U << 6,
  kEventShaftLeft = 1U << 7,
  kEventFolded = 1U << 8,  ///< with kEventReleased: the tissue would have folded, or slipped back by a turn
  // Of a hollow organ that came twisted.
  kEventBruised = 1U << 9,     ///< the jaw has pressed too hard for too long
  kEventTorn = 1U << 10,       ///< through the wall: the content leaves
  kEventClipped = 1U << 11,    ///< a clip or an assistant holds the mobile part
  kEventUnclipped = 1U << 12,  ///< and has let go
  kEventChecked = 1U << 13,    ///< a check of the blood flow has its answer
  kEventRelapsing = 1U << 14,  ///< the mobile part begins to turn back by itself
};

/// Events of one tick with their time, for readers that must not miss one.
struct ExerciseMoment {
  std::int64_t tick = 0;
  std::int64_t time_us = 0;
  std::uint32_t events = kEventNone;               ///< ExerciseEvent bits
  ExercisePhase phase = ExercisePhase::kTracking;  ///< after them
  friend constexpr bool operator==(const ExerciseMoment&, const ExerciseMoment&) = default;
};
static_assert(std::is_trivially_copyable_v<ExerciseMoment>);

/// Stiffness that a steady push meets, softer than any device's limit, which caps it: that of the
/// coupling (contact_coupling.h).
inline constexpr double kContactStiffness_N_per_m = 400.0;
static_assert(kSurfaceStiffness_N_per_m * kCouplingRatio / (1.0 + kCouplingRatio) ==
              kContactStiffness_N_per_m);
/// Spring that keeps the jaw on the grasped section: along the axis and towards or away from it. Round the
/// axis the tip is free: there the twist itself pulls back.
inline constexpr double kGripStiffness_N_per_m = 100.0;
/// Distance from the grasped section at which the jaw slips off.
inline constexpr double kSlipWay_m = 0.020;
/// Turn of a jaw round an organ that a clip holds from which the jaw slips off; assumed.
inline constexpr double kSlideTurn_rad = radians(30.0);
/// Height above the surface at which a contact ends, so that tremor does not end it; the force ends at the
/// surface.
inline constexpr double kContactHysteresis_m = 0.0005;
/// Closure above which the jaw counts as closed.
inline constexpr double kJawCloses = 0.5;
/// Closure below which the jaw counts as open.
inline constexpr double kJawOpens = 0.4;
/// Distance from the axis within which the tangential drive holds its angle.
inline constexpr double kNearAxis_m = 0.002;
/// Time constant of the elastic return after a release.
inline constexpr double kReturnTime_s = 0.12;
/// Angle below which the organ is at rest.
inline constexpr double kAtRest_rad = 1e-3;

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
/// it bit for bit.
class Exercise {
 public:
  /// Throws Error{kBadParameter}.
  explicit Exercise(const ExerciseOptions& options);

  /// Lays a hollow organ as it comes in the trial of this seed; any other organ lies at rest. Before the
  /// first step; allocates nothing.
  void begin(const Scene& scene, std::uint64_t seed);
  /// Asks for what concerns a hollow organ, for the next step (DetorsionStep); others do not heed it.
  void holdOrgan(bool held) noexcept { detorsion_.hold(held); }
  void vent(bool open) noexcept { detorsion_.vent(open); }
  void check(FlowCheck check) noexcept { detorsion_.check(check); }

  /// Steps the exercise by one tick. Servo thread; noexcept, no allocation.
  [[nodiscard]] ExerciseStep step(const ToolState& tool, const Scene& scene) noexcept;

  /// Takes what a model beside the servo has said before the next step, if anything; once a tick, where the
  /// scene is answered by such a model.
  void hear(const BesideAnswer& answer) noexcept { beside_.hear(answer, options_.tickPeriod_us); }
  /// Returns how often the jaw has gripped the organ.
  [[nodiscard]] std::int64_t grips() const noexcept { return grips_; }

  /// Tells whether nothing of the steps before bears on the next ones but whether the jaw is closed: nothing
  /// is touched, and the organ lies at rest. Of a scene without a wall or a model beside the servo.
  [[nodiscard]] bool settled() const noexcept;
  [[nodiscard]] bool jawClosed() const noexcept { return jawClosed_; }
  /// Closes or opens the jaw of an exercise that is settled(), without a step.
  void setJaw(bool closed) noexcept { jawClosed_ = closed; }
  /// Tells whether a jaw is closed by `tool`, by whether it was before.
  [[nodiscard]] static bool jawCloses(bool wasClosed, const ToolState& tool) noexcept;

  /// Lets go in the next step, as if the jaw had opened; the jaw must open and close to grip again.
  void releaseTissue() noexcept { releaseAsked_ = true; }

  [[nodiscard]] ExercisePhase phase() const noexcept { return phase_; }
  /// Returns how the organ lies.
  [[nodiscard]] const OrganState& organ() const noexcept { return organ_; }

 private:
  [[nodiscard]] bool updateJaw(const ToolState& tool) noexcept;
  [[nodiscard]] bool grip(const Vec3& held_m, const ToolState& tool, const Scene& scene) noexcept;
  /// Returns where the tip is about the axis, rad.
  [[nodiscard]] double tipAngle(const ToolState& tool) const noexcept;
  [[nodiscard]] double driveAngle(const ToolState& tool) const noexcept;
  /// Turns the organ with the tool. Returns the event that ends the grip, kEventNone while it holds.
  [[nodiscard]] std::uint32_t follow(const ToolState& tool, const Scene& scene) noexcept;
  /// Returns the tool as it lies against the tissue: a hand that twists by turning may stay in place, and
  /// what it holds carries its tool round.
  [[nodiscard]] ToolState onTissue(const ToolState& tool, const Scene& scene) const noexcept;
  /// Returns the way of the tip along and across the axis since the grip.
  [[nodiscard]] Vec3 gripOffset(const ToolState& tool, const Scene& scene) const noexcept;
  /// Turns the mobile part of a hollow organ with the hand, by kHandTurn_rad at most in a grip, there and
  /// back together; slides on while a clip holds it. Tells whether that makes the jaw slip off.
  [[nodiscard]] bool turnMobilePart(double turn_rad) noexcept;
  [[nodiscard]] DetorsionHand detorsionHand(const ToolState& tool) const noexcept;
  void letGo(std::uint32_t why, std::uint32_t& events) noexcept;
  /// What a hollow organ in the jaw lets the hand feel.
  void feelWrung(const Vec3& tip_m, const Scene& scene, TwistResponse& response) const noexcept;
  void relax(bool touching, const Scene& scene, std::uint32_t& events) noexcept;
  [[nodiscard]] double tick_s() const noexcept { return static_cast<double>(options_.tickPeriod_us) * 1e-6; }
  /// Makes the transition of this tick, if any.
  void moveOn(double gap_m, const std::optional<SurfacePoint>& held, const ToolState& tool,
              const Scene& scene, std::uint32_t& events) noexcept;
  void noteContacts(const ToolTouch& at, ExerciseStep& answer) noexcept;
  /// Steps both couplings and returns the force of the touched parts.
  [[nodiscard]] Vec3 pushBack(const ToolTouch& at, std::array<ContactPatch, 2>& patches) noexcept;
  /// What the grip lets the hand feel: torque, and the force of it.
  void feelGrip(const ToolState& tool, const Scene& scene, TwistResponse& response,
                std::uint32_t& limits) const noexcept;
  [[nodiscard]] TwistResponse responseTo(const ToolTouch& at, const ToolState& tool, const Scene& scene,
                                         ExerciseStep& answer) noexcept;

  ExerciseOptions options_;
  TouchMemory memory_;
  ContactCoupling jaw_;
  ContactCoupling shaft_;
  bool shaftTouched_ = false;
  bool jawOpens_ = false;  // it has let go in this tick, and touches anew from where it is
  double returnFactor_;    // of the angle, a tick
  ExercisePhase phase_ = ExercisePhase::kTracking;
  OrganState organ_;
  bool jawClosed_ = true;  // a jaw that is closed at the start grips nothing
  bool gripPending_ = false;
  bool releaseAsked_ = false;

  DetorsionStep detorsion_;  // of a hollow organ
  double lastPull_N_ = 0.0;  // of the hand on it, in the tick before
  double gripAngle_rad_ = 0.0;
  double gripRound_rad_ = 0.0;
  // Turn of the wrist since the jaw closed: where the present turn began, its extremes, and where it was when
  // the clip was set.
  double wristFrom_rad_ = 0.0;
  double wristLeast_rad_ = 0.0;
  double wristMost_rad_ = 0.0;
  double slidFrom_rad_ = 0.0;
  double lost_rad_ = 0.0;  // turned beyond what a hand turns: the shaft does not go round by it

  BesideTissue beside_;  // where a model beside the servo answers
  std::int64_t grips_ = 0;

  // Of the current grip.
  RodGrasp rodGrasp_;  // of an organ that is a rod
  AxisFrame axis_;     // that the grasped section turns about
  double firstAngle_rad_ = 0.0;
  double angle_rad_ = 0.0;     // of the tool about the axis, unwrapped
  double heldFrom_rad_ = 0.0;  // angle of the organ when the jaw closed
  double tipFrom_rad_ = 0.0;   // of the tip about the axis, then
  Quat grippedAt_;             // orientation of the tool
  double gripRadius_m_ = 0.0;
  double gripHeight_m_ = 0.0;
};
static_assert(std::is_trivially_copyable_v<Exercise>);

}  // namespace torsio
