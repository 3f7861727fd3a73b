// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <type_traits>

#include "sim/core/latest_value.h"
#include "sim/device/haptic_device.h"

namespace torsio {

/// How far a pressed mouse button closes the jaw: a button knows no force, so that it holds with care. Closed
/// fully it would bruise a thin wall in every grip.
inline constexpr double kPointerClosure = 0.6;

/// State of mouse and keyboard as a view knows it. Views send it whenever something changed; the newest
/// counts.
struct PointerInput {
  bool present = false;       ///< false: the pointer is elsewhere, the instrument stays and its jaw opens
  Vec3 onPlane_m;             ///< the pointer on the working plane, world frame
  double depth_m = 0.0;       ///< wheel: way from the working plane into the picture
  Quat view;                  ///< camera to world: x right, y up, z towards the viewer
  double yaw_rad = 0.0;       ///< keys: tilt of the stylus about the camera's y axis
  double pitch_rad = 0.0;     ///< keys: tilt of the stylus about the camera's x axis
  double roll_rad = 0.0;      ///< keys or wheel: turn of the stylus about its own axis, unwrapped
  double grip = 0.0;          ///< mouse button: 0 open .. 1 closed
  std::uint32_t buttons = 0;  ///< DeviceButton bits besides the jaw
};
static_assert(std::is_trivially_copyable_v<PointerInput>);

/// Time constant of the smoothing: a view delivers 60 positions a second, the servo needs 1000.
inline constexpr double kPointerSmoothing_s = 0.015;
/// Largest speed of the instrument, so that a pointer that leaves the view and comes back elsewhere does
/// not throw it through the organ.
inline constexpr double kPointerSpeedLimit_m_per_s = 1.5;

/// Mouse and keyboard as a hand-held device with six degrees of freedom. The stylus points into the picture;
/// mouse, wheel and keys steer it, smoothed in the servo thread.
///
/// | channel     | direction | unit | source                                             |
/// |-------------|-----------|------|----------------------------------------------------|
/// | position x,y| given     | m    | mouse on the working plane                         |
/// | position z  | given     | m    | wheel, along the view direction                    |
/// | yaw, pitch  | given     | rad  | keys                                               |
/// | roll        | given     | rad  | keys or wheel, unwrapped; also in the orientation  |
/// | grip        | given     | 1    | mouse button, smoothed, 0..kPointerClosure         |
/// | buttons     | given     |      | kButtonSecond, kButtonBookmark                     |
/// | status      | given     |      | kDeviceOk; kDeviceInvalid for a non-finite input   |
/// | force       | taken     | N    | not rendered (shown by the views)                  |
class PointerDevice final : public HapticDevice {
 public:
  /// Makes a device that rests at `start` until the first input.
  explicit PointerDevice(const Pose& start);

  /// Hands over the newest input. From one view thread; never waits.
  void publish(const PointerInput& input) noexcept { inputs_.publish(input); }

  [[nodiscard]] const DeviceCapabilities& capabilities() const noexcept override { return capabilities_; }
  [[nodiscard]] DeviceSample read(std::int64_t time_us) noexcept override;
  void write(const ForceCommand&) noexcept override {}

 private:
  /// What is smoothed; orientation as camera and angles, so that nothing has to be interpolated on a sphere.
  struct Steering {
    Vec3 position_m;
    double yaw_rad = 0.0;
    double pitch_rad = 0.0;
    double roll_rad = 0.0;
    double grip = 0.0;
  };
  void follow(const Steering& target, double step_s) noexcept;

  DeviceCapabilities capabilities_;
  LatestValue<PointerInput> inputs_;
  Quat view_;          // camera of the last input
  Steering target_;    // where the last input wants the stylus
  Steering halfway_;   // first of two equal low-pass filters
  Steering steering_;  // second one: where the stylus is
  DeviceSample sample_;
  std::int64_t last_us_ = 0;
  bool started_ = false;
};

}  // namespace torsio
