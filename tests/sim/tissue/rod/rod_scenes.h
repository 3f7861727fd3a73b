// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/angle.h"
#include "sim/core/pose.h"
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

/// An elliptic section (half axes along e1 and e2) of linear material: what the tests of the rod need, from
/// closed forms. Shear factor 0.9 (docs/model.md R.2).
struct EllipticSection {
  double a_m = 0.0;
  double b_m = 0.0;
  double young_Pa = 0.0;
  double shear_Pa = 0.0;

  [[nodiscard]] double area_m2() const { return kPi * a_m * b_m; }
  [[nodiscard]] double bending1_Nm2() const { return young_Pa * kPi * a_m * b_m * b_m * b_m / 4.0; }
  [[nodiscard]] double bending2_Nm2() const { return young_Pa * kPi * a_m * a_m * a_m * b_m / 4.0; }
  [[nodiscard]] double torsion_Nm2() const {
    const double ab_m2 = a_m * b_m;
    return shear_Pa * kPi * ab_m2 * ab_m2 * ab_m2 / (a_m * a_m + b_m * b_m);
  }
};

/// Stiffness of an element of a rod that is straight at rest.
inline RodElement straightElement(const EllipticSection& s, double length_m) {
  const double shear_N = 0.9 * s.shear_Pa * s.area_m2();
  RodElement e{.length_m = length_m,
               .stretch_N = {shear_N, 0, 0, 0, shear_N, 0, 0, 0, s.young_Pa * s.area_m2()},
               .bend_Nm2 = {s.bending1_Nm2(), 0, 0, 0, s.bending2_Nm2(), 0, 0, 0, s.torsion_Nm2()}};
  return e;
}

/// Stiffness of an element bent at rest by kappa2 = `bend_per_m` about e2: every integral over the section
/// carries 1/j0, j0 = 1 - kappa2 u1 (docs/model.md R.2), here by the middle rule in 60 x 96 polar cells.
inline RodElement curvedElement(const EllipticSection& s, double bend_per_m, double length_m) {
  double s2 = 0.0;
  double i1 = 0.0;
  double i2 = 0.0;
  constexpr int kRings = 60;
  constexpr int kRays = 96;
  for (int r = 0; r < kRings; ++r) {
    for (int k = 0; k < kRays; ++k) {
      const double radius = (r + 0.5) / kRings;
      const double angle = 2.0 * kPi * (k + 0.5) / kRays;
      const SinCos turn = portableSinCos(angle);
      const double u1 = s.a_m * radius * turn.cos;
      const double u2 = s.b_m * radius * turn.sin;
      const double w =
          radius * s.a_m * s.b_m * (1.0 / kRings) * (2.0 * kPi / kRays) / (1.0 - bend_per_m * u1);
      s2 += w * u1;
      i1 += w * u2 * u2;
      i2 += w * u1 * u1;
    }
  }
  RodElement e = straightElement(s, length_m);
  const double polar_m4 = kPi * s.a_m * s.b_m * (s.a_m * s.a_m + s.b_m * s.b_m) / 4.0;
  e.bend_Nm2 = {s.young_Pa * i1, 0, 0, 0, s.young_Pa * i2, 0, 0, 0, s.torsion_Nm2() * (i1 + i2) / polar_m4};
  e.coupling_Nm = {0, 0, 0, 0, 0, s.shear_Pa * s2, 0, -s.young_Pa * s2, 0};
  return e;
}

/// Gives every element the strains of `pose` as its shape at rest.
inline void restAt(const RodPose& pose, std::vector<RodElement>& elements) {
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const RodStrain strain = rodStrain(elements[i].length_m, pose.nodes[i], pose.nodes[i + 1]);
    elements[i].restStrain = {strain.stretch.x, strain.stretch.y, strain.stretch.z};
    elements[i].restCurvature_per_m = {strain.curvature_per_m.x, strain.curvature_per_m.y,
                                       strain.curvature_per_m.z};
  }
}

/// Nodes along z, axes as the world's.
inline RodPose straightPose(double length_m, int elements) {
  RodPose pose{.count = elements + 1};
  for (int i = 0; i <= elements; ++i) {
    pose.nodes[static_cast<std::size_t>(i)].position_m = {0, 0, length_m * i / elements};
  }
  return pose;
}

/// Nodes on an arc in the plane y = 0 that leaves the origin along z and turns towards x by `angle_rad` in
/// all: tests/data/calculix.
inline RodPose bentPose(double length_m, double angle_rad, int elements) {
  RodPose pose{.count = elements + 1};
  const double radius_m = length_m / angle_rad;
  for (int i = 0; i <= elements; ++i) {
    const double at = angle_rad * i / elements;
    pose.nodes[static_cast<std::size_t>(i)] = {
        .position_m = {radius_m * (1.0 - portableSinCos(at).cos), 0, radius_m * portableSinCos(at).sin},
        .orientation = axisAngle({0, 1, 0}, at)};
  }
  return pose;
}

/// Returns 1 / mean(1 / GJ) over an element of a bar of sections `at`, a share of its length: composite
/// Simpson.
inline double torsionOver(const std::function<EllipticSection(double)>& at, double from, double to) {
  constexpr int kParts = 256;
  double sum = 0.0;
  for (int k = 0; k <= kParts; ++k) {
    const double weight = k == 0 || k == kParts ? 1.0 : (k % 2 == 1 ? 4.0 : 2.0);
    sum += weight / at(from + (to - from) * k / kParts).torsion_Nm2();
  }
  return 3.0 * kParts / sum;
}

/// A straight rod of sections `at` (share of its length), each element with its exact compliance in torsion.
inline Rod straightRod(double length_m, int elements, const std::function<EllipticSection(double)>& at,
                       RodRestraints restraints = {}) {
  std::vector<RodElement> chain;
  for (int i = 0; i < elements; ++i) {
    const double from = static_cast<double>(i) / elements;
    const double to = static_cast<double>(i + 1) / elements;
    chain.push_back(straightElement(at(0.5 * (from + to)), length_m / elements));
    chain.back().bend_Nm2[8] = torsionOver(at, from, to);
  }
  return Rod(std::move(chain), straightPose(length_m, elements),
             std::vector<double>(static_cast<std::size_t>(elements) + 1, 0.0), std::move(restraints));
}

}  // namespace torsio
