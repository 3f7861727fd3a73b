// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <future>
#include <memory>

#include "sim/device/hdapi/hdapi_session.h"
#include "sim/device/hosted_device.h"

namespace torsio {

/// Age at which a reading that is not renewed is marked stale in mailbox operation.
inline constexpr std::int64_t kReadingStale_us = 5'000;
/// Age of a reading at which the device counts as lost in mailbox operation.
inline constexpr std::int64_t kReadingLost_us = 250'000;

/// Time without any call of the library's servo after which a snapshot says so.
inline constexpr std::int64_t kServoSilent_us = 500'000;

/// PHANTOM Omni or 3D Systems Touch through the vendor's library. Two ways to run:
///
/// - start(tick): the vendor's servo thread calls the tick function inside its own frame, a thousand times a
///   second; the tick reads, computes and writes. Least delay.
/// - serve(): the vendor's servo thread exchanges readings and forces with another thread (ServoThread) over
///   mailboxes; neither ever waits for the other. One more tick of delay each way.
///
/// Millimetres and device axes become SI and the world frame in hdapi_border.h only; nothing above sees them.
///
/// | channel     | direction | unit | source                                                                |
/// |-------------|-----------|------|-----------------------------------------------------------------------|
/// | position    | given     | m    | HD_CURRENT_TRANSFORM (mm), middle of the gimbal, moved to the tip     |
/// | orientation | given     | 1    | HD_CURRENT_TRANSFORM; the stylus points along -z                      |
/// | roll        | given     | rad  | gimbal angle 3, sign turned, unwrapped, from the docked reference     |
/// | grip        | given     | 1    | stylus button 1, 0..1 within kGripTime_us                             |
/// | buttons     | given     |      | kButtonGrip, kButtonSecond, debounced; further bits are dropped       |
/// | status      | given     |      | see below                                                             |
/// | force       | taken     | N    | HD_CURRENT_FORCE, three axes, at the middle of the gimbal             |
///
/// There is no torque about the stylus: the device has three motors. Resistance to a twist is rendered as a
/// force at the grasp.
///
/// | status              | when                                                                     |
/// |---------------------|--------------------------------------------------------------------------|
/// | kDeviceUncalibrated | not calibrated, kJumpSettles_us after a jump of the pose, after a trip   |
/// | kDeviceStale        | no frame, rate below kLowestRate_Hz, HD_WARM_MOTORS, lost, old mailbox   |
/// | kDeviceInvalid      | the pose is not rigid, or the device's own protection tripped            |
/// | kDeviceWarm         | a motor above kWarmAbove, until all are below kWarmUntilBelow            |
/// | kDeviceLost         | device, communication, timer or scheduler error: the servo has ended     |
///
/// start, close and destruction belong to one thread; enableForce, retryCalibration, snapshot and nextEvent
/// to one (the same or another); read and write to the servo.
class HdapiDevice final : public HostedDevice {
 public:
  /// Opens the device, force off. `api`: complete (HdapiLibrary). Throws Error{kDevice}.
  HdapiDevice(const hd::Api& api, const HdapiOptions& options);
  /// Closes the device as close() does.
  ~HdapiDevice() override;

  void start(const DeviceTick& tick) override;
  /// Closes in a thread of its own: the library may take longer.
  void beginClose() override;
  /// beginClose(), then waits, the first time for at most HdapiOptions::patience_us. False when the library
  /// did not let go (unplugged devices block it): the process must end before the device can be opened again.
  bool close() override;
  void switchOff() noexcept override { session_->switchOff(); }
  [[nodiscard]] bool silent() const noexcept override { return session_->silent(); }
  [[nodiscard]] bool released() const override;

  /// Asks for force output. Force is granted while the device is calibrated, quick and cool, and always
  /// ramped.
  void enableForce(bool on) noexcept override { session_->servo().wishForce(on); }
  /// Begins another round of calibration attempts after CalibrationState::kFailed.
  void retryCalibration() noexcept { session_->servo().wishCalibration(); }
  [[nodiscard]] DeviceSnapshot snapshot() noexcept override;
  /// Takes the oldest event not yet taken; false when there is none.
  [[nodiscard]] bool nextEvent(DeviceEvent& event) noexcept override {
    return session_->servo().nextEvent(event);
  }
  [[nodiscard]] Text lossText(std::uint32_t code) const override;
  [[nodiscard]] const DeviceIdentity& identity() const noexcept override { return session_->identity(); }

  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override {
    return session_->capabilities();
  }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override;
  void write(const ForceCommand& command) noexcept override;
  /// Ends a frame that hangs with zero force, and every other until the gate has opened anew.
  void dropForce() noexcept override { session_->servo().dropForce(); }

 private:
  std::shared_ptr<HdapiSession> session_;  // shared with the thread that closes it
  const std::int64_t patience_us_;
  std::future<void> closed_;
  std::shared_ptr<std::atomic<bool>> released_ = std::make_shared<std::atomic<bool>>(false);
  bool waited_ = false;
  bool started_ = false;
  bool driven_ = false;                               // by the vendor's servo thread
  std::int64_t lastTicks_ = 0;                        // snapshot(): of the newest one
  std::chrono::steady_clock::time_point lastTick_{};  // ... and when it was new
  // Mailbox operation, servo thread only.
  ReadingAge age_{kDeviceStale | kDeviceUncalibrated, kReadingStale_us, kReadingLost_us};
  MailedForce force_;
};

}  // namespace torsio
