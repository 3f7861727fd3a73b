// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/sim/tissue/rod/rod_scenes.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "sim/core/angle.h"
#include "sim/core/random.h"

namespace torsio {

namespace {

constexpr int kElements = 31;
constexpr double kShear_Pa = 3e3;
constexpr double kYoung_Pa = 9e3;

/// Follows the curvature about e2 and a slight one about e1 from the origin along z.
RodPose curvePose(const std::vector<double>& bend2_per_m, double bend1_per_m, double h_m) {
  RodPose pose{.count = static_cast<int>(bend2_per_m.size()) + 1};
  for (std::size_t i = 0; i < bend2_per_m.size(); ++i) {
    const Vec3 sigma{0.25 * h_m * bend1_per_m, 0.25 * h_m * bend2_per_m[i], 0};
    const Pose& at = pose.nodes[i];
    const Quat middle = at.orientation * unitFrom(sigma);
    pose.nodes[i + 1] = {.position_m = at.position_m + rotate(middle, {0, 0, h_m}),
                         .orientation = normalized(middle * unitFrom(sigma))};
  }
  return pose;
}

RodElement organElement(double radius_m, double bend_per_m, double h_m) {
  RodElement e = curvedElement({radius_m, radius_m, kYoung_Pa, kShear_Pa}, bend_per_m, h_m);
  e.axial_N = std::exchange(e.stretch_N[8], 0.0);
  return e;
}

Rod organ(const std::vector<double>& bend2_per_m, double bend1_per_m, const std::vector<double>& radii_m,
          double h_m, RodRestraints (*restraints)(const RodPose&, const std::vector<RodElement>&)) {
  const RodPose pose = curvePose(bend2_per_m, bend1_per_m, h_m);
  std::vector<RodElement> elements;
  for (std::size_t i = 0; i < bend2_per_m.size(); ++i) {
    elements.push_back(organElement(0.5 * (radii_m[i] + radii_m[i + 1]), bend2_per_m[i], h_m));
  }
  restAt(pose, elements);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    limitBend(0.5 * (radii_m[i] + radii_m[i + 1]), elements[i].axial_N, elements[i]);
  }
  RodRestraints held = restraints(pose, elements);
  return Rod(std::move(elements), pose, radii_m, std::move(held));
}

}  // namespace

void limitBend(double radius_m, double stretch_N, RodElement& element) {
  const double bend1 = element.restCurvature_per_m[1];
  const double bend2 = -element.restCurvature_per_m[0];
  const double spread_m2 = radius_m * radius_m;  // 4 I / A
  RodBendLimit& limit = element.bendLimit;
  limit.lever_m = {-0.5 * spread_m2 * bend1, -0.5 * spread_m2 * bend2};  // <xi^2> = r^2 / 4
  limit.spread_m2 = {spread_m2, 0.0, spread_m2};
  const double bend = std::sqrt(bend1 * bend1 + bend2 * bend2);
  limit.limit = std::max(0.40, bend * radius_m - 0.5 * bend * bend * spread_m2 + 0.02);
  limit.stiffness_N = 200.0 * stretch_N / 4.0;
}

Rod stomachRod() {
  std::vector<double> bends;
  std::vector<double> radii_m;
  for (int i = 0; i < kElements; ++i) {
    bends.push_back(18.0 - 12.0 * i / kElements);  // 162 degrees in all
  }
  for (int i = 0; i <= kElements; ++i) {
    const double s = static_cast<double>(i) / kElements;
    radii_m.push_back(0.014 + 0.020 * std::min(1.0, 1.8 * s) - 0.006 * std::max(0.0, s - 0.7) / 0.3);
  }
  return organ(
      bends, 0.8, radii_m, 0.270 / kElements,
      [](const RodPose& pose, const std::vector<RodElement>& elements) {
        RodRestraints held;
        const NodeRange pylorus = nodesAround(elements, 0.0, 0.007, 5);
        const Vec3 end = pose.nodes[0].position_m;
        addPatchSpring({.nodes = pylorus, .point_m = end, .anchor_m = end, .stiffness_N_per_m = 2000}, pose,
                       held);
        addPatchTurn(pylorus, 0.010, pose, held);
        const NodeRange cardia = nodesAround(elements, 0.91 * 0.270, 0.011, 5);
        const auto node = static_cast<std::size_t>(cardia.first);
        const Vec3 mouth =
            pose.nodes[node].position_m + rotate(pose.nodes[node].orientation, {0.028, 0.0, 0.0});
        addPatchSpring({.nodes = cardia, .point_m = mouth, .anchor_m = mouth, .stiffness_N_per_m = 1000},
                       pose, held);
        return held;
      });
}

Rod bowelLoop(double radius_m, double gap_m) {
  const double turn_m = kPi * (radius_m + 0.5 * gap_m);
  const double h_m = (0.240 + turn_m) / kElements;
  const double perLength = kPi / turn_m;
  std::vector<double> bends;
  for (int i = 0; i < kElements; ++i) {
    const double begin = std::max(h_m * i, 0.120);
    const double end = std::min(h_m * (i + 1), 0.120 + turn_m);
    bends.push_back(perLength * std::max(0.0, end - begin) / h_m);
  }
  return organ(bends, 0.0, std::vector<double>(kElements + 1, radius_m), h_m,
               [](const RodPose& pose, const std::vector<RodElement>& elements) {
                 RodRestraints held;
                 for (const int last : {0, 1}) {
                   const int node = last * kElements;
                   const NodeRange foot = nodesAround(elements, last * 1.0, 0.007, 5);
                   const Vec3 place = pose.nodes[static_cast<std::size_t>(node)].position_m;
                   addPatchSpring(
                       {.nodes = foot, .point_m = place, .anchor_m = place, .stiffness_N_per_m = 2000}, pose,
                       held);
                   addPatchTurn(foot, 0.020, pose, held);
                 }
                 return held;
               });
}

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
