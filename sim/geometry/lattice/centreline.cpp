// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/centreline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr int kFine = 8;                  // points a station while the line is smoothed
constexpr int kFootSteps = 60;            // at most: enough to halve the interval to the last bit
constexpr double kFootTolerance = 1e-15;  // of an interval

std::vector<double> cumulativeLength_m(std::span<const Vec3> line) {
  std::vector<double> length(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i) {
    length[i] = length[i - 1] + norm(line[i] - line[i - 1]);
  }
  return length;
}

/// `count` + 1 points at equal way along a polyline.
std::vector<Vec3> resampled(std::span<const Vec3> line, std::span<const double> way, std::size_t count) {
  std::vector<Vec3> points;
  points.reserve(count + 1);
  std::size_t i = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const double target = way.back() * static_cast<double>(k) / static_cast<double>(count);
    while (i + 2 < line.size() && way[i + 1] <= target) {
      ++i;
    }
    const double step = way[i + 1] - way[i];
    const double x = step > 0.0 ? std::clamp((target - way[i]) / step, 0.0, 1.0) : 0.0;
    points.push_back(line[i] + x * (line[i + 1] - line[i]));
  }
  points.push_back(line.back());
  return points;
}

/// Repeated [1 2 1] / 4: a Gaussian whose standard deviation is sqrt(passes / 2) points. The ends stay.
void smooth(std::vector<Vec3>& points, int passes) {
  for (int pass = 0; pass < passes; ++pass) {
    Vec3 before = points.front();
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      const Vec3 here = points[i];
      points[i] = 0.25 * (before + points[i + 1]) + 0.5 * here;
      before = here;
    }
  }
}

/// What the first smoothing took away is smoothed and given back: bends keep their radius (2 S - S S).
void smoothTwice(std::vector<Vec3>& points, int passes) {
  std::vector<Vec3> once = points;
  smooth(once, passes);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] -= once[i];
  }
  smooth(points, passes);
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] += once[i];
  }
}

/// Value at `x` of the monotone table (from, to), linear between its entries.
double lookUp(std::span<const double> from, std::span<const double> to, double x) {
  const auto at = std::upper_bound(from.begin() + 1, from.end() - 1, x);
  const auto i = static_cast<std::size_t>(at - from.begin());
  const double step = from[i] - from[i - 1];
  const double share = step > 0.0 ? std::clamp((x - from[i - 1]) / step, 0.0, 1.0) : 0.0;
  return to[i - 1] + share * (to[i] - to[i - 1]);
}

Vec3 perpendicularPart(const Vec3& v, const Vec3& tangent) {
  return v - dot(v, tangent) * tangent;
}

/// Unit vector at right angles to `tangent` nearest to `wish`; any when `wish` is zero or parallel.
Vec3 firstNormal(const Vec3& wish, const Vec3& tangent) {
  constexpr double kTooParallel = 1e-6;
  const Vec3 across = perpendicularPart(normalized(wish), tangent);
  return norm(across) > kTooParallel ? normalized(across) : anyPerpendicular(tangent);
}

Vec3 reflected(const Vec3& v, const Vec3& mirror) {
  const double m2 = dot(mirror, mirror);
  return m2 > 0.0 ? v - (2.0 * dot(mirror, v) / m2) * mirror : v;
}

/// Carries e1 from one station to the next without turning about the line (Wang et al. 2008).
Vec3 doubleReflection(const AxisFrame& from, const AxisFrame& to) {
  const Vec3 along = to.centre_m - from.centre_m;
  const Vec3 e1 = reflected(from.e1, along);
  const Vec3 tangent = reflected(from.tangent, along);
  return normalized(perpendicularPart(reflected(e1, to.tangent - tangent), to.tangent));
}

}  // namespace

Centreline Centreline::curved(std::span<const Vec3> line_m, double smoothing_m, int intervals, const Vec3& e1,
                              double e1At, std::vector<double>& arcs_m) {
  TORSIO_EXPECTS(line_m.size() >= 2 && intervals >= 1);
  const std::vector<double> raw = cumulativeLength_m(line_m);
  TORSIO_EXPECTS(raw.back() > 0.0);
  const std::size_t fine = static_cast<std::size_t>(intervals) * kFine;
  std::vector<Vec3> points = resampled(line_m, raw, fine);
  const double deviation = smoothing_m / raw.back() * static_cast<double>(fine);
  smoothTwice(points, static_cast<int>(std::lround(2.0 * deviation * deviation)));

  // Arc length of the given points: their place among the fine points is kept by the smoothing.
  const std::vector<double> way = cumulativeLength_m(points);
  std::vector<double> place(points.size());
  for (std::size_t i = 0; i < place.size(); ++i) {
    place[i] = raw.back() * static_cast<double>(i) / static_cast<double>(fine);
  }
  arcs_m.clear();
  for (const double length : raw) {
    arcs_m.push_back(lookUp(place, way, length));
  }
  arcs_m.back() = way.back();

  Centreline line;
  line.length_m_ = way.back();
  line.spacing_m_ = way.back() / intervals;
  for (const Vec3& centre : resampled(points, way, static_cast<std::size_t>(intervals))) {
    line.stations_.push_back({centre, {}, {}, {}});
  }
  line.setSlopes();
  for (std::size_t i = 0; i < line.stations_.size(); ++i) {
    line.stations_[i].tangent = normalized(line.slopes_[i]);
  }
  line.transportFrames(e1, e1At);
  return line;
}

Centreline Centreline::straightAlong(const Vec3& axis, double length_m, std::span<const Vec3> centres_m,
                                     const Vec3& e1) {
  TORSIO_EXPECTS(centres_m.size() >= 2 && length_m > 0.0);
  Centreline line;
  line.straight_ = true;
  line.length_m_ = length_m;
  line.spacing_m_ = length_m / static_cast<double>(centres_m.size() - 1);
  const Vec3 first = firstNormal(e1, axis);
  for (const Vec3& centre : centres_m) {
    line.stations_.push_back({centre, axis, first, cross(axis, first)});
  }
  line.setSlopes();
  return line;
}

void Centreline::setSlopes() {
  const std::size_t n = stations_.size();
  const auto c = [this](std::size_t i) { return stations_[i].centre_m; };
  slopes_.assign(n, {});
  for (std::size_t i = 1; i + 1 < n; ++i) {
    slopes_[i] = (c(i + 1) - c(i - 1)) / (2.0 * spacing_m_);
  }
  if (n == 2) {
    slopes_[0] = slopes_[1] = (c(1) - c(0)) / spacing_m_;
  } else {
    slopes_[0] = (4.0 * c(1) - 3.0 * c(0) - c(2)) / (2.0 * spacing_m_);
    slopes_[n - 1] = (3.0 * c(n - 1) - 4.0 * c(n - 2) + c(n - 3)) / (2.0 * spacing_m_);
  }
}

void Centreline::transportFrames(const Vec3& e1, double e1At) {
  const auto last = stations_.size() - 1;
  const auto anchor = std::min(last, static_cast<std::size_t>(std::lround(e1At * static_cast<double>(last))));
  stations_[anchor].e1 = firstNormal(e1, stations_[anchor].tangent);
  for (std::size_t i = anchor; i < last; ++i) {
    stations_[i + 1].e1 = doubleReflection(stations_[i], stations_[i + 1]);
  }
  for (std::size_t i = anchor; i > 0; --i) {
    stations_[i - 1].e1 = doubleReflection(stations_[i], stations_[i - 1]);
  }
  for (AxisFrame& station : stations_) {
    station.e2 = cross(station.tangent, station.e1);
  }
}

Vec3 Centreline::point(std::size_t i, double x) const noexcept {
  const Vec3& a = stations_[i].centre_m;
  const Vec3 chord = stations_[i + 1].centre_m - a;
  const Vec3 from = spacing_m_ * slopes_[i] - chord;
  const Vec3 to = chord - spacing_m_ * slopes_[i + 1];
  return a + x * chord + (x * (1.0 - x)) * ((1.0 - x) * from + x * to);
}

Vec3 Centreline::slope(std::size_t i, double x) const noexcept {
  const Vec3 chord = stations_[i + 1].centre_m - stations_[i].centre_m;
  const Vec3 from = spacing_m_ * slopes_[i] - chord;
  const Vec3 to = chord - spacing_m_ * slopes_[i + 1];
  const double y = 1.0 - x;
  return (chord + (y * (y - 2.0 * x)) * from + (x * (2.0 * y - x)) * to) / spacing_m_;
}

AxisFrame Centreline::frameAt(double arc_m) const noexcept {
  const double last = static_cast<double>(stations_.size() - 1);
  const double place = arc_m > 0.0 ? std::min(arc_m / spacing_m_, last) : 0.0;
  const auto i = std::min(static_cast<std::size_t>(place), stations_.size() - 2);
  const double x = place - static_cast<double>(i);
  AxisFrame frame = stations_[i];
  if (x == 0.0) {
    return frame;
  }
  frame.centre_m = point(i, x);
  if (straight_) {
    return frame;
  }
  frame.tangent = normalized(slope(i, x));
  const Vec3 between = stations_[i].e1 + x * (stations_[i + 1].e1 - stations_[i].e1);
  frame.e1 = normalized(perpendicularPart(between, frame.tangent));
  frame.e2 = cross(frame.tangent, frame.e1);
  return frame;
}

/// Arc length in interval i at which the line is at right angles to the way to the point, or the end of the
/// interval that is nearer to it: secant steps held inside a shrinking bracket.
double Centreline::footInInterval(std::size_t i, const Vec3& point_m) const noexcept {
  const auto ahead = [&](double x) { return dot(point_m - point(i, x), slope(i, x)); };
  const double start = static_cast<double>(i) * spacing_m_;
  double low = 0.0;
  double high = 1.0;
  const double atLow = ahead(low);
  const double atHigh = ahead(high);
  if (atLow <= 0.0) {
    return start;
  }
  if (atHigh >= 0.0) {
    return start + spacing_m_;
  }
  double lastX = low;
  double lastAhead = atLow;
  double x = atLow / (atLow - atHigh);
  for (int step = 0; step < kFootSteps; ++step) {
    const double here = ahead(x);
    if (here == 0.0) {
      break;
    }
    (here > 0.0 ? low : high) = x;
    double next = x - here * (x - lastX) / (here - lastAhead);
    if (!(next > low && next < high)) {
      next = 0.5 * (low + high);
    }
    if (std::abs(next - x) < kFootTolerance || high - low < kFootTolerance) {
      return start + next * spacing_m_;
    }
    lastX = x;
    lastAhead = here;
    x = next;
  }
  return start + x * spacing_m_;
}

double Centreline::nearestArc_m(const Vec3& point_m) const noexcept {
  if (straight_) {
    return std::clamp(dot(point_m - stations_.front().centre_m, stations_.front().tangent), 0.0, length_m_);
  }
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < stations_.size(); ++i) {
    const Vec3 d = point_m - stations_[i].centre_m;
    const double d2 = dot(d, d);
    if (d2 < least) {
      least = d2;
      best = i;
    }
  }
  const bool forward = dot(point_m - stations_[best].centre_m, slopes_[best]) > 0.0;
  if (forward) {
    return best + 1 < stations_.size() ? footInInterval(best, point_m) : length_m_;
  }
  return best > 0 ? footInInterval(best - 1, point_m) : 0.0;
}

}  // namespace torsio
