// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "sim/core/angle.h"
#include "sim/core/pose.h"
#include "sim/device/haptic_device.h"
#include "sim/device/hdapi/hdapi_abi.h"

namespace torsio {

inline constexpr double kMillimetre_m = 1e-3;  ///< the vendor counts in millimetres

/// One frame as the vendor's library gives it. Device frame: x to the user's right, y up, z towards the user.
struct HdapiFrame {
  std::array<double, 16> transform_mm{};  ///< column-major; 12 to 14: middle of the gimbal, mm
  std::array<double, 3> joints_rad{};     ///< turret, thigh, shin
  std::array<double, 3> gimbal_rad{};     ///< yaw, pitch, roll, as the model reports them
};

/// How the device stands in the world of the simulation.
struct DevicePlacement {
  /// The default: the user's right is the patient's left (x), up is towards the head (z), towards the user is
  /// towards the patient's front (-y).
  Quat deviceToWorld{0x1.6a09e667f3bcdp-1, 0x1.6a09e667f3bcdp-1, 0.0, 0.0};
  Vec3 worldOrigin_m;        ///< world point at which `deviceCentre_m` lies
  Vec3 deviceCentre_m;       ///< device frame
  double stylusTip_m = 0.0;  ///< from the middle of the gimbal along the stylus
};

/// Distance from the middle of the gimbal to the tip of the stylus (third-party figure; measure your own).
inline constexpr double kStylusTip_m = 0.039;
/// Largest deviation of a column of a rotation matrix from unit length: the library computes in double, so
/// a larger one is not a rotation.
inline constexpr double kRotationTolerance = 1e-3;

/// Returns the pose of the stylus tip: the only place where the vendor's millimetres and device axes become
/// metres of the world. Empty when the transform is not a rigid motion (not finite, not orthonormal).
[[nodiscard]] std::optional<Pose> worldPose(const HdapiFrame& frame,
                                            const DevicePlacement& placement) noexcept;

/// Returns a force of the world as the vendor's library takes it (N, device axes).
[[nodiscard]] std::array<double, 3> deviceForce(const Vec3& world_N,
                                                const DevicePlacement& placement) noexcept;

/// Axis-aligned box of the world that holds a box of the vendor's (minimum, then maximum, mm) and the stylus.
struct WorldBox {
  Vec3 min_m;
  Vec3 max_m;
};
[[nodiscard]] WorldBox worldBox(const std::array<double, 6>& box_mm,
                                const DevicePlacement& placement) noexcept;

/// Convention by which a model reports the three gimbal angles: true angle = scale * reported + offset,
/// wrapped to +-pi, in the Touch's convention (from neutral: right +, up -, clockwise +).
struct GimbalProfile {
  std::string model;
  std::array<double, 3> scale{1.0, 1.0, 1.0};
  std::array<double, 3> offset_rad{};
  bool armKnown = true;  ///< its arm is that of touchTransform_mm
};
/// Returns the gimbal profile of a model. The FireWire Omni reports other offsets and directions than the
/// Touch; the numbers are one published unit's and are replaced by the docked reference. Every model but
/// "PHANTOM Omni" counts as a Touch; the arms of Touch X, Desktop and Premium are longer.
[[nodiscard]] GimbalProfile gimbalProfile(const std::string& model);
[[nodiscard]] std::array<double, 3> trueGimbal_rad(const GimbalProfile& profile,
                                                   const std::array<double, 3>& reported_rad) noexcept;

/// Place of the stylus in the inkwell (recorded on a Touch): middle of the gimbal, device frame, mm.
inline constexpr std::array<double, 3> kInkwell_mm{0.0, -65.5107, -88.1142};
/// Distance from kInkwell_mm within which the stylus counts as docked.
inline constexpr double kInkwellReach_mm = 15.0;
[[nodiscard]] bool isDocked(const HdapiFrame& frame) noexcept;

/// Computes the pose that follows from the joint and gimbal angles of a Touch (angles in rad, result in mm,
/// device frame):
///   x = -sin q1 (L cos q2 + L sin q3)
///   y = L sin q2 - L cos q3 + 23.35
///   z = cos q1 (L cos q2 + L sin q3) - 168.35,  L = 133.35
///   R = Ry(-q1) Rx(-q3) Ry(g1) Rx(-g2) Rz(-g3)
/// q3 is the shin's absolute angle. Derived from one recorded pose; poses with a large yaw are unverified.
[[nodiscard]] std::array<double, 16> touchTransform_mm(const std::array<double, 3>& joints_rad,
                                                       const std::array<double, 3>& gimbal_rad) noexcept;

/// Time between two questions for the state of calibration; the device calibrates itself whenever the
/// stylus sits in the inkwell.
inline constexpr std::int64_t kCalibrationCheck_us = 1'000'000;
/// Number of refused updates in a row after which the flow waits for the user.
inline constexpr int kCalibrationTries = 5;

/// The steps from an unknown to a calibrated device, without any call of the library: the servo frame asks,
/// the flow decides. Servo thread; a plain value.
class CalibrationFlow {
 public:
  /// Tells whether the device should be asked now.
  [[nodiscard]] bool due(std::int64_t now_us) const noexcept {
    return state_ != CalibrationState::kFailed && (!asked_ || now_us - asked_us_ >= kCalibrationCheck_us);
  }
  /// Takes the device's answer; true when hdUpdateCalibration must be called once.
  [[nodiscard]] bool answered(hd::Enum result, std::int64_t now_us) noexcept {
    asked_ = true;
    asked_us_ = now_us;
    if (result == hd::kCalibrationOk) {
      tries_ = 0;
      state_ = CalibrationState::kCalibrated;
    } else if (result == hd::kCalibrationNeedsUpdate) {
      state_ = CalibrationState::kUpdating;
      return true;
    } else {
      state_ = CalibrationState::kDockStylus;
    }
    return false;
  }
  /// Takes the result of the update. Whether the device is calibrated is asked anew after the usual pause.
  void updated(bool refused) noexcept {
    tries_ = refused ? tries_ + 1 : 0;
    if (tries_ >= kCalibrationTries) {
      state_ = CalibrationState::kFailed;
    }
  }
  /// Begins anew because the user asks for another attempt.
  void retry() noexcept { *this = {}; }

  [[nodiscard]] CalibrationState state() const noexcept { return state_; }
  [[nodiscard]] bool calibrated() const noexcept { return state_ == CalibrationState::kCalibrated; }

 private:
  CalibrationState state_ = CalibrationState::kUnknown;
  bool asked_ = false;
  std::int64_t asked_us_ = 0;
  int tries_ = 0;
};

/// Largest turn of the gimbal's third joint to either side of neutral (published for the Omni and Touch).
inline constexpr double kRollRange_rad = radians(150.0);
/// Angle from its stop within which the joint counts as being at the stop: noise of a potentiometer and
/// calibration.
inline constexpr double kRollStopMargin_rad = radians(2.0);

/// Turn of the stylus about its own axis from gimbal angle 3: unwrapped, right-handed about the stylus's z
/// axis (hence minus the clockwise gimbal angle), counted from the docked reference once there is one. Servo
/// thread; a plain value.
class StylusRoll {
 public:
  /// Takes the joint's angle (the Touch's convention, wrapped to +-pi).
  void follow(double gimbalRoll_rad) noexcept {
    const double turn_rad = -gimbalRoll_rad;
    unwrapped_rad_ = started_ ? unwrapNear(turn_rad, unwrapped_rad_) : turn_rad;
    started_ = true;
  }
  /// Returns the turn of the stylus, rad; without a reference it counts from the joint's neutral position.
  [[nodiscard]] double turn_rad() const noexcept { return unwrapped_rad_ - reference_rad_; }
  /// Makes the present angle zero, because the stylus rests in the inkwell.
  void reference() noexcept {
    reference_rad_ = unwrapped_rad_;
    referenced_ = true;
  }

  [[nodiscard]] bool referenced() const noexcept { return referenced_; }
  /// Tells whether the joint is at its mechanical stop: the turn must go on after a new grip.
  [[nodiscard]] bool atStop() const noexcept {
    const double free_rad = kRollRange_rad - kRollStopMargin_rad;
    return unwrapped_rad_ > free_rad || unwrapped_rad_ < -free_rad;
  }

 private:
  double unwrapped_rad_ = 0.0;
  double reference_rad_ = 0.0;
  bool started_ = false;
  bool referenced_ = false;
};

/// Debounce time: a switch bounces within it, a person does not press twice.
inline constexpr std::int64_t kButtonBounce_us = 5'000;

/// Debounces buttons without delaying them: a change counts at once, further changes of the same button are
/// ignored for kButtonBounce_us, then the button's level counts again. Servo thread; a plain value.
class ButtonFilter {
 public:
  /// Returns the mask of pressed buttons at `now_us`; bits beyond the first kButtons are dropped.
  std::uint32_t filter(std::uint32_t raw, std::int64_t now_us) noexcept {
    for (std::size_t i = 0; i < kButtons; ++i) {
      const std::uint32_t bit = 1U << i;
      if (((raw ^ mask_) & bit) == 0 || now_us < quietUntil_us_[i]) {
        continue;
      }
      mask_ ^= bit;
      quietUntil_us_[i] = now_us + kButtonBounce_us;
    }
    return mask_;
  }

  static constexpr std::size_t kButtons = 2;  ///< on the stylus of an Omni or Touch

 private:
  std::uint32_t mask_ = 0;
  std::array<std::int64_t, kButtons> quietUntil_us_{};
};

/// Way that the position's noise and the smallest step of its encoders (0.055 mm) always exceed in a hand.
inline constexpr double kPositionNoise_mm = 0.02;
/// Turn of the gimbal during which a held stylus cannot keep its position within kPositionNoise_mm.
inline constexpr double kGimbalMoves_rad = 0.1;

/// Tells a position that no longer follows the hand from one that rests: the gimbal turns and the position
/// stays. In the inkwell a stylus may be turned on the spot. Servo thread; a plain value.
class PositionLiveness {
 public:
  /// Takes one frame (valid numbers) and tells whether the position is frozen.
  [[nodiscard]] bool frozen(const HdapiFrame& frame, bool docked) noexcept {
    double way_mm = 0.0;
    double turn_rad = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      way_mm = std::max(way_mm, std::abs(frame.transform_mm[12 + i] - anchor_mm_[i]));
      turn_rad = std::max(turn_rad, std::abs(frame.gimbal_rad[i] - anchor_rad_[i]));
    }
    if (!started_ || docked || way_mm > kPositionNoise_mm) {
      started_ = true;
      for (std::size_t i = 0; i < 3; ++i) {
        anchor_mm_[i] = frame.transform_mm[12 + i];
      }
      anchor_rad_ = frame.gimbal_rad;
      frozen_ = false;
    } else if (turn_rad > kGimbalMoves_rad) {
      frozen_ = true;
    }
    return frozen_;
  }

 private:
  std::array<double, 3> anchor_mm_{};
  std::array<double, 3> anchor_rad_{};
  bool started_ = false;
  bool frozen_ = false;
};

}  // namespace torsio
