// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/organ_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "app/gui/scene/view_frame.h"
#include "sim/core/contracts.h"

namespace torsio::gui {

namespace {

/// The sRGB curve (IEC 61966-2-1) from a table, accurate to 4e-7. A power per channel and vertex would take
/// longer than the rest of an organ's frame.
class LinearLight {
 public:
  LinearLight() {
    for (std::size_t i = 0; i < table_.size(); ++i) {
      const double encoded = static_cast<double>(i) / kSteps;
      table_[i] =
          static_cast<float>(encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
    }
  }
  float operator()(float encoded) const {
    const float at = std::clamp(encoded, 0.0F, 1.0F) * static_cast<float>(kSteps);
    const auto cell = std::min(static_cast<std::size_t>(at), static_cast<std::size_t>(kSteps - 1));
    return table_[cell] + (at - static_cast<float>(cell)) * (table_[cell + 1] - table_[cell]);
  }

 private:
  static constexpr int kSteps = 1024;
  std::array<float, kSteps + 1> table_{};
};

}  // namespace

OrganSurface::OrganSurface(const TriangleMesh& mesh) : triangles_(mesh.triangles) {
  vertices_.resize(mesh.vertices_m.size());
  turning_.resize(mesh.vertices_m.size());
  for (SurfaceVertex& v : vertices_) {
    std::fill(std::begin(v.colour), std::end(v.colour), 1.0F);
  }
  update(mesh.vertices_m);
}

void OrganSurface::place(std::uint32_t vertex, const Vec3& at_m, const Vec3& normal) {
  const QVector3D p = toView(at_m);
  const QVector3D n = toViewDirection(normalized(normal));
  for (int k = 0; k < 3; ++k) {
    vertices_[vertex].position[k] = p[k];
    vertices_[vertex].normal[k] = n[k];
  }
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
  static const LinearLight kLinear;
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      // The scene graph expects linear vertex colours.
      vertices_[i].colour[k] = colours.empty() ? 1.0F : kLinear(colours[i][k]);
    }
  }
}

void OrganSurface::update(std::span<const Vec3> vertices_m) {
  TORSIO_EXPECTS(vertices_m.size() == vertices_.size());
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const QVector3D p = toView(vertices_m[i]);
    SurfaceVertex& v = vertices_[i];
    v.position[0] = p.x(), v.position[1] = p.y(), v.position[2] = p.z();
    turning_[i] = {{p.x(), p.y(), p.z(), 0.0F}, {}};
  }
  for (const TriangleMesh::Triangle& corners : triangles_) {
    Turning& first = turning_[corners[0]];
    Turning& second = turning_[corners[1]];
    Turning& third = turning_[corners[2]];
    const std::array<float, 4>& a = first.place;
    const std::array<float, 4>& b = second.place;
    const std::array<float, 4>& c = third.place;
    const float ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
    const float wx = c[0] - a[0], wy = c[1] - a[1], wz = c[2] - a[2];
    // Twice the area times the unit normal, so that large triangles weigh more.
    const float n[3] = {uy * wz - uz * wy, uz * wx - ux * wz, ux * wy - uy * wx};
    for (std::size_t k = 0; k < 3; ++k) {
      first.sum[k] += n[k];
      second.sum[k] += n[k];
      third.sum[k] += n[k];
    }
  }
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    const std::array<float, 4>& sum = turning_[i].sum;
    const float square = sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2];
    const float inverse = square > 0.0F ? 1.0F / std::sqrt(square) : 0.0F;
    for (std::size_t k = 0; k < 3; ++k) {
      vertices_[i].normal[k] = sum[k] * inverse;
    }
    if (square == 0.0F) {
      vertices_[i].normal[1] = 1.0F;
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
