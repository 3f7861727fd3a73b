// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/core/device_sample.h"
#include "sim/core/text.h"
#include "sim/device/safety/tick_statistics.h"

namespace torsio {

/// What a device reports about itself, and what had to be assumed because its report made no sense.
struct DeviceIdentity {
  std::string model;
  std::string vendor;
  std::string serial;
  std::string driverVersion;
  std::string libraryVersion;
  std::string openedAs;  ///< the name that worked; "default device" for none
  int inputDof = 0;
  int outputDof = 0;
  std::vector<Text> assumed;  ///< "maximum force", "usable workspace" ...
  std::vector<Text> notes;    ///< sentences for the user
};

enum class CalibrationState : std::uint8_t {
  kUnknown,     ///< not asked yet
  kDockStylus,  ///< the user has to put the stylus into the inkwell
  kUpdating,    ///< the stylus is docked, the device is being calibrated
  kCalibrated,  ///< also of a device that needs no calibration
  kFailed,      ///< the device refused several times; waits until the user asks for another try
};

enum class DeviceState : std::uint8_t {
  kOpened,            ///< found, not served yet
  kNeedsCalibration,  ///< no force until the stylus was in the inkwell (DeviceSnapshot::calibration says
                      ///< more)
  kReady,             ///< calibrated, force off
  kRunning,           ///< calibrated, force on
  kDegraded,          ///< the servo is too slow or the motors are warm: force off until that has passed
  kSilent,            ///< the driver's thread does not call: what the motors do is not known
  kLost,              ///< the connection broke off: close, then open again when the user asks
  kClosed,
};

/// Temperature of a motor above which the force is folded back (rule of the first vendor's own sample).
inline constexpr double kWarmAbove = 0.7;
/// Temperature below which all motors must be before the full force returns.
inline constexpr double kWarmUntilBelow = 0.5;

/// State of a device, published by its driver's thread; the newest counts. What a device does not have stays
/// at its default.
struct DeviceSnapshot {
  DeviceState state = DeviceState::kOpened;
  CalibrationState calibration = CalibrationState::kUnknown;
  DeviceSample sample;             ///< as given to the loop
  bool docked = false;             ///< the stylus rests in the inkwell (by its place)
  bool inkwellSwitch = false;      ///< raw switch; its polarity differs between units
  bool rollReferenced = false;     ///< the docked reference was taken
  bool rollAtStop = false;         ///< the stylus cannot be turned further: grip anew
  bool forceOn = false;            ///< force output, as the device answered when asked after the last change
  bool frozen = false;             ///< the position stands still while the gimbal moves
  double warmest = 0.0;            ///< motors, 0 cold .. 1 warm
  double geometryError_m = 0.0;    ///< reported position against that of the reported joint angles
  std::int64_t jumps = 0;          ///< the position leapt as no hand can move
  std::int64_t forceTrips = 0;     ///< the device's own force protection tripped
  std::int64_t refusedCalls = 0;   ///< harmless errors
  std::int64_t validPoses = 0;     ///< frames whose pose is a rigid motion within reach
  std::int64_t invalidPoses = 0;   ///< frames without
  std::int64_t forcesSent = 0;     ///< frames with a force other than zero that the device took
  std::int64_t forcesRefused = 0;  ///< ... that it refused
  std::int64_t refusedFrames = 0;  ///< frames that could not be opened
  std::int64_t refusedEvents = 0;  ///< events that found the queue full
  std::uint32_t lostBecause = 0;   ///< driver's code; HapticDevice::lossText says it
  TickStatistics timing;
};

/// An event of the driver's thread, which must not be overwritten by a later one.
struct DeviceEvent {
  enum class Kind : std::uint8_t { kButtons, kError, kCalibration, kRollStop, kJump, kGap, kLost, kFrozen };
  Kind kind = Kind::kError;
  std::int64_t time_us = 0;  ///< since the device was served
  std::uint32_t value = 0;   ///< kButtons: mask of pressed buttons; kCalibration: CalibrationState
  std::uint32_t code = 0;    ///< kError, kLost: driver's code
  std::int32_t detail = 0;   ///< driver's own further code; 0 for other kinds
};

static_assert(std::is_trivially_copyable_v<DeviceSnapshot>);
static_assert(std::is_trivially_copyable_v<DeviceEvent>);

}  // namespace torsio
