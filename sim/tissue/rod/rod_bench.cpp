// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod_bench.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "sim/core/contracts.h"
#include "sim/tissue/rod/landmark_turn.h"
#include "sim/tissue/rod/rod_step.h"

namespace torsio {
namespace {

constexpr int kBenchElements = 31;
constexpr double kBenchLength_m = 0.270;
constexpr double kBenchRadius_m = 0.025;
constexpr double kBenchBend_rad = 2.8;
constexpr double kBenchShear_Pa = 3e3;
constexpr int kBenchGrip = 15;
constexpr int kBenchRepeats = 3;

Rod benchRod() {
  const double h_m = kBenchLength_m / kBenchElements;
  const double bow_m = kBenchLength_m / kBenchBend_rad;
  RodPose rest;
  rest.count = kBenchElements + 1;
  for (int i = 0; i < rest.count; ++i) {
    const double at_rad = kBenchBend_rad * i / kBenchElements;
    const SinCos turn = portableSinCos(at_rad);
    rest.nodes[static_cast<std::size_t>(i)] = {.position_m = {bow_m * (1.0 - turn.cos), 0, bow_m * turn.sin},
                                               .orientation = axisAngle({0, 1, 0}, at_rad)};
  }
  const double area_m2 = kPi * kBenchRadius_m * kBenchRadius_m;
  const double spread_m2 = kBenchRadius_m * kBenchRadius_m;  // 4 I / A
  const double bending_Nm2 = 3.0 * kBenchShear_Pa * area_m2 * spread_m2 / 4.0;
  RodElement element;
  element.length_m = h_m;
  element.stretch_N[0] = element.stretch_N[4] = 0.9 * kBenchShear_Pa * area_m2;
  element.axial_N = 3.0 * kBenchShear_Pa * area_m2;
  element.bend_Nm2 = {bending_Nm2, 0, 0, 0, bending_Nm2, 0, 0, 0, bending_Nm2 * 2.0 / 3.0};
  const RodStrain strain = rodStrain(h_m, rest.nodes[0], rest.nodes[1]);
  element.restStrain = {strain.stretch.x, strain.stretch.y, strain.stretch.z};
  element.restCurvature_per_m = {strain.curvature_per_m.x, strain.curvature_per_m.y,
                                 strain.curvature_per_m.z};
  element.bendLimit = {.lever_m = {-0.5 * spread_m2 * strain.curvature_per_m.y, 0},
                       .spread_m2 = {spread_m2, 0, spread_m2},
                       .stiffness_N = 50.0 * element.axial_N};
  const std::vector<RodElement> elements(kBenchElements, element);
  RodRestraints held;
  for (const double arc_m : {0.0, kBenchLength_m}) {
    const NodeRange patch = nodesAround(elements, arc_m, 0.5 * kBenchRadius_m, 5);
    const Vec3 foot = rest.nodes[static_cast<std::size_t>(arc_m > 0.0 ? patch.last : patch.first)].position_m;
    addPatchSpring({.nodes = patch, .point_m = foot, .anchor_m = foot, .stiffness_N_per_m = 2000.0}, rest,
                   held);
    addPatchTurn(patch, 0.010, rest, held);
  }
  return Rod(elements, rest, std::vector<double>(kBenchElements + 1, kBenchRadius_m), std::move(held));
}

Landmarks marksOf(const RodPose& pose) {
  const Pose& grip = pose.nodes[kBenchGrip];
  return {.from = pose.nodes[0].position_m,
          .point = grip.position_m + rotate(grip.orientation, {-kBenchRadius_m, 0, 0}),
          .to = pose.nodes[kBenchElements].position_m};
}

}  // namespace

RodBenchResult runRodBench(int ticks) {
  TORSIO_EXPECTS(ticks >= 1);
  using Clock = std::chrono::steady_clock;
  const Rod rod = benchRod();
  const auto work = std::make_unique<RodWorkspace>();
  RodPose pose = rod.rest();
  const Pose closed = pose.nodes[kBenchGrip];
  const RodGrip grip = gripAt(rod, pose, kBenchGrip, 0.5 * kBenchRadius_m, closed, {});
  const Vec3 line = normalized(pose.nodes[kBenchElements].position_m - pose.nodes[0].position_m);
  const Landmarks rest = marksOf(pose);
  RodBenchResult result;
  std::vector<double> times_us;
  for (int tick = 1; tick <= ticks; ++tick) {
    const double angle_rad = 0.5 * kPi * tick / ticks;
    const Pose hand{rotateAbout(closed.position_m, line, angle_rad),
                    axisAngle(line, angle_rad) * closed.orientation};
    const RodPose before = pose;
    double fastest_us = 1e9;
    for (int repeat = 0; repeat < kBenchRepeats; ++repeat) {
      pose = before;
      const auto begun = Clock::now();
      stepRod(rod, &grip, hand, 1e-3, pose, *work);
      fastest_us =
          std::min(fastest_us, std::chrono::duration<double, std::micro>(Clock::now() - begun).count());
    }
    times_us.push_back(fastest_us);
    result.turn_rad = landmarkTurn_rad(rest, marksOf(pose), result.turn_rad);
  }
  std::sort(times_us.begin(), times_us.end());
  result.median_us = times_us[times_us.size() / 2];
  result.p999_us = times_us[static_cast<std::size_t>(0.999 * static_cast<double>(times_us.size() - 1))];
  return result;
}

}  // namespace torsio
