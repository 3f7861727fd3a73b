// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <span>

#include "sim/tissue/rod/rod.h"

namespace torsio {

/// Most pairs of elements that a rod can have.
inline constexpr int kMaxContactPairs = (kMaxRodNodes - 1) * (kMaxRodNodes - 2) / 2;

/// Pairs of elements that may touch during a step, in the order of Rod::contactPairs().
struct NearPairs {
  int count = 0;
  std::array<RodContactPair, kMaxContactPairs> pairs{};
  [[nodiscard]] std::span<const RodContactPair> all() const noexcept {
    return {pairs.data(), static_cast<std::size_t>(count)};
  }
};

/// Finds all pairs that can touch before a node has moved by more than `way_m` from `pose`. Real time.
void findNearPairs(const Rod& rod, const RodPose& pose, double way_m, NearPairs& near) noexcept;

/// A point of one element inside the capsule of another: nodes 2 and 3 carry the capsule, 0 and 1 the point.
/// A small move u of the nodes lowers the depth by sum of share_k normal . u_k.
struct RodContact {
  std::array<int, 4> nodes{};
  std::array<double, 4> shares{};  ///< of the point, 1 in sum; of the capsule, -1 in sum
  double depth_m = 0.0;            ///< > 0
  Vec3 normal;                     ///< unit, from the capsule's axis to the point
};

/// Tells whether point `share` of the way along element `of` lies in the capsule of `capsule`, of radii
/// `reach_m` in sum, and fills `contact`.
[[nodiscard]] inline bool touches(const RodPose& pose, int of, double share, int capsule, double reach_m,
                                  RodContact& contact) noexcept {
  const auto place = [&pose](int node) { return pose.nodes[static_cast<std::size_t>(node)].position_m; };
  const Vec3 begin = place(capsule);
  const Vec3 along = place(capsule + 1) - begin;
  const Vec3 point = (1.0 - share) * place(of) + share * place(of + 1);
  const double length2 = dot(along, along);
  double t = length2 > 0.0 ? dot(point - begin, along) / length2 : 0.0;
  t = t < 0.0 ? 0.0 : (t > 1.0 ? 1.0 : t);
  const Vec3 apart = point - begin - t * along;
  const double distance2 = dot(apart, apart);
  if (!(distance2 < reach_m * reach_m) || distance2 < 1e-16) {
    return false;
  }
  const double distance = std::sqrt(distance2);
  contact = {.nodes = {of, of + 1, capsule, capsule + 1},
             .shares = {1.0 - share, share, t - 1.0, -t},
             .depth_m = reach_m - distance,
             .normal = (1.0 / distance) * apart};
  return true;
}

/// Tells whether two elements lie so far apart that no point of one can be within `reach_m` of the other: the
/// distance of their middles is at least reach + (la + lb) / 2 once its square is above 5/4 reach^2 + 5/2
/// (la^2 + lb^2), for (r + h)^2 <= 5/4 r^2 + 5 h^2 and (la + lb)^2 <= 2 (la^2 + lb^2); a thousandth covers
/// rounding.
[[nodiscard]] inline bool farApart(const RodPose& pose, int a, int b, double reach_m) noexcept {
  const auto place = [&pose](int node) { return pose.nodes[static_cast<std::size_t>(node)].position_m; };
  const Vec3 alongA = place(a + 1) - place(a);
  const Vec3 alongB = place(b + 1) - place(b);
  const Vec3 apart = place(a) - place(b) + 0.5 * (alongA - alongB);
  return dot(apart, apart) >
         1.001 * (1.25 * reach_m * reach_m + 2.5 * (dot(alongA, alongA) + dot(alongB, alongB)));
}

/// Calls `visit(const RodContact&)` for every contact of the `near` pairs, in fixed order. The points are the
/// nodes and the middles of the elements: the distance of a point from a segment has a continuous derivative,
/// that of two segments has not. Real time.
template <typename Visit>
void visitContacts(const Rod& rod, std::span<const RodContactPair> near, const RodPose& pose,
                   Visit&& visit) noexcept {
  const std::span<const double> radii_m = rod.capsuleRadii_m();
  const int lastElement = pose.count - 2;
  RodContact contact;
  for (const RodContactPair& pair : near) {
    const int a = pair.first;
    const int b = pair.second;
    const double reach_m = radii_m[static_cast<std::size_t>(a)] + radii_m[static_cast<std::size_t>(b)];
    if (farApart(pose, a, b, reach_m)) {
      continue;
    }
    for (int way = 0; way < 2; ++way) {
      const int of = way == 0 ? a : b;
      const int capsule = way == 0 ? b : a;
      const int points = of == lastElement ? 3 : 2;  // the end of an element belongs to the next one
      for (int k = 0; k < points; ++k) {
        if (touches(pose, of, 0.5 * k, capsule, reach_m, contact)) {
          visit(contact);
        }
      }
    }
  }
}

/// Returns stiffness/2 times the sum of the squared depths. Real time.
[[nodiscard]] double contactEnergy_J(const Rod& rod, std::span<const RodContactPair> near,
                                     const RodPose& pose) noexcept;

/// Returns how far the capsules of two elements overlap at most: sum of their radii less the distance of
/// their axes; 0 when none touch.
[[nodiscard]] double deepestOverlap_m(const Rod& rod, const RodPose& pose) noexcept;

/// What a step minimises the energy of: the rod, the jaw that holds it if any, and the start of the step
/// against which its motion is damped. Refers only.
struct RodTask {
  const Rod* rod = nullptr;
  const RodGrip* grip = nullptr;  ///< null: free
  Pose hand{};                    ///< finite; its quaternion is a unit
  std::span<const RodContactPair> near{};
  const RodPose* before = nullptr;  ///< pose at the start of the step; unused without rate
  std::span<const RodStrain> strainsBefore{};
  std::span<const HeldNode> held{};  ///< beside those of the rod
  double rate_per_s = 0.0;           ///< 1 / duration of the step; 0: no damping, the pose at rest is sought
};

/// Returns the energy stored in elements, restraints, contact and jaw. Real time.
[[nodiscard]] double storedEnergy_J(const Rod& rod, const RodPose& pose, const RodGrip* grip,
                                    const Pose& hand) noexcept;

/// Returns stored energy plus what damping and drag take on the way from the start of the step:
///   Pi = E + (eta/2T) h (e - e')^T S (e - e') + (b/2T) |x - x'|^2. Real time.
[[nodiscard]] double stepEnergy_J(const RodTask& task, const RodPose& pose) noexcept;

/// Returns stepEnergy_J() at the start of a step, where nothing has been damped and the strains are known.
/// Real time.
[[nodiscard]] double startEnergy_J(const RodTask& task) noexcept;

}  // namespace torsio
