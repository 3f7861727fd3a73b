// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "sim/tissue/rod/rod.h"
#include "sim/tissue/rod/rod_algebra.h"

/// Energy, stress and stiffness of one element from its strains. Shared by the sources of sim/tissue/rod.
namespace torsio {

/// Energy of a pose that no step may take: an element squeezed to less than a twentieth of its length.
inline constexpr double kForbiddenEnergy_J = 1e30;
inline constexpr double kLeastStretch = 0.05;

constexpr Vec3 vec(const std::array<double, 3>& a) noexcept {
  return {a[0], a[1], a[2]};
}
/// Returns M v of a matrix of an element.
constexpr Vec3 times(const RowMajor3& m, const Vec3& v) noexcept {
  return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
          m[6] * v.x + m[7] * v.y + m[8] * v.z};
}
constexpr Vec3 transposedTimes(const RowMajor3& m, const Vec3& v) noexcept {
  return {m[0] * v.x + m[3] * v.y + m[6] * v.z, m[1] * v.x + m[4] * v.y + m[7] * v.z,
          m[2] * v.x + m[5] * v.y + m[8] * v.z};
}
constexpr Mat3 matrix(const RowMajor3& m) noexcept {
  return {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]};
}

/// How far an element is bent towards its limit: z = stretch^(-3/2) (bend . lever + root).
struct BendState {
  double z = 0.0;
  double over = 0.0;                    ///< z - limit
  double scale = 1.0;                   ///< stretch^(-3/2)
  double root = 0.0;                    ///< sqrt(bend^T spread bend)
  double spread1 = 0.0, spread2 = 0.0;  ///< spread bend
};

/// `stretch`: l = Gamma3 / Gamma03 > 0.
inline BendState bendState(const RodBendLimit& limit, const Vec3& curvature, double stretch) noexcept {
  const double bend1 = curvature.y;
  const double bend2 = -curvature.x;
  BendState s;
  s.spread1 = limit.spread_m2[0] * bend1 + limit.spread_m2[1] * bend2;
  s.spread2 = limit.spread_m2[1] * bend1 + limit.spread_m2[2] * bend2;
  s.root = std::sqrt(bend1 * s.spread1 + bend2 * s.spread2 + 1e-12);
  s.scale = 1.0 / (stretch * std::sqrt(stretch));
  s.z = s.scale * (bend1 * limit.lever_m[0] + bend2 * limit.lever_m[1] + s.root);
  s.over = s.z - limit.limit;
  return s;
}

/// Returns the quadratic form of the stiffness of an element, with `axial_N` beside the linear axial part:
/// (g^T A g + 2 g^T X k + k^T C k) + axial g3^2.
inline double stiffnessForm(const RodElement& e, double axial_N, const Vec3& g, const Vec3& k) noexcept {
  return dot(g, times(e.stretch_N, g)) + axial_N * g.z * g.z + 2.0 * dot(g, times(e.coupling_Nm, k)) +
         dot(k, times(e.bend_Nm2, k));
}

/// Returns the stored energy of an element; kForbiddenEnergy_J when it is squeezed away.
inline double elementEnergy_J(const RodElement& e, const RodStrain& strain) noexcept {
  const Vec3 g = strain.stretch - vec(e.restStrain);
  const Vec3 k = strain.curvature_per_m - vec(e.restCurvature_per_m);
  double perLength = 0.5 * stiffnessForm(e, 0.0, g, k);
  const double rest3 = e.restStrain[2];
  const double l = strain.stretch.z / rest3;
  if (!(l > kLeastStretch)) {
    return kForbiddenEnergy_J;
  }
  // l^2 / 2 + 1 / l - 3 / 2, in the form that keeps its digits next to rest.
  perLength += e.axial_N * (1.0 / 3.0) * rest3 * rest3 * ((l - 1.0) * (l - 1.0) * (l + 2.0) / (2.0 * l));
  const BendState bend = bendState(e.bendLimit, strain.curvature_per_m, l);
  if (bend.over > 0.0) {
    perLength += 0.5 * e.bendLimit.stiffness_N * bend.over * bend.over;
  }
  return e.length_m * perLength;
}

/// Stress of an element and its derivatives: n = A g + X k + ..., m = X^T g + C k + ...
struct ElementStress {
  Vec3 force_N;
  Vec3 moment_Nm;
  Mat3 stretch_N;    ///< dn / dGamma
  Mat3 coupling_Nm;  ///< dn / dkappa
  Mat3 bend_Nm2;     ///< dm / dkappa
};

/// Adds the bend limit of `e`: derivatives of stiffness/2 (z - limit)^2 by Gamma3 and kappa.
inline void addBendLimit(const RodElement& e, const RodStrain& strain, ElementStress& stress) noexcept {
  const RodBendLimit& limit = e.bendLimit;
  const double perStretch = 1.0 / strain.stretch.z;  // of d ln(stretch)
  const BendState s = bendState(limit, strain.curvature_per_m, strain.stretch.z / e.restStrain[2]);
  if (!(s.over > 0.0)) {
    return;
  }
  const double u = s.spread1 / s.root;
  const double v = s.spread2 / s.root;
  const Vec3 rate = s.scale * Vec3{-(limit.lever_m[1] + v), limit.lever_m[0] + u, 0.0};  // dz / dkappa
  const double thin = -1.5 * perStretch * s.z;                                           // dz / dGamma3
  const double push = limit.stiffness_N * s.over;
  const double curved = push * s.scale / s.root;
  const double bend11 = curved * (limit.spread_m2[0] - u * u);
  const double bend12 = curved * (limit.spread_m2[1] - u * v);
  const double bend22 = curved * (limit.spread_m2[2] - v * v);
  stress.force_N.z += push * thin;
  stress.moment_Nm += push * rate;
  stress.stretch_N.zz += limit.stiffness_N * thin * thin - 2.5 * perStretch * push * thin;
  const double mixed = limit.stiffness_N * thin - 1.5 * perStretch * push;
  stress.coupling_Nm.zx += mixed * rate.x;
  stress.coupling_Nm.zy += mixed * rate.y;
  Mat3& c = stress.bend_Nm2;
  c.xx += limit.stiffness_N * rate.x * rate.x + bend22;
  c.xy += limit.stiffness_N * rate.x * rate.y - bend12;
  c.yx += limit.stiffness_N * rate.x * rate.y - bend12;
  c.yy += limit.stiffness_N * rate.y * rate.y + bend11;
}

/// Returns stress and stiffness of an element. `viscous`: damping time over the tick, 0 without damping;
/// `before`: strains at the start of the step.
inline ElementStress elementStress(const RodElement& e, const RodStrain& strain, double viscous,
                                   const RodStrain& before) noexcept {
  const Vec3 g = strain.stretch - vec(e.restStrain) + viscous * (strain.stretch - before.stretch);
  const Vec3 k = strain.curvature_per_m - vec(e.restCurvature_per_m) +
                 viscous * (strain.curvature_per_m - before.curvature_per_m);
  ElementStress s;
  s.force_N = times(e.stretch_N, g) + times(e.coupling_Nm, k);
  s.moment_Nm = transposedTimes(e.coupling_Nm, g) + times(e.bend_Nm2, k);
  s.stretch_N = (1.0 + viscous) * matrix(e.stretch_N);
  s.coupling_Nm = (1.0 + viscous) * matrix(e.coupling_Nm);
  s.bend_Nm2 = (1.0 + viscous) * matrix(e.bend_Nm2);
  const double rest3 = e.restStrain[2];
  const double l = strain.stretch.z / rest3;
  const double third_N = e.axial_N * (1.0 / 3.0);
  const double inverse2 = 1.0 / (l * l);
  s.force_N.z +=
      third_N * rest3 * (l - inverse2) + viscous * e.axial_N * (strain.stretch.z - before.stretch.z);
  s.stretch_N.zz += third_N * (1.0 + 2.0 * inverse2 / l) + viscous * e.axial_N;
  addBendLimit(e, strain, s);
  return s;
}

}  // namespace torsio
