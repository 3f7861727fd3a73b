// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "sim/core/organ_pose.h"
#include "sim/geometry/lattice/section_lattice.h"
#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/scene/turn_task.h"
#include "sim/tissue/rod/rod.h"
#include "sim/tissue/rod/rod_sections.h"
#include "sim/tissue/rod/rod_skin.h"
#include "sim/tissue/rod/rod_solve.h"
#include "sim/tissue/twist/twist_model.h"

namespace torsio {

/// Normalised bend z of the skin above which a pose counts as folded: there FoldCheck finds that det F falls
/// below kLeastDeterminant (docs/model.md R.12).
inline constexpr double kFoldingBend = 0.55;

/// Returns the pose `share` of the way from `a` to `b`, which have the same number of nodes.
[[nodiscard]] RodPose poseBetween(const RodPose& a, const RodPose& b, double share) noexcept;

/// A jaw closed over an organ, and the axis that it turns about. Trivially copyable.
struct OrganGrip {
  RodGrip jaw;
  int node = 0;    ///< the gripped section
  AxisFrame axis;  ///< that the hand turns about; e1 towards the jaw
};

/// A stretch of a rod whose torque is not proportional to its twist, as that of a wall that folds.
struct TwistLaw {
  double from_m = 0.0;  ///< arc lengths along the lattice's centreline, ascending
  double to_m = 0.0;
  std::function<double(double twist_rad)> torque_Nm;  ///< odd; its slope at 0 is the stretch's own
};

/// The organ at rest in the hand of a task, at one turn of the hand.
struct TaskPoint {
  double hand_rad = 0.0;              ///< turn of the hand about the axis of the task
  double angle_rad = 0.0;             ///< of the task, as measured
  double torque_Nm = 0.0;             ///< of the hand about its axis; positive holds a positive turn
  double force_N = 0.0;               ///< of the hand beside that
  std::array<double, 2> twist_rad{};  ///< of the stretches that have a TwistLaw, beyond that at rest
  RodPose pose;
};

/// Why a turn goes no further.
enum class TurnEnd {
  kThere,      ///< it was turned as far as was asked
  kFolds,      ///< the skin bends beyond kFoldingBend
  kNoBalance,  ///< no pose at rest was found
  kSlipsBack,  ///< a part of the organ, or what holds its end, would slip back by a whole turn
  kHandAlone,  ///< the hand turns on without the organ
};

/// Returns the point of a path, from rest on, where the measured turn is `angle_rad`; the nearest end
/// outside.
[[nodiscard]] TaskPoint atAngle(std::span<const TaskPoint> path, double angle_rad);

/// Tells whether a path, from rest on, goes as far as `angle_rad`, to the same side.
[[nodiscard]] bool reaches(std::span<const TaskPoint> path, double angle_rad) noexcept;

/// An organ as a rod, with its restraints, its skin and the task of a pattern. Immutable; what is marked so
/// runs in the tick.
class RodOrgan {
 public:
  struct Parts {
    const TriangleMesh* mesh = nullptr;
    const TwistModel* model = nullptr;  ///< of the same organ: lattice, material, solved sections
    std::vector<Restraint> restraints = {};
    TurnTask task;
    double graspArc = 0.5;  ///< of the pattern, fraction of the length
    double targetAngle_rad = 0.0;
    WallMap wall = {};  ///< of a hollow organ; empty: filled
    std::vector<TwistLaw> laws =
        {};  ///< two at most; what their torque leaves of the stiffness holds in follow()
  };
  /// Builds the rod and follows its task to the target. Throws Error{kBadMesh} where the organ has no simple
  /// section, {kBadParameter} for a restraint or a task that does not fit the organ.
  explicit RodOrgan(const Parts& parts);

  [[nodiscard]] const Rod& rod() const noexcept { return rod_; }
  [[nodiscard]] const RodSkin& skin() const noexcept { return skin_; }
  [[nodiscard]] const TurnTask& task() const noexcept { return task_; }
  /// Returns arc lengths of the nodes along the centreline of the lattice.
  [[nodiscard]] std::span<const double> arcs_m() const noexcept { return organ_.arcs_m; }

  /// Closes a jaw at arc length `arc_m` of the organ in `pose`, the hand standing at `hand`. In the tick.
  [[nodiscard]] OrganGrip grip(const RodPose& pose, double arc_m, const Pose& hand) const noexcept;
  /// Returns where the jaw's coupling is held for a hand that has turned by `turn_rad` about the axis since
  /// it closed at `closed`; `now`: the hand's pose. In the tick.
  [[nodiscard]] Pose handAfter(const OrganGrip& grip, const Pose& closed, const Pose& now,
                               double turn_rad) const noexcept;
  /// Returns the turn of the task, unwrapped near `before_rad`; `curve`: of the pose. In the tick.
  [[nodiscard]] double turn_rad(const OrganGrip& grip, const RodPose& pose, const RodCurve& curve,
                                double before_rad) const noexcept;
  /// Returns the turn of the gripped section as it is counted from section to section from the fixed end, if
  /// that is another whole turn than `turn_rad`, which was counted in time: then a stretch of the organ, or
  /// what holds its end, was turned by more than half a turn and has slipped back. None if not, and of a task
  /// that measures landmarks, whose turn is seen on the skin. In the tick.
  [[nodiscard]] std::optional<double> slippedBack_rad(const OrganGrip& grip, const RodPose& pose,
                                                      double turn_rad) const noexcept;
  /// Returns the moment of the hand about the axis of the grip, N m. In the tick.
  [[nodiscard]] static double torque_Nm(const OrganGrip& grip, const GripLoad& load,
                                        const Pose& hand) noexcept;
  /// Returns how far the node that is farthest from its place at rest lies from it, m. In the tick.
  [[nodiscard]] double farthestFromRest_m(const RodPose& pose) const noexcept;
  /// Returns the largest stiffness dT/d(turn of the hand) on the way to the target, N m/rad.
  [[nodiscard]] double turnStiffness_Nm_per_rad() const noexcept { return turnStiffness_Nm_per_rad_; }

  /// Returns the organ as the task turns it, from rest past the target, in steps of the hand.
  [[nodiscard]] std::span<const TaskPoint> path() const noexcept { return path_; }
  /// Returns the point of the task, gripped where the pattern does, where the measured turn is `angle_rad`;
  /// beyond the path it is followed on. The farthest point where it goes no further. Not for the tick.
  [[nodiscard]] TaskPoint pointAt(double angle_rad) const;
  /// Follows the task with a jaw at another place until the measured turn is `angle_rad`, or the hand has
  /// turned three times as far, or the tissue folds (unless `pastFolds`), or a part of the organ slips back
  /// by a whole turn. `end`, if given: why it ends there.
  [[nodiscard]] std::vector<TaskPoint> follow(double graspArc, double angle_rad, bool pastFolds = false,
                                              TurnEnd* end = nullptr) const;
  /// Returns why path() goes no further.
  [[nodiscard]] TurnEnd pathEnd() const noexcept { return pathEnd_; }

  /// Returns the twist rate of the organ's own axis at arc length `arc_m`, rad/m, beyond that at rest.
  [[nodiscard]] double twistRateAt(double arc_m, const RodPose& pose) const noexcept;

 private:
  [[nodiscard]] AxisFrame axisOf(const RodPose& pose, int node, const Vec3& hand_m) const noexcept;
  [[nodiscard]] Landmarks marksOf(const RodCurve& curve) const noexcept;
  [[nodiscard]] double nodeTurn_rad(const OrganGrip& grip, const RodPose& pose, std::size_t node,
                                    double before_rad) const noexcept;
  [[nodiscard]] bool losesTurns(const OrganGrip& grip, const RodPose& pose,
                                std::vector<double>& turns_rad) const;

  RodOrgan(const Parts& parts, const SolvedSections& sections);
  [[nodiscard]] double twist_rad(const TwistLaw& law, const RodPose& pose) const noexcept;
  /// Returns the rod with its stretches as stiff as a secant of their laws; `shares`: of their own stiffness.
  [[nodiscard]] Rod asStiff(const std::array<double, 2>& shares) const;
  /// Moves to a balance of rod and laws; `shares`: those of the step before, and of this one.
  RodBalance balance(const OrganGrip& grip, const Pose& hand, std::array<double, 2>& shares,
                     RodPose& pose) const;

  OrganRod organ_;
  RodSkin skin_;
  Rod rod_;
  std::vector<TwistLaw> laws_;
  double length_m_ = 0.0;
  double graspArc_ = 0.5;
  TurnTask task_;
  std::array<RodSkinPlace, 3> marks_{};
  std::vector<TaskPoint> path_;
  TurnEnd pathEnd_ = TurnEnd::kThere;
  double turnStiffness_Nm_per_rad_ = 0.0;
};

}  // namespace torsio
