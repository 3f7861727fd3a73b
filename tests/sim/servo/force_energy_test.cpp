// SPDX-License-Identifier: GPL-3.0-or-later
// Energy at the hand's port: whatever the hand is like and whatever the jaw does, a contact gives no more
// than it has got. The hand is a mass on a spring and a damper that are led to and fro; its physics is
// integrated in steps of 20 us while the force of a tick is held.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/random.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/bar_scene.h"
#include "tests/sim/servo/led_hand.h"

namespace torsio {
namespace {

using testing::Hand;
using testing::kMaxGiven_J;
using testing::LedHand;

struct Lead {
  double given_J = 0.0;
  bool felt = false;
  std::int64_t grips = 0;
};

Lead lead(const Scene& scene, const Hand& hand, std::uint32_t rules) {
  constexpr int kTicks = 1'500;
  LedHand device(hand);
  ServoLoop loop({.device = &device, .scene = &scene}, {.rules = rules});
  for (int tick = 0; tick < kTicks; ++tick) {
    loop.tick(1000LL * tick);
  }
  return {device.mostGiven_J(), device.felt(), loop.grips()};
}

/// Hands of 0.05 to 1 kg, 0 to 40 N s/m, 0 to 2,000 N/m, led with 0.5 to 20 Hz through the surface of the
/// bar, jaw open or at work.
std::vector<Hand> hands(int count) {
  Random random(20);
  std::vector<Hand> all;
  for (int i = 0; i < count; ++i) {
    Hand hand;
    hand.mass_kg = 0.05 * std::pow(20.0, random.uniform());
    hand.damping_Ns_per_m = 40.0 * random.uniform();
    hand.stiffness_N_per_m = 2000.0 * random.uniform();
    hand.frequency_Hz = 0.5 + 19.5 * random.uniform();
    hand.centre_m = {kBarRadius_m + 0.012 * random.uniform() - 0.004, 0.0, 0.2};
    hand.amplitude_m = {0.001 + 0.007 * random.uniform(), 0.006 * random.uniform(), 0.004 * random.uniform()};
    hand.jawEvery_us = i % 2 == 0 ? 0 : 80'000 + static_cast<std::int64_t>(300'000 * random.uniform());
    all.push_back(hand);
  }
  return all;
}

TEST(ForceEnergy, NoContactReturnsMoreThanTheHandPutIn) {
  const Scene scene = barScene();
  int felt = 0;
  std::int64_t grips = 0;
  double worst_J = 0.0;

  for (const Hand& hand : hands(300)) {
    const Lead led = lead(scene, hand, kServoRules);
    worst_J = std::max(worst_J, led.given_J);
    felt += led.felt ? 1 : 0;
    grips += led.grips;
    EXPECT_LE(led.given_J, kMaxGiven_J)
        << hand.mass_kg << " kg, " << hand.damping_Ns_per_m << " N s/m, " << hand.stiffness_N_per_m
        << " N/m, " << hand.frequency_Hz << " Hz, jaw every " << hand.jawEvery_us << " us";
  }

  EXPECT_GT(felt, 220);
  EXPECT_GT(grips, 120);
  RecordProperty("worst_mJ", std::to_string(1e3 * worst_J));
}

TEST(ForceEnergy, EarlierRulesGaveEnergyAway) {
  const Scene scene = barScene();
  int over = 0;
  for (const Hand& hand : hands(40)) {
    over += lead(scene, hand, 1).given_J > kMaxGiven_J ? 1 : 0;
  }
  EXPECT_GT(over, 5);
}

}  // namespace
}  // namespace torsio
