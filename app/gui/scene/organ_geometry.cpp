// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/organ_geometry.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

#include <QByteArray>
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
    for (int k = 0; k < 3; ++k) *out++ = v.position[k] + kWireLift_mm * v.normal[k];
  }
  return bytes;
}

}  // namespace

OrganGeometry::OrganGeometry() {
  setStride(static_cast<int>(sizeof(SurfaceVertex)));
  setPrimitiveType(PrimitiveType::Triangles);
  addAttribute(Attribute::PositionSemantic, 0, Attribute::F32Type);
  addAttribute(Attribute::NormalSemantic, 3 * sizeof(float), Attribute::F32Type);
  addAttribute(Attribute::ColorSemantic, 6 * sizeof(float), Attribute::F32Type);
  addAttribute(Attribute::IndexSemantic, 0, Attribute::U32Type);
}

void OrganGeometry::setSurface(const OrganSurface& surface) {
  setIndexData(bytesOf(surface.triangles()));
  updateVertices(surface);
}

void OrganGeometry::updateVertices(const OrganSurface& surface) {
  setVertexData(bytesOf(surface.vertices()));
  const auto [low, high] = boundsOf(surface);
  setBounds(low, high);
  update();
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
  updateVertices(surface);
}

void WireGeometry::updateVertices(const OrganSurface& surface) {
  setVertexData(liftedPositions(surface));
  const auto [low, high] = boundsOf(surface);
  setBounds(low, high);
  update();
}

}  // namespace torsio::gui
