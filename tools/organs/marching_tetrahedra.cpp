// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/organs/marching_tetrahedra.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "sim/base/contracts.h"

namespace torsio {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr std::size_t kBlock = 8;        // grid steps of one skipped region
constexpr double kClearOfCorner = 0.02;  // share of an edge: no triangle without area

// The six tetrahedra of a cube; bit 0, 1, 2 of a corner is its step along x, y, z. All positively oriented.
constexpr std::array<std::array<unsigned, 4>, 6> kTetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

class Marcher {
 public:
  Marcher(const SampleGrid& grid, const std::vector<double>& values)
      : grid_(grid), values_(values), onEdge_(7 * values.size(), kNone) {}

  TriangleMesh run() {
    for (std::size_t z = 0; z + 1 < grid_.count[2]; ++z) {
      for (std::size_t y = 0; y + 1 < grid_.count[1]; ++y) {
        for (std::size_t x = 0; x + 1 < grid_.count[0]; ++x) {
          cube(x, y, z);
        }
      }
    }
    return std::move(mesh_);
  }

 private:
  std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
    return (z * grid_.count[1] + y) * grid_.count[0] + x;
  }
  std::size_t corner(std::size_t base, unsigned bits) const {
    return base + (bits & 1U) + ((bits >> 1U) & 1U) * grid_.count[0] +
           ((bits >> 2U) & 1U) * grid_.count[0] * grid_.count[1];
  }
  Vec3 point(std::size_t i) const {
    const std::size_t x = i % grid_.count[0];
    const std::size_t y = i / grid_.count[0] % grid_.count[1];
    const std::size_t z = i / (grid_.count[0] * grid_.count[1]);
    return grid_.origin +
           grid_.step * Vec3{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  }

  void cube(std::size_t x, std::size_t y, std::size_t z) {
    const std::size_t base = index(x, y, z);
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
    std::uint32_t& found = onEdge_[7 * corner(base, low) + direction - 1];
    if (found != kNone) {
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
  const std::vector<double>& values_;
  std::vector<std::uint32_t> onEdge_;  // seven edges start at each grid point
  TriangleMesh mesh_;
};

// Values of the field where the surface may be near, the value at the middle of the block elsewhere.
std::vector<double> sample(const SampleGrid& grid, double slope,
                           const std::function<double(const Vec3&)>& field) {
  const auto [nx, ny, nz] = grid.count;
  std::vector<double> values(nx * ny * nz);
  const double half = 0.5 * static_cast<double>(kBlock) * grid.step;
  for (std::size_t z0 = 0; z0 < nz; z0 += kBlock) {
    for (std::size_t y0 = 0; y0 < ny; y0 += kBlock) {
      for (std::size_t x0 = 0; x0 < nx; x0 += kBlock) {
        const Vec3 corner = grid.origin + grid.step * Vec3{static_cast<double>(x0), static_cast<double>(y0),
                                                           static_cast<double>(z0)};
        const double middle = field(corner + Vec3{half, half, half});
        const bool clear = std::abs(middle) > slope * std::sqrt(3.0) * half;
        for (std::size_t z = z0; z < std::min(nz, z0 + kBlock); ++z) {
          for (std::size_t y = y0; y < std::min(ny, y0 + kBlock); ++y) {
            for (std::size_t x = x0; x < std::min(nx, x0 + kBlock); ++x) {
              const Vec3 step{static_cast<double>(x - x0), static_cast<double>(y - y0),
                              static_cast<double>(z - z0)};
              values[(z * ny + y) * nx + x] = clear ? middle : field(corner + grid.step * step);
            }
          }
        }
      }
    }
  }
  return values;
}

}  // namespace

TriangleMesh zeroSurface(const SampleGrid& grid, double slope,
                         const std::function<double(const Vec3&)>& field) {
  TORSIO_EXPECTS(grid.count[0] >= 2 && grid.count[1] >= 2 && grid.count[2] >= 2);
  const std::vector<double> values = sample(grid, slope, field);
  return Marcher(grid, values).run();
}

}  // namespace torsio
