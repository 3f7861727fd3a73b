// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/sim/tissue/rod/rod_scenes.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "sim/core/angle.h"
#include "sim/core/random.h"
#include "tests/sim/tissue/rod/rod_organs.h"

namespace torsio {
namespace {

constexpr int kStomachGrip = 16;
constexpr double kStomachJaw_m = 0.017;

Pose turnedAbout(const Vec3& centre, const Vec3& axis, double angle_rad, const Pose& pose) {
  return {.position_m = centre + rotateAbout(pose.position_m - centre, axis, angle_rad),
          .orientation = axisAngle(axis, angle_rad) * pose.orientation};
}

double share(int tick, int whole) {
  return std::min(1.0, static_cast<double>(tick) / whole);
}

double sine(double x) {
  return portableSinCos(x).sin;
}

Pose shaken(Pose pose, Random& random, double place_m, double turn_rad) {
  const auto next = [&random] { return 2.0 * random.uniform() - 1.0; };
  const double angle_rad = turn_rad * next();
  const double x = next();
  const double y = next();
  const double z = next();
  pose = turnedAbout(pose.position_m, normalized(Vec3{x, y, z + 1e-3}), angle_rad, pose);
  const double dx = next();
  const double dy = next();
  const double dz = next();
  pose.position_m += place_m * Vec3{dx, dy, dz};
  return pose;
}

}  // namespace

std::vector<RodScene> rodScenes() {
  const auto stomach = std::make_shared<const Rod>(stomachRod());
  const auto bowel = std::make_shared<const Rod>(bowelLoop(0.012, 0.010));
  const Vec3 pylorus = stomach->rest().nodes[0].position_m;
  const Vec3 line = normalized(stomach->rest().nodes[28].position_m - pylorus);
  const RodScene held{.rod = stomach, .node = kStomachGrip, .halfWidth_m = kStomachJaw_m};
  const auto scene = [](RodScene base, std::string name, int ticks,
                        std::function<Pose(int, const Pose&)> hand) {
    base.name = std::move(name);
    base.ticks = ticks;
    base.hand = std::move(hand);
    return base;
  };
  RodScene own = held;
  own.stiffness.place_N_per_m = 0.0;
  RodScene loop = held;
  loop.rod = bowel;
  loop.node = 5;
  loop.halfWidth_m = 0.006;
  return {
      scene(held, "about pylorus-cardia, -180 degrees in 3 s", 3500,
            [=](int tick, const Pose& rest) {
              return turnedAbout(pylorus, line, -kPi * share(tick, 3000), rest);
            }),
      scene(own, "own axis, 180 degrees in 2 s", 2500,
            [](int tick, const Pose& rest) {
              return turnedAbout(rest.position_m, rotate(rest.orientation, {0, 0, 1}),
                                 kPi * share(tick, 2000), rest);
            }),
      scene(held, "tremor, 8 Hz, 1 mm, 2 degrees", 2500,
            [=](int tick, const Pose& rest) {
              const double shake = tick > 1500 ? sine(0.050 * tick) : 0.0;
              Pose pose =
                  turnedAbout(pylorus, line, -radians(120.0) * share(tick, 1500) + 0.035 * shake, rest);
              pose.position_m += 1e-3 * shake * Vec3{1, 1, 0};
              return pose;
            }),
      scene(held, "jump of 10 degrees in a tick", 500,
            [](int tick, const Pose& rest) {
              return turnedAbout(rest.position_m, rotate(rest.orientation, {0, 0, 1}),
                                 tick >= 100 ? radians(10.0) : 0.0, rest);
            }),
      randomHand(held, 1000, 0.005, radians(20.0), 1),
      scene(loop, "bowel limbs pressed and slid", 2500,
            [](int tick, const Pose& rest) {
              Pose pose = rest;
              pose.position_m.x += 0.060 * share(tick, 1000);
              pose.position_m.z += tick > 1000 ? 0.02 * sine(0.003 * (tick - 1000)) : 0.0;
              return pose;
            }),
  };
}

RodScene randomHand(const RodScene& scene, int ticks, double place_m, double turn_rad, unsigned seed) {
  RodScene random = scene;
  random.name = "random hand";
  random.ticks = ticks;
  random.hand = [=, draws = std::make_shared<Random>(seed)](int, const Pose& rest) {
    return shaken(rest, *draws, place_m, turn_rad);
  };
  return random;
}

RunningRodScene::RunningRodScene(const RodScene& scene)
    : scene_(scene), work_(std::make_unique<RodWorkspace>()), pose_(scene.rod->rest()) {
  rest_ = pose_.nodes[static_cast<std::size_t>(scene.node)];
  hand_ = rest_;
  grip_ = gripAt(*scene.rod, pose_, scene.node, scene.halfWidth_m, rest_, scene.stiffness);
}

void RunningRodScene::moveHand() {
  hand_ = scene_.hand(tick_++, rest_);
}

RodStepResult RunningRodScene::step() noexcept {
  return stepRod(*scene_.rod, &grip_, hand_, 1e-3, pose_, *work_);
}

}  // namespace torsio
