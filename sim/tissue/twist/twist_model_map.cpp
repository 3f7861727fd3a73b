// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/twist/twist_model_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/core/portable_math.h"

namespace torsio {

namespace {

constexpr double kSmallestRadius_m = 1e-9;

}  // namespace

TwistMap::TwistMap(const TwistModel::Tables& tables, const SectionLattice& lattice,
                   const TwistState& state) noexcept
    : tables_(tables),
      lattice_(lattice),
      angle_rad_(state.graspAngle_rad),
      graspArc_m_(tables.twist.graspAt(state.graspArc_m)),
      grasp_(tables.twist.placeAt(graspArc_m_)),
      blend_m_(kBlendPerRadius * tables.radius.value(state.graspArc_m)),
      identity_(state.graspAngle_rad == 0.0) {
  if (tables.linear || tables.poynting) {
    torquePerBar_Nm_ = angle_rad_ / tables.twist.compliance(graspArc_m_);
  }
}

TwistLine TwistMap::centreAt(double arc_m) const noexcept {
  const AxisFrame frame = lattice_.frameAt(arc_m);
  if (!tables_.shiftedCentre) {
    return {frame.centre_m, frame.tangent};
  }
  return {frame.centre_m + tables_.centreX.value(arc_m) * frame.e1 + tables_.centreY.value(arc_m) * frame.e2,
          frame.tangent};
}

Vec3 TwistMap::turned(const Vec3& x, const TwistLine& axis, double angle_rad) const noexcept {
  const Vec3 u = x - axis.point_m;
  const Vec3 across = cross(axis.direction, u);
  if (tables_.linear) {
    return x + angle_rad * across;  // Eqs. 21, 22
  }
  const SinCos a = portableSinCos(angle_rad);
  const Vec3 radius = u - dot(axis.direction, u) * axis.direction;
  return x + (a.cos - 1.0) * radius + a.sin * across;
}

Vec3 TwistMap::turnedBack(const Vec3& x, const TwistLine& axis, double angle_rad) const noexcept {
  if (!tables_.linear) {
    return turned(x, axis, -angle_rad);
  }
  const Vec3 u = x - axis.point_m;
  const Vec3 radius = u - dot(axis.direction, u) * axis.direction;
  const double grown = 1.0 + angle_rad * angle_rad;
  return x + (1.0 / grown - 1.0) * radius - (angle_rad / grown) * cross(axis.direction, u);
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

double TwistMap::turnAt(double arc_m) const noexcept {
  return angle_rad_ * tables_.twist.share(arc_m, graspArc_m_).value;
}

Vec3 TwistMap::forward(const Vec3& rest_m, double arc_m) const noexcept {
  return identity_ ? rest_m : forward(rest_m, arc_m, centreAt(arc_m));
}

Vec3 TwistMap::forward(const Vec3& rest_m, double arc_m, const TwistLine& line) const noexcept {
  if (identity_) {
    return rest_m;
  }
  const Vec3 x = turned(rest_m, line, turnAt(arc_m));
  return tables_.poynting ? stretched(x, line, arc_m) : x;
}

double TwistMap::radiusGrowth(const Vec3& rest_m, double arc_m) const noexcept {
  const TwistLine axis = centreAt(arc_m);
  const auto radius = [&](const Vec3& point) { return norm(cross(axis.direction, point - axis.point_m)); };
  const double before = radius(rest_m);
  return before > kSmallestRadius_m ? radius(turned(rest_m, axis, turnAt(arc_m))) / before : 1.0;
}

Vec3 TwistMap::unwound(const Vec3& deformed_m, double arc_m) const noexcept {
  const TwistLine line = centreAt(arc_m);
  const Vec3 x = tables_.poynting ? unstretched(deformed_m, line, arc_m) : deformed_m;
  return turnedBack(x, line, turnAt(arc_m));
}

// Zero when the point, turned back as one of this arc length, has this arc length.
double TwistMap::miss(const Vec3& deformed_m, double arc_m) const noexcept {
  return tables_.arcs.arcAt(lattice_, unwound(deformed_m, arc_m)) - arc_m;
}

// From the nearest point of the centreline, which a turn about it leaves alone.
Vec3 TwistMap::backward(const Vec3& deformed_m) const noexcept {
  if (identity_) {
    return deformed_m;
  }
  const ArcFound found = secantSteps([&](double arc_m) { return miss(deformed_m, arc_m); },
                                     lattice_.nearestArc_m(deformed_m), lattice_.length_m());
  return unwound(deformed_m, found.arc_m);
}

// Adding 0 turns a negative zero into 0, so that nothing prints as -0.
double TwistMap::angle(double arc_m) const noexcept {
  return 0.0 + turnAt(arc_m);
}

double TwistMap::rate(double arc_m) const noexcept {
  return 0.0 + angle_rad_ * tables_.twist.share(arc_m, graspArc_m_).slope;
}

double TwistMap::warpingRate(double arc_m) const noexcept {
  return 0.0 + angle_rad_ * tables_.twist.blendedShare(arc_m, graspArc_m_, blend_m_).slope;
}

// forward() with what is known of a vertex.
Vec3 TwistMap::turnedAbout(const Vec3& rest_m, const TwistVertex& vertex) const noexcept {
  const double turn_rad = angle_rad_ * TorsionTable::shareOf(vertex.torsion, grasp_);
  const Vec3 x = turned(rest_m, vertex.line, turn_rad);
  return tables_.poynting ? stretched(x, vertex.line, vertex.arc_m) : x;
}

Vec3 TwistMap::vertex(const TwistVertex& vertex) const noexcept {
  if (identity_) {
    return vertex.rest_m;
  }
  if (tables_.linear) {
    const TwistLine& line = vertex.line;
    const Vec3 moved = turnedAbout(vertex.rest_m, vertex);
    if (vertex.arc_m > graspArc_m_) {
      return moved;
    }
    const Vec3 u = vertex.rest_m - line.point_m;
    const double rho2 = dot(u, u) - dot(u, line.direction) * dot(u, line.direction);
    const double h = tables_.spacing_m;
    const double lift = torquePerBar_Nm_ * tables_.lift.value(vertex.arc_m) * h / std::sqrt(rho2 + h * h);
    return moved + lift * line.direction;  // Eq. 23
  }
  if (vertex.warp_m2 == 0.0) {
    return turnedAbout(vertex.rest_m, vertex);
  }
  const double rate = 0.0 + angle_rad_ * TorsionTable::blendedSlopeOf(vertex.torsion, grasp_, blend_m_);
  const double along = vertex.warp_m2 * rate;
  return turnedAbout(vertex.rest_m + along * vertex.line.direction, vertex);
}

}  // namespace torsio
