// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/core/clock.h"
#include "sim/core/text.h"
#include "sim/device/haptic_device.h"
#include "sim/device/hdapi/hdapi_abi.h"
#include "sim/device/hdapi/hdapi_servo.h"

namespace torsio {

struct HdapiOptions {
  /// Name that the vendor's set-up tool gave the device; tried first, then the default device. Empty: the
  /// default device first, then the vendor's two customary names.
  std::string deviceName;
  Quat deviceToWorld = DevicePlacement{}.deviceToWorld;
  Vec3 workspaceCentre_m;                ///< world point for the centre of the usable workspace
  double stylusTip_m = kStylusTip_m;     ///< from the middle of the gimbal to the tip
  std::int64_t patience_us = 2'000'000;  ///< how long close() waits for a library that does not let go
  std::shared_ptr<const Clock> clock;    ///< null: the machine's monotonic clock
};

struct ServoEntry;

/// One connection to one device, from hdInitDevice to hdDisableDevice, and the order of everything between:
/// init, capabilities, callback, scheduler; then zero force, scheduler, callback, device. The library
/// allows one servo loop a process, so there is one session at a time. The calls of a session belong to one
/// thread; those of HdapiServo to the vendor's.
class HdapiSession {
 public:
  /// Opens the device with its force off. Throws Error{kDevice}: no device, in use, no licence.
  HdapiSession(const hd::Api& api, const HdapiOptions& options);
  /// Ends the session as tearDown() does.
  ~HdapiSession();
  HdapiSession(const HdapiSession&) = delete;
  HdapiSession& operator=(const HdapiSession&) = delete;

  /// Starts the vendor's servo loop. Throws Error{kDevice}; then everything is torn down again.
  void start(const DeviceTick& tick);
  /// Ends the session: zero force, stop, unschedule, disable, in this order; once. Blocks as long as the
  /// library does.
  void tearDown() noexcept;

  /// As HostedDevice::switchOff(). Any thread.
  void switchOff() noexcept;
  /// Tells whether the output was switched off by tearDown(). Any thread.
  [[nodiscard]] bool silent() const noexcept { return silent_.load(); }

  [[nodiscard]] HdapiServo& servo() noexcept { return *servo_; }
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept { return capabilities_; }
  [[nodiscard]] const DeviceIdentity& identity() const noexcept { return identity_; }

 private:
  void open(const std::string& deviceName);
  void calibrateBeforeStart();
  void readIdentity();
  void readCapabilities(const HdapiOptions& options);
  [[nodiscard]] HdapiSetup setup();
  [[nodiscard]] double reported(hd::Enum name, double least, double most, double assumed, Phrase what);
  [[nodiscard]] std::string text(hd::Enum name);

  /// Waits for the servo to let go, for as long as it calls; then does it in its place.
  void letGo() noexcept;

  const hd::Api api_;
  const std::shared_ptr<const Clock> clock_;
  hd::Handle handle_ = hd::kInvalidHandle;
  hd::SchedulerHandle callback_ = 0;
  bool scheduled_ = false;
  bool running_ = false;  // hdStartScheduler was called
  bool served_ = false;   // ... and did not fail
  DevicePlacement placement_;
  DeviceCapabilities capabilities_;
  DeviceIdentity identity_;
  std::unique_ptr<HdapiServo> servo_;
  std::atomic<bool> silent_{false};
  ServoEntry* entry_ = nullptr;  // never freed: the library may call after hdUnschedule
  bool claimed_ = false;         // the process's one session
};

}  // namespace torsio
