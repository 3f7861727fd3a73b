// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod_contact.h"

#include <cmath>
#include <span>

namespace torsio {
namespace {

double clampedShare(double t) noexcept {
  return t < 0.0 ? 0.0 : (t > 1.0 ? 1.0 : t);
}

/// Distance of two segments p + s u and q + t v (Ericson, Real-Time Collision Detection, 5.1.9).
double segmentDistance_m(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) noexcept {
  const Vec3 r = p - q;
  const double a = dot(u, u);
  const double e = dot(v, v);
  const double b = dot(u, v);
  const double c = dot(u, r);
  const double f = dot(v, r);
  const double across = a * e - b * b;
  double s = across > 1e-12 * a * e ? clampedShare((b * f - c * e) / across) : 0.0;
  const double t = clampedShare((b * s + f) / e);
  s = clampedShare((b * t - c) / a);
  return norm(r + s * u - t * v);
}

}  // namespace

void findNearPairs(const Rod& rod, const RodPose& pose, double way_m, NearPairs& near) noexcept {
  std::array<Vec3, kMaxRodNodes> middles;
  std::array<double, kMaxRodNodes> reaches_m;
  const std::span<const double> radii_m = rod.capsuleRadii_m();
  for (std::size_t i = 0; i + 1 < static_cast<std::size_t>(pose.count); ++i) {
    const Vec3& a = pose.nodes[i].position_m;
    const Vec3& b = pose.nodes[i + 1].position_m;
    middles[i] = 0.5 * (a + b);
    reaches_m[i] = radii_m[i] + 0.5 * norm(b - a) + way_m;
  }
  near.count = 0;
  for (const RodContactPair& pair : rod.contactPairs()) {
    const auto a = static_cast<std::size_t>(pair.first);
    const auto b = static_cast<std::size_t>(pair.second);
    const Vec3 apart = middles[a] - middles[b];
    const double reach_m = reaches_m[a] + reaches_m[b];
    if (dot(apart, apart) <= reach_m * reach_m) {
      near.pairs[static_cast<std::size_t>(near.count++)] = pair;
    }
  }
}

double contactEnergy_J(const Rod& rod, std::span<const RodContactPair> near, const RodPose& pose) noexcept {
  double squares_m2 = 0.0;
  visitContacts(rod, near, pose, [&squares_m2](const RodContact& contact) {
    squares_m2 += contact.depth_m * contact.depth_m;
  });
  return 0.5 * rod.settings().contactStiffness_N_per_m * squares_m2;
}

double deepestOverlap_m(const Rod& rod, const RodPose& pose) noexcept {
  double deepest_m = 0.0;
  for (const RodContactPair& pair : rod.contactPairs()) {
    const auto a = static_cast<std::size_t>(pair.first);
    const auto b = static_cast<std::size_t>(pair.second);
    const Vec3& p = pose.nodes[a].position_m;
    const Vec3& q = pose.nodes[b].position_m;
    const double apart_m =
        segmentDistance_m(p, pose.nodes[a + 1].position_m - p, q, pose.nodes[b + 1].position_m - q);
    const double overlap_m = rod.capsuleRadii_m()[a] + rod.capsuleRadii_m()[b] - apart_m;
    deepest_m = overlap_m > deepest_m ? overlap_m : deepest_m;
  }
  return deepest_m;
}

}  // namespace torsio
