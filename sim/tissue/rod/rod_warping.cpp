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

namespace torsio {

namespace {

constexpr int kSteps = 160;        // along the rod
constexpr std::size_t kWaves = 6;  // psi = sum of Re and Im of z^n, n = 1 .. kWaves, and a constant
constexpr std::size_t kTerms = 2 * kWaves + 1;
constexpr double kRidge = 1e-12;  // of the mean diagonal: keeps the fit solvable
constexpr double kLeastFlatCompliance = 0.02;
// One shape of the section alone reaches too far: measured with 3D finite elements on bars bent between held
// faces, circles and ellipses to 1 : 2.75, within 3 % of this.
constexpr double kMeasuredReach = 0.8;
constexpr double kMeasuredWidth = 0.06;
constexpr double kTiny = 1e-6;
constexpr double kRound = 0.005;           // 1 - J / Ip below which a section does not warp
constexpr double kChangeSpan_radii = 0.5;  // to either side; what changes faster dies out within the section

using Terms = std::array<double, kTerms>;

Terms termsAt(const Point2& point) {
  Terms terms{1.0};
  double re = 1.0;
  double im = 0.0;
  for (std::size_t n = 0; n < kWaves; ++n) {
    const double next = re * point[0] - im * point[1];
    im = re * point[1] + im * point[0];
    re = next;
    terms[2 * n + 1] = re;
    terms[2 * n + 2] = im;
  }
  return terms;
}

// Solves a x = b for a symmetric positive definite matrix by Cholesky; consumes `a`.
template <std::size_t N>
std::array<double, N> solveSymmetric(std::array<std::array<double, N>, N>& a, std::array<double, N> b) {
  for (std::size_t k = 0; k < N; ++k) {
    for (std::size_t j = 0; j < k; ++j) {
      a[k][k] -= a[k][j] * a[k][j];
    }
    a[k][k] = std::sqrt(a[k][k]);
    for (std::size_t i = k + 1; i < N; ++i) {
      for (std::size_t j = 0; j < k; ++j) {
        a[i][k] -= a[i][j] * a[k][j];
      }
      a[i][k] /= a[k][k];
    }
  }
  for (std::size_t i = 0; i < N; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      b[i] -= a[i][j] * b[j];
    }
    b[i] /= a[i][i];
  }
  for (std::size_t i = N; i-- > 0;) {
    for (std::size_t j = i + 1; j < N; ++j) {
      b[i] -= a[j][i] * b[j];
    }
    b[i] /= a[i][i];
  }
  return b;
}

// Coefficients of psi in coordinates divided by `scale_m`, from its values on the outline.
Terms fitted(const LatticeOutline& outline, std::span<const double> warping_m2, double scale_m) {
  std::array<Terms, kTerms> gram{};
  Terms right{};
  for (std::size_t i = 0; i < outline.points_m.size(); ++i) {
    const Point2& p = outline.points_m[i];
    const Terms terms = termsAt({p[0] / scale_m, p[1] / scale_m});
    const double psi = atAngle(warping_m2, outline.angles_rad[i]);
    for (std::size_t r = 0; r < kTerms; ++r) {
      for (std::size_t c = 0; c < kTerms; ++c) {
        gram[r][c] += terms[r] * terms[c];
      }
      right[r] += terms[r] * psi;
    }
  }
  double trace = 0.0;
  for (std::size_t r = 0; r < kTerms; ++r) {
    trace += gram[r][r];
  }
  for (std::size_t r = 0; r < kTerms; ++r) {
    gram[r][r] += kRidge * trace / kTerms;
  }
  return solveSymmetric(gram, right);
}

// Integrals over a section of a field given by its terms: of the field, and of its square without the part
// that is linear in the section (which stretches and bends the rod instead).
struct FieldMoments {
  double sum = 0.0;
  double square = 0.0;
};

FieldMoments momentsOfField(std::span<const SectionPoint> points, const Terms& field, double scale_m) {
  std::array<std::array<double, 3>, 3> linear{};
  std::array<double, 3> right{};
  FieldMoments moments;
  for (const SectionPoint& point : points) {
    const std::array<double, 3> basis{1.0, point.place_m[0] / scale_m, point.place_m[1] / scale_m};
    const Terms terms = termsAt({basis[1], basis[2]});
    double value = 0.0;
    for (std::size_t k = 0; k < kTerms; ++k) {
      value += field[k] * terms[k];
    }
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        linear[r][c] += point.weight_m2 * basis[r] * basis[c];
      }
      right[r] += point.weight_m2 * basis[r] * value;
    }
    moments.square += point.weight_m2 * value * value;
  }
  moments.sum = right[0];
  const std::array<double, 3> part = solveSymmetric(linear, right);
  for (std::size_t r = 0; r < 3; ++r) {
    moments.square -= part[r] * right[r];
  }
  moments.square = std::max(0.0, moments.square);
  return moments;
}

// Integrals over the section at each place.
struct WarpingSections {
  std::vector<TorsionSection> torsion;
  std::vector<double> area_m2;
  std::vector<double> warping_m6;    // Iw
  std::vector<double> change_m4;     // V
  std::vector<double> changeSum_m3;  // integral d psi / ds
  bool warps = false;
};

WarpingSections sectionsAlong(const SectionLattice& lattice, const SolvedSections& sections, double first_m,
                              double step_m) {
  WarpingSections all;
  std::vector<double> arcs;
  double scale_m = 0.0;
  for (int k = 0; k <= kSteps; ++k) {
    arcs.push_back(std::min(first_m + k * step_m, lattice.length_m()));
    all.torsion.push_back(sections.profile().at(arcs.back()));
    const TorsionSection& here = all.torsion.back();
    all.warps = all.warps || 1.0 - here.torsionConstant_m4 / here.polarMoment_m4 > kRound;
    scale_m = std::max(scale_m, sections.profile().radius_m(arcs.back()));
  }
  if (!all.warps) {
    return all;
  }
  const std::vector<LatticeOutline> outlines = lattice.outlinesAt(arcs);
  std::vector<Terms> psi;
  for (std::size_t k = 0; k < arcs.size(); ++k) {
    psi.push_back(fitted(outlines[k], sections.warping_m2(arcs[k]), scale_m));
  }
  for (int k = 0; k <= kSteps; ++k) {
    const double reach_m = kChangeSpan_radii * sections.profile().radius_m(arcs[at(k)]);
    const int span = std::max(1, static_cast<int>(std::lround(reach_m / step_m)));
    const int low = std::max(0, k - span);
    const int high = std::min(kSteps, k + span);
    Terms change{};
    for (std::size_t t = 0; t < kTerms; ++t) {
      change[t] = (psi[at(high)][t] - psi[at(low)][t]) / ((high - low) * step_m);
    }
    const std::vector<SectionPoint> points = pointsOf(outlines[at(k)].points_m);
    const FieldMoments rate = momentsOfField(points, change, scale_m);
    all.warping_m6.push_back(momentsOfField(points, psi[at(k)], scale_m).square);
    all.change_m4.push_back(rate.square);
    all.changeSum_m3.push_back(rate.sum);
  }
  return all;
}

// Solves e (Iw p')' - (a + e V) p = -b for p, a = (Ip - J) J / Ip and b = (Ip - J) / Ip: the amplitude of psi
// under G times a unit torque. Thomas's algorithm; at an end that is not held p' is 0.
std::vector<double> amplitudes(const WarpingSections& s, double step_m, double youngOverShear,
                               EndCondition ends) {
  const std::size_t last = kSteps;
  std::vector<double> upper(last + 1, 0.0);
  std::vector<double> p(last + 1, 0.0);
  const auto between = [&](std::size_t k) {
    return youngOverShear * 0.5 * (s.warping_m6[k] + s.warping_m6[k + 1]) / (step_m * step_m);
  };
  for (std::size_t k = 0; k <= last; ++k) {
    const double part = k == 0 || k == last ? 0.5 : 1.0;
    const double free = 1.0 - s.torsion[k].torsionConstant_m4 / s.torsion[k].polarMoment_m4;
    const double below = k > 0 ? between(k - 1) : 0.0;
    const double above = k < last ? between(k) : 0.0;
    double diagonal =
        below + above + part * (free * s.torsion[k].torsionConstant_m4 + youngOverShear * s.change_m4[k]);
    double right = part * free;
    if (k == 0 || (k == last && ends == EndCondition::kBothHeld)) {
      continue;  // p = 0
    }
    if (k > 0) {
      diagonal -= below * upper[k - 1];
      right += below * p[k - 1];
    }
    const double pivot = std::max(diagonal, 1e-300);
    upper[k] = above / pivot;
    p[k] = right / pivot;
  }
  for (std::size_t k = last; k-- > 1;) {
    p[k] += upper[k] * p[k + 1];
  }
  return p;
}

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

RodWarping::RodWarping(const SectionLattice& lattice, const SolvedSections& sections, double first_m,
                       double last_m, double youngOverShear, EndCondition ends)
    : first_m_(first_m), step_m_((last_m - first_m) / kSteps) {
  TORSIO_EXPECTS(last_m > first_m && youngOverShear > 0.0);
  const WarpingSections s = sectionsAlong(lattice, sections, first_m, step_m_);
  places_.resize(kSteps + 1);
  if (!s.warps) {
    return;
  }
  const std::vector<double> amplitude = amplitudes(s, step_m_, youngOverShear, ends);
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const double ip = s.torsion[k].polarMoment_m4;
    const double j = s.torsion[k].torsionConstant_m4;
    const double rate = (1.0 + (ip - j) * amplitude[k]) / ip;  // twist rate under G times a unit torque
    places_[k] = {j * rate, amplitude[k] / rate * s.changeSum_m3[k]};
  }
}

RodWarping::Place RodWarping::at(double arc_m) const noexcept {
  const double way = std::clamp((arc_m - first_m_) / step_m_, 0.0, static_cast<double>(kSteps));
  const std::size_t low = std::min(static_cast<std::size_t>(way), places_.size() - 2);
  const double t = way - static_cast<double>(low);
  const Place& a = places_[low];
  const Place& b = places_[low + 1];
  return {a.compliance + t * (b.compliance - a.compliance),
          a.stretchShift_m3 + t * (b.stretchShift_m3 - a.stretchShift_m3)};
}

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
