// SPDX-License-Identifier: GPL-3.0-or-later
// Energy at the hand's port: whatever the hand is like and whatever the jaw does, a contact gives no more
// than it has got. The hand is a mass on a spring and a damper that are led to and fro; its physics is
// integrated in steps of 20 us while the force of a tick is held.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "sim/core/random.h"
#include "sim/device/haptic_device.h"
#include "sim/servo/servo_loop.h"
#include "tests/sim/servo/bar_scene.h"

namespace torsio {
namespace {

constexpr double kTwoPi = 6.28318530717958647692;
constexpr int kSteps = 50;  // a tick
// What the issue of a safe force allows.
constexpr double kMaxGiven_J = 1e-3;

struct Hand {
  double mass_kg = 0.2;
  double damping_Ns_per_m = 5.0;
  double stiffness_N_per_m = 500.0;
  double frequency_Hz = 5.0;
  Vec3 centre_m;
  Vec3 amplitude_m;
  std::int64_t jawEvery_us = 0;  // it closes and opens; 0: it stays open
};

/// A hand on a device; what it gets of the force is added up exactly.
class LedHand final : public HapticDevice {
 public:
  explicit LedHand(const Hand& hand) : hand_(hand), at_m_(hand.centre_m) {
    capabilities_.rendersForce = true;
  }

  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override {
    DeviceReading reading{.time_us = time_us, .pose = {at_m_, facing_}};
    const bool closed = hand_.jawEvery_us > 0 && (time_us / hand_.jawEvery_us) % 2 == 1;
    reading.grip = closed ? 1.0 : 0.0;
    reading.buttons = closed ? static_cast<std::uint32_t>(kButtonGrip) : 0U;
    last_ = quantize(reading, last_);
    return last_;
  }
  void write(const ForceCommand& command) noexcept override {
    for (int i = 0; i < kSteps; ++i) {
      const double angle_rad = kTwoPi * hand_.frequency_Hz * time_s_;
      const Vec3 led_m = hand_.centre_m + hand_.amplitude_m * std::sin(angle_rad);
      const Vec3 led_m_per_s = hand_.amplitude_m * (kTwoPi * hand_.frequency_Hz * std::cos(angle_rad));
      const Vec3 force_N = command.force_N + (led_m - at_m_) * hand_.stiffness_N_per_m +
                           (led_m_per_s - speed_m_per_s_) * hand_.damping_Ns_per_m;
      constexpr double kStep_s = 1e-3 / kSteps;
      speed_m_per_s_ += force_N * (kStep_s / hand_.mass_kg);
      at_m_ += speed_m_per_s_ * kStep_s;
      given_J_ += dot(command.force_N, speed_m_per_s_) * kStep_s;
      time_s_ += kStep_s;
    }
    if (command.force_N == Vec3{}) {
      given_J_ = 0.0;
    }
    mostGiven_J_ = std::max(mostGiven_J_, given_J_);
    felt_ = felt_ || norm(command.force_N) > 0.1;
  }
  /// Returns the most that a contact has given in all, J.
  [[nodiscard]] double mostGiven_J() const noexcept { return mostGiven_J_; }
  [[nodiscard]] bool felt() const noexcept { return felt_; }

 private:
  Hand hand_;
  DeviceCapabilities capabilities_;
  Quat facing_{std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0};  // the stylus points along -x
  DeviceSample last_;
  Vec3 at_m_;
  Vec3 speed_m_per_s_;
  double time_s_ = 0.0;
  double given_J_ = 0.0;
  double mostGiven_J_ = 0.0;
  bool felt_ = false;
};

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
