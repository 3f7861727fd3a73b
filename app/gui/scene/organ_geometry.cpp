// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/organ_geometry.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

#include <QByteArray>
#include <QSignalBlocker>
#include <QVector3D>

namespace torsio::gui {

namespace {

constexpr float kWireLift_mm = 0.25F;

using Attribute = QQuick3DGeometry::Attribute;

template <typename T>
QByteArray bytesOf(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), static_cast<qsizetype>(values.size_bytes())};
}

std::pair<QVector3D, QVector3D> boundsOf(const OrganSurface& surface) {
  constexpr float kHuge = std::numeric_limits<float>::max();
  QVector3D low(kHuge, kHuge, kHuge);
  QVector3D high(-kHuge, -kHuge, -kHuge);
  for (const SurfaceVertex& v : surface.vertices()) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], v.position[k]);
      high[k] = std::max(high[k], v.position[k]);
    }
  }
  return {low, high};
}

QByteArray liftedPositions(const OrganSurface& surface) {
  QByteArray bytes(static_cast<qsizetype>(surface.vertices().size() * 3 * sizeof(float)), Qt::Uninitialized);
  auto* out = reinterpret_cast<float*>(bytes.data());
  for (const SurfaceVertex& v : surface.vertices()) {
    for (int k = 0; k < 3; ++k) {
      *out++ = v.position[k] + kWireLift_mm * v.normal[k];
    }
  }
  return bytes;
}

}  // namespace

OrganGeometry::OrganGeometry() {
  setStride(static_cast<int>(sizeof(DrawnVertex)));
  setPrimitiveType(PrimitiveType::Triangles);
  addAttribute(Attribute::PositionSemantic, offsetof(DrawnVertex, position), Attribute::F32Type);
  addAttribute(Attribute::NormalSemantic, offsetof(DrawnVertex, normal), Attribute::F32Type);
  addAttribute(Attribute::ColorSemantic, offsetof(DrawnVertex, colour), Attribute::F32Type);
  addAttribute(Attribute::TexCoord0Semantic, offsetof(DrawnVertex, map), Attribute::F32Type);
  addAttribute(Attribute::TexCoord1Semantic, offsetof(DrawnVertex, along), Attribute::F32Type);
  addAttribute(Attribute::TangentSemantic, offsetof(DrawnVertex, rest), Attribute::F32Type);
  addAttribute(Attribute::IndexSemantic, 0, Attribute::U32Type);
}

void OrganGeometry::setSurface(const OrganSurface& surface, const TissueSkin* skin) {
  reshape();
  silhouette_ = Silhouette(surface.triangles(), surface.vertices().size());
  if (skin == nullptr) {
    corners_.assign(surface.triangles().begin(), surface.triangles().end());
    sources_.resize(surface.vertices().size());
    std::iota(sources_.begin(), sources_.end(), 0U);
    drawn_.assign(sources_.size(), DrawnVertex{});
  } else {
    const SkinCharts& charts = skin->charts;
    corners_ = charts.triangles;
    sources_.clear();
    drawn_.clear();
    for (const SkinCharts::Corner& corner : charts.corners) {
      const std::array<float, 3>& rest = skin->rest_mm[corner.vertex];
      sources_.push_back(corner.vertex);
      drawn_.push_back({{},
                        {},
                        {},
                        {corner.place[0] / static_cast<float>(charts.width),
                         corner.place[1] / static_cast<float>(charts.height)},
                        {skin->arc_mm[corner.vertex], 0.0F},
                        {rest[0], rest[1], rest[2]}});
    }
  }
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    drawn_[i].along[1] = static_cast<float>(sources_[i]);
  }
  setIndexData(bytesOf(std::span<const TriangleMesh::Triangle>(corners_)));
  updateVertices(surface);
}

std::span<const EdgeVertex> OrganGeometry::softEdge(const OrganSurface& surface, const Eye& eye) {
  places_.clear();
  for (const SurfaceVertex& v : surface.vertices()) {
    places_.emplace_back(v.position[0], v.position[1], v.position[2]);
  }
  edge_.clear();
  for (const Silhouette::Rim& rim : silhouette_.find(places_, eye.position)) {
    const TriangleMesh::Triangle& corners = corners_[rim.triangle];
    const DrawnVertex& from = drawn_[corners[rim.side]];
    const DrawnVertex& to = drawn_[corners[(rim.side + 1) % 3]];
    EdgeVertex ends[2];
    static_assert(sizeof(EdgeVertex) == offsetof(DrawnVertex, along), "the same up to the place on the skin");
    std::memcpy(&ends[0], &from, sizeof(EdgeVertex));
    std::memcpy(&ends[1], &to, sizeof(EdgeVertex));
    const TriangleMesh::Triangle& vertices = silhouette_.triangle(rim.triangle);
    appendSoftEdge(ends[0], ends[1], silhouette_.outward(vertices[rim.side]),
                   silhouette_.outward(vertices[(rim.side + 1) % 3]), eye, edge_);
  }
  return edge_;
}

void OrganGeometry::updateVertices(const OrganSurface& surface) {
  const std::span<const SurfaceVertex> vertices = surface.vertices();
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    static_assert(offsetof(DrawnVertex, map) == sizeof(SurfaceVertex),
                  "what moves comes first, in one piece");
    std::memcpy(&drawn_[i], &vertices[sources_[i]], sizeof(SurfaceVertex));
  }
  setVertexData(bytesOf(std::span<const DrawnVertex>(drawn_)));
  const auto [low, high] = boundsOf(surface);
  setBounds(low, high);
  update();
}

void OrganGeometry::setCovers(std::span<const std::array<float, 4>> covers) {
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    std::copy(covers[sources_[i]].begin(), covers[sources_[i]].end(), drawn_[i].colour);
  }
  setVertexData(bytesOf(std::span<const DrawnVertex>(drawn_)));
  update();
}

void OrganGeometry::setReach(const OrganSurface& surface, std::span<const std::uint32_t> some) {
  constexpr float kBetween_mm = 12.0F;  // by which vertices between them may lie further out
  constexpr float kHuge = std::numeric_limits<float>::max();
  QVector3D low(kHuge, kHuge, kHuge);
  QVector3D high = -low;
  for (const std::uint32_t vertex : some) {
    for (int k = 0; k < 3; ++k) {
      const float at = surface.vertices()[vertex].position[k];
      low[k] = std::min(low[k], at - kBetween_mm);
      high[k] = std::max(high[k], at + kBetween_mm);
    }
  }
  setBounds(low, high);
  update();
}

void NumberTexture::setTexels(std::span<const std::array<float, 4>> texels, int wide) {
  setFormat(RGBA32F);
  fill(texels.empty() ? nullptr : texels.front().data(), texels.size(), 4, wide);
}

void NumberTexture::setNumbers(std::span<const float> numbers, int wide) {
  setFormat(R32F);
  fill(numbers.data(), numbers.size(), 1, wide);
}

void NumberTexture::fill(const float* numbers, std::size_t texels, std::size_t each, int wide) {
  const std::size_t lines = (texels + static_cast<std::size_t>(wide) - 1) / static_cast<std::size_t>(wide);
  QByteArray bytes(static_cast<qsizetype>(lines * static_cast<std::size_t>(wide) * each * sizeof(float)),
                   '\0');
  std::memcpy(bytes.data(), numbers, texels * each * sizeof(float));
  setSize({wide, static_cast<int>(lines)});
  setHasTransparency(false);
  setTextureData(bytes);
}

QSSGRenderGraphObject* NumberTexture::updateSpatialNode(QSSGRenderGraphObject* node) {
  // As in MovingGeometry: a notification would request one more, identical frame.
  QSignalBlocker quiet(this);
  if (node == nullptr) {
    quiet.unblock();
  }
  return QQuick3DTextureData::updateSpatialNode(node);
}

void SkinTexture::setSkin(const TissueSkin& skin) {
  setSize({skin.charts.width, skin.charts.height});
  setFormat(RGBA8);
  setHasTransparency(false);
  setTextureData(bytesOf(std::span<const std::uint8_t>(skin.rgba)));
}

WireGeometry::WireGeometry() {
  setStride(3 * sizeof(float));
  setPrimitiveType(PrimitiveType::Lines);
  addAttribute(Attribute::PositionSemantic, 0, Attribute::F32Type);
  addAttribute(Attribute::IndexSemantic, 0, Attribute::U32Type);
}

void WireGeometry::setSurface(const OrganSurface& surface) {
  const std::vector<std::array<std::uint32_t, 2>> edges = surface.edges();
  setIndexData(bytesOf(std::span<const std::array<std::uint32_t, 2>>(edges)));
  reshape();
  updateVertices(surface);
}

void WireGeometry::updateVertices(const OrganSurface& surface) {
  setVertexData(liftedPositions(surface));
  const auto [low, high] = boundsOf(surface);
  setBounds(low, high);
  update();
}

}  // namespace torsio::gui
