// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/servo/surface_proxy.h"

#include <algorithm>
#include <cmath>

#include "sim/servo/contact_coupling.h"
#include "sim/servo/tool_touch.h"

namespace torsio {

namespace {

constexpr std::uint32_t kNobodyLeads = kDeviceLost | kDeviceUncalibrated | kDeviceEnded;
// A part that is no deeper than this still slides along the surface: it arrives anew in every tick.
constexpr double kShallow_m = 0.0025;
// How far ahead of the tip the tissue is looked at, how much deeper it must lie there, and how often.
constexpr double kAhead_m = 0.003;
constexpr double kDeeperAhead_m = 0.5 * kAhead_m;
constexpr double kLookEvery_m = 0.0005;
// By this share of the depth the surface gives way under a steady push.
constexpr double kGivesWay = kCouplingRatio / (1.0 + kCouplingRatio);

std::int32_t inSteps(double position_m) noexcept {
  return static_cast<std::int32_t>(std::lround(position_m / kPositionStep_m));
}

}  // namespace

Vec3 SurfaceProxy::allowed(Vec3 way_m) const noexcept {
  // The second round mends what the plane of the shaft undid of that of the jaw.
  for (int round = 0; round < 2; ++round) {
    for (const std::optional<Arrival>& arrival : arrivals_) {
      if (!arrival) {
        continue;
      }
      const double here_m = dot(tip_m_ - arrival->tip_m, arrival->normal);
      const double there_m = here_m + dot(way_m, arrival->normal);
      const double least_m = std::min(-arrival->most_m, here_m);  // never pushed out by its own plane
      if (there_m < least_m) {
        way_m += arrival->normal * (least_m - there_m);
      }
    }
  }
  return way_m;
}

DeviceSample SurfaceProxy::held(const DeviceSample& reading) noexcept {
  const Vec3 hand_m = toolState(reading).pose.position_m;
  if (!placed_ || (reading.status & kNobodyLeads) != 0) {
    placed_ = (reading.status & kNobodyLeads) == 0;
    tip_m_ = hand_m;
    arrivals_ = {};
    return reading;
  }
  const Vec3 wanted_m = hand_m - tip_m_;
  Vec3 way_m = allowed(wanted_m);
  const double length_m = norm(way_m);
  if (length_m <= kProxyStep_m && way_m == wanted_m) {
    tip_m_ = hand_m;
    return reading;
  }
  if (length_m > kProxyStep_m) {
    way_m = way_m * (kProxyStep_m / length_m);
  }
  DeviceSample held = reading;
  const Vec3 tip_m = tip_m_ + way_m;
  held.position = {inSteps(tip_m.x), inSteps(tip_m.y), inSteps(tip_m.z)};
  tip_m_ = toolState(held).pose.position_m;
  return held;
}

void SurfaceProxy::noteContact(Part part, const ContactPatch& patch, double depth_m) noexcept {
  std::optional<Arrival>& arrival = arrivals_[part];
  if (!(depth_m > 0.0)) {
    arrival.reset();
    return;
  }
  if (!arrival || depth_m <= kShallow_m) {
    arrival = Arrival{.tip_m = tip_m_ + patch.normal * depth_m,
                      .normal = patch.normal,
                      .most_m = part == kJaw ? kDeepestPress_m : kDeepestShaft_m,
                      .deepest_m = kShallow_m};
  }
}

void SurfaceProxy::lookAhead(const Scene& scene, const OrganState& organ) noexcept {
  std::optional<Arrival>& arrival = arrivals_[kJaw];
  if (!arrival) {
    return;
  }
  const double inwards_m = dot(arrival->tip_m - tip_m_, arrival->normal);
  if (inwards_m < arrival->deepest_m + kLookEvery_m || inwards_m >= arrival->most_m) {
    return;
  }
  arrival->deepest_m = inwards_m;
  const double here_m = nearestSurface(tip_m_, scene, organ).distance_m;
  const double ahead_m = nearestSurface(tip_m_ - arrival->normal * kAhead_m, scene, organ).distance_m;
  if (!(here_m - ahead_m >= kDeeperAhead_m)) {
    arrival->most_m = inwards_m;
  }
}

void SurfaceProxy::note(const ExerciseStep& step, TwistDrive drive, const Scene& scene,
                        const OrganState& organ) noexcept {
  if (step.phase == ExercisePhase::kTwisting) {
    // What is led round takes its side along. What turns on the spot stays at its own, while what it holds
    // carries its shaft round in the picture.
    arrivals_[kShaft].reset();
    if (drive == TwistDrive::kTangential) {
      arrivals_[kJaw].reset();
    }
  } else {
    noteContact(kShaft, step.patches[kShaft], step.patches[kShaft].depth_m / kGivesWay);
    noteContact(kJaw, step.patches[kJaw], step.patches[kJaw].depth_m > 0.0 ? step.response.depth_m : 0.0);
  }
  lookAhead(scene, organ);
}

}  // namespace torsio
