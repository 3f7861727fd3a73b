// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/section_outline.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/core/angle.h"
#include "sim/core/error.h"
#include "sim/core/portable_math.h"

namespace torsio {

namespace {

constexpr double kSamePoint = 1e-6;  // of the perimeter: points nearer to each other are one
constexpr double kCollinear = 1e-9;  // of the perimeter: a corner nearer to its chord is ignored

double cross2(const Point2& a, const Point2& b) {
  return a[0] * b[1] - a[1] * b[0];
}
Point2 minus(const Point2& a, const Point2& b) {
  return {a[0] - b[0], a[1] - b[1]};
}
double norm2(const Point2& a) {
  return std::sqrt(a[0] * a[0] + a[1] * a[1]);
}
double wrapped(double angle_rad) {
  const double turns = std::floor(angle_rad / kTurn);
  const double rest = angle_rad - turns * kTurn;
  return rest < 0.0 || rest >= kTurn ? 0.0 : rest;
}

/// The harmonic angle made non-decreasing: where thin triangles fold it back, the largest value so far holds.
/// One value a point and the first plus a turn at the end.
std::vector<double> risingAngle(const LevelLoop& loop) {
  std::vector<double> rising;
  rising.reserve(loop.points.size() + 1);
  double most = loop.points.front().angle_rad;
  for (const LoopPoint& p : loop.points) {
    most = std::max(most, p.angle_rad - kTurn);
  }
  for (const LoopPoint& p : loop.points) {
    most = std::max(most, p.angle_rad);
    rising.push_back(most);
  }
  rising.push_back(std::max(most, rising.front() + kTurn));
  return rising;
}

/// Way along the loop at which the rising angle passes `angle_rad` (any number of turns), 0 .. perimeter.
double wayAtAngle(const LevelLoop& loop, const std::vector<double>& rising, double angle_rad) {
  const double first = rising.front();
  const double target = first + wrapped(angle_rad - first);
  const auto after = std::upper_bound(rising.begin() + 1, rising.end() - 1, target);
  const auto i = static_cast<std::size_t>(after - rising.begin()) - 1;
  const double end = i + 1 < loop.points.size() ? loop.points[i + 1].way_m : loop.perimeter_m;
  const double step = rising[i + 1] - rising[i];
  const double x = step > 0.0 ? std::clamp((target - rising[i]) / step, 0.0, 1.0) : 0.0;
  return loop.points[i].way_m + x * (end - loop.points[i].way_m);
}

/// A loop with the ridge angle of each of its points, starting at the smallest.
class DividedLoop {
 public:
  DividedLoop(const LevelLoop& loop, const AxisFrame& frame, const RidgeRule& rule)
      : loop_(loop), spacing_(rule.spacing) {
    const std::size_t n = loop.points.size();
    flat_.reserve(n);
    for (const LoopPoint& p : loop.points) {
      flat_.push_back(inFrame(frame, p.position_m));
    }
    angle_.reserve(n);
    if (spacing_ == RidgeSpacing::kArcLength) {
      const double start = rule.alongE1 ? exitAlongE1(loop, frame).way_m
                                        : wayAtAngle(loop, risingAngle(loop), rule.anchor_rad);
      for (const LoopPoint& p : loop.points) {
        angle_.push_back(wrapped(kTurn * ((p.way_m - start) / loop.perimeter_m)));
      }
    } else {
      for (const Point2& p : flat_) {
        angle_.push_back(wrapped(portableAtan2(p[1], p[0])));
      }
    }
    sortFromSmallest();
  }

  [[nodiscard]] std::size_t size() const { return angle_.size(); }
  /// Index into the loop of the i-th point by ridge angle.
  [[nodiscard]] std::size_t at(std::size_t i) const { return (first_ + i) % size(); }
  [[nodiscard]] double angle(std::size_t i) const { return angle_[at(i)]; }
  [[nodiscard]] const Point2& flat(std::size_t i) const { return flat_[at(i)]; }

  /// Share x of the way from point i to the next at which the ridge angle is `target`.
  [[nodiscard]] std::pair<std::size_t, double> find(double target) const {
    // Points before the smallest angle belong to the segment that ends the turn.
    std::size_t low = 0;
    std::size_t high = size();
    while (low < high) {
      const std::size_t middle = (low + high) / 2;
      if (angle(middle) <= target) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    const std::size_t i = low == 0 ? size() - 1 : low - 1;
    return {i, share(i, target)};
  }

  [[nodiscard]] Vec3 position(std::size_t i, double x) const {
    const Vec3& a = loop_.points[at(i)].position_m;
    return a + x * (loop_.points[at(i + 1)].position_m - a);
  }
  /// The same, but a point that is almost a corner of the loop is that corner.
  [[nodiscard]] Vec3 cornerOrPosition(std::size_t i, double x) const {
    const double length = norm(position(i, 1.0) - position(i, 0.0));
    const double near = kSamePoint * loop_.perimeter_m;
    if (x * length < near) {
      return position(i, 0.0);
    }
    return (1.0 - x) * length < near ? position(i, 1.0) : position(i, x);
  }

 private:
  [[nodiscard]] double share(std::size_t i, double target) const {
    if (spacing_ == RidgeSpacing::kAngle) {
      const SinCos ray = portableSinCos(target);
      const Point2 direction{ray.cos, ray.sin};
      const double across = cross2(direction, minus(flat(i + 1), flat(i)));
      return across != 0.0 ? std::clamp(-cross2(direction, flat(i)) / across, 0.0, 1.0) : 0.0;
    }
    const double step = wrapped(angle(i + 1) - angle(i));
    return step > 0.0 ? std::clamp(wrapped(target - angle(i)) / step, 0.0, 1.0) : 0.0;
  }

  /// Points at the same place may have angles that fall by a rounding error: from the smallest they only
  /// rise.
  void sortFromSmallest() {
    constexpr double kRounding_rad = 1e-9;
    const std::size_t n = angle_.size();
    first_ = static_cast<std::size_t>(std::min_element(angle_.begin(), angle_.end()) - angle_.begin());
    const double least = angle_[first_];
    for (std::size_t k = 1; k < n && angle_[(first_ + n - 1) % n] < least + kRounding_rad; ++k) {
      first_ = (first_ + n - 1) % n;
    }
    for (std::size_t i = 1; i < n; ++i) {
      angle_[at(i)] = std::max(angle_[at(i)], angle_[at(i - 1)]);
    }
  }

  const LevelLoop& loop_;
  RidgeSpacing spacing_;
  std::vector<Point2> flat_;
  std::vector<double> angle_;
  std::size_t first_ = 0;
};

struct OutlinePoint {
  Point2 place_m{};
  double angle_rad = 0.0;
  bool sample = false;  // an equal step of the ridge angle, else a corner of the mesh's section
};

/// Samples and corners in the order of their ridge angle.
std::vector<OutlinePoint> merge(const DividedLoop& loop, const std::vector<OutlinePoint>& samples) {
  std::vector<OutlinePoint> merged;
  merged.reserve(loop.size() + samples.size());
  std::size_t corner = 0;
  for (const OutlinePoint& sample : samples) {
    for (; corner < loop.size() && loop.angle(corner) < sample.angle_rad; ++corner) {
      merged.push_back({loop.flat(corner), loop.angle(corner), false});
    }
    merged.push_back(sample);
  }
  for (; corner < loop.size(); ++corner) {
    merged.push_back({loop.flat(corner), loop.angle(corner), false});
  }
  return merged;
}

/// Without corners that repeat a neighbour or lie on the chord of theirs.
void simplify(std::vector<OutlinePoint>& points, double perimeter_m) {
  std::vector<OutlinePoint> kept;
  kept.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const OutlinePoint& here = points[i];
    const OutlinePoint& next = points[(i + 1) % points.size()];
    if (!here.sample && !kept.empty()) {
      const OutlinePoint& last = kept.back();
      const Point2 chord = minus(next.place_m, last.place_m);
      const Point2 way = minus(here.place_m, last.place_m);
      const bool repeated = norm2(way) < kSamePoint * perimeter_m ||
                            norm2(minus(next.place_m, here.place_m)) < kSamePoint * perimeter_m ||
                            here.angle_rad <= last.angle_rad;
      const bool onChord = std::abs(cross2(chord, way)) <= kCollinear * perimeter_m * norm2(chord);
      if (repeated || onChord) {
        continue;
      }
    }
    kept.push_back(here);
  }
  points = std::move(kept);
}

double area(const std::vector<Point2>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    twice += cross2(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return 0.5 * twice;
}

bool segmentsCross(const Point2& a, const Point2& b, const Point2& c, const Point2& d) {
  const double ac = cross2(minus(b, a), minus(c, a));
  const double ad = cross2(minus(b, a), minus(d, a));
  const double ca = cross2(minus(d, c), minus(a, c));
  const double cb = cross2(minus(d, c), minus(b, c));
  return ((ac > 0.0) != (ad > 0.0)) && ((ca > 0.0) != (cb > 0.0)) && ac != 0.0 && ad != 0.0 && ca != 0.0 &&
         cb != 0.0;
}

/// Sweep over the sides sorted by their left end.
bool crossesItself(const std::vector<Point2>& polygon) {
  const std::size_t n = polygon.size();
  const auto left = [&](std::size_t i) { return std::min(polygon[i][0], polygon[(i + 1) % n][0]); };
  const auto right = [&](std::size_t i) { return std::max(polygon[i][0], polygon[(i + 1) % n][0]); };
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return left(a) < left(b); });
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t i = order[k];
    for (std::size_t m = k + 1; m < n && left(order[m]) <= right(i); ++m) {
      const std::size_t j = order[m];
      if (j == (i + 1) % n || i == (j + 1) % n) {
        continue;
      }
      if (segmentsCross(polygon[i], polygon[(i + 1) % n], polygon[j], polygon[(j + 1) % n])) {
        return true;
      }
    }
  }
  return false;
}

bool angleRises(const std::vector<Point2>& polygon) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (cross2(polygon[i], polygon[(i + 1) % polygon.size()]) <= 0.0) {
      return false;
    }
  }
  return true;
}

}  // namespace

Point2 inFrame(const AxisFrame& frame, const Vec3& point_m) noexcept {
  const Vec3 d = point_m - frame.centre_m;
  return {dot(d, frame.e1), dot(d, frame.e2)};
}

bool isStarShaped(const LevelLoop& loop, const AxisFrame& frame) {
  double turned = 0.0;
  Point2 last = inFrame(frame, loop.points.back().position_m);
  for (const LoopPoint& p : loop.points) {
    const Point2 here = inFrame(frame, p.position_m);
    const double sine = cross2(last, here);
    // A point that repeats the last one does not turn back.
    if (sine < -kSamePoint * norm2(last) * norm2(here)) {
      return false;
    }
    turned += portableAtan2(sine, last[0] * here[0] + last[1] * here[1]);
    last = here;
  }
  return std::abs(turned - kTurn) < 0.1;
}

SectionOutline cutOutline(const LevelLoop& loop, const AxisFrame& frame, const RidgeRule& rule, int ridges,
                          const std::string& name) {
  const DividedLoop divided(loop, frame, rule);
  const int stepsPerRidge = (kMinOutlinePoints + ridges - 1) / ridges;
  const int count = ridges * stepsPerRidge;
  SectionOutline outline;
  outline.ridges_m.reserve(static_cast<std::size_t>(ridges));
  std::vector<OutlinePoint> samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) {
    const double angle = kTurn * k / count;
    const auto [i, x] = divided.find(angle);
    const Vec3 position = divided.cornerOrPosition(i, x);
    samples.push_back({inFrame(frame, position), angle, true});
    if (k % stepsPerRidge == 0) {
      outline.ridges_m.push_back(position);
    }
  }
  std::vector<OutlinePoint> points = merge(divided, samples);
  simplify(points, loop.perimeter_m);
  for (const OutlinePoint& p : points) {
    outline.points_m.push_back(p.place_m);
    outline.angles_rad.push_back(p.angle_rad);
  }
  constexpr double kFlattest = 1e-6;  // smallest area of a section, as a share of its perimeter squared
  if (!(area(outline.points_m) > kFlattest * loop.perimeter_m * loop.perimeter_m)) {
    throw Error(ErrorCode::kBadMesh, Text::tr("the section encloses no area"), name,
                Text::tr("Move the end points inwards, or give the end points of the axis."));
  }
  if (!angleRises(outline.points_m) && crossesItself(outline.points_m)) {
    throw Error(ErrorCode::kBadMesh, Text::tr("the outline of the section crosses itself"), name,
                Text::tr("Move the end points so that the axis follows the organ, or smooth the mesh."));
  }
  return outline;
}

LatticePoint pointOnLoop(const LevelLoop& loop, const AxisFrame& frame, const RidgeRule& rule,
                         double angle_rad, const TriangleMesh& mesh) {
  const DividedLoop divided(loop, frame, rule);
  const auto [i, x] = divided.find(wrapped(angle_rad));
  LatticePoint point;
  point.position_m = divided.position(i, x);
  // The segment lies in the triangle that its first point enters: barycentric coordinates by areas.
  point.triangle = loop.points[divided.at(i)].half / 3;
  const auto& [ia, ib, ic] = mesh.triangles[point.triangle];
  const Vec3& a = mesh.vertices_m[ia];
  const Vec3 ab = mesh.vertices_m[ib] - a;
  const Vec3 ac = mesh.vertices_m[ic] - a;
  const Vec3 ap = point.position_m - a;
  const Vec3 normal = cross(ab, ac);
  const double n2 = dot(normal, normal);
  if (n2 > 0.0) {
    const double b = dot(cross(ap, ac), normal) / n2;
    const double c = dot(cross(ab, ap), normal) / n2;
    point.barycentric = {1.0 - b - c, b, c};
  }
  return point;
}

std::vector<double> wayAtAngles(const LevelLoop& loop, int count) {
  const std::vector<double> rising = risingAngle(loop);
  const double start = wayAtAngle(loop, rising, 0.0);
  std::vector<double> ways{0.0};
  for (int k = 1; k < count; ++k) {
    double way = (wayAtAngle(loop, rising, kTurn * k / count) - start) / loop.perimeter_m;
    if (way < 0.0) {
      way += 1.0;
    }
    ways.push_back(std::max(way, ways.back()));
  }
  ways.push_back(1.0);
  return ways;
}

RayExit exitAlongE1(const LevelLoop& loop, const AxisFrame& frame) {
  double farthest = -1.0;
  RayExit exit{0.0, loop.points.front().angle_rad};
  for (std::size_t i = 0; i < loop.points.size(); ++i) {
    const LoopPoint& from = loop.points[i];
    const bool last = i + 1 == loop.points.size();
    const LoopPoint& to = loop.points[last ? 0 : i + 1];
    const Point2 a = inFrame(frame, from.position_m);
    const Point2 b = inFrame(frame, to.position_m);
    if ((a[1] > 0.0) == (b[1] > 0.0)) {
      continue;
    }
    const double x = a[1] / (a[1] - b[1]);
    const double reach = a[0] + x * (b[0] - a[0]);
    if (reach <= farthest) {
      continue;
    }
    farthest = reach;
    const double toAngle = last ? to.angle_rad + loop.turn_rad : to.angle_rad;
    const double toWay = last ? loop.perimeter_m : to.way_m;
    exit = {from.way_m + x * (toWay - from.way_m), from.angle_rad + x * (toAngle - from.angle_rad)};
  }
  return exit;
}

double shareOfWay(const LevelLoop& loop, double way_m) {
  const double share = (way_m - wayAtAngle(loop, risingAngle(loop), 0.0)) / loop.perimeter_m;
  return share < 0.0 ? share + 1.0 : share;
}

double ridgeAngleTowards(const SectionOutline& outline, const Point2& direction) {
  const double length = norm2(direction);
  double farthest = 0.0;
  double angle = 0.0;
  if (!(length > 0.0)) {
    return angle;
  }
  const std::size_t n = outline.points_m.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point2& a = outline.points_m[i];
    const Point2& b = outline.points_m[(i + 1) % n];
    const double atA = cross2(direction, a);
    const double atB = cross2(direction, b);
    if ((atA > 0.0) == (atB > 0.0)) {
      continue;
    }
    const double x = atA / (atA - atB);
    const Point2 p{a[0] + x * (b[0] - a[0]), a[1] + x * (b[1] - a[1])};
    const double reach = (p[0] * direction[0] + p[1] * direction[1]) / length;
    if (reach <= farthest) {
      continue;
    }
    farthest = reach;
    const double next = i + 1 < n ? outline.angles_rad[i + 1] : kTurn;
    angle = outline.angles_rad[i] + x * (next - outline.angles_rad[i]);
  }
  return wrapped(angle);
}

}  // namespace torsio
