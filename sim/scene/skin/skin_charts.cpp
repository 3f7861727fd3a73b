// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/skin/skin_charts.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace torsio {

namespace {

constexpr int kMaxCrossings = 64;  // a step is shorter than a few triangles; a corner must not hold it

std::uint64_t edgeKey(std::uint32_t from, std::uint32_t to) {
  return (static_cast<std::uint64_t>(from) << 32U) | to;
}

constexpr double kLeastFacing = 0.62;  // a piece's tissue leans by 52 degrees at most: stretched 1.6 times
constexpr int kRounding = 4;
constexpr double kCoarsest = 50.0;  // times the wished pixel: a surface of splinters ends the search

struct Chart {
  std::vector<std::uint32_t> triangles;
  Vec3 across;
  Vec3 down;
  double left_m = 0.0;
  double top_m = 0.0;
  double width_m = 0.0;
  double height_m = 0.0;
  int x = 0;
  int y = 0;
};

Chart chartFrom(std::uint32_t seed, const SurfaceWalk& walk, std::vector<bool>& taken) {
  Chart chart;
  const Vec3 facing = walk.normal(seed);
  std::deque<std::uint32_t> waiting{seed};
  taken[seed] = true;
  while (!waiting.empty()) {
    const std::uint32_t t = waiting.front();
    waiting.pop_front();
    chart.triangles.push_back(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t other = walk.neighbour(t, k);
      if (other == SurfaceWalk::kNone || taken[other] || dot(walk.normal(other), facing) < kLeastFacing) {
        continue;
      }
      taken[other] = true;
      waiting.push_back(other);
    }
  }
  chart.across = normalized(cross(std::abs(facing.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}, facing));
  chart.down = cross(facing, chart.across);
  return chart;
}

void measure(Chart& chart, const TriangleMesh& mesh) {
  double right_m = -1e9;
  double bottom_m = -1e9;
  chart.left_m = chart.top_m = 1e9;
  for (const std::uint32_t t : chart.triangles) {
    for (const std::uint32_t v : mesh.triangles[t]) {
      const double x = dot(mesh.vertices_m[v], chart.across);
      const double y = dot(mesh.vertices_m[v], chart.down);
      chart.left_m = std::min(chart.left_m, x), right_m = std::max(right_m, x);
      chart.top_m = std::min(chart.top_m, y), bottom_m = std::max(bottom_m, y);
    }
  }
  chart.width_m = right_m - chart.left_m;
  chart.height_m = bottom_m - chart.top_m;
}

int pixels(double length_m, double pixel_m) {
  return static_cast<int>(std::ceil(length_m / pixel_m)) + 2 * kChartMargin + 1;
}

/// On shelves, the tallest first; returns the height that is needed.
int pack(std::vector<Chart>& charts, int width, double pixel_m) {
  int x = 0;
  int shelf = 0;
  int y = 0;
  for (Chart& chart : charts) {
    const int w = pixels(chart.width_m, pixel_m);
    const int h = pixels(chart.height_m, pixel_m);
    if (x + w > width) {
      y += shelf, x = 0, shelf = 0;
    }
    chart.x = x, chart.y = y;
    x += w;
    shelf = std::max(shelf, h);
  }
  return y + shelf;
}

int roundedUp(int pixels) {
  return (pixels + kRounding - 1) / kRounding * kRounding;
}

/// Chooses the size of the map and places the charts on it.
void arrange(std::vector<Chart>& charts, SkinCharts& map, int mostPixels) {
  std::sort(charts.begin(), charts.end(), [](const Chart& a, const Chart& b) {
    return a.height_m != b.height_m ? a.height_m > b.height_m : a.triangles[0] < b.triangles[0];
  });
  const double coarsest_m = kCoarsest * map.pixel_m;
  for (;; map.pixel_m *= 1.1) {
    double area = 0.0;
    int widest = 0;
    for (const Chart& chart : charts) {
      const int w = pixels(chart.width_m, map.pixel_m);
      area += static_cast<double>(w) * pixels(chart.height_m, map.pixel_m);
      widest = std::max(widest, w);
    }
    map.width = roundedUp(std::max(widest, static_cast<int>(1.08 * std::sqrt(area))));
    map.height = roundedUp(pack(charts, map.width, map.pixel_m));
    const bool fits = static_cast<std::int64_t>(map.width) * map.height <= mostPixels;
    if (fits || map.pixel_m > coarsest_m) {
      return;
    }
  }
}

}  // namespace

SurfaceWalk::SurfaceWalk(const TriangleMesh& mesh)
    : mesh_(mesh), neighbours_(mesh.triangles.size(), {kNone, kNone, kNone}) {
  std::unordered_map<std::uint64_t, std::uint32_t> owners;
  owners.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleMesh::Triangle& corner = mesh.triangles[t];
    const Vec3& a = mesh.vertices_m[corner[0]];
    normals_.push_back(normalized(cross(mesh.vertices_m[corner[1]] - a, mesh.vertices_m[corner[2]] - a)));
    for (std::size_t k = 0; k < 3; ++k) {
      owners[edgeKey(corner[k], corner[(k + 1) % 3])] = t;
    }
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const TriangleMesh::Triangle& corner = mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto other = owners.find(edgeKey(corner[(k + 1) % 3], corner[k]));
      if (other != owners.end()) {
        neighbours_[t][k] = other->second;
      }
    }
  }
}

bool SurfaceWalk::step(SurfaceWalker& walker, double way_m) const {
  double left_m = way_m;
  for (int crossing = 0; crossing < kMaxCrossings; ++crossing) {
    const TriangleMesh::Triangle& corner = mesh_.triangles[walker.triangle];
    const Vec3& normal = normals_[walker.triangle];
    double nearest_m = std::numeric_limits<double>::max();
    std::size_t through = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& a = mesh_.vertices_m[corner[k]];
      const Vec3 inwards = normalized(cross(normal, mesh_.vertices_m[corner[(k + 1) % 3]] - a));
      const double approach = -dot(walker.heading, inwards);
      if (approach <= 1e-9) {
        continue;
      }
      const double way = std::max(0.0, dot(walker.place_m - a, inwards)) / approach;
      if (way < nearest_m) {
        nearest_m = way, through = k;
      }
    }
    if (nearest_m >= left_m) {
      walker.place_m += walker.heading * left_m;
      return true;
    }
    walker.place_m += walker.heading * nearest_m;
    left_m -= nearest_m;
    const std::uint32_t next = neighbours_[walker.triangle][through];
    if (next == kNone) {
      return false;
    }
    const Vec3 edge =
        normalized(mesh_.vertices_m[corner[(through + 1) % 3]] - mesh_.vertices_m[corner[through]]);
    const double along = dot(walker.heading, edge);
    const double across = dot(walker.heading, cross(normal, edge));
    walker.heading = normalized(edge * along + cross(normals_[next], edge) * across);
    walker.triangle = next;
  }
  return false;
}

void SurfaceWalk::turn(SurfaceWalker& walker, double angle_rad) const {
  const Vec3 left = cross(normals_[walker.triangle], walker.heading);
  walker.heading = normalized(walker.heading * std::cos(angle_rad) + left * std::sin(angle_rad));
}

void SurfaceWalk::head(SurfaceWalker& walker, const Vec3& direction) const {
  const Vec3& normal = normals_[walker.triangle];
  walker.heading = normalized(direction - normal * dot(normal, direction));
}

SkinCharts layFlat(const TriangleMesh& mesh, double pixel_m, int mostPixels) {
  const SurfaceWalk walk(mesh);
  std::vector<bool> taken(mesh.triangles.size(), false);
  std::vector<Chart> charts;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!taken[t]) {
      charts.push_back(chartFrom(t, walk, taken));
    }
  }
  for (Chart& chart : charts) {
    measure(chart, mesh);
  }
  SkinCharts map;
  map.pixel_m = pixel_m;
  arrange(charts, map, mostPixels);
  map.triangles.resize(mesh.triangles.size());
  for (const Chart& chart : charts) {
    std::unordered_map<std::uint32_t, std::uint32_t> drawn;
    for (const std::uint32_t t : chart.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t v = mesh.triangles[t][k];
        const auto [entry, fresh] = drawn.try_emplace(v, static_cast<std::uint32_t>(map.corners.size()));
        map.triangles[t][k] = entry->second;
        if (!fresh) {
          continue;
        }
        const Vec3& p = mesh.vertices_m[v];
        const double x = (dot(p, chart.across) - chart.left_m) / map.pixel_m + chart.x + kChartMargin + 0.5;
        const double y = (dot(p, chart.down) - chart.top_m) / map.pixel_m + chart.y + kChartMargin + 0.5;
        map.corners.push_back({v, {static_cast<float>(x), static_cast<float>(y)}});
      }
    }
  }
  return map;
}

}  // namespace torsio
