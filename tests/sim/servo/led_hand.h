// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include "sim/device/haptic_device.h"

namespace torsio::testing {

inline constexpr double kTwoPi = 6.28318530717958647692;
/// Energy that a safe contact may give.
inline constexpr double kMaxGiven_J = 1e-3;

struct Hand {
  double mass_kg = 0.2;
  double damping_Ns_per_m = 5.0;
  double stiffness_N_per_m = 500.0;
  double frequency_Hz = 5.0;
  Vec3 centre_m;
  Vec3 amplitude_m;
  std::int64_t jawEvery_us = 0;                           // it closes and opens; 0: it stays open
  Quat facing{std::sqrt(0.5), 0.0, std::sqrt(0.5), 0.0};  // the stylus points along -x
  bool wholeContacts = false;  // a contact ends by endContact(), not already without force
  std::function<std::uint32_t(std::int64_t time_us)> status{};  // DeviceStatus; empty: kDeviceOk
};

/// A hand on a device; what it gets of the force is added up exactly.
class LedHand final : public HapticDevice {
 public:
  explicit LedHand(const Hand& hand) : hand_(hand), told_{hand.centre_m, hand.facing}, at_m_(hand.centre_m) {
    capabilities_.rendersForce = true;
  }

  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override {
    DeviceReading reading{.time_us = time_us, .pose = {at_m_, hand_.facing}};
    const bool closed = hand_.jawEvery_us > 0 && (time_us / hand_.jawEvery_us) % 2 == 1;
    reading.grip = closed ? 1.0 : 0.0;
    reading.buttons = closed ? static_cast<std::uint32_t>(kButtonGrip) : 0U;
    reading.status = hand_.status ? hand_.status(time_us) : kDeviceOk;
    if ((reading.status & kRepeats) != 0) {
      reading.pose = told_;
    }
    told_ = reading.pose;
    last_ = quantize(reading, last_);
    return last_;
  }
  void write(const ForceCommand& command) noexcept override {
    const double before_J = given_J_;
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
    if (command.force_N == Vec3{} && !hand_.wholeContacts) {
      given_J_ = 0.0;
    }
    hidden_J_ += (last_.status & kRepeats) != 0 ? std::max(0.0, given_J_ - before_J) : 0.0;
    mostKnown_J_ = std::max(mostKnown_J_, given_J_ - hidden_J_);
    mostGiven_J_ = std::max(mostGiven_J_, given_J_);
    felt_ = felt_ || norm(command.force_N) > 0.1;
  }
  void endContact() noexcept { given_J_ = hidden_J_ = 0.0; }
  /// Adds energy that the organ brought along, and so may give.
  void lend(double energy_J) noexcept { given_J_ -= energy_J; }
  /// Returns the most that a contact has given beyond what it gave while the reading stood still, J: nobody
  /// knows then where the hand is.
  [[nodiscard]] double mostKnown_J() const noexcept { return mostKnown_J_; }
  /// Returns the most that a contact has given in all, J.
  [[nodiscard]] double mostGiven_J() const noexcept { return mostGiven_J_; }
  [[nodiscard]] bool felt() const noexcept { return felt_; }

 private:
  static constexpr int kSteps = 50;  // a tick
  Hand hand_;
  DeviceCapabilities capabilities_;
  /// Of a state in which a driver repeats the last pose.
  static constexpr std::uint32_t kRepeats = kDeviceStale | kDeviceLost | kDeviceInvalid;

  DeviceSample last_;
  Pose told_;
  Vec3 at_m_;
  Vec3 speed_m_per_s_;
  double time_s_ = 0.0;
  double given_J_ = 0.0;
  double hidden_J_ = 0.0;
  double mostGiven_J_ = 0.0;
  double mostKnown_J_ = 0.0;
  bool felt_ = false;
};

}  // namespace torsio::testing
