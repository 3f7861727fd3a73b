// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <type_traits>

#include "sim/core/live_types.h"

namespace torsio {

/// Stiffness of the organ's surface under the tip when the device allows it: the design cap on what a haptic
/// device renders cleanly.
inline constexpr double kSurfaceStiffness_N_per_m = 500.0;
/// The coupling's spring as a multiple of the surface's: a steady push meets 4/5 of the surface's stiffness,
/// 400 N/m, and the surface gives way by 4/5 of the penetration.
inline constexpr double kCouplingRatio = 4.0;
/// Relaxation of the coupling's damper, B = K t: felt at the onset of a contact only.
inline constexpr double kCouplingTime_s = 0.0005;

/// Virtual coupling of one contact (Colgate, Stanley and Brown 1995; Adams and Hannaford 1999), along its
/// normal. The held instrument, d deep in the undisturbed surface, is tied by a spring K and a damper B to an
/// instrument without mass that lies on the surface; the surface gives way by w with the force k w:
///
///   k w = K (d - w) + B (d' - w'),   solved once a tick by the implicit Euler rule.
///
/// The force on the hand is k w, along the normal. The rendered stiffness lies between k K / (k + K) for a
/// steady push and k for an instant one, never above k; every element is passive.
///
/// A plain value: IEEE basic operations only.
class ContactCoupling {
 public:
  /// Makes a coupling to a surface of stiffness k = `surface_N_per_m` > 0; the tick period > 0.
  constexpr ContactCoupling(double surface_N_per_m, std::int64_t tickPeriod_us) noexcept
      : surface_N_per_m_(surface_N_per_m),
        spring_N_per_m_(kCouplingRatio * surface_N_per_m),
        damper_N_per_m_(spring_N_per_m_ * kCouplingTime_s / (static_cast<double>(tickPeriod_us) * 1e-6)) {}

  /// Begins a contact anew at this depth, m: until the part has come out as far, only what lies deeper is
  /// pressed. For a part that is in the tissue already when it begins to touch.
  constexpr void anchor(double depth_m) noexcept {
    anchor_m_ = depth_m > 0.0 ? depth_m : 0.0;
    depth_m_ = 0.0;
    surface_m_ = 0.0;
  }

  /// Steps to the next tick at this depth, m; 0 or less: no contact. Returns by how much the surface gives
  /// way, m.
  constexpr double step(double depth_m) noexcept {
    anchor_m_ = depth_m > 0.0 ? std::min(anchor_m_, depth_m) : 0.0;
    depth_m -= anchor_m_;
    if (!(depth_m > 0.0)) {
      depth_m_ = 0.0;
      surface_m_ = 0.0;
      return 0.0;
    }
    const double pushed_N = spring_N_per_m_ * depth_m + damper_N_per_m_ * (depth_m - depth_m_ + surface_m_);
    surface_m_ = std::max(0.0, pushed_N / (surface_N_per_m_ + spring_N_per_m_ + damper_N_per_m_));
    depth_m_ = depth_m;
    return surface_m_;
  }

  /// Tells whether nothing of the steps before bears on the next one.
  [[nodiscard]] constexpr bool untouched() const noexcept {
    return depth_m_ == 0.0 && surface_m_ == 0.0 && anchor_m_ == 0.0;
  }
  /// Returns the force of the last step, N.
  [[nodiscard]] constexpr double force_N() const noexcept { return surface_N_per_m_ * surface_m_; }
  [[nodiscard]] constexpr double indentation_m() const noexcept { return surface_m_; }
  [[nodiscard]] constexpr double surface_N_per_m() const noexcept { return surface_N_per_m_; }

 private:
  double surface_N_per_m_;
  double spring_N_per_m_;
  double damper_N_per_m_;  // B / T
  double depth_m_ = 0.0;
  double surface_m_ = 0.0;
  double anchor_m_ = 0.0;
};
static_assert(std::is_trivially_copyable_v<ContactCoupling>);

/// Radius of the part of the surface that gives way, as a multiple of the radius of what presses on it.
inline constexpr double kPatchShare = 6.0;

/// How the surface gives way under a part of the instrument of radius a: like a membrane patch that is held
/// on a circle of radius R and pressed by a round part, w(r) = w0 for r <= a, w0 ln(R / r) / ln(R / a) up to
/// R and 0 beyond, against the normal; r: distance from the contact point. A membrane of tension S pushes
/// back by F = 2 pi S w0 / ln(R / a) = k w0, with the k of the contact force (above): the force
/// that is felt and the dent that is seen are one membrane's.

/// Computes the displacement of a point of the deformed surface, m; the zero vector outside the patch. Any
/// thread.
[[nodiscard]] Vec3 indentationAt(const ContactPatch& patch, const Vec3& point_m) noexcept;

/// Presses the dents of `state` into the vertices of the deformed organ, metres. For views, once a frame
/// after the twist was applied; returns false and leaves everything as it is when nothing is touched. Any one
/// thread; allocates nothing.
bool indentSurface(const LiveState& state, std::span<Vec3> vertices_m) noexcept;

}  // namespace torsio
