// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/saint_venant.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/portable_math.h"
#include "sim/tissue/twist/held_warping.h"

namespace torsio {

namespace {

// Derivative per step at node i of the cubic through four neighbours (fourth order inside, third at the
// ends); fewer nodes: the differences that exist.
double slopePerStep(const std::vector<double>& y, std::size_t i) {
  const std::size_t n = y.size();
  if (n == 2) {
    return y[1] - y[0];
  }
  if (n == 3) {
    if (i == 1) {
      return 0.5 * (y[2] - y[0]);
    }
    return i == 0 ? -1.5 * y[0] + 2.0 * y[1] - 0.5 * y[2] : 1.5 * y[2] - 2.0 * y[1] + 0.5 * y[0];
  }
  if (i >= 2 && i + 2 < n) {
    return (y[i - 2] - y[i + 2]) / 12.0 + (y[i + 1] - y[i - 1]) * (2.0 / 3.0);
  }
  if (i == 0) {
    return (-11.0 * y[0] + 18.0 * y[1] - 9.0 * y[2] + 2.0 * y[3]) / 6.0;
  }
  if (i == 1) {
    return (-2.0 * y[0] - 3.0 * y[1] + 6.0 * y[2] - y[3]) / 6.0;
  }
  if (i + 1 == n) {
    return (11.0 * y[i] - 18.0 * y[i - 1] + 9.0 * y[i - 2] - 2.0 * y[i - 3]) / 6.0;
  }
  return (2.0 * y[i + 1] + 3.0 * y[i] - 6.0 * y[i - 1] + y[i - 2]) / 6.0;
}

constexpr int kMinIntegrationIntervals = 96;  // along the whole organ
constexpr int kMinFineIntervals = 256;
constexpr int kFineIntervalsPerSection = 4;
constexpr double kSmallestRiseShare = 1e-12;  // of the whole compliance, between two nodes

// Gauss-Legendre, four points on [0, 1].
constexpr std::array<double, 4> kGaussPoints{0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                                             0.93056815579702629};
constexpr std::array<double, 4> kGaussWeights{0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                              0.17392742256872693};

double fourthRoot(double x) {
  return std::sqrt(std::sqrt(x));
}

bool positive(double x) {
  return x > 0.0 && std::isfinite(x);
}

struct Factors {
  std::vector<double> rising;
  std::vector<double> falling;
};

// The two solutions of the discrete (G J phi')' = k phi. Between two nodes the bar is a spring 1 / (C_{i+1} -
// C_i), exact for any G J; the foundation acts at the nodes. Marched in the direction in which they grow.
Factors foundationFactors(const std::vector<double>& compliance, double step, double stiffness,
                          EndCondition ends) {
  const std::size_t n = compliance.size();
  const double least = kSmallestRiseShare * (compliance.back() - compliance.front());
  const auto flexibility = [&](std::size_t i) { return std::max(compliance[i + 1] - compliance[i], least); };
  Factors f{std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
  double flux = 1.0;
  for (std::size_t i = 0; i + 1 < n; ++i) {
    f.rising[i + 1] = f.rising[i] + flux * flexibility(i);
    flux += stiffness * step * f.rising[i + 1];
  }
  const bool held = ends == EndCondition::kBothHeld;
  f.falling[n - 1] = held ? 0.0 : 1.0;
  flux = held ? 1.0 : 0.5 * stiffness * step;
  double lastFlux = flux;
  for (std::size_t i = n - 1; i-- > 0;) {
    f.falling[i] = f.falling[i + 1] + flux * flexibility(i);
    lastFlux = flux;
    flux += stiffness * step * f.falling[i];
  }
  // Wronskian between nodes 0 and 1; there the flux of the rising solution is 1 and its value at node 0 is 0.
  const double wronskian = f.falling[0] + f.rising[0] * lastFlux;
  for (double& b : f.falling) {
    b /= wronskian;
  }
  return f;
}

}  // namespace

HermiteTable::HermiteTable(double first, double step, std::vector<double> values, bool monotone)
    : first_(first), step_(step), inverseStep_(1.0 / step) {
  TORSIO_EXPECTS(values.size() >= 2 && step > 0.0);
  nodes_.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    nodes_.push_back({values[i], slopePerStep(values, i)});
  }
  if (monotone) {
    limitSlopes();
  }
}

void HermiteTable::limitSlopes() {
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const double before = i > 0 ? nodes_[i].value - nodes_[i - 1].value : nodes_[1].value - nodes_[0].value;
    const double after = i + 1 < nodes_.size() ? nodes_[i + 1].value - nodes_[i].value : before;
    if (before * after <= 0.0) {
      nodes_[i].slope = 0.0;
      continue;
    }
    const double limit = 3.0 * std::min(std::abs(before), std::abs(after));
    const double magnitude =
        std::min(nodes_[i].slope * before > 0.0 ? std::abs(nodes_[i].slope) : 0.0, limit);
    nodes_[i].slope = before > 0.0 ? magnitude : -magnitude;
  }
}

ValueSlope HermiteTable::at(double x) const noexcept {
  const double u = (x - first_) * inverseStep_;
  const double top = static_cast<double>(nodes_.size() - 1);
  if (!(u >= 0.0)) {
    return {nodes_.front().value, 0.0};
  }
  if (u > top) {
    return {nodes_.back().value, 0.0};
  }
  const std::size_t cell = std::min(static_cast<std::size_t>(u), nodes_.size() - 2);
  const double t = u - static_cast<double>(cell);
  const ValueSlope& a = nodes_[cell];
  const ValueSlope& b = nodes_[cell + 1];
  // Newton-like form about the left node: exact there, and exact at the right node up to rounding.
  const double rise = b.value - a.value;
  const double c2 = 3.0 * rise - 2.0 * a.slope - b.slope;
  const double c3 = a.slope + b.slope - 2.0 * rise;
  if (t == 1.0) {
    return {b.value, b.slope * inverseStep_};
  }
  return {a.value + t * (a.slope + t * (c2 + t * c3)),
          (a.slope + t * (2.0 * c2 + 3.0 * t * c3)) * inverseStep_};
}

SectionProfile::SectionProfile(std::span<const double> arcs_m, std::span<const TorsionSection> sections,
                               const KrigingOptions& kriging)
    : kriging_(arcs_m, kriging) {
  TORSIO_EXPECTS(arcs_m.size() == sections.size());
  for (std::size_t j = 0; j < sections.size(); ++j) {
    const TorsionSection& s = sections[j];
    if (!positive(s.torsionConstant_m4) || !positive(s.polarMoment_m4) || !positive(s.area_m2)) {
      refuseParameter(Text::verbatim("a section has no area or no torsion constant"),
                      Text::verbatim("arc length %1 m", std::to_string(arcs_m[j])),
                      Text::verbatim("Check the organ's surface there."));
    }
    torsionLength_.push_back(fourthRoot(s.torsionConstant_m4));
    polarLength_.push_back(fourthRoot(s.polarMoment_m4));
    areaLength_.push_back(std::sqrt(s.area_m2));
  }
  smallest_ = 0.5 * *std::min_element(torsionLength_.begin(), torsionLength_.end());
}

TorsionSection SectionProfile::at(double arc_m) const {
  // Kriging may undershoot between very uneven sections; half the thinnest one is a bound no organ needs.
  const auto fourth = [](double x) { return x * x * x * x; };
  const double torsion = std::max(kriging_.estimate(arc_m, torsionLength_), smallest_);
  const double polar = std::max(kriging_.estimate(arc_m, polarLength_), torsion);
  const double area = std::max(kriging_.estimate(arc_m, areaLength_), smallest_);
  return {fourth(torsion), fourth(polar), area * area};
}

double SectionProfile::radius_m(double arc_m) const {
  return std::max(kriging_.estimate(arc_m, areaLength_), smallest_) / std::sqrt(kPi);
}

double taperCompliance(const SectionProfile& profile, double arc_m, double length_m, double step_m) {
  const double half = 0.5 * step_m;
  const double low = std::max(0.0, arc_m - half);
  const double high = std::min(length_m, arc_m + half);
  const double slope = (profile.radius_m(high) - profile.radius_m(low)) / (high - low);
  return 1.0 + (2.0 / 3.0) * slope * slope;
}

std::vector<double> sectionCompliances(const SectionProfile& profile, int places, double length_m,
                                       double shearModulus_Pa, bool taper, const HeldWarping* held) {
  TORSIO_EXPECTS(places >= 2);
  if (!positive(shearModulus_Pa)) {
    refuseParameter(
        Text::verbatim("the shear modulus is %1 Pa, but must be above 0", std::to_string(shearModulus_Pa)),
        Text::verbatim("material"),
        Text::verbatim("Give G in pascal; for nearly incompressible tissue it is E / 3."));
  }
  if (!positive(length_m)) {
    refuseParameter(Text::verbatim("the organ's length is not above 0"), Text::verbatim("lattice"),
                    Text::verbatim("Check the organ's ends."));
  }
  const int perPlace = (kMinIntegrationIntervals + places - 2) / (places - 1);
  const double step = length_m / static_cast<double>((places - 1) * perPlace);
  const auto density = [&](double s) {
    double c = 1.0 / (shearModulus_Pa * profile.at(s).torsionConstant_m4);
    if (taper) {
      c *= taperCompliance(profile, s, length_m, step);
    }
    if (held != nullptr) {
      c *= held->at(s).compliance;
    }
    return c;
  };
  std::vector<double> result{0.0};
  double sum = 0.0;
  for (int i = 0; i < (places - 1) * perPlace; ++i) {
    for (std::size_t p = 0; p < kGaussPoints.size(); ++p) {
      sum += step * kGaussWeights[p] * density((static_cast<double>(i) + kGaussPoints[p]) * step);
    }
    if ((i + 1) % perPlace == 0) {
      result.push_back(sum);
    }
  }
  return result;
}

int fineNodes(int sections) noexcept {
  const int perSection =
      std::max(kFineIntervalsPerSection, (kMinFineIntervals + sections - 2) / (sections - 1));
  return (sections - 1) * perSection + 1;
}

std::vector<double> krigedNodes(std::span<const double> atSections, double length_m,
                                const KrigingOptions& kriging) {
  const int sections = static_cast<int>(atSections.size());
  TORSIO_EXPECTS(sections >= 2);
  std::vector<double> arcs;
  arcs.reserve(atSections.size());
  for (int j = 0; j < sections; ++j) {
    arcs.push_back(length_m * j / (sections - 1));
  }
  const Kriging1d along(arcs, kriging);
  const int intervals = fineNodes(sections) - 1;
  const int perSection = intervals / (sections - 1);
  std::vector<double> nodes;
  for (int i = 0; i <= intervals; ++i) {
    const std::size_t section = static_cast<std::size_t>(i / perSection);
    double value = atSections[section];
    if (i % perSection != 0) {
      value = along.estimate(length_m * i / intervals, atSections);
    }
    nodes.push_back(value);
  }
  return nodes;
}

TorsionTable::TorsionTable(double first, double step, std::vector<double> compliance, EndCondition ends,
                           const Foundation& foundation, bool paperAngles)
    : ends_(ends) {
  TORSIO_EXPECTS(compliance.size() >= 2 && compliance.back() > compliance.front());
  const double span = step * static_cast<double>(compliance.size() - 1);
  lowestGrasp_ = first + kHeldMargin * span;
  highestGrasp_ = first + span * (ends == EndCondition::kBothHeld ? 1.0 - kHeldMargin : 1.0);
  const double whole = compliance.back() - compliance.front();
  const double start = compliance.front();
  for (double& c : compliance) {
    c -= start;
  }
  Factors factors;
  if (foundation.length_m > 0.0) {
    const double stiffness = span / whole / (foundation.length_m * foundation.length_m);
    factors = foundationFactors(compliance, step, stiffness, ends);
    plain_ = false;
  } else {
    factors.rising = compliance;
    for (const double c : compliance) {
      factors.falling.push_back(ends == EndCondition::kBothHeld ? 1.0 - c / whole : 1.0);
    }
    plain_ = !paperAngles;
  }
  rising_ = HermiteTable(first, step, std::move(factors.rising), !paperAngles);
  falling_ = HermiteTable(first, step, std::move(factors.falling), !paperAngles);
}

double TorsionTable::graspAt(double g) const noexcept {
  return std::clamp(g, lowestGrasp_, highestGrasp_);
}

double TorsionTable::compliance(double g) const noexcept {
  const double at = graspAt(g);
  return rising_.value(at) * falling_.value(at);
}

ValueSlope TorsionTable::share(double x, double g) const noexcept {
  const double at = graspAt(g);
  const HermiteTable& side = x <= at ? rising_ : falling_;
  const double reference = side.value(at);
  const ValueSlope here = side.at(x);
  return {here.value / reference, here.slope / reference};
}

double TorsionTable::blendedSlopeOf(const Place& x, const Place& grasp, double width) noexcept {
  const double nearSlope = x.rising.slope / grasp.rising.value;
  const double farSlope = x.falling.slope / grasp.falling.value;
  // In compliance, not in length: the view kernels know no more of a vertex than its compliance.
  const double range = width * grasp.rising.slope;
  const double t = range > 0.0 ? std::clamp(0.5 + (grasp.rising.value - x.rising.value) / range, 0.0, 1.0)
                               : (x.arc_m <= grasp.arc_m ? 1.0 : 0.0);
  const double blend = t * t * (3.0 - 2.0 * t);
  return farSlope + (nearSlope - farSlope) * blend;
}

ValueSlope TorsionTable::blendedShare(double x, double g, double width) const noexcept {
  const Place here = placeAt(x);
  const Place grasp = placeAt(graspAt(g));
  return {shareOf(here, grasp), blendedSlopeOf(here, grasp, width)};
}

}  // namespace torsio
