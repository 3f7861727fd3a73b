// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/lattice/level_loops.h"

#include <algorithm>

namespace torsio {

namespace {

using Index = std::uint32_t;

/// One level line is on its way through the triangles: what counts as above it.
struct Level {
  double value = 0.0;
  bool fromBelow = false;

  [[nodiscard]] bool above(double u) const noexcept { return fromBelow ? u >= value : u > value; }
};

double shareOf(double level, double from, double to) {
  return from == to ? 0.5 : std::clamp((level - from) / (to - from), 0.0, 1.0);
}

/// Perimeter, area vector and centroid of a traced loop.
void measure(LevelLoop& loop) {
  const std::size_t n = loop.points.size();
  Vec3 middle;
  for (const LoopPoint& p : loop.points) {
    middle += p.position_m / static_cast<double>(n);
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3& a = loop.points[i].position_m;
    const Vec3& b = loop.points[(i + 1) % n].position_m;
    loop.points[i].way_m = loop.perimeter_m;
    loop.perimeter_m += norm(b - a);
    loop.areaVector_m2 += 0.5 * cross(a - middle, b - middle);
  }
  const Vec3 direction = normalized(loop.areaVector_m2);
  double area = 0.0;
  Vec3 moment;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 a = loop.points[i].position_m - middle;
    const Vec3 b = loop.points[(i + 1) % n].position_m - middle;
    const double part = 0.5 * dot(cross(a, b), direction);
    area += part;
    moment += part / 3.0 * (a + b);
  }
  loop.centroid_m = area > 0.0 ? middle + moment / area : middle;
}

}  // namespace

LevelTracer::LevelTracer(const TriangleMesh& mesh, const SurfaceTopology& topology,
                         const HarmonicField& field)
    : mesh_(mesh), topology_(topology), field_(field), visited_(mesh.triangles.size(), 0) {}

std::vector<LevelLoop> LevelTracer::trace(double level, bool fromBelow) const {
  const Level line{level, fromBelow};
  std::vector<Index> crossed;
  for (Index t = 0; t < mesh_.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh_.triangles[t];
    const bool first = line.above(field_.level[a]);
    if (first != line.above(field_.level[b]) || first != line.above(field_.level[c])) {
      crossed.push_back(t);
    }
  }
  return traceIn(crossed, level, fromBelow);
}

void LevelTracer::traceAll(std::span<const double> levels,
                           const std::function<void(std::size_t, std::vector<LevelLoop>)>& use) const {
  // Bucket the triangles by the levels that cross them: least <= level < most.
  const std::size_t inner = levels.empty() ? 0 : levels.size() - 1;
  std::vector<std::pair<std::size_t, std::size_t>> ranges(mesh_.triangles.size());
  std::vector<std::size_t> first(inner + 1, 0);
  for (std::size_t t = 0; t < ranges.size(); ++t) {
    const auto& [a, b, c] = mesh_.triangles[t];
    const auto [least, most] = std::minmax({field_.level[a], field_.level[b], field_.level[c]});
    const auto end = levels.begin() + static_cast<std::ptrdiff_t>(inner);
    ranges[t] = {static_cast<std::size_t>(std::lower_bound(levels.begin(), end, least) - levels.begin()),
                 static_cast<std::size_t>(std::lower_bound(levels.begin(), end, most) - levels.begin())};
    for (std::size_t k = ranges[t].first; k < ranges[t].second; ++k) {
      ++first[k + 1];
    }
  }
  for (std::size_t k = 0; k < inner; ++k) {
    first[k + 1] += first[k];
  }
  std::vector<Index> crossed(first[inner]);
  std::vector<std::size_t> fill(first.begin(), first.end());
  for (std::size_t t = 0; t < ranges.size(); ++t) {
    for (std::size_t k = ranges[t].first; k < ranges[t].second; ++k) {
      crossed[fill[k]++] = static_cast<Index>(t);
    }
  }
  for (std::size_t k = 0; k < inner; ++k) {
    use(k, traceIn({crossed.data() + first[k], crossed.data() + first[k + 1]}, levels[k], false));
  }
  if (!levels.empty()) {
    use(inner, trace(levels[inner], true));
  }
}

std::vector<LevelLoop> LevelTracer::traceIn(std::span<const Index> crossed, double level,
                                            bool fromBelow) const {
  ++mark_;
  std::vector<LevelLoop> loops;
  for (const Index t : crossed) {
    if (visited_[t] == mark_) {
      continue;
    }
    loops.push_back(walk(t, level, fromBelow));
    measure(loops.back());
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const LevelLoop& a, const LevelLoop& b) { return a.perimeter_m > b.perimeter_m; });
  return loops;
}

LevelLoop LevelTracer::walk(Index start, double level, bool fromBelow) const {
  const Level line{level, fromBelow};
  const auto u = [this](Index half) { return field_.level[topology_.origin(half)]; };
  // The line enters each triangle across the half-edge that falls through the level: above is on its left.
  Index entry = 3 * start;
  while (!(line.above(u(entry)) && !line.above(u(SurfaceTopology::next(entry))))) {
    ++entry;
  }
  LevelLoop loop;
  double share = shareOf(level, u(entry), u(SurfaceTopology::next(entry)));
  double angle = field_.angle_rad[topology_.origin(entry)] + share * field_.rise_rad(topology_, entry);
  const double firstAngle = angle;
  while (visited_[entry / 3] != mark_) {
    visited_[entry / 3] = mark_;
    const Index next = SurfaceTopology::next(entry);
    const Index previous = SurfaceTopology::previous(entry);
    const Vec3& a = mesh_.vertices_m[topology_.origin(entry)];
    const Vec3& b = mesh_.vertices_m[topology_.origin(next)];
    loop.points.push_back({a + share * (b - a), entry, share, angle, 0.0});
    // Both crossed edges meet in one corner; the rise of the angle is counted through it.
    const double entryRise = field_.rise_rad(topology_, entry);
    Index exit = previous;
    if (line.above(u(previous))) {
      exit = next;
      const double way = shareOf(level, u(next), u(previous));
      angle += (1.0 - share) * entryRise + way * field_.rise_rad(topology_, next);
      share = 1.0 - way;
    } else {
      const double way = shareOf(level, u(previous), u(entry));
      angle += -share * entryRise - (1.0 - way) * field_.rise_rad(topology_, previous);
      share = 1.0 - way;
    }
    entry = topology_.opposite(exit);
  }
  loop.turn_rad = angle - firstAngle;
  return loop;
}

}  // namespace torsio
