// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

#include "sim/core/pose.h"

namespace torsio {

/// Steps of the quantisation at the device border. A recorded trial holds exactly what the model saw, so that
/// it replays bit for bit; every step lies far below any sensor's resolution (a Touch resolves 55 um).
inline constexpr double kPositionStep_m = 1e-7;      ///< 0.1 um; +-214 m
inline constexpr double kOrientationStep = 0x1p-30;  ///< quaternion component, about 1e-9 rad
inline constexpr double kRollStep_rad = 1e-7;        ///< unwrapped stylus roll; +-34 turns
inline constexpr double kGripStep = 1.0 / 65536.0;   ///< jaw closure, 0 open .. 1 closed

/// Bits of DeviceSample::buttons.
enum DeviceButton : std::uint32_t {
  kButtonGrip = 1U << 0,      ///< closes the jaw (stylus button 1, left mouse button)
  kButtonSecond = 1U << 1,    ///< stylus button 2
  kButtonBookmark = 1U << 2,  ///< marks this instant for the debrief
};

/// Bits of DeviceSample::status; anything but kDeviceOk means zero force.
enum DeviceStatus : std::uint32_t {
  kDeviceOk = 0,
  kDeviceStale = 1U << 0,  ///< nothing new since the last tick's deadline
  kDeviceUncalibrated = 1U << 1,
  kDeviceLost = 1U << 2,
  kDeviceInvalid = 1U << 3,  ///< the driver delivered a non-finite pose: the last good one is repeated
  kDeviceEnded = 1U << 4,    ///< a scripted hand or a replay has no more samples
  kDeviceWarm = 1U << 5,     ///< motors warm: force folds back
};

/// One reading of a haptic device, quantised. Integers only: what is stored is what the model sees.
struct DeviceSample {
  std::int64_t time_us = 0;                                   ///< servo time of the reading
  std::array<std::int32_t, 3> position{};                     ///< stylus tip, world frame, kPositionStep_m
  std::array<std::int32_t, 4> orientation{1 << 30, 0, 0, 0};  ///< w x y z, kOrientationStep
  std::int32_t roll = 0;             ///< unwrapped roll about the stylus, kRollStep_rad
  std::int32_t grip = 0;             ///< jaw closure, kGripStep
  std::uint32_t buttons = 0;         ///< DeviceButton bits
  std::uint32_t status = kDeviceOk;  ///< DeviceStatus bits
  friend constexpr bool operator==(const DeviceSample&, const DeviceSample&) = default;
};
static_assert(std::is_trivially_copyable_v<DeviceSample>);

/// What a driver measures before quantisation, SI.
struct DeviceReading {
  std::int64_t time_us = 0;
  Pose pose;
  double roll_rad = 0.0;
  double grip = 0.0;  ///< 0 open .. 1 closed
  std::uint32_t buttons = 0;
  std::uint32_t status = kDeviceOk;
};

/// The pose that the simulation computes with: decoded from a DeviceSample, same bits on every processor.
struct ToolState {
  std::int64_t time_us = 0;
  Pose pose;
  double roll_rad = 0.0;
  double grip = 0.0;
  std::uint32_t buttons = 0;
  std::uint32_t status = kDeviceOk;
};
static_assert(std::is_trivially_copyable_v<ToolState>);

/// Quantises a device reading; the only place where readings become integers. A non-finite or out-of-range
/// reading repeats the pose of `previous` and sets kDeviceInvalid. noexcept: runs in the servo tick.
[[nodiscard]] DeviceSample quantize(const DeviceReading& reading, const DeviceSample& previous) noexcept;

/// Decodes a sample: the inverse of quantize up to the step, with the quaternion normalised.
[[nodiscard]] ToolState toolState(const DeviceSample& sample) noexcept;

}  // namespace torsio
