// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/core/device_sample.h"
#include "sim/core/live_types.h"
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

/// What a device can do. A driver that assumes a value says so.
struct DeviceCapabilities {
  std::string model;        ///< "Scripted hand", "Mouse and keyboard", "Touch" ...
  double maxForce_N = 3.3;  ///< nominal, norm
  double continuousForce_N = 0.88;
  double maxStiffness_N_per_m = 500.0;
  Vec3 workspaceMin_m{-10.0, -10.0, -10.0};  ///< usable box, world frame; the default means "no box"
  Vec3 workspaceMax_m{10.0, 10.0, 10.0};
  bool rendersForce = false;  ///< false: force is shown, not felt
  bool realTime = true;       ///< false: may be driven faster than the wall clock
  /// How its motion becomes the twist. Not every device can be led round an organ.
  TwistDrive drive = TwistDrive::kTangential;
};

/// A hand-held device with up to six sensed degrees of freedom and a three-axis force. Vendor types never
/// appear here. Drivers convert to SI and to the world frame, quantise at their border (device_sample.h), and
/// honour any force they cannot render by ignoring it.
///
/// The stylus points along the -z axis of its pose; the position is that of its tip.
///
/// Life: opened by a DeviceDriver with its force off, served, closed. serve, close and destruction belong to
/// one thread; enableForce, snapshot and nextEvent to one (the same or another); read and write to the servo.
/// What needs no hardware is always ready: it overrides the readings only.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;

  [[nodiscard]] virtual const DeviceCapabilities& capabilities() const noexcept = 0;
  /// Returns the reading for servo time `time_us`, which never decreases from call to call. Servo thread;
  /// no allocation, no lock, no log.
  [[nodiscard]] virtual DeviceSample read(std::int64_t time_us) noexcept = 0;
  /// Sets the force to render until the next write. Servo thread; no allocation, no lock, no log.
  virtual void write(const ForceCommand& command) noexcept = 0;
  /// Lets go of the hand at once and until the next write: a watchdog calls it when the tick stalls, from a
  /// thread of its own while read or write may hang. Never waits. A device whose force ends by itself when
  /// nobody writes, or that renders none, has nothing to do.
  virtual void dropForce() noexcept {}

  /// Starts the driver's thread; readings and forces go over mailboxes. Once. Throws Error{kDevice}.
  virtual void serve() {}
  /// Lets go of the hand and ends the driver. False when the device did not let go by itself.
  virtual bool close() { return true; }
  /// Asks for force output. Force is granted while the device is calibrated, quick and cool, and always
  /// ramped; a device that renders none stays without.
  virtual void enableForce(bool) noexcept {}
  /// Returns the newest state that the device confirmed.
  [[nodiscard]] virtual DeviceSnapshot snapshot() noexcept {
    DeviceSnapshot ready;
    ready.state = DeviceState::kReady;
    ready.calibration = CalibrationState::kCalibrated;
    return ready;
  }
  /// Takes the oldest event not yet taken; false when there is none.
  [[nodiscard]] virtual bool nextEvent(DeviceEvent&) noexcept { return false; }
  /// Says why the device was lost (DeviceSnapshot::lostBecause), without a full stop.
  [[nodiscard]] virtual Text lossText(std::uint32_t) const {
    return Text::tr("the connection to the device broke off");
  }
  /// Returns what the device says about itself; empty of one without hardware.
  [[nodiscard]] virtual const DeviceIdentity& identity() const noexcept {
    static const DeviceIdentity kNothing;
    return kNothing;
  }
};

}  // namespace torsio
