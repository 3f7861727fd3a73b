// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "sim/tissue/rod/rod.h"
#include "sim/tissue/rod/rod_step.h"

namespace torsio {

/// A rod of the size and stiffness of a stomach (G = 3 kPa): 31 elements on 270 mm of a J, radius 14 mm at
/// the pylorus (node 0, pinned) to 34 mm, a pin at the cardia, bend limits. Everything by element, nothing
/// solved.
[[nodiscard]] Rod stomachRod();

/// A loop of bowel: two limbs of radius `radius_m`, 120 mm long and `gap_m` apart from wall to wall, joined
/// by half a circle; both feet pinned. 31 elements, G = 3 kPa.
[[nodiscard]] Rod bowelLoop(double radius_m, double gap_m);

/// Adds the bend limit of a circular section of `radius_m` to an element (docs/model.md R.3).
void limitBend(double radius_m, double stretch_N, RodElement& element);

/// A rod, a jaw on it and the way of the hand, tick by tick.
struct RodScene {
  std::string name{};
  std::shared_ptr<const Rod> rod{};
  int node = 0;              ///< in the middle of the jaw
  double halfWidth_m = 0.0;  ///< of the jaw
  GripStiffness stiffness{};
  int ticks = 0;
  std::function<Pose(int tick, const Pose& rest)> hand{};
};

/// The scenes that the bits and the time of the tick are measured in: a stomach swung about the line from
/// pylorus to cardia, twisted about its own axis, held with a tremor, jumped by 10 degrees, thrown about at
/// random; and the limbs of a bowel loop pressed on each other.
[[nodiscard]] std::vector<RodScene> rodScenes();

/// The random hand of the given scene for as many ticks as asked: up to `place_m` and `turn_rad` anew each
/// tick.
[[nodiscard]] RodScene randomHand(const RodScene& scene, int ticks, double place_m, double turn_rad,
                                  unsigned seed);

/// A scene under way: its rod, jaw and pose, stepped by calls of step().
class RunningRodScene {
 public:
  explicit RunningRodScene(const RodScene& scene);
  /// Does one tick of a millisecond.
  RodStepResult step() noexcept;

  [[nodiscard]] const RodPose& pose() const noexcept { return pose_; }
  void setPose(const RodPose& pose) noexcept { pose_ = pose; }
  [[nodiscard]] const RodGrip& grip() const noexcept { return grip_; }
  [[nodiscard]] const Pose& hand() const noexcept { return hand_; }
  /// Moves the hand to where it is in the next tick, which step() then does.
  void moveHand();

 private:
  const RodScene& scene_;
  std::unique_ptr<RodWorkspace> work_;
  RodPose pose_;
  RodGrip grip_;
  Pose rest_;
  Pose hand_;
  int tick_ = 0;
};

}  // namespace torsio
