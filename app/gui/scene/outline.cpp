// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/outline.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <tuple>

#include <QByteArray>

#include "sim/core/contracts.h"

namespace torsio::gui {

namespace {

constexpr std::size_t kQuad = 4;
constexpr std::size_t kRoom = 512;  // quads; grows on demand

using Attribute = QQuick3DGeometry::Attribute;

QVector3D placeOf(const EdgeVertex& vertex) {
  return {vertex.position[0], vertex.position[1], vertex.position[2]};
}

EdgeVertex beyond(EdgeVertex vertex, const QVector3D& outward, const Eye& eye) {
  const float pixel_mm = eye.pixel_share * (placeOf(vertex) - eye.position).length();
  for (int k = 0; k < 3; ++k) {
    vertex.position[k] += pixel_mm * outward[k];
  }
  vertex.colour[3] = 0.0F;
  return vertex;
}

}  // namespace

void announceEdgeVertices(QQuick3DGeometry& geometry) {
  geometry.setStride(static_cast<int>(sizeof(EdgeVertex)));
  geometry.setPrimitiveType(QQuick3DGeometry::PrimitiveType::Triangles);
  geometry.addAttribute(Attribute::PositionSemantic, offsetof(EdgeVertex, position), Attribute::F32Type);
  geometry.addAttribute(Attribute::NormalSemantic, offsetof(EdgeVertex, normal), Attribute::F32Type);
  geometry.addAttribute(Attribute::ColorSemantic, offsetof(EdgeVertex, colour), Attribute::F32Type);
  geometry.addAttribute(Attribute::TexCoord0Semantic, offsetof(EdgeVertex, map), Attribute::F32Type);
}

Silhouette::Silhouette(std::span<const TriangleMesh::Triangle> triangles, std::size_t vertices)
    : triangles_(triangles.begin(), triangles.end()), faces_(triangles.size()), outward_(vertices) {
  std::vector<std::tuple<std::uint32_t, std::uint32_t, Rim>> all;
  all.reserve(3 * triangles_.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const auto [low, high] = std::minmax(triangles_[t][side], triangles_[t][(side + 1) % 3]);
      all.emplace_back(low, high, Rim{t, side});
    }
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return std::tie(std::get<0>(a), std::get<1>(a)) < std::tie(std::get<0>(b), std::get<1>(b));
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto& [low, high, rim] = all[i];
    const bool pair = i + 1 < all.size() && std::get<0>(all[i + 1]) == low && std::get<1>(all[i + 1]) == high;
    sides_.push_back({rim, pair ? std::get<2>(all[i + 1]) : rim, !pair});
    i += pair ? 1 : 0;
  }
}

std::span<const Silhouette::Rim> Silhouette::find(std::span<const QVector3D> places, const QVector3D& eye) {
  TORSIO_EXPECTS(places.size() == outward_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const QVector3D& a = places[triangles_[t][0]];
    const QVector3D normal =
        QVector3D::crossProduct(places[triangles_[t][1]] - a, places[triangles_[t][2]] - a);
    faces_[t] = QVector3D::dotProduct(normal, eye - a) > 0.0F ? 1 : 0;
  }
  for (const Rim& rim : rims_) {
    outward_[triangles_[rim.triangle][rim.side]] = {};
    outward_[triangles_[rim.triangle][(rim.side + 1) % 3]] = {};
  }
  rims_.clear();
  for (const Side& side : sides_) {
    const bool seen = faces_[side.rim.triangle] != 0;
    if (side.last ? seen : seen != (faces_[side.other.triangle] != 0)) {
      add(places, eye, seen ? side.rim : side.other);
    }
  }
  return rims_;
}

void Silhouette::add(std::span<const QVector3D> places, const QVector3D& eye, const Rim& seen) {
  const TriangleMesh::Triangle& corners = triangles_[seen.triangle];
  const std::uint32_t from = corners[seen.side];
  const std::uint32_t to = corners[(seen.side + 1) % 3];
  const QVector3D& inside = places[corners[(seen.side + 2) % 3]];
  QVector3D across = QVector3D::crossProduct(places[to] - places[from], places[from] - eye).normalized();
  if (QVector3D::dotProduct(across, inside - places[from]) > 0.0F) {
    across = -across;
  }
  outward_[from] += across;
  outward_[to] += across;
  rims_.push_back(seen);
}

void appendSoftEdge(const EdgeVertex& from, const EdgeVertex& to, const QVector3D& outwardFrom,
                    const QVector3D& outwardTo, const Eye& eye, std::vector<EdgeVertex>& quads) {
  quads.push_back(from);
  quads.push_back(to);
  quads.push_back(beyond(to, outwardTo, eye));
  quads.push_back(beyond(from, outwardFrom, eye));
}

OutlineGeometry::OutlineGeometry() {
  announceEdgeVertices(*this);
  addAttribute(Attribute::IndexSemantic, 0, Attribute::U32Type);
  setQuads({});
}

void OutlineGeometry::setQuads(std::span<const EdgeVertex> corners) {
  TORSIO_EXPECTS(corners.size() % kQuad == 0);
  if (drawn_.empty() || corners.size() > drawn_.size()) {
    drawn_.assign(std::max(2 * corners.size(), kQuad * kRoom), EdgeVertex{});
    std::vector<std::uint32_t> indices;
    for (std::uint32_t first = 0; first < drawn_.size(); first += kQuad) {
      indices.insert(indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
    }
    setIndexData({reinterpret_cast<const char*>(indices.data()),
                  static_cast<qsizetype>(indices.size() * sizeof(std::uint32_t))});
    reshape();
  }
  // Unused quads have zero size.
  std::fill(std::copy(corners.begin(), corners.end(), drawn_.begin()), drawn_.end(), EdgeVertex{});
  setVertexData({reinterpret_cast<const char*>(drawn_.data()),
                 static_cast<qsizetype>(drawn_.size() * sizeof(EdgeVertex))});
  constexpr float kHuge = std::numeric_limits<float>::max();
  QVector3D low(kHuge, kHuge, kHuge);
  QVector3D high = -low;
  for (const EdgeVertex& corner : corners) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], corner.position[k]);
      high[k] = std::max(high[k], corner.position[k]);
    }
  }
  setBounds(corners.empty() ? QVector3D() : low, corners.empty() ? QVector3D() : high);
  update();
}

}  // namespace torsio::gui
