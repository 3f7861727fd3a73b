// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "sim/core/live_types.h"
#include "sim/core/random.h"

namespace torsio {

/// Samples like those of a twist about z at 40 mm: half a hertz of twisting, a trembling hand, ten seconds of
/// grip and ten without.
inline std::vector<Sample> twistSamples(std::int64_t count) {
  std::vector<Sample> samples;
  DeviceSample device;
  for (std::int64_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) * 1e-3;
    const double tremor_m =
        0.0002 * std::sin(2.0 * kPi * 9.3 * t) + 0.0001 * std::sin(2.0 * kPi * 10.9 * t + 1.0);
    const double angle_rad = 0.8 * std::sin(kPi * t) + tremor_m / 0.04;
    const bool held = (i / 10'000) % 2 == 0;
    DeviceReading reading;
    reading.time_us = 1000 * i + (i * 37) % 11;
    reading.pose.position_m = {0.04 * std::cos(angle_rad), 0.04 * std::sin(angle_rad), 0.2 + tremor_m};
    reading.pose.orientation = axisAngle({0.0, 0.0, 1.0}, angle_rad);
    reading.grip = held ? 1.0 : 0.0;
    device = quantize(reading, device);
    Sample s;
    s.tick = i;
    s.device = device;
    if (i % 777 == 5) {
      s.command = {ServoCommand::Kind::kSetTarget, 0.1 * t};
    }
    if (held) {
      s.phase = ExercisePhase::kTwisting;
      s.limits = i % 100 < 10 ? kForceSlew : kForceFull;
      s.response.angle_rad = angle_rad;
      s.response.torque_Nm = 0.0804 * angle_rad;
      s.response.force_N =
          Vec3{std::sin(angle_rad), -std::cos(angle_rad), 0.0} * (s.response.torque_Nm / 0.04);
      s.response.depth_m = 0.001 + tremor_m;
      s.response.graspArc_m = 0.2;
      s.force_N = s.response.force_N * 0.9;
    }
    samples.push_back(s);
  }
  return samples;
}

/// A sample in which every field is random within its range.
inline Sample noiseSample(std::int64_t tick, Random& random) {
  const auto any32 = [&random] { return static_cast<std::int32_t>(random.next() >> 32); };
  Sample s;
  s.tick = tick;
  s.device.time_us = static_cast<std::int64_t>(random.next());
  for (std::int32_t& value : s.device.position) {
    value = any32();
  }
  for (std::int32_t& value : s.device.orientation) {
    value = any32();
  }
  s.device.roll = any32();
  s.device.grip = any32();
  s.device.buttons = static_cast<std::uint32_t>(random.next());
  s.device.status = static_cast<std::uint32_t>(random.next());
  s.command = {static_cast<ServoCommand::Kind>(random.bounded(8)), random.normal() * 1e100};
  s.phase = static_cast<ExercisePhase>(random.bounded(4));
  s.limits = static_cast<std::uint32_t>(random.next());
  s.response = {random.normal(), random.normal(), {random.normal(), 1e30, -1e-30}, 0.1, random.uniform()};
  s.force_N = {random.normal(), random.normal(), random.normal()};
  s.contact = static_cast<std::uint32_t>(random.next());
  s.rules = 1 + static_cast<std::uint32_t>(random.bounded(kServoRules));
  if (areOfDetorsion(s.rules)) {
    s.hollow = {1e5 * random.uniform(), random.uniform(), random.uniform(), 3.0 * random.uniform()};
  }
  return s;
}

/// Samples of an untwisting: the organ opens, blood returns, a dose has gathered.
inline std::vector<Sample> detorsionSamples(std::int64_t count) {
  std::vector<Sample> samples = twistSamples(count);
  for (Sample& s : samples) {
    const double share = static_cast<double>(s.tick) / static_cast<double>(count);
    s.rules = kRulesOfDetorsion;
    s.hollow = {2000.0 - 1500.0 * share, share, 0.3 + 0.7 * share, 0.4 + 0.01 * share};
  }
  samples.back().command = {ServoCommand::Kind::kCheckFlow, 3.0};
  return samples;
}

}  // namespace torsio
