// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/hdapi/hdapi_border.h"

#include <algorithm>
#include <cmath>

namespace torsio {

namespace {

constexpr double kLink_mm = 133.35;
constexpr double kBaseHeight_mm = 23.35;
constexpr double kBaseDepth_mm = 168.35;
// No arm of a desktop device reaches farther.
constexpr double kFarthest_m = 2.0;

struct Axes {
  Vec3 x;
  Vec3 y;
  Vec3 z;
};

Vec3 column(const std::array<double, 16>& m, std::size_t i) noexcept {
  return {m[4 * i], m[4 * i + 1], m[4 * i + 2]};
}

bool isRotation(const Axes& a) noexcept {
  const auto near = [](double value, double wanted) { return std::abs(value - wanted) < kRotationTolerance; };
  return near(norm(a.x), 1.0) && near(norm(a.y), 1.0) && near(norm(a.z), 1.0) && near(dot(a.x, a.y), 0.0) &&
         near(dot(a.y, a.z), 0.0) && near(dot(cross(a.x, a.y), a.z), 1.0);
}

/// Quaternion of a rotation matrix; the branch keeps the divisor away from zero.
Quat quaternion(const Axes& a) noexcept {
  const double trace = a.x.x + a.y.y + a.z.z;
  if (trace > 0.0) {
    return {1.0 + trace, a.y.z - a.z.y, a.z.x - a.x.z, a.x.y - a.y.x};
  }
  if (a.x.x >= a.y.y && a.x.x >= a.z.z) {
    return {a.y.z - a.z.y, 1.0 + a.x.x - a.y.y - a.z.z, a.y.x + a.x.y, a.z.x + a.x.z};
  }
  if (a.y.y >= a.z.z) {
    return {a.z.x - a.x.z, a.y.x + a.x.y, 1.0 - a.x.x + a.y.y - a.z.z, a.z.y + a.y.z};
  }
  return {a.x.y - a.y.x, a.z.x + a.x.z, a.z.y + a.y.z, 1.0 - a.x.x - a.y.y + a.z.z};
}

}  // namespace

std::optional<Pose> worldPose(const HdapiFrame& frame, const DevicePlacement& placement) noexcept {
  const Axes axes{column(frame.transform_mm, 0), column(frame.transform_mm, 1),
                  column(frame.transform_mm, 2)};
  const Vec3 gimbal_m = column(frame.transform_mm, 3) * kMillimetre_m;
  if (!isFinite(gimbal_m) || !(norm(gimbal_m) < kFarthest_m) || !isRotation(axes)) {
    return std::nullopt;
  }
  Pose pose;
  pose.orientation = placement.deviceToWorld * normalized(quaternion(axes));
  pose.position_m = placement.worldOrigin_m +
                    rotate(placement.deviceToWorld, gimbal_m - placement.deviceCentre_m) +
                    rotate(pose.orientation, {0.0, 0.0, -placement.stylusTip_m});
  return pose;
}

std::array<double, 3> deviceForce(const Vec3& world_N, const DevicePlacement& placement) noexcept {
  const Vec3 device_N = rotate(conjugate(placement.deviceToWorld), world_N);
  return {device_N.x, device_N.y, device_N.z};
}

WorldBox worldBox(const std::array<double, 6>& box_mm, const DevicePlacement& placement) noexcept {
  WorldBox box;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 corner_m = Vec3{box_mm[(corner & 1U) != 0 ? 3 : 0], box_mm[(corner & 2U) != 0 ? 4 : 1],
                               box_mm[(corner & 4U) != 0 ? 5 : 2]} *
                          kMillimetre_m;
    const Vec3 world_m =
        placement.worldOrigin_m + rotate(placement.deviceToWorld, corner_m - placement.deviceCentre_m);
    if (corner == 0) {
      box = {world_m, world_m};
    }
    box.min_m = {std::min(box.min_m.x, world_m.x), std::min(box.min_m.y, world_m.y),
                 std::min(box.min_m.z, world_m.z)};
    box.max_m = {std::max(box.max_m.x, world_m.x), std::max(box.max_m.y, world_m.y),
                 std::max(box.max_m.z, world_m.z)};
  }
  const Vec3 stylus{placement.stylusTip_m, placement.stylusTip_m, placement.stylusTip_m};
  return {box.min_m - stylus, box.max_m + stylus};
}

GimbalProfile gimbalProfile(const std::string& model) {
  const auto names = [&model](const char* word) { return model.find(word) != std::string::npos; };
  if (names("Omni")) {
    return {model, {1.0, -1.0, 1.0}, {3.665, -3.805, 3.089}};
  }
  return {model, {1.0, 1.0, 1.0}, {}, names("Touch") && !names("Touch X")};
}

std::array<double, 3> trueGimbal_rad(const GimbalProfile& profile,
                                     const std::array<double, 3>& reported_rad) noexcept {
  std::array<double, 3> angles{};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    angles[i] = unwrapNear(profile.scale[i] * reported_rad[i] + profile.offset_rad[i], 0.0);
  }
  return angles;
}

bool isDocked(const HdapiFrame& frame) noexcept {
  const Vec3 inkwell_mm{kInkwell_mm[0], kInkwell_mm[1], kInkwell_mm[2]};
  return norm(column(frame.transform_mm, 3) - inkwell_mm) < kInkwellReach_mm;  // false for NaN
}

std::array<double, 16> touchTransform_mm(const std::array<double, 3>& joints_rad,
                                         const std::array<double, 3>& gimbal_rad) noexcept {
  const auto [q1, q2, q3] = joints_rad;
  const SinCos turret = portableSinCos(q1);
  const SinCos thigh = portableSinCos(q2);
  const SinCos shin = portableSinCos(q3);
  const double reach_mm = kLink_mm * thigh.cos + kLink_mm * shin.sin;
  const Quat rotation = axisAngle({0.0, 1.0, 0.0}, -q1) * axisAngle({1.0, 0.0, 0.0}, -q3) *
                        axisAngle({0.0, 1.0, 0.0}, gimbal_rad[0]) *
                        axisAngle({1.0, 0.0, 0.0}, -gimbal_rad[1]) *
                        axisAngle({0.0, 0.0, 1.0}, -gimbal_rad[2]);
  const Vec3 x = rotate(rotation, {1.0, 0.0, 0.0});
  const Vec3 y = rotate(rotation, {0.0, 1.0, 0.0});
  const Vec3 z = rotate(rotation, {0.0, 0.0, 1.0});
  return {x.x,
          x.y,
          x.z,
          0.0,
          y.x,
          y.y,
          y.z,
          0.0,
          z.x,
          z.y,
          z.z,
          0.0,
          -turret.sin * reach_mm,
          kLink_mm * thigh.sin - kLink_mm * shin.cos + kBaseHeight_mm,
          turret.cos * reach_mm - kBaseDepth_mm,
          1.0};
}

}  // namespace torsio
