// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "sim/core/pose.h"

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
/// a larger one is no rotation.
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
};
/// Returns the gimbal profile of a model. The FireWire Omni reports other offsets and directions than the
/// Touch; the numbers are one published unit's and are replaced by the docked reference. Every model but
/// "PHANTOM Omni" counts as a Touch.
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

}  // namespace torsio
