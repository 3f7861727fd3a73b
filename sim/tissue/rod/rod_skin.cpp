// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/rod/rod_skin.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "sim/core/angle.h"
#include "sim/core/contracts.h"
#include "sim/core/index.h"
#include "sim/core/portable_math.h"
#include "sim/tissue/rod/bent_section.h"
#include "sim/tissue/rod/rod_algebra.h"

namespace torsio {

namespace {

constexpr int kSmoothings = 6;          // of (1, 2, 1) / 4: a standard deviation of 1.7 elements
constexpr int kMaxSmoothings = 96;      // of an axis that is bent too sharply at rest
constexpr double kSharpestRest = 0.67;  // of the way to the centre of the bend that a vertex may lie at
constexpr double kLeastSkinStretch = 0.05;
constexpr double kLeastSkinFibre = 0.2;  // of a step towards the section of a point
constexpr int kWarpingRows = 256;        // places along the organ at which psi is known
constexpr double kHeldFade = 0.5;        // of the radius
constexpr int kMaxFootSteps = 40;
constexpr double kFootTolerance = 1e-15;  // of the length

struct CurvePoint {
  Vec3 place_m;
  Vec3 slope;
  Quat turn;
  Vec3 bend_per_m;  // in its axes
  double stretch = 1.0;
};

// Cubic Hermite polynomials and their derivatives on [0, 1].
struct Hermite {
  explicit constexpr Hermite(double w) noexcept
      : from((2.0 * w - 3.0) * w * w + 1.0),
        fromSlope(((w - 2.0) * w + 1.0) * w),
        to(w * w * (3.0 - 2.0 * w)),
        toSlope((w - 1.0) * w * w),
        rise(6.0 * w * (1.0 - w)),
        fromSlopeRate((3.0 * w - 4.0) * w + 1.0),
        toSlopeRate((3.0 * w - 2.0) * w) {}
  double from, fromSlope, to, toSlope;
  double rise;  // of `to`; `from` falls as much
  double fromSlopeRate, toSlopeRate;
};

void smoothNodes(std::array<Pose, kMaxRodNodes>& nodes, int count, int passes) noexcept {
  const auto sum = [](const Pose& a, const Pose& b, const Pose& c) {
    // The three quaternions are taken on the same side: q and -q turn alike.
    const auto side = [&b](const Quat& q) {
      return q.w * b.orientation.w + q.x * b.orientation.x + q.y * b.orientation.y + q.z * b.orientation.z <
                     0.0
                 ? -1.0
                 : 1.0;
    };
    const double sa = side(a.orientation);
    const double sc = side(c.orientation);
    const Quat& qa = a.orientation;
    const Quat& qb = b.orientation;
    const Quat& qc = c.orientation;
    const Quat q{sa * qa.w + 2.0 * qb.w + sc * qc.w, sa * qa.x + 2.0 * qb.x + sc * qc.x,
                 sa * qa.y + 2.0 * qb.y + sc * qc.y, sa * qa.z + 2.0 * qb.z + sc * qc.z};
    return Pose{0.25 * (a.position_m + c.position_m) + 0.5 * b.position_m, normalized(q)};
  };
  for (int pass = 0; pass < passes; ++pass) {
    Pose before = nodes[0];
    for (std::size_t i = 1; i + 1 < at(count); ++i) {
      const Pose here = nodes[i];
      nodes[i] = sum(before, here, nodes[i + 1]);
      before = here;
    }
  }
}

inline Vec3 placeIn_m(const RodCurve& c, std::size_t i, const Hermite& t) noexcept {
  const double h = c.arcs_m[i + 1] - c.arcs_m[i];
  const Vec3& a = c.nodes[i].position_m;
  const Vec3& b = c.nodes[i + 1].position_m;
  return t.from * a + t.to * b + h * (t.fromSlope * c.slopes[i] + t.toSlope * c.slopes[i + 1]);
}

// Point of element i, w in 0..1. The turn from its first node is 4 sigma, interpolated so that its rate at
// both nodes is their bend: 4 d sigma = B(sigma) bend ds. A tick asks for a hundred of them, and a call would
// carry each through memory.
[[gnu::always_inline]] inline CurvePoint pointOf(const RodCurve& c, std::size_t i, double w) noexcept {
  const Hermite t(w);
  const double h = c.arcs_m[i + 1] - c.arcs_m[i];
  const Vec3& a = c.nodes[i].position_m;
  const Vec3& b = c.nodes[i + 1].position_m;
  CurvePoint p;
  p.place_m = placeIn_m(c, i, t);
  p.slope = (t.rise / h) * (b - a) + t.fromSlopeRate * c.slopes[i] + t.toSlopeRate * c.slopes[i + 1];
  const Vec3& last = c.lastRates[i];
  const Vec3 four = t.to * c.turns[i] + h * (t.fromSlope * c.bends_per_m[i] + t.toSlope * last);
  const Vec3 rate = (t.rise / h) * c.turns[i] + t.fromSlopeRate * c.bends_per_m[i] + t.toSlopeRate * last;
  const Vec3 sigma = 0.25 * four;
  const double s2 = dot(sigma, sigma);
  const double scale = 1.0 / (1.0 + s2);
  p.turn = normalized(c.nodes[i].orientation * quatOf((1.0 - s2) * scale, (2.0 * scale) * sigma));
  p.bend_per_m =
      (scale * scale) * ((1.0 - s2) * rate - 2.0 * cross(sigma, rate) + 2.0 * dot(sigma, rate) * sigma);
  p.stretch = std::max(kLeastSkinStretch, dot(rotate(p.turn, {0, 0, 1}), p.slope));
  return p;
}

/// An element, and how far along it.
struct ElementPlace {
  std::size_t element = 0;
  double share = 0.0;
};

ElementPlace elementAt(const RodCurve& c, double arc_m) noexcept {
  std::size_t low = 0;
  std::size_t high = at(c.count - 1);
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (c.arcs_m[middle] <= arc_m ? low : high) = middle;
  }
  const double w = (arc_m - c.arcs_m[low]) / (c.arcs_m[high] - c.arcs_m[low]);
  return {low, std::clamp(w, 0.0, 1.0)};
}

CurvePoint pointAt(const RodCurve& c, double arc_m) noexcept {
  const ElementPlace place = elementAt(c, arc_m);
  return pointOf(c, place.element, place.share);
}

// Bend over stretch of the axis: the inside of a section lies towards this direction.
std::array<double, 2> inwards(const CurvePoint& p) noexcept {
  return {p.bend_per_m.y / p.stretch, -p.bend_per_m.x / p.stretch};
}

// Length of a fibre of the section over the arc at rest: Gamma3 + (kappa x U)3.
double fibre(const CurvePoint& p, const std::array<double, 2>& u) noexcept {
  return p.stretch + p.bend_per_m.x * u[1] - p.bend_per_m.y * u[0];
}

// Arc length of the section in which `point_m` lies, from a guess near it.
double footOf(const RodCurve& c, const Vec3& point_m, double arc_m) noexcept {
  const double length = c.length_m();
  const double stride = length / (c.count - 1);
  double arc = std::clamp(arc_m, 0.0, length);
  for (int step = 0; step < kMaxFootSteps; ++step) {
    const CurvePoint p = pointAt(c, arc);
    const Vec3 local = rotate(conjugate(p.turn), point_m - p.place_m);
    const double way = local.z / std::max(kLeastSkinFibre, fibre(p, {local.x, local.y}));
    const double next = std::clamp(arc + std::clamp(way, -stride, stride), 0.0, length);
    if (std::abs(next - arc) <= kFootTolerance * length) {
      return next;
    }
    arc = next;
  }
  return arc;
}

// Share of the way from the axis to the centre of the bend.
double insideOfBend(const CurvePoint& p, const Vec3& point_m) noexcept {
  const Vec3 local = rotate(conjugate(p.turn), point_m - p.place_m);
  return 1.0 - fibre(p, {local.x, local.y}) / p.stretch;
}

// Place k of the curve that the search for the nearest one begins at.
Vec3 sampleOf_m(const RodCurve& c, std::size_t k) noexcept {
  const std::size_t element = k / RodCurve::kSamples;
  if (element + 1 == at(c.count)) {
    return c.nodes[element].position_m;
  }
  return placeIn_m(c, element, Hermite(static_cast<double>(k % RodCurve::kSamples) / RodCurve::kSamples));
}

double nearestSample(const RodCurve& c, const Vec3& point_m) noexcept {
  const std::size_t count = at((c.count - 1) * RodCurve::kSamples + 1);
  std::size_t nearest = 0;
  const Vec3 first = sampleOf_m(c, 0) - point_m;
  double least = dot(first, first);
  for (std::size_t i = 1; i < count; ++i) {
    const Vec3 aside = sampleOf_m(c, i) - point_m;
    if (dot(aside, aside) < least) {
      least = dot(aside, aside);
      nearest = i;
    }
  }
  const std::size_t i = std::min(nearest / RodCurve::kSamples, at(c.count - 2));
  const double share = static_cast<double>(nearest - i * RodCurve::kSamples) / RodCurve::kSamples;
  return c.arcs_m[i] + share * (c.arcs_m[i + 1] - c.arcs_m[i]);
}

}  // namespace

RodSkin::RodSkin(const OrganRod& organ, const SectionLattice& lattice, const SolvedSections& sections,
                 const TriangleMesh& mesh) {
  TORSIO_EXPECTS(mesh.vertices_m.size() == lattice.vertexCoordinates().size() && organ.rest.count >= 2 &&
                 organ.arcs_m.size() == at(organ.rest.count));
  for (std::size_t i = 0; i < organ.arcs_m.size(); ++i) {
    rest_.arcs_m[i] = organ.arcs_m[i] - organ.arcs_m.front();
  }
  for (smoothings_ = kSmoothings;; smoothings_ *= 2) {
    rest_ = curveOf(organ.rest);
    double sharpest = 0.0;
    vertices_.clear();
    for (std::size_t v = 0; v < mesh.vertices_m.size(); ++v) {
      const double guess = lattice.vertexCoordinates()[v].arc_m - organ.arcs_m.front();
      const double arc = footOf(rest_, mesh.vertices_m[v], guess);
      sharpest = std::max(sharpest, insideOfBend(pointAt(rest_, arc), mesh.vertices_m[v]));
      vertices_.push_back(placeAt(mesh.vertices_m[v], arc));
    }
    if (sharpest <= kSharpestRest || 2 * smoothings_ > kMaxSmoothings) {
      break;
    }
  }
  findRims();
  warpVertices(organ, lattice, sections);
}

void RodSkin::warpVertices(const OrganRod& organ, const SectionLattice& lattice,
                           const SolvedSections& sections) {
  const double step = lattice.length_m() / kWarpingRows;
  std::vector<std::vector<double>> rows;
  for (int i = 0; i <= kWarpingRows; ++i) {
    rows.push_back(sections.warping_m2(std::min(lattice.length_m(), step * i)));
  }
  const auto fade = [](double way_m, double radius_m) {
    const double t = std::clamp(way_m / (kHeldFade * radius_m), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
  };
  for (std::size_t v = 0; v < vertices_.size(); ++v) {
    RodSkinPlace& place = vertices_[v];
    const double along = std::clamp((place.arc_m + organ.arcs_m.front()) / step, 0.0, 1.0 * kWarpingRows);
    const std::size_t low = std::min(static_cast<std::size_t>(along), at(kWarpingRows - 1));
    const double share = along - static_cast<double>(low);
    const double angle = lattice.vertexCoordinates()[v].angle_rad;
    const double psi = (1.0 - share) * atAngle(rows[low], angle) + share * atAngle(rows[low + 1], angle);
    place.warping_m2 = psi * fade(place.arc_m, organ.radii_m.front()) *
                       fade(rest_.length_m() - place.arc_m, organ.radii_m.back());
  }
}

RodCurve RodSkin::curveOf(const RodPose& pose) const noexcept {
  RodCurve c;
  c.count = pose.count;
  c.arcs_m = rest_.arcs_m;
  c.widths.fill(1.0);
  c.nodes = pose.nodes;
  smoothNodes(c.nodes, c.count, smoothings_);
  std::array<Vec3, kMaxRodNodes> stretches{};
  std::array<Vec3, kMaxRodNodes> bends{};
  const std::size_t elements = at(c.count - 1);
  for (std::size_t i = 0; i < elements; ++i) {
    const double h = c.arcs_m[i + 1] - c.arcs_m[i];
    const RodStrain strain = rodStrain(h, c.nodes[i], c.nodes[i + 1]);
    stretches[i] = strain.stretch;
    bends[i] = strain.curvature_per_m;
    c.turns[i] = 4.0 * quarterTangent(conjugate(c.nodes[i].orientation) * c.nodes[i + 1].orientation);
  }
  for (std::size_t i = 0; i <= elements; ++i) {
    const std::size_t before = i > 0 ? i - 1 : 0;
    const std::size_t after = std::min(i, elements - 1);
    c.bends_per_m[i] = 0.5 * (bends[before] + bends[after]);
    c.slopes[i] = rotate(c.nodes[i].orientation, 0.5 * (stretches[before] + stretches[after]));
  }
  for (std::size_t i = 0; i < elements; ++i) {
    c.lastRates[i] = turnRate(0.25 * c.turns[i]) * c.bends_per_m[i + 1];
  }
  return c;
}

RodSkinPlace RodSkin::placeAt(const Vec3& rest_m, double arc_m) const noexcept {
  const ElementPlace along = elementAt(rest_, arc_m);
  const CurvePoint p = pointOf(rest_, along.element, along.share);
  const Vec3 local = rotate(conjugate(p.turn), rest_m - p.place_m);
  const std::array<double, 2> u{local.x, local.y};
  RodSkinPlace place;
  place.arc_m = arc_m;
  place.element = along.element;
  place.share = along.share;
  place.section_m = straightened(u, inwards(p));
  const std::array<double, 2> back = bent(place.section_m, inwards(p));
  place.left_m = {u[0] - back[0], u[1] - back[1]};
  place.beyond_m = local.z;
  place.restStretch = p.stretch;
  place.restTwist_per_m = p.bend_per_m.z;
  place.restFibre = fibre(p, back);  // above 0: no point goes through the centre of a bend
  return place;
}

RodSkinPlace RodSkin::placeOf(const Vec3& rest_m) const noexcept {
  return placeAt(rest_m, footOf(rest_, rest_m, nearestSample(rest_, rest_m)));
}

RodCurvePlace RodSkin::placeOn(const RodCurve& curve, std::size_t element, double share) noexcept {
  const CurvePoint p = pointOf(curve, element, share);
  return {p.place_m, p.turn, inwards(p), p.stretch, p.bend_per_m.z};
}

Vec3 RodSkin::positionOf_m(const RodSkinPlace& place, const RodCurve& curve) const noexcept {
  const CurvePoint p = pointOf(curve, place.element, place.share);
  const double thin = curve.widthAt(place.element, place.share) * std::sqrt(place.restStretch / p.stretch);
  const std::array<double, 2> u = bent({thin * place.section_m[0], thin * place.section_m[1]}, inwards(p));
  const double longer = fibre(p, u) / place.restFibre;
  const double warped = (p.bend_per_m.z - place.restTwist_per_m) / p.stretch * place.warping_m2;
  return p.place_m +
         rotate(p.turn, {u[0] + place.left_m[0], u[1] + place.left_m[1], longer * place.beyond_m + warped});
}

Vec3 RodSkin::toDeformed_m(const Vec3& rest_m, const RodCurve& curve) const noexcept {
  return positionOf_m(placeOf(rest_m), curve);
}

Vec3 RodSkin::toRest_m(const Vec3& deformed_m, const RodCurve& curve) const noexcept {
  const double arc = footOf(curve, deformed_m, nearestSample(curve, deformed_m));
  const CurvePoint now = pointAt(curve, arc);
  const CurvePoint rest = pointAt(rest_, arc);
  const Vec3 local = rotate(conjugate(now.turn), deformed_m - now.place_m);
  const std::array<double, 2> u{local.x, local.y};
  const ElementPlace along = elementAt(curve, arc);
  const double thick = std::sqrt(now.stretch / rest.stretch) / curve.widthAt(along.element, along.share);
  const std::array<double, 2> w = straightened(u, inwards(now));
  const std::array<double, 2> back = bent({thick * w[0], thick * w[1]}, inwards(rest));
  const double shorter = fibre(rest, back) / std::max(kLeastSkinStretch, fibre(now, u));
  return rest.place_m + rotate(rest.turn, {back[0], back[1], shorter * local.z});
}

void RodSkin::findRims() {
  rims_m_.assign(at(rest_.count), {});
  std::array<std::array<double, 2>, kRimPoints> directions{};
  for (std::size_t j = 0; j < kRimPoints; ++j) {
    const SinCos turn = portableSinCos(2.0 * kPi * static_cast<double>(j) / kRimPoints);
    directions[j] = {turn.cos, turn.sin};
  }
  const auto along = [](const std::array<double, 2>& a, const std::array<double, 2>& b) {
    return a[0] * b[0] + a[1] * b[1];
  };
  for (const RodSkinPlace& place : vertices_) {
    const auto first = rest_.arcs_m.begin();
    const auto after = std::upper_bound(first, first + rest_.count, place.arc_m);
    const auto right = std::min<std::ptrdiff_t>(after - first, rest_.count - 1);
    for (const std::ptrdiff_t node : {std::max<std::ptrdiff_t>(right - 1, 0), right}) {
      auto& rim = rims_m_[static_cast<std::size_t>(node)];
      for (std::size_t j = 0; j < kRimPoints; ++j) {
        if (along(place.section_m, directions[j]) > along(rim[j], directions[j])) {
          rim[j] = place.section_m;
        }
      }
    }
  }
}

double RodSkin::sharpestBend(const RodCurve& curve) const noexcept {
  double sharpest = 0.0;
  for (std::size_t i = 0; i < at(curve.count); ++i) {
    const Quat& turn = curve.nodes[i].orientation;
    const double stretch = std::max(kLeastSkinStretch, dot(rotate(turn, {0, 0, 1}), curve.slopes[i]));
    const double rest = dot(rotate(rest_.nodes[i].orientation, {0, 0, 1}), rest_.slopes[i]);
    const double scale = std::sqrt(rest / stretch) / stretch;
    const Vec3& bend = curve.bends_per_m[i];
    for (const std::array<double, 2>& rim : rims_m_[i]) {
      sharpest = std::max(sharpest, scale * (rim[0] * bend.y - rim[1] * bend.x));
    }
  }
  return sharpest;
}

void RodSkin::deform(const RodCurve& curve, std::span<Vec3> out_m) const noexcept {
  for (std::size_t v = 0; v < vertices_.size() && v < out_m.size(); ++v) {
    out_m[v] = vertex_m(v, curve);
  }
}

}  // namespace torsio
