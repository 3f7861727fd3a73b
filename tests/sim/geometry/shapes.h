// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>

#include "sim/core/portable_math.h"
#include "sim/geometry/mesh/triangle_mesh.h"

namespace torsio::testing {

/// A closed surface of `around` x `along` quads on a sphere with two poles; `radius_m` may differ per axis.
inline TriangleMesh ellipsoid(const Vec3& radius_m, std::uint32_t around = 24, std::uint32_t along = 16) {
  TriangleMesh mesh;
  for (std::uint32_t j = 1; j < along; ++j) {
    const double polar = kPi * j / along;
    for (std::uint32_t i = 0; i < around; ++i) {
      const double azimuth = 2.0 * kPi * i / around;
      mesh.vertices_m.push_back({radius_m.x * std::sin(polar) * std::cos(azimuth),
                                 radius_m.y * std::sin(polar) * std::sin(azimuth),
                                 -radius_m.z * std::cos(polar)});
    }
  }
  const auto bottom = static_cast<std::uint32_t>(mesh.vertices_m.size());
  mesh.vertices_m.push_back({0, 0, -radius_m.z});
  mesh.vertices_m.push_back({0, 0, radius_m.z});
  for (std::uint32_t i = 0; i < around; ++i) {
    const std::uint32_t next = (i + 1) % around;
    mesh.triangles.push_back({bottom, next, i});
    for (std::uint32_t j = 0; j + 2 < along; ++j) {
      const std::uint32_t a = j * around + i, b = j * around + next;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
    const std::uint32_t last = (along - 2) * around;
    mesh.triangles.push_back({last + i, last + next, bottom + 1});
  }
  return mesh;
}

/// A torus about z: genus 1.
inline TriangleMesh torus(double ring_m, double tube_m, std::uint32_t around = 24,
                          std::uint32_t across = 12) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < around; ++i) {
    const double u = 2.0 * kPi * i / around;
    for (std::uint32_t j = 0; j < across; ++j) {
      const double v = 2.0 * kPi * j / across;
      const double r = ring_m + tube_m * std::cos(v);
      mesh.vertices_m.push_back({r * std::cos(u), r * std::sin(u), tube_m * std::sin(v)});
      const std::uint32_t i2 = (i + 1) % around, j2 = (j + 1) % across;
      const std::uint32_t a = i * across + j, b = i2 * across + j, c = i2 * across + j2, d = i * across + j2;
      mesh.triangles.push_back({a, b, c});
      mesh.triangles.push_back({a, c, d});
    }
  }
  return mesh;
}

}  // namespace torsio::testing
