// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/held_warping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "sim/core/contracts.h"
#include "sim/core/index.h"
#include "sim/tissue/twist/section_fields.h"

namespace torsio {

namespace {

constexpr int kHeldSteps = 160;            // along the rod
constexpr double kRidge = 1e-12;           // of the mean diagonal: keeps the fit solvable
constexpr double kRound = 0.005;           // 1 - J / Ip below which a section does not warp
constexpr double kChangeSpan_radii = 0.5;  // to either side; what changes faster dies out within the section

constexpr std::array<double, 6> kRayPoints{0.033765242898423986, 0.16939530676686774, 0.38069040695840155,
                                           0.61930959304159845,  0.83060469323313226, 0.96623475710157601};
constexpr std::array<double, 6> kRayWeights{0.085662246189585172, 0.18038078652406930, 0.23395696728634552,
                                            0.23395696728634552,  0.18038078652406930, 0.085662246189585172};
constexpr std::array<double, 3> kEdgePoints{0.11270166537925831, 0.5, 0.88729833462074169};
constexpr std::array<double, 3> kEdgeWeights{0.27777777777777778, 0.44444444444444444, 0.27777777777777778};

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
  for (int k = 0; k <= kHeldSteps; ++k) {
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
  for (int k = 0; k <= kHeldSteps; ++k) {
    const double reach_m = kChangeSpan_radii * sections.profile().radius_m(arcs[at(k)]);
    const int span = std::max(1, static_cast<int>(std::lround(reach_m / step_m)));
    const int low = std::max(0, k - span);
    const int high = std::min(kHeldSteps, k + span);
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
  const std::size_t last = kHeldSteps;
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

}  // namespace

std::vector<SectionPoint> pointsOf(std::span<const Point2> outline_m) {
  std::vector<SectionPoint> points;
  points.reserve(outline_m.size() * kEdgePoints.size() * kRayPoints.size());
  for (std::size_t i = 0; i < outline_m.size(); ++i) {
    const Point2& a = outline_m[i];
    const Point2& b = outline_m[i + 1 < outline_m.size() ? i + 1 : 0];
    const double twice = a[0] * b[1] - a[1] * b[0];
    for (std::size_t e = 0; e < kEdgePoints.size(); ++e) {
      const double px = a[0] + kEdgePoints[e] * (b[0] - a[0]);
      const double py = a[1] + kEdgePoints[e] * (b[1] - a[1]);
      for (std::size_t r = 0; r < kRayPoints.size(); ++r) {
        points.push_back({{kRayPoints[r] * px, kRayPoints[r] * py},
                          twice * kEdgeWeights[e] * kRayWeights[r] * kRayPoints[r]});
      }
    }
  }
  return points;
}

HeldWarping::HeldWarping(const SectionLattice& lattice, const SolvedSections& sections, double first_m,
                         double last_m, double youngOverShear, EndCondition ends)
    : first_m_(first_m), step_m_((last_m - first_m) / kHeldSteps) {
  TORSIO_EXPECTS(last_m > first_m && youngOverShear > 0.0);
  const WarpingSections s = sectionsAlong(lattice, sections, first_m, step_m_);
  places_.resize(kHeldSteps + 1);
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

HeldWarping::Place HeldWarping::at(double arc_m) const noexcept {
  const double way = std::clamp((arc_m - first_m_) / step_m_, 0.0, static_cast<double>(kHeldSteps));
  const std::size_t low = std::min(static_cast<std::size_t>(way), places_.size() - 2);
  const double t = way - static_cast<double>(low);
  const Place& a = places_[low];
  const Place& b = places_[low + 1];
  return {a.compliance + t * (b.compliance - a.compliance),
          a.stretchShift_m3 + t * (b.stretchShift_m3 - a.stretchShift_m3)};
}

}  // namespace torsio
