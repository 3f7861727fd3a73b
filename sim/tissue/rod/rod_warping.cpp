// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod_warping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "sim/core/contracts.h"
#include "sim/core/index.h"
#include "sim/core/portable_math.h"
#include "sim/tissue/rod/rod_sections.h"
#include "sim/tissue/twist/section_fields.h"

namespace torsio {

namespace {

constexpr double kLeastFlatCompliance = 0.02;
// One shape of the section alone reaches too far: measured with 3D finite elements on bars bent between held
// faces, circles and ellipses to 1 : 2.75, within 3 % of this.
constexpr double kMeasuredReach = 0.8;
constexpr double kMeasuredWidth = 0.06;
constexpr double kTiny = 1e-6;

Point2 centroidOf(std::span<const SectionPoint> points) {
  Point2 sum{};
  double area = 0.0;
  for (const SectionPoint& point : points) {
    sum = {sum[0] + point.weight_m2 * point.place_m[0], sum[1] + point.weight_m2 * point.place_m[1]};
    area += point.weight_m2;
  }
  return {sum[0] / area, sum[1] / area};
}

// Torsion of a section without a shear force, and minus the shear that it brings along.
struct LeastShear {
  double torsion_m4 = 0.0;
  std::array<double, 2> shear_m{};
};

// Energy of two shears, a twist and the terms z^2 .. z^6 of u / j0: the terms, then the shears are
// eliminated.
LeastShear leastShear(std::span<const SectionPoint> points, const Point2& centre, double kappa1,
                      double kappa2) {
  constexpr std::size_t kRigid = 3;
  constexpr std::size_t kUnknowns = kRigid + 2 * (kWaves - 1);
  double scale = 0.0;
  for (const SectionPoint& point : points) {
    scale = std::max(scale, std::abs(point.place_m[0]) + std::abs(point.place_m[1]));
  }
  std::array<std::array<double, kUnknowns>, kUnknowns> energy{};
  for (const SectionPoint& point : points) {
    const auto [x, y] = point.place_m;
    const double fibre = restFibre(point.place_m, kappa1, kappa2);
    const Terms terms = termsAt({x / scale, y / scale});
    std::array<std::array<double, 2>, kUnknowns> field{};
    field[0] = {1.0 / fibre, 0.0};
    field[1] = {0.0, 1.0 / fibre};
    field[2] = {(centre[1] - y) / fibre, (x - centre[0]) / fibre};
    for (std::size_t n = 2; n <= kWaves; ++n) {  // grad z^n = n z^(n-1)
      const double re = static_cast<double>(n) * fibre * terms[2 * n - 3];
      const double im = static_cast<double>(n) * fibre * terms[2 * n - 2];
      field[2 * n - 1] = {re, -im};
      field[2 * n] = {im, re};
    }
    for (std::size_t r = 0; r < kUnknowns; ++r) {
      for (std::size_t c = 0; c <= r; ++c) {
        energy[r][c] += point.weight_m2 * fibre * (field[r][0] * field[c][0] + field[r][1] * field[c][1]);
      }
    }
  }
  // The twist stands between shears and terms; it is kept, all others are eliminated from the last on.
  const auto entry = [&energy](std::size_t r, std::size_t c) -> double& {
    return r >= c ? energy[r][c] : energy[c][r];
  };
  for (std::size_t k = kUnknowns; k-- > kRigid;) {
    for (std::size_t r = 0; r < k; ++r) {
      const double share = entry(k, r) / entry(k, k);
      for (std::size_t c = 0; c <= r; ++c) {
        entry(r, c) -= share * entry(k, c);
      }
    }
  }
  const double free = energy[0][0] * energy[1][1] - energy[1][0] * energy[1][0];
  const std::array<double, 2> shear{(energy[1][1] * energy[2][0] - energy[1][0] * energy[2][1]) / free,
                                    (energy[0][0] * energy[2][1] - energy[1][0] * energy[2][0]) / free};
  return {energy[2][2] - shear[0] * energy[2][0] - shear[1] * energy[2][1], shear};
}

}  // namespace

BentTorsion bentTorsion(std::span<const Point2> outline_m, double kappa1_per_m, double kappa2_per_m) {
  const std::vector<SectionPoint> points = pointsOf(outline_m);
  const auto torsion = [&](double kappa1, double kappa2) {
    return leastShear(points, centroidOf(points), kappa1, kappa2);
  };
  const LeastShear bent = torsion(kappa1_per_m, kappa2_per_m);
  return {bent.torsion_m4 / torsion(0.0, 0.0).torsion_m4, bent.shear_m};
}

FlatBending flatBending(std::span<const Point2> outline_m, double poisson, std::span<const double> away_m) {
  const double share =
      4.0 * poisson * poisson / (4.0 * poisson * poisson + 2.0 * (1.0 + poisson) * (1.0 - 2.0 * poisson));
  if (away_m.empty() || !(share > 0.0)) {
    return {};
  }
  const std::vector<SectionPoint> points = pointsOf(outline_m);
  const SectionMoments m = momentsOf(outline_m, 0.0, 0.0);
  const Point2 centre{m.x_m3 / m.area_m2, m.y_m3 / m.area_m2};
  const double xx = m.xx_m4 - centre[0] * m.x_m3;
  const double xy = m.xy_m4 - centre[0] * m.y_m3;
  const double yy = m.yy_m4 - centre[1] * m.y_m3;
  // Principal axes: cosine and sine of the axis u, without trigonometry.
  const double half = 0.5 * (xx - yy);
  const double radius = std::sqrt(half * half + xy * xy);
  const double cosine = radius > 0.0 ? std::sqrt(std::max(0.0, 0.5 * (1.0 + half / radius))) : 1.0;
  const double sine = (xy < 0.0 ? -1.0 : 1.0) * std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  double cross4 = 0.0;   // integral u^2 v^2
  double differ4 = 0.0;  // integral (u^2 - v^2)^2
  for (const SectionPoint& point : points) {
    const double x = point.place_m[0] - centre[0];
    const double y = point.place_m[1] - centre[1];
    const double u = cosine * x + sine * y;
    const double v = cosine * y - sine * x;
    cross4 += point.weight_m2 * u * u * v * v;
    differ4 += point.weight_m2 * (u * u - v * v) * (u * u - v * v);
  }
  const double mean = 2.0 * radius / m.area_m2;  // of u^2 - v^2
  const double within = cross4 + 0.25 * (differ4 - mean * mean * m.area_m2);
  const double centre4 = 0.5 * (xx + yy);
  const auto stiffening = [&](double second_m4) {
    const double own_m4 = std::max(second_m4, kTiny * centre4);
    const double reach_m = kMeasuredReach / (1.0 + kMeasuredWidth * (2.0 * centre4 - own_m4) / own_m4) *
                           std::sqrt(poisson * poisson * within / (2.0 * (1.0 + poisson) * share * own_m4));
    double left = 1.0;
    for (const double away : away_m) {
      left -= share * portableExp(-away / reach_m);
    }
    return 1.0 / std::sqrt(std::max(left, kLeastFlatCompliance));
  };
  const double alongU = stiffening(centre4 - radius);  // bending about u has the second moment of v
  const double alongV = stiffening(centre4 + radius);
  return {cosine * cosine * alongU + sine * sine * alongV, cosine * sine * (alongU - alongV),
          sine * sine * alongU + cosine * cosine * alongV};
}

}  // namespace torsio
