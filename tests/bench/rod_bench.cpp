// SPDX-License-Identifier: GPL-3.0-or-later
// One tick of the rod in each of its scenes, in processor time of this thread: every tick is repeated seven
// times from the same pose and the fastest counts, to exclude other load on a shared machine. Prints median,
// 99 % and 99.9 % against the target, Newton steps, and the ratio to the median of one STREAM triad over
// 100,000 doubles.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <vector>

#include "sim/core/angle.h"
#include "tests/bench/times.h"
#include "tests/sim/tissue/rod/rod_scenes.h"

namespace torsio {
namespace {

constexpr double kP999Target_us = 60.0;
constexpr int kRepeats = 7;

/// A wide loop of bowel turned upside down and further, its limbs touching in 43 places. Not among the scenes
/// with fixed bits.
RodScene turnedLoop() {
  RodScene scene;
  scene.name = "wide bowel loop turned by 360 degrees in 3 s";
  scene.rod = std::make_shared<const Rod>(bowelLoop(0.022, 0.020));
  scene.node = 16;
  scene.halfWidth_m = 0.006;
  scene.stiffness.turn_Nm_per_rad = 5.0;
  scene.ticks = 4000;
  scene.hand = [](int tick, const Pose& rest) {
    const Quat turn = axisAngle({0, 0, 1}, kTurn * std::min(1.0, tick / 3000.0));
    return Pose{rest.position_m, turn * rest.orientation};
  };
  return scene;
}

void measure(const RodScene& scene, double triad) {
  RunningRodScene run(scene);
  std::vector<double> times_us;
  int steps = 0;
  for (int tick = 0; tick < scene.ticks; ++tick) {
    run.moveHand();
    const RodPose before = run.pose();
    double best_us = 1e9;
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
      run.setPose(before);
      const double begun = processor_us();
      const RodStepResult step = run.step();
      best_us = std::min(best_us, processor_us() - begun);
      steps += repeat == 0 ? step.newtonSteps : 0;
    }
    times_us.push_back(best_us);
  }
  std::sort(times_us.begin(), times_us.end());
  const double p999_us = quantile(times_us, 0.999);
  std::printf("%-44s %8.1f %8.1f %8.1f us  %4.2f steps  %6.2f triads  %s\n", scene.name.c_str(),
              quantile(times_us, 0.5), quantile(times_us, 0.99), p999_us,
              static_cast<double>(steps) / scene.ticks, p999_us / triad,
              p999_us <= kP999Target_us ? "ok" : "over the target");
}

}  // namespace
}  // namespace torsio

int main() {
  const double triad = torsio::triad_us(100'000, 201, torsio::processor_us);
  std::printf("rod of 32 nodes, target of 99.9 %%: %.0f us; one triad: %.1f us\n%-44s %8s %8s %8s\n",
              torsio::kP999Target_us, triad, "scene", "50 %", "99 %", "99.9 %");
  for (const torsio::RodScene& scene : torsio::rodScenes()) {
    torsio::measure(scene, triad);
  }
  torsio::measure(torsio::turnedLoop(), triad);
  return 0;
}
