// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/anatomy/marching_tetrahedra.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace torsio {

namespace {

constexpr std::size_t kBlock = 8;  // grid steps of one skipped region

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
  const std::vector<double> values = sample(grid, slope, field);
  return isoSurface(grid, [&values](std::size_t z, std::span<double> layer) {
    std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(z * layer.size()), layer.size(), layer.begin());
  });
}

}  // namespace torsio
