// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever state the device is in, and whatever organ is shipped, a hand gets no more than 1 mJ
// out of a contact that neither it nor the organ put in (docs/contact.md, Energy).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/random.h"
#include "sim/core/time_units.h"
#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/record/trial.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/scene.h"
#include "sim/servo/exercise.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/led_hand.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

using testing::Hand;
using testing::kMaxGiven_J;
using testing::LedHand;

constexpr int kTicks = 1'200;
constexpr int kHands = 4;  // for each organ, pattern and state

/// A state of the device, as the servo hears of it.
struct State {
  const char* name;
  std::uint32_t status;
  std::int64_t every_us;  ///< begins anew; 0: never
  std::int64_t lasts_us;
};

constexpr std::int64_t kLong_us = 90'000;
const std::vector<State>& states() {
  static const std::vector<State> kAll{
      {"ready", kDeviceOk, 0, 0},
      {"stale ticks", kDeviceStale, 7 * kTickPeriod_us, 2 * kTickPeriod_us},
      {"stale for long", kDeviceStale, 4 * kLong_us, kLong_us},
      {"uncalibrated", kDeviceUncalibrated, 4 * kLong_us, kLong_us},
      {"lost", kDeviceLost, 4 * kLong_us, kLong_us},
      {"invalid poses", kDeviceInvalid, 11 * kTickPeriod_us, 3 * kTickPeriod_us},
      {"warm", kDeviceWarm, 4 * kLong_us, 2 * kLong_us},
  };
  return kAll;
}

Quat turning(const Vec3& from, const Vec3& to) {
  const double c = dot(from, to);
  if (c < -0.999999) {
    return {0.0, 1.0, 0.0, 0.0};
  }
  const Vec3 axis = cross(from, to);
  const double w = std::sqrt(2.0 * (1.0 + c));
  return {0.5 * w, axis.x / w, axis.y / w, axis.z / w};
}

/// Leads a hand through a random place of the organ's surface, the instrument along its normal.
Hand handAt(const std::vector<Vec3>& vertices_m, const std::vector<Vec3>& normals, Random& random,
            int number) {
  const auto place = static_cast<std::size_t>(random.uniform() * static_cast<double>(vertices_m.size() - 1));
  const Vec3& out = normals[place];
  Hand hand;
  hand.mass_kg = 0.05 * std::pow(20.0, random.uniform());
  hand.damping_Ns_per_m = 40.0 * random.uniform();
  hand.stiffness_N_per_m = 2000.0 * random.uniform();
  hand.frequency_Hz = 0.5 + 9.5 * random.uniform();
  hand.centre_m = vertices_m[place] + out * (0.004 * random.uniform() - 0.002);
  hand.amplitude_m = out * (0.002 + 0.005 * random.uniform());
  hand.jawEvery_us = number % 2 == 0 ? 0 : 80'000 + static_cast<std::int64_t>(300'000 * random.uniform());
  hand.wholeContacts = true;
  hand.facing = turning({0.0, 0.0, -1.0}, out * -1.0);
  return hand;
}

TEST(PassiveOrgans, GiveAHandNoMoreThanAMillijouleInAnyStateOfTheDevice) {
  const std::filesystem::path assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  std::vector<double> worstOf_J(states().size(), 0.0);
  std::vector<double> hiddenOf_J = worstOf_J;
  int felt = 0;
  std::int64_t grips = 0;
  std::size_t organs = 0;
  for (const std::string& id : sceneIds(assets)) {
    double worst_J = 0.0;
    for (const std::string& pattern : patternIds(assets, id)) {
      const Scene scene = testing::shippedScene(id, pattern);
      const std::uint64_t seed = detorsionSeed({});
      TriangleMesh mesh = scene.mesh;
      if (scene.hollow) {
        mesh.vertices_m = testing::smoothAt(scene, scene.hollow->start(seed));
      }
      const std::vector<Vec3> normals = vertexNormals(mesh);
      Random random(43);
      for (std::size_t at = 0; at < states().size(); ++at) {
        const State& state = states()[at];
        for (int number = 0; number < kHands; ++number) {
          Hand hand = handAt(mesh.vertices_m, normals, random, number);
          hand.status = [&state](std::int64_t time_us) -> std::uint32_t {
            const bool now =
                state.every_us > 0 && time_us % state.every_us >= state.every_us - state.lasts_us;
            return now ? state.status : kDeviceOk;
          };
          LedHand device(hand);
          ServoLoop loop({.device = &device, .scene = &scene}, {.seed = seed});
          Exercise lender({.drive = TwistDrive::kTangential,
                           .maxStiffness_N_per_m = device.capabilities().maxStiffness_N_per_m},
                          scene, seed);
          for (int tick = 0; tick < kTicks; ++tick) {
            loop.tick(kTickPeriod_us * tick);
            device.lend(lender.step(toolState(loop.lastSample().device)).lent_J);
            const Sample& last = loop.lastSample();
            if (last.response.force_N == Vec3{} && last.force_N == Vec3{}) {
              device.endContact();
            }
          }
          EXPECT_LE(device.mostGiven_J(), kMaxGiven_J) << id << ", " << pattern << ", " << state.name;
          EXPECT_LE(device.mostKnown_J(), kMaxGiven_J)
              << id << ", " << pattern << ", " << state.name << ", hand " << number;
          worst_J = std::max(worst_J, device.mostKnown_J());
          worstOf_J[at] = std::max(worstOf_J[at], device.mostKnown_J());
          hiddenOf_J[at] = std::max(hiddenOf_J[at], device.mostGiven_J());
          felt += device.felt() ? 1 : 0;
          grips += loop.grips();
        }
      }
    }
    ++organs;
    std::printf("  %-24s %.3f mJ at most\n", id.c_str(), 1e3 * worst_J);
  }
  for (std::size_t at = 0; at < states().size(); ++at) {
    std::printf("  %-24s %.3f mJ at most; %.3f mJ with what the device did not tell\n", states()[at].name,
                1e3 * worstOf_J[at], 1e3 * hiddenOf_J[at]);
  }
  std::printf("  %d contacts, %d grips\n", felt, static_cast<int>(grips));
  EXPECT_GE(organs, 9U);
  EXPECT_GT(felt, 200);
  EXPECT_GT(grips, 60);
}

}  // namespace
}  // namespace torsio
