// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <type_traits>

#include "sim/core/device_sample.h"
#include "sim/core/latest_value.h"
#include "sim/core/spsc_ring.h"
#include "sim/device/device_driver.h"
#include "sim/device/hosted_device.h"

namespace torsio {

/// Where a device that is pushed and turned, not carried, wants its tip to go. Frame of the user: x to the
/// right, y up, z towards the user.
struct SteeringInput {
  Vec3 move{};                ///< each -1 .. 1 of kSteeringSpeed_m_per_s
  double yaw = 0.0;           ///< tilt of the stylus to the left, -1 .. 1 of kSteeringTilt_rad_per_s
  double pitch = 0.0;         ///< tilt upwards, the same
  double roll = 0.0;          ///< turn about the stylus, against the clock for the user, -1 .. 1
  double grip = 0.0;          ///< jaw: 0 open .. 1 closed
  std::uint32_t buttons = 0;  ///< DeviceButton bits besides the jaw
};
static_assert(std::is_trivially_copyable_v<SteeringInput>);

/// Speed of the tip at full deflection.
inline constexpr double kSteeringSpeed_m_per_s = 0.15;
/// Tilt of the stylus at full deflection.
inline constexpr double kSteeringTilt_rad_per_s = 0.8;
/// Turn about the stylus at full deflection: 90 degrees take a second.
inline constexpr double kSteeringRoll_rad_per_s = 1.5707963267948966;
/// Largest tilt; beyond it right and left would change places.
inline constexpr double kSteeringTiltMost_rad = 1.3;
/// Half the edge of the cube that the tip stays in, about the centre of the workspace.
inline constexpr double kSteeringReach_m = 0.25;
/// Longest step that is taken at once: a thread that was held up does not throw the tip.
inline constexpr double kSteeringStepMost_s = 0.02;
/// Time constant of the smoothing of speeds and grip.
inline constexpr double kSteeringSmoothing_s = 0.03;

/// Makes a deflection of one axis fine in the middle: nothing within `dead` of rest, then the square of what
/// is left, with its sign; 1 at the end. A deflection that is not finite counts as none.
[[nodiscard]] double steeringCurve(double deflection, double dead) noexcept;

/// Turns deflections into a pose, step by step. A plain value, one thread.
class RateSteering {
 public:
  /// Begins at `start_m` with the stylus pointing away from the user, in a cube about `centre_m`.
  RateSteering(const Vec3& start_m, const Vec3& centre_m) noexcept;

  /// Goes on by `step_s` seconds. An input that is not finite moves nothing and is marked kDeviceInvalid.
  void step(const SteeringInput& input, double step_s) noexcept;
  /// Returns where the stylus is, stamped.
  [[nodiscard]] DeviceReading reading(std::int64_t time_us) const noexcept;

 private:
  Vec3 centre_m_;
  Vec3 position_m_;
  Vec3 move_;  // smoothed deflections
  double yaw_ = 0.0;
  double pitch_ = 0.0;
  double roll_ = 0.0;
  double grip_ = 0.0;
  double yaw_rad_ = 0.0;
  double pitch_rad_ = 0.0;
  double roll_rad_ = 0.0;
  std::uint32_t buttons_ = 0;
  bool invalid_ = false;
};

/// What a device that is pushed and turned says: the part that differs from one to the next.
class SteeringSource {
 public:
  virtual ~SteeringSource() = default;
  /// Asks for the newest deflections without waiting; empty when the connection broke off. One thread, not
  /// the one that made it.
  [[nodiscard]] virtual std::optional<SteeringInput> poll() = 0;
};

/// Age of a reading after which it is marked stale, and after which the device counts as lost.
inline constexpr std::int64_t kSteeringStale_us = 100'000;
inline constexpr std::int64_t kSteeringLost_us = 2'000'000;

/// A device without force whose deflections are speeds: game controller, six-axis puck. A thread of its own
/// asks the source a thousand times a second, steers (RateSteering) and publishes; the servo reads the
/// newest.
/// Position and orientation are the summed deflections, in a cube about the organ; the grip is a trigger or
/// a button, smoothed. Forces are not rendered: the views show them.
class SteeredDevice final : public HapticDevice {
 public:
  /// `identity.model` names it to people.
  SteeredDevice(std::unique_ptr<SteeringSource> source, DeviceIdentity identity,
                const DeviceRequest& request);
  ~SteeredDevice() override;

  void serve() override;
  bool close() override;
  [[nodiscard]] DeviceSnapshot snapshot() noexcept override;
  [[nodiscard]] bool nextEvent(DeviceEvent& event) noexcept override { return events_.pop(event); }
  [[nodiscard]] const DeviceIdentity& identity() const noexcept override { return identity_; }
  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override;
  void write(const ForceCommand&) noexcept override {}

 private:
  void follow();

  std::unique_ptr<SteeringSource> source_;  // of the thread, once there is one
  const DeviceIdentity identity_;
  DeviceCapabilities capabilities_;
  RateSteering steering_;
  std::thread thread_;
  std::atomic<bool> ending_{false};
  LatestValue<MailedReading> readings_;
  LatestValue<DeviceSnapshot> snapshots_;
  SpscRing<DeviceEvent> events_;
  bool closed_ = false;
  // Servo thread.
  ReadingAge age_{kDeviceStale, kSteeringStale_us, kSteeringLost_us};
};

}  // namespace torsio
