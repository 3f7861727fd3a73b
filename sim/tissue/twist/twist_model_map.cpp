// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/twist_model_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "sim/base/portable_math.h"

namespace torsio {

namespace {

constexpr int kInverseSteps = 12;
constexpr double kInverseTolerance = 1e-14;  // of the organ's length
constexpr double kLargestStep = 0.1;         // of the organ's length
constexpr int kSearchIntervals = 64;
constexpr double kSmallestRadius_m = 1e-9;

}  // namespace

TwistMap::TwistMap(const TwistModel::Tables& tables, const SectionLattice& lattice,
                   const TwistState& state) noexcept
    : tables_(tables),
      lattice_(lattice),
      count_(tables.operations.size()),
      identity_(state.graspAngle_rad == 0.0) {
  for (std::size_t k = 0; k < count_; ++k) {
    const PreparedOperation& op = tables.operations[k];
    steps_[k] = {&op, op.ratio() * state.graspAngle_rad, op.peakFor(state.graspArc_m)};
  }
  const PreparedOperation& first = tables.operations.front();
  if (tables.linear || tables.poynting) {
    if (first.aboutCentreline() && first.isElastic()) {
      graspArc_m_ = first.elastic().graspAt(steps_[0].peak);
      torquePerBar_Nm_ = steps_[0].angle_rad / first.elastic().compliance(steps_[0].peak);
    }
  }
  blend_m_ = kBlendPerRadius * tables.radius.value(state.graspArc_m);
}

TwistLine TwistMap::centreAt(double arc_m) const noexcept {
  const AxisFrame frame = lattice_.frameAt(arc_m);
  if (!tables_.shiftedCentre) {
    return {frame.centre_m, frame.tangent};
  }
  return {frame.centre_m + tables_.centreX.value(arc_m) * frame.e1 + tables_.centreY.value(arc_m) * frame.e2,
          frame.tangent};
}

TwistLine TwistMap::axisOf(const Step& step, const TwistLine& centreline) noexcept {
  const PreparedOperation& op = *step.operation;
  return op.aboutCentreline() ? centreline : TwistLine{op.origin_m(), op.direction()};
}

Vec3 TwistMap::turned(const Vec3& x, const Vec3& point, const Vec3& axis, double angle_rad) const noexcept {
  const Vec3 u = x - point;
  const Vec3 across = cross(axis, u);
  if (tables_.linear) {
    return x + angle_rad * across;  // Eqs. 21, 22
  }
  const SinCos a = portableSinCos(angle_rad);
  const Vec3 radius = u - dot(axis, u) * axis;
  return x + (a.cos - 1.0) * radius + a.sin * across;
}

Vec3 TwistMap::turnedBack(const Vec3& x, const Vec3& point, const Vec3& axis,
                          double angle_rad) const noexcept {
  if (!tables_.linear) {
    return turned(x, point, axis, -angle_rad);
  }
  const Vec3 u = x - point;
  const Vec3 radius = u - dot(axis, u) * axis;
  const double grown = 1.0 + angle_rad * angle_rad;
  return x + (1.0 / grown - 1.0) * radius - (angle_rad / grown) * cross(axis, u);
}

TwistLine TwistMap::carried(const TwistLine& line, const Step& step, double arc_m) const noexcept {
  const PreparedOperation& op = *step.operation;
  const double along = dot(op.direction(), line.direction);
  const ValueSlope s = op.share(op.alongAxis() ? op.way(line.point_m) : arc_m, step.peak);
  const double angle = step.angle_rad * s.value;
  const double angleRate = step.angle_rad * s.slope * (op.alongAxis() ? along : 1.0);
  const Vec3 foot = turned(line.point_m, op.origin_m(), op.direction(), angle);
  const Vec3 turnedTangent = turned(line.direction, Vec3{}, op.direction(), angle);
  return {foot, normalized(turnedTangent + angleRate * cross(op.direction(), foot - op.origin_m()))};
}

Vec3 TwistMap::elongation(double arc_m) const noexcept {
  const HermiteTable& q = tables_.stretch;
  const double place = std::clamp((std::min(arc_m, graspArc_m_) - q.first()) / q.step(), 0.0,
                                  static_cast<double>(q.nodes() - 1));
  const std::size_t cell = std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(q.nodes() - 2));
  const double t = place - static_cast<double>(cell);
  // (1 + x)^(1/3) - 1 = x/3 - x^2/9 + 5 x^3/81 - 10 x^4/243 with x = T^2 q.
  constexpr std::array<double, 4> kSeries{1.0 / 3.0, -1.0 / 9.0, 5.0 / 81.0, -10.0 / 243.0};
  const double t2 = torquePerBar_Nm_ * torquePerBar_Nm_;
  double power = 1.0;
  Vec3 sum;
  for (std::size_t k = 0; k < kSeries.size(); ++k) {
    power *= t2;
    const Vec3& low = tables_.elongation_m[cell][k];
    const Vec3& high = tables_.elongation_m[cell + 1][k];
    sum += (kSeries[k] * power) * (low + t * (high - low));
  }
  return sum;
}

double TwistMap::contraction(double arc_m) const noexcept {
  if (arc_m > graspArc_m_) {
    return 1.0;
  }
  const double x = torquePerBar_Nm_ * torquePerBar_Nm_ * std::max(0.0, tables_.stretch.value(arc_m));
  return portableExp(-portableLog(1.0 + x) / 6.0);  // lambda^(-1/2)
}

Vec3 TwistMap::stretched(const Vec3& rest_m, const TwistLine& line, double arc_m) const noexcept {
  const Vec3 u = rest_m - line.point_m;
  const Vec3 radius = u - dot(line.direction, u) * line.direction;
  return rest_m + (contraction(arc_m) - 1.0) * radius + elongation(arc_m);
}

Vec3 TwistMap::unstretched(const Vec3& x, const TwistLine& line, double arc_m) const noexcept {
  const Vec3 back = x - elongation(arc_m);
  const Vec3 u = back - line.point_m;
  const Vec3 radius = u - dot(line.direction, u) * line.direction;
  return back + (1.0 / contraction(arc_m) - 1.0) * radius;
}

Vec3 TwistMap::forward(const Vec3& rest_m, double arc_m) const noexcept {
  if (identity_) {
    return rest_m;
  }
  return forward(rest_m, arc_m, tables_.needsArc ? centreAt(arc_m) : TwistLine{});
}

double TwistMap::angleOf(const Step& step, const Vec3& x, double arc_m) const noexcept {
  const PreparedOperation& op = *step.operation;
  return step.angle_rad * op.share(op.alongAxis() ? op.way(x) : arc_m, step.peak).value;
}

Vec3 TwistMap::forward(const Vec3& rest_m, double arc_m, TwistLine line) const noexcept {
  if (identity_) {
    return rest_m;
  }
  Vec3 x = rest_m;
  for (std::size_t k = 0; k < count_; ++k) {
    const Step& step = steps_[k];
    const TwistLine axis = axisOf(step, line);
    x = turned(x, axis.point_m, axis.direction, angleOf(step, x, arc_m));
    if (tables_.carriesCentreline && !step.operation->aboutCentreline()) {
      line = carried(line, step, arc_m);
    }
  }
  return tables_.poynting ? stretched(x, line, arc_m) : x;
}

double TwistMap::radiusGrowth(const Vec3& rest_m, double arc_m) const noexcept {
  const auto radius = [](const Vec3& point, const TwistLine& axis) {
    return norm(cross(axis.direction, point - axis.point_m));
  };
  Vec3 x = rest_m;
  TwistLine line = centreAt(arc_m);
  double growth = 1.0;
  for (std::size_t k = 0; k < count_; ++k) {
    const Step& step = steps_[k];
    const TwistLine axis = axisOf(step, line);
    const double before = radius(x, axis);
    x = turned(x, axis.point_m, axis.direction, angleOf(step, x, arc_m));
    if (before > kSmallestRadius_m) {
      growth *= radius(x, axis) / before;
    }
    if (tables_.carriesCentreline && !step.operation->aboutCentreline()) {
      line = carried(line, step, arc_m);
    }
  }
  return growth;
}

Vec3 TwistMap::unwound(const Vec3& deformed_m, double arc_m) const noexcept {
  std::array<TwistLine, kMostOperations> lines;
  TwistLine line;
  if (tables_.needsArc) {
    line = centreAt(arc_m);
  }
  for (std::size_t k = 0; k < count_; ++k) {
    lines[k] = line;
    if (tables_.carriesCentreline && !steps_[k].operation->aboutCentreline()) {
      line = carried(line, steps_[k], arc_m);
    }
  }
  Vec3 x = tables_.poynting ? unstretched(deformed_m, line, arc_m) : deformed_m;
  for (std::size_t k = count_; k-- > 0;) {
    const Step& step = steps_[k];  // a point keeps its way along an axis that it turns about
    const TwistLine axis = axisOf(step, lines[k]);
    x = turnedBack(x, axis.point_m, axis.direction, angleOf(step, x, arc_m));
  }
  return x;
}

// Zero when the point, turned back as one of this arc length, has this arc length.
double TwistMap::miss(const Vec3& deformed_m, double arc_m) const noexcept {
  return tables_.arcs.arcAt(lattice_, unwound(deformed_m, arc_m)) - arc_m;
}

// First guess where only operations about straight axes, each by its own way, come after the last one about
// the centreline: undo those; turning about the centreline then leaves the nearest centreline point alone.
double TwistMap::firstArc(const Vec3& deformed_m) const noexcept {
  Vec3 x = deformed_m;
  for (std::size_t k = count_; k-- > 0;) {
    const Step& step = steps_[k];
    if (step.operation->aboutCentreline()) {
      break;
    }
    const TwistLine axis = axisOf(step, {});
    x = turnedBack(x, axis.point_m, axis.direction, angleOf(step, x, 0.0));
  }
  return lattice_.nearestArc_m(x);
}

// First guess for all other lists. Turned back as one of section s, the point lies ahead of the plane of s or
// behind it; where that changes, it may have come from there. Of several such places the one counts at which
// it lies nearest to the centreline, in radii: the others are far outside the organ.
double TwistMap::searchedArc(const Vec3& deformed_m) const noexcept {
  const double length = lattice_.length_m();
  double best = 0.0;
  double nearest = std::numeric_limits<double>::infinity();
  const auto offer = [&](double arc, double distance) {
    const double radii = distance / tables_.radius.value(arc);
    if (!(radii < nearest)) {
      return;
    }
    nearest = radii;
    best = arc;
  };
  double aheadBefore = 0.0;
  for (int i = 0; i <= kSearchIntervals; ++i) {
    const double arc = length * i / kSearchIntervals;
    const AxisFrame frame = lattice_.frameAt(arc);
    const Vec3 u = unwound(deformed_m, arc) - frame.centre_m;
    const double ahead = dot(u, frame.tangent);
    const double across = norm(u - ahead * frame.tangent);
    if (i == 0 && ahead <= 0.0) {
      offer(arc, norm(u));
    }
    if (i == kSearchIntervals && ahead >= 0.0) {
      offer(arc, norm(u));
    }
    if (i > 0 && aheadBefore > 0.0 && ahead <= 0.0) {
      offer(arc - length / kSearchIntervals * ahead / (ahead - aheadBefore), across);
    }
    aheadBefore = ahead;
  }
  return best;
}

// Secant steps on `miss`; the best arc length met counts.
Vec3 TwistMap::backward(const Vec3& deformed_m) const noexcept {
  if (identity_) {
    return deformed_m;
  }
  if (!tables_.needsArc) {
    return unwound(deformed_m, 0.0);
  }
  const double length = lattice_.length_m();
  double before = tables_.searchesArc ? searchedArc(deformed_m) : firstArc(deformed_m);
  double missBefore = miss(deformed_m, before);
  double best = before;
  double least = std::abs(missBefore);
  double arc = std::clamp(before + missBefore, 0.0, length);
  for (int i = 0; i < kInverseSteps && least > kInverseTolerance * length; ++i) {
    const double here = miss(deformed_m, arc);
    if (std::abs(here) < least) {
      best = arc;
      least = std::abs(here);
    }
    const double change = here - missBefore;
    double next = change != 0.0 ? arc - here * (arc - before) / change : arc + here;
    if (!(std::abs(next - arc) <= kLargestStep * length)) {
      next = arc + 0.5 * here;
    }
    before = arc;
    missBefore = here;
    arc = std::clamp(next, 0.0, length);
  }
  return unwound(deformed_m, best);
}

double TwistMap::angle(double arc_m) const noexcept {
  double sum = 0.0;
  for (std::size_t k = 0; k < count_; ++k) {
    const PreparedOperation& op = *steps_[k].operation;
    const double coordinate = op.alongAxis() ? op.way(lattice_.frameAt(arc_m).centre_m) : arc_m;
    sum += steps_[k].angle_rad * op.share(coordinate, steps_[k].peak).value;
  }
  return sum;
}

double TwistMap::rate(double arc_m) const noexcept {
  double sum = 0.0;
  for (std::size_t k = 0; k < count_; ++k) {
    const PreparedOperation& op = *steps_[k].operation;
    if (op.aboutCentreline()) {
      sum += steps_[k].angle_rad * op.share(arc_m, steps_[k].peak).slope;
      continue;
    }
    const AxisFrame frame = lattice_.frameAt(arc_m);
    const double along = dot(op.direction(), frame.tangent);
    const double coordinate = op.alongAxis() ? op.way(frame.centre_m) : arc_m;
    const double component = op.alongAxis() ? along * along : along;
    sum += steps_[k].angle_rad * op.share(coordinate, steps_[k].peak).slope * component;
  }
  return sum;
}

double TwistMap::warpingRate(double arc_m) const noexcept {
  double sum = 0.0;
  for (std::size_t k = 0; k < count_; ++k) {
    const PreparedOperation& op = *steps_[k].operation;
    if (!op.aboutCentreline()) {
      continue;
    }
    sum += steps_[k].angle_rad * op.blendedShare(arc_m, steps_[k].peak, blend_m_).slope;
  }
  return sum;
}

Vec3 TwistMap::vertex(const TwistVertex& vertex) const noexcept {
  if (identity_) {
    return vertex.rest_m;
  }
  if (tables_.linear) {
    const TwistLine& line = vertex.line;
    const Vec3 moved = forward(vertex.rest_m, vertex.arc_m, line);
    if (vertex.arc_m > graspArc_m_ || torquePerBar_Nm_ == 0.0) {
      return moved;
    }
    const Vec3 u = vertex.rest_m - line.point_m;
    const double rho2 = dot(u, u) - dot(u, line.direction) * dot(u, line.direction);
    const double h = tables_.spacing_m;
    const double lift = torquePerBar_Nm_ * tables_.lift.value(vertex.arc_m) * h / std::sqrt(rho2 + h * h);
    return moved + lift * line.direction;  // Eq. 23
  }
  if (vertex.warp_m2 == 0.0) {
    return forward(vertex.rest_m, vertex.arc_m, vertex.line);
  }
  const double along = vertex.warp_m2 * warpingRate(vertex.arc_m);
  return forward(vertex.rest_m + along * vertex.line.direction, vertex.arc_m, vertex.line);
}

}  // namespace torsio
