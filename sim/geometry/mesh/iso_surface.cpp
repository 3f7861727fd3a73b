// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/iso_surface.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "sim/core/contracts.h"

namespace torsio {

namespace {

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();
constexpr double kClearOfCorner = 0.02;  // share of an edge: no triangle without area

// The six tetrahedra of a cube; bit 0, 1, 2 of a corner is its step along x, y, z. All positively oriented.
constexpr std::array<std::array<unsigned, 4>, 6> kTetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

/// Two layers of samples at a time, and the vertices on the edges that start in each.
class Marcher {
 public:
  Marcher(const SampleGrid& grid, const LayerOfSamples& layerAt)
      : grid_(grid),
        layerAt_(layerAt),
        area_(grid.count[0] * grid.count[1]),
        values_(2 * area_),
        onEdge_(2 * kEdges * area_, kNoVertex) {}

  TriangleMesh run() {
    layerAt_(0, {values_.data() + area_, area_});
    for (z_ = 0; z_ + 1 < grid_.count[2]; ++z_) {
      std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(area_), area_, values_.begin());
      layerAt_(z_ + 1, {values_.data() + area_, area_});
      const auto upper = onEdge_.begin() + static_cast<std::ptrdiff_t>(kEdges * area_);
      std::copy(upper, onEdge_.end(), onEdge_.begin());
      std::fill(upper, onEdge_.end(), kNoVertex);
      for (std::size_t y = 0; y + 1 < grid_.count[1]; ++y) {
        for (std::size_t x = 0; x + 1 < grid_.count[0]; ++x) {
          cube(y * grid_.count[0] + x);
        }
      }
    }
    return std::move(mesh_);
  }

 private:
  static constexpr std::size_t kEdges = 7;  // start at each grid point

  // Points are counted from the lower one of the two layers.
  std::size_t corner(std::size_t base, unsigned bits) const {
    return base + (bits & 1U) + ((bits >> 1U) & 1U) * grid_.count[0] + ((bits >> 2U) & 1U) * area_;
  }
  Vec3 point(std::size_t i) const {
    const std::size_t x = i % grid_.count[0];
    const std::size_t y = i / grid_.count[0] % grid_.count[1];
    const std::size_t z = z_ + i / area_;
    return grid_.origin +
           grid_.step * Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }

  void cube(std::size_t base) {
    unsigned inside = 0;
    for (unsigned bits = 0; bits < 8; ++bits) {
      inside += values_[corner(base, bits)] < 0.0 ? 1 : 0;
    }
    if (inside == 0 || inside == 8) {
      return;
    }
    for (const std::array<unsigned, 4>& tetrahedron : kTetrahedra) {
      cut(base, tetrahedron);
    }
  }

  // Vertex on the edge between two corners of one cube, made once for all tetrahedra around it.
  std::uint32_t vertex(std::size_t base, unsigned p, unsigned q) {
    const unsigned low = p & q;  // the corners of an edge of these tetrahedra contain one another
    const unsigned direction = p ^ q;
    std::uint32_t& found = onEdge_[kEdges * corner(base, low) + direction - 1];
    if (found != kNoVertex) {
      return found;
    }
    const std::size_t i = corner(base, low);
    const std::size_t j = corner(base, low | direction);
    const double t = std::clamp(values_[i] / (values_[i] - values_[j]), kClearOfCorner, 1.0 - kClearOfCorner);
    const Vec3 a = point(i);
    found = static_cast<std::uint32_t>(mesh_.vertices_m.size());
    mesh_.vertices_m.push_back(a + t * (point(j) - a));
    return found;
  }

  void cut(std::size_t base, const std::array<unsigned, 4>& tetrahedron) {
    // Corners inside first, by swaps; each swap turns the orientation.
    std::array<unsigned, 4> c = tetrahedron;
    bool turned = false;
    const auto isInside = [this, base](unsigned bits) { return values_[corner(base, bits)] < 0.0; };
    std::size_t inside = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      if (!isInside(c[k])) {
        continue;
      }
      if (k != inside) {
        std::swap(c[k], c[inside]);
        turned = !turned;
      }
      ++inside;
    }
    const auto on = [this, base, &c](std::size_t p, std::size_t q) { return vertex(base, c[p], c[q]); };
    // One after another: in which order arguments are evaluated, compilers choose differently.
    if (inside == 1 || inside == 3) {
      const std::size_t apex = inside == 1 ? 0 : 3;
      const std::size_t first = inside == 1 ? 1 : 0;
      const std::uint32_t p = on(apex, first);
      const std::uint32_t q = on(apex, first + 1);
      const std::uint32_t r = on(apex, first + 2);
      add(p, q, r, turned);
    }
    if (inside == 2) {
      const std::uint32_t p = on(0, 2);
      const std::uint32_t q = on(0, 3);
      const std::uint32_t r = on(1, 3);
      const std::uint32_t s = on(1, 2);
      add(p, q, r, turned);
      add(p, r, s, turned);
    }
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turned) {
    if (turned) {
      std::swap(b, c);
    }
    mesh_.triangles.push_back({a, b, c});
  }

  const SampleGrid& grid_;
  const LayerOfSamples& layerAt_;
  std::size_t area_;  // points of a layer
  std::size_t z_ = 0;
  std::vector<double> values_;
  std::vector<std::uint32_t> onEdge_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh isoSurface(const SampleGrid& grid, const LayerOfSamples& layerAt) {
  TORSIO_EXPECTS(grid.count[0] >= 2 && grid.count[1] >= 2 && grid.count[2] >= 2);
  return Marcher(grid, layerAt).run();
}

}  // namespace torsio
