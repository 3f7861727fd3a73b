// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

#include "sim/base/device_sample.h"
#include "sim/device/hdapi/hdapi_abi.h"
#include "sim/device/hdapi/hdapi_calibration.h"
#include "sim/device/safety/tick_statistics.h"

namespace torsio {

enum class HdapiState : std::uint8_t {
  kOpened,            ///< found, the servo does not run yet
  kNeedsCalibration,  ///< no force until the stylus was in the inkwell (HdapiSnapshot::calibration says more)
  kReady,             ///< calibrated, force off
  kRunning,           ///< calibrated, force on
  kDegraded,          ///< the servo is too slow or the motors are warm: force off until that has passed
  kSilent,            ///< the library's servo does not call: what the motors do is not known
  kLost,              ///< the connection broke off: close, then open again on the user's wish
  kClosed,
};

/// State of the servo thread, published once a tick; the newest counts.
struct HdapiSnapshot {
  HdapiState state = HdapiState::kOpened;
  CalibrationState calibration = CalibrationState::kUnknown;
  DeviceSample sample;          ///< as given to the loop
  bool docked = false;          ///< the stylus rests in the inkwell (by its place)
  bool inkwellSwitch = false;   ///< raw switch; its polarity differs between units
  bool rollReferenced = false;  ///< the docked reference was taken
  bool rollAtStop = false;      ///< the stylus cannot be turned further: grip anew
  bool forceOn = false;         ///< HD_FORCE_OUTPUT, as the library answered when asked after the last change
  bool frozen = false;          ///< the position stands still while the gimbal moves (PositionLiveness)
  double warmest = 0.0;         ///< motors, 0 cold .. 1 warm
  double geometryError_m = 0.0;    ///< reported position against touchTransform_mm of the reported angles
  std::int64_t jumps = 0;          ///< the position leapt as no hand can move
  std::int64_t forceTrips = 0;     ///< the device's own force protection tripped
  std::int64_t refusedCalls = 0;   ///< harmless errors
  std::int64_t validPoses = 0;     ///< frames whose pose is a rigid motion within reach
  std::int64_t invalidPoses = 0;   ///< frames without
  std::int64_t forcesSent = 0;     ///< frames with a force other than zero that the library took
  std::int64_t forcesRefused = 0;  ///< ... that it refused
  std::int64_t refusedFrames = 0;  ///< frames that could not be opened
  std::int64_t refusedEvents = 0;  ///< events that found the queue full
  hd::ErrorCode lostBecause = hd::kSuccess;
  TickStatistics timing;
};

/// An event of the servo thread, which must not be overwritten by a later one.
struct HdapiEvent {
  enum class Kind : std::uint8_t { kButtons, kError, kCalibration, kRollStop, kJump, kGap, kLost, kFrozen };
  Kind kind = Kind::kError;
  std::int64_t time_us = 0;  ///< since the start of the servo
  std::uint32_t value = 0;   ///< kButtons: mask of pressed buttons; kCalibration: CalibrationState
  hd::ErrorInfo error;       ///< kError, kLost
};

static_assert(std::is_trivially_copyable_v<HdapiSnapshot>);
static_assert(std::is_trivially_copyable_v<HdapiEvent>);

}  // namespace torsio
