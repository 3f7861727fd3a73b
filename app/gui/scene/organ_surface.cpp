// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/organ_surface.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "app/gui/scene/view_frame.h"
#include "sim/base/contracts.h"

namespace torsio::gui {

namespace {

/// The curve of sRGB (IEC 61966-2-1).
float linear(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

}  // namespace

OrganSurface::OrganSurface(const TriangleMesh& mesh) : triangles_(mesh.triangles) {
  vertices_.resize(mesh.vertices_m.size());
  for (SurfaceVertex& v : vertices_) {
    std::fill(std::begin(v.colour), std::end(v.colour), 1.0F);
  }
  update(mesh.vertices_m);
}

void OrganSurface::sink(float depth_mm) {
  for (SurfaceVertex& v : vertices_) {
    for (int k = 0; k < 3; ++k) {
      v.position[k] -= depth_mm * v.normal[k];
    }
  }
}

void OrganSurface::paint(std::span<const std::array<float, 3>> colours) {
  TORSIO_EXPECTS(colours.empty() || colours.size() == vertices_.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      // The scene graph reads vertex colours as linear light.
      vertices_[i].colour[k] = colours.empty() ? 1.0F : linear(colours[i][k]);
    }
  }
}

void OrganSurface::update(std::span<const Vec3> vertices_m) {
  TORSIO_EXPECTS(vertices_m.size() == vertices_.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const QVector3D p = toView(vertices_m[i]);
    SurfaceVertex& v = vertices_[i];
    v.position[0] = p.x(), v.position[1] = p.y(), v.position[2] = p.z();
    v.normal[0] = v.normal[1] = v.normal[2] = 0.0F;
  }
  for (const TriangleMesh::Triangle& corners : triangles_) {
    const float* a = vertices_[corners[0]].position;
    const float* b = vertices_[corners[1]].position;
    const float* c = vertices_[corners[2]].position;
    const float ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
    const float wx = c[0] - a[0], wy = c[1] - a[1], wz = c[2] - a[2];
    // Twice the area times the unit normal: large triangles weigh more.
    const float n[3] = {uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx};
    for (const std::uint32_t corner : corners) {
      for (int k = 0; k < 3; ++k) {
        vertices_[corner].normal[k] += n[k];
      }
    }
  }
  for (SurfaceVertex& v : vertices_) {
    const float length =
        std::sqrt(v.normal[0] * v.normal[0] + v.normal[1] * v.normal[1] + v.normal[2] * v.normal[2]);
    if (length > 0.0F) {
      for (float& component : v.normal) {
        component /= length;
      }
    } else {
      v.normal[1] = 1.0F;
    }
  }
}

std::vector<std::array<std::uint32_t, 2>> OrganSurface::edges() const {
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(3 * triangles_.size());
  for (const TriangleMesh::Triangle& t : triangles_) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      edges.push_back({low, high});
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

}  // namespace torsio::gui
