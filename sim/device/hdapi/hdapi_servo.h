// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <optional>

#include "sim/core/clock.h"
#include "sim/core/latest_value.h"
#include "sim/core/live_types.h"
#include "sim/core/spsc_ring.h"
#include "sim/device/haptic_device.h"
#include "sim/device/hdapi/hdapi_abi.h"
#include "sim/device/hdapi/hdapi_border.h"
#include "sim/device/hdapi/hdapi_library.h"
#include "sim/device/hosted_device.h"
#include "sim/device/safety/force_governor.h"

namespace torsio {

/// What the servo thread knows of the device before it starts.
struct HdapiSetup {
  hd::Handle handle = hd::kInvalidHandle;
  hd::Enum calibrationStyle = hd::kCalibrationInkwell;
  DevicePlacement placement;
  GimbalProfile gimbal;
  double maxForce_N = 3.3;
  bool hasTemperature = true;    ///< the library answers when asked for the temperature
  bool hasInkwellSwitch = true;  ///< the library answers when asked for the inkwell switch
};

/// Age at which a force that was not renewed is no longer sent: with a frame of the device and a millisecond
/// of looking well below the 20 ms within which a hand must be let go.
inline constexpr std::int64_t kForceExpires_us = 15'000;
/// Time after which a device that refuses every frame counts as lost.
inline constexpr std::int64_t kFramesRefused_us = 100'000;
/// Speed that no hand exceeds; a faster step is a jump of the calibration.
inline constexpr double kFastestHand_m_per_s = 10.0;
/// Time for which the pose is not trusted after a jump.
inline constexpr std::int64_t kJumpSettles_us = 100'000;
/// Time within which the jaw follows stylus button 1, closing and opening.
inline constexpr std::int64_t kGripTime_us = 100'000;

/// Everything that happens in the vendor's servo thread: one frame a tick, errors, calibration, the border
/// to SI and the force. Only this object calls the library while the scheduler runs; other threads leave
/// requests in atomics and read mailboxes.
class HdapiServo {
 public:
  HdapiServo(const hd::Api& api, const HdapiSetup& setup, const Clock& clock);

  /// Sets the tick function. Any thread, before the scheduler starts.
  void setTick(const DeviceTick& tick) noexcept { tick_ = tick; }

  // --- vendor's servo thread ---
  /// Runs one frame; returns kCallbackDone when the connection is over. Allocates nothing, locks nothing,
  /// logs nothing.
  hd::CallbackCode frame() noexcept;
  /// Lets go of the hand: a frame with zero force, then force output off. Vendor's servo thread, or any other
  /// one once the servo no longer calls; while a frame of the servo hangs, no other can be opened, and only
  /// the output is switched off. Once; later calls do nothing.
  /// `afterFrame`: in the tick of a frame that is over, so that a second one needs the library's limit
  /// lifted.
  void letGo(bool afterFrame = false) noexcept;
  /// When the vendor's servo called last, by the session's clock; 0: never. Any thread.
  [[nodiscard]] std::int64_t called_us() const noexcept { return called_us_.load(std::memory_order_relaxed); }
  /// Tells whether the vendor's servo is within a frame. Any thread.
  [[nodiscard]] bool inFrame() const noexcept { return inFrame_.load(std::memory_order_acquire); }
  /// Tells whether letGo() was done after revokeTick() or a loss.
  [[nodiscard]] bool silent() const noexcept { return silent_.load(std::memory_order_acquire); }

  // --- inside the tick function ---
  [[nodiscard]] const DeviceSample& current() const noexcept { return snapshot_.sample; }
  void send(const Vec3& force_N) noexcept { command_ = {force_N, command_.number + 1}; }

  // --- one thread outside ---
  [[nodiscard]] MailedReading newestReading() noexcept { return readings_.latest(); }
  void publishForce(const MailedForce& force) noexcept { forces_.publish(force); }

  // --- another thread outside ---
  [[nodiscard]] DeviceSnapshot newestSnapshot() noexcept { return snapshots_.latest(); }
  [[nodiscard]] bool nextEvent(DeviceEvent& event) noexcept { return events_.pop(event); }
  void wishForce(bool on) noexcept { forceWished_.store(on, std::memory_order_relaxed); }
  void wishCalibration() noexcept { calibrationWished_.store(true, std::memory_order_relaxed); }
  /// Ends the frames: zero force from the next one on. After the return the tick function is never called
  /// again. Not from within the tick function.
  void revokeTick() noexcept;
  /// Sends zero force from the frame in progress or, outside of one, from the next on, until the gate has
  /// opened anew. Any thread; calls nothing of the library, which belongs to the servo thread: while a
  /// frame hangs, only the device's own protection is left.
  void dropForce() noexcept { dropAsked_.store(true, std::memory_order_relaxed); }
  [[nodiscard]] bool lost() const noexcept { return lost_.load(std::memory_order_acquire); }

 private:
  void takeWishes() noexcept;
  [[nodiscard]] bool beginFrame(std::int64_t now_us) noexcept;
  void refuseFrame(std::int64_t now_us) noexcept;
  void readDevice(std::int64_t now_us) noexcept;
  void readSwitches(std::int64_t now_us) noexcept;
  void readTemperature() noexcept;
  void checkCalibration(std::int64_t now_us) noexcept;
  void updateCalibration(std::int64_t now_us) noexcept;
  void noteJump(const Pose& pose, std::int64_t now_us) noexcept;
  void followGrip(std::int64_t now_us) noexcept;
  void judge(std::int64_t now_us) noexcept;
  void runTick(std::int64_t now_us) noexcept;
  void sendForce(std::int64_t now_us) noexcept;
  void chooseState(bool slowOrWarm) noexcept;
  [[nodiscard]] Vec3 forceToSend(std::int64_t now_us) noexcept;
  void switchForce(bool on) noexcept;
  void lose(const hd::ErrorInfo& error, std::int64_t now_us) noexcept;
  HdapiErrors drain(std::int64_t now_us) noexcept;
  void publish() noexcept;
  void note(DeviceEvent::Kind kind, std::int64_t now_us, std::uint32_t value = 0,
            const hd::ErrorInfo& error = {}) noexcept;

  const hd::Api& api_;
  const HdapiSetup setup_;
  const Clock& clock_;
  DeviceTick tick_;

  // Servo thread only.
  TickMeter meter_;
  CalibrationFlow calibration_;
  StylusRoll roll_;
  PositionLiveness liveness_;
  ButtonFilter buttons_;
  ForceGate gate_;
  DeviceSnapshot snapshot_;
  MailedForce command_;
  Vec3 rendered_N_;  // by the last frame, over mailboxes
  DeviceReading reading_;
  std::optional<Pose> lastPose_;
  bool started_ = false;
  bool frameOpen_ = false;
  bool endRefused_ = false;    // the motors go on with the frame before
  bool tripped_ = false;       // the device's force protection, this tick
  bool warmStop_ = false;      // HD_WARM_MOTORS, until cold
  bool warm_ = false;          // fold-back with hysteresis
  bool updateNeeded_ = false;  // hdUpdateCalibration after the frame
  std::int64_t begun_us_ = 0;
  std::int64_t taken_us_ = 0;  // last frame that was opened and ended
  std::int64_t interval_us_ = 0;
  std::int64_t lastPose_us_ = 0;
  std::int64_t distrustUntil_us_ = 0;
  std::int64_t grip_us_ = 0;
  std::uint64_t seenForce_ = 0;
  std::int64_t seenForce_us_ = 0;
  std::uint64_t frames_ = 0;

  // Between threads.
  LatestValue<MailedReading> readings_;
  LatestValue<MailedForce> forces_;
  LatestValue<DeviceSnapshot> snapshots_;
  SpscRing<DeviceEvent> events_;
  std::atomic<bool> forceWished_{false};
  std::atomic<bool> calibrationWished_{false};
  std::atomic<bool> dropAsked_{false};
  std::atomic<bool> revoked_{false};
  std::atomic<bool> inFrame_{false};
  std::atomic<bool> inTick_{false};
  std::atomic<bool> lost_{false};
  std::atomic<bool> silent_{false};
  std::atomic<bool> lettingGo_{false};
  std::atomic<std::int64_t> called_us_{0};
  std::atomic<bool> zeroSent_{false};  // the last frame carried zero force and was taken
};

}  // namespace torsio
