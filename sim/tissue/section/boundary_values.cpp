// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/tissue/section/boundary_values.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace torsio {

namespace {

/// A turn by more than this (sine of 25 degrees) is a corner of the section; less is a curve that the points
/// sample, and the dip of the stress at each of its points is an artefact of the polygon.
constexpr double kCornerSine = 0.42;

/// Smaller turns count as straight.
constexpr double kStraight = 1e-3;

enum class PointKind { kCurve, kConvexCorner, kReentrantCorner };

/// One loop with, for each point of the divided outline, psi and the force on it: the integral of |dz/dn|
/// times the hat function of the point.
struct LoopValues {
  const SampledLoop& loop;
  std::vector<double> warping;
  std::vector<double> force;
};

class ShearOnLoop {
 public:
  explicit ShearOnLoop(const LoopValues& values)
      : loop_(values.loop), force_(values.force), count_(static_cast<int>(values.force.size())) {
    kind_.assign(force_.size(), PointKind::kCurve);
    left_.assign(force_.size(), 1);
    right_.assign(force_.size(), 1);
    for (std::size_t c = 0; c < loop_.corners.size(); ++c) {
      classify(c);
    }
    mean_.resize(force_.size());
    for (int i = 0; i < count_; ++i) {
      mean_[at(i)] = meanShear(i);
    }
  }

  /// |tau| at every point of the divided outline.
  [[nodiscard]] std::vector<double> shear() const {
    std::vector<double> out(force_.size());
    for (int i = 0; i < count_; ++i) {
      switch (kind_[at(i)]) {
        case PointKind::kConvexCorner:
          out[at(i)] = 0.0;
          break;
        case PointKind::kReentrantCorner:
          out[at(i)] = mean_[at(i)];
          break;
        case PointKind::kCurve:
          out[at(i)] = corrected(i);
          break;
      }
    }
    for (std::size_t c = 0; c < loop_.corners.size(); ++c) {
      if (isChord(c)) {
        interpolate(out, loop_.corners[c], loop_.corners[(c + 1) % loop_.corners.size()]);
      }
    }
    return out;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  [[nodiscard]] int wrap(int i) const { return (i % count_ + count_) % count_; }

  /// Way from point i to the next.
  [[nodiscard]] double step(int i) const {
    const int k = wrap(i);
    const double end = k + 1 < count_ ? loop_.boundary.arc[at(k + 1)] : loop_.boundary.length;
    return end - loop_.boundary.arc[at(k)];
  }

  /// Kind of an own point of the loop, and how many points its window reaches to either side: on a curve as
  /// far as the shorter of its two edges, so that the window holds whole dips and nothing of a long side.
  void classify(std::size_t c) {
    const std::size_t n = loop_.corners.size();
    const int i = loop_.corners[c];
    if (loop_.sharpTurn[c] || std::abs(loop_.turn[c]) > kCornerSine) {
      kind_[at(i)] = loop_.turn[c] > 0.0 ? PointKind::kConvexCorner : PointKind::kReentrantCorner;
      return;
    }
    if (std::abs(loop_.turn[c]) < kStraight) {
      return;
    }
    const int before = loop_.corners[(c + n - 1) % n], after = loop_.corners[(c + 1) % n];
    const int parts[2] = {wrap(i - before), wrap(after - i)};
    const double reach = 1.001 * std::min(parts[0] * step(i - 1), parts[1] * step(i));
    left_[at(i)] = std::clamp(static_cast<int>(reach / step(i - 1)), 1, parts[0]);
    right_[at(i)] = std::clamp(static_cast<int>(reach / step(i)), 1, parts[1]);
  }

  /// Whether the edge from own point c on is a chord of a curve: between two gentle turns and not much longer
  /// than the edges before and after.
  [[nodiscard]] bool isChord(std::size_t c) const {
    constexpr double kLongest = 2.0;
    const std::size_t n = loop_.corners.size();
    const auto turns = [&](std::size_t k) {
      return kind_[at(loop_.corners[k])] == PointKind::kCurve && std::abs(loop_.turn[k]) >= kStraight;
    };
    if (!turns(c) || !turns((c + 1) % n)) {
      return false;
    }
    return edgeLength(c) <= kLongest * std::min(edgeLength((c + n - 1) % n), edgeLength((c + 1) % n));
  }

  [[nodiscard]] double edgeLength(std::size_t c) const {
    const int i = loop_.corners[c], j = loop_.corners[(c + 1) % loop_.corners.size()];
    return wrap(j - i) * step(i);
  }

  /// Along a chord the stress rises to the middle, which the curve does not have.
  void interpolate(std::vector<double>& values, int from, int to) const {
    const int parts = wrap(to - from);
    for (int k = 1; k < parts; ++k) {
      const double f = static_cast<double>(k) / parts;
      values[at(wrap(from + k))] = (1.0 - f) * values[at(from)] + f * values[at(to)];
    }
  }

  /// Mean of |tau| = 2 |dz/dn| under the hat of the window.
  [[nodiscard]] double meanShear(int i) const {
    const double a = left_[at(i)] * step(i - 1), b = right_[at(i)] * step(i);
    double sum = force_[at(i)];
    for (int k = 1; k < left_[at(i)]; ++k) {
      sum += force_[at(wrap(i - k))] * (1.0 - static_cast<double>(k) / left_[at(i)]);
    }
    for (int k = 1; k < right_[at(i)]; ++k) {
      sum += force_[at(wrap(i + k))] * (1.0 - static_cast<double>(k) / right_[at(i)]);
    }
    return std::abs(2.0 * sum / (0.5 * (a + b)));
  }

  /// The mean under a hat of half widths a, b is q + q' (b - a)/3 + q'' (a^2 - a b + b^2)/12: take the two
  /// terms away with the parabola through the neighbouring means.
  [[nodiscard]] double corrected(int i) const {
    const int before = wrap(i - left_[at(i)]), after = wrap(i + right_[at(i)]);
    const double middle = mean_[at(i)];
    if (kind_[at(before)] == PointKind::kReentrantCorner || kind_[at(after)] == PointKind::kReentrantCorner) {
      return middle;
    }
    const double a = left_[at(i)] * step(i - 1), b = right_[at(i)] * step(i);
    const double down = valueAtNeighbour(before) - middle, up = valueAtNeighbour(after) - middle;
    const double slope = (a * a * up - b * b * down) / (a * b * (a + b));
    const double bend = 2.0 * (up / b + down / a) / (a + b);
    const double change = slope * (b - a) / 3.0 + bend * (a * a - a * b + b * b) / 12.0;
    // Beside a corner the parabola may be a poor guess; it must not take over.
    return middle - std::clamp(change, -0.25 * middle, 0.25 * middle);
  }

  [[nodiscard]] double valueAtNeighbour(int i) const {
    return kind_[at(i)] == PointKind::kConvexCorner ? 0.0 : mean_[at(i)];
  }

  const SampledLoop& loop_;
  const std::vector<double>& force_;
  int count_;
  std::vector<PointKind> kind_;
  std::vector<int> left_;   // window, in points of the divided outline
  std::vector<int> right_;  // likewise
  std::vector<double> mean_;
};

void addLoopValues(BoundaryValues& out, const LoopValues& values) {
  const std::vector<double> shear = ShearOnLoop(values).shear();
  std::vector<double> psi, tau;
  for (const int sample : values.loop.sampleOf) {
    psi.push_back(values.warping[static_cast<std::size_t>(sample)]);
    tau.push_back(shear[static_cast<std::size_t>(sample)]);
  }
  out.warping.push_back(std::move(psi));
  out.shear.push_back(std::move(tau));
  out.maxShear = std::max(out.maxShear, *std::max_element(shear.begin(), shear.end()));
}

const SampledLoop& loopOf(const SectionShape& shape, std::size_t k) {
  return k == 0 ? shape.outline : shape.holes[k - 1];
}

/// Place of `arc` among the points of the divided loop: the last point at or before it, and the part of the
/// way to the next.
std::pair<std::size_t, double> placeOf(const BoundaryLoop& loop, double arc) {
  const auto after = std::upper_bound(loop.arc.begin(), loop.arc.end(), arc);
  const auto i = static_cast<std::size_t>(after - loop.arc.begin()) - 1;
  const double end = i + 1 < loop.arc.size() ? loop.arc[i + 1] : loop.length;
  return {i, (arc - loop.arc[i]) / (end - loop.arc[i])};
}

}  // namespace

BoundaryValues boundaryValues(const SectionShape& shape, const QuadraticFields& fields) {
  BoundaryValues out;
  for (std::size_t k = 0; k <= shape.holes.size(); ++k) {
    const SampledLoop& loop = loopOf(shape, k);
    const std::size_t n = loop.boundary.points.size();
    LoopValues values{loop, std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
    for (std::size_t i = 0; i < fields.nodes.size(); ++i) {
      if (fields.loop[i] != static_cast<int>(k)) {
        continue;
      }
      out.warpingMin = std::min(out.warpingMin, fields.warping[i]);
      out.warpingMax = std::max(out.warpingMax, fields.warping[i]);
      const auto [place, part] = placeOf(loop.boundary, fields.arc[i]);
      values.force[place] += (1.0 - part) * fields.edgeForce[i];
      values.force[(place + 1) % n] += part * fields.edgeForce[i];
      if (part == 0.0) {
        values.warping[place] = fields.warping[i];
      }
    }
    addLoopValues(out, values);
  }
  return out;
}

BoundaryValues boundaryValues(const SectionShape& shape, const BoundaryFields& fields) {
  BoundaryValues out;
  for (std::size_t k = 0; k <= shape.holes.size(); ++k) {
    const SampledLoop& loop = loopOf(shape, k);
    const std::size_t n = loop.boundary.points.size();
    LoopValues values{loop, std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
    for (std::size_t i = 0; i < n; ++i) {
      values.warping[i] = fields.warping[k][2 * i];
      const double end = i + 1 < n ? loop.boundary.arc[i + 1] : loop.boundary.length;
      const double quarter = 0.125 * (end - loop.boundary.arc[i]);
      const double near = fields.slope[k][2 * i], far = fields.slope[k][2 * i + 1];
      values.force[i] += quarter * (3.0 * near + far);
      values.force[(i + 1) % n] += quarter * (near + 3.0 * far);
    }
    for (const double psi : fields.warping[k]) {
      out.warpingMin = std::min(out.warpingMin, psi);
      out.warpingMax = std::max(out.warpingMax, psi);
    }
    addLoopValues(out, values);
  }
  return out;
}

}  // namespace torsio
