// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/instrument_geometry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include <QByteArray>
#include <QVector3D>

namespace torsio::gui {

namespace {

using Attribute = QQuick3DGeometry::Attribute;

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kShaftRadius_mm = 2.5F;
constexpr float kHinge_mm = InstrumentGeometry::kJawLength_mm;
constexpr float kCollar_mm = kHinge_mm + 9.0F;  // steel end of the shaft
constexpr float kShaftEnd_mm = 250.0F;

struct Corner {
  QVector3D position;
  QVector3D normal;
};

/// Grows a triangle mesh out of curved patches.
class PatchMesh {
 public:
  using Patch = std::function<QVector3D(float u, float v)>;  // u, v in [0, 1]

  /// Normals point along dP/du x dP/dv.
  void add(int stepsU, int stepsV, const Patch& patch) {
    const auto first = static_cast<std::uint32_t>(corners_.size());
    constexpr float kSmall = 1e-3F;
    for (int j = 0; j <= stepsV; ++j) {
      for (int i = 0; i <= stepsU; ++i) {
        const float u = static_cast<float>(i) / static_cast<float>(stepsU);
        const float v = static_cast<float>(j) / static_cast<float>(stepsV);
        // Where a patch shrinks to a point its normal is taken a little inside.
        const float um = std::clamp(u, kSmall, 1.0F - kSmall);
        const float vm = std::clamp(v, kSmall, 1.0F - kSmall);
        const QVector3D du = patch(um + kSmall, vm) - patch(um - kSmall, vm);
        const QVector3D dv = patch(um, vm + kSmall) - patch(um, vm - kSmall);
        corners_.push_back({patch(u, v), QVector3D::crossProduct(du, dv).normalized()});
      }
    }
    const auto row = static_cast<std::uint32_t>(stepsU + 1);
    for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(stepsV); ++j) {
      for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(stepsU); ++i) {
        const std::uint32_t a = first + j * row + i;
        indices_.insert(indices_.end(), {a, a + 1, a + row, a + row, a + 1, a + row + 1});
      }
    }
  }

  /// A straight piece of a turned part about +y; equal heights make a flat ring.
  void turned(float radius0, float y0, float radius1, float y1) {
    add(28, 1, [=](float u, float v) {
      const float angle = -2.0F * kPi * u;
      const float r = radius0 + (radius1 - radius0) * v;
      return QVector3D(r * std::cos(angle), y0 + (y1 - y0) * v, r * std::sin(angle));
    });
  }

  [[nodiscard]] const std::vector<Corner>& corners() const noexcept { return corners_; }
  [[nodiscard]] const std::vector<std::uint32_t>& indices() const noexcept { return indices_; }

 private:
  std::vector<Corner> corners_;
  std::vector<std::uint32_t> indices_;
};

void buildShaft(PatchMesh& mesh) {
  mesh.turned(0.0F, kCollar_mm, kShaftRadius_mm - 0.1F, kCollar_mm);
  mesh.turned(kShaftRadius_mm - 0.1F, kCollar_mm, kShaftRadius_mm, kCollar_mm + 0.6F);
  mesh.turned(kShaftRadius_mm, kCollar_mm + 0.6F, kShaftRadius_mm, kShaftEnd_mm);
  mesh.turned(kShaftRadius_mm, kShaftEnd_mm, 0.0F, kShaftEnd_mm);
}

void buildHinge(PatchMesh& mesh) {
  constexpr float kSteel_mm = 2.25F;
  mesh.turned(0.0F, kHinge_mm - 1.5F, 1.5F, kHinge_mm - 1.5F);
  mesh.turned(1.5F, kHinge_mm - 1.5F, kSteel_mm, kHinge_mm + 1.2F);
  mesh.turned(kSteel_mm, kHinge_mm + 1.2F, kSteel_mm, kCollar_mm);
  // The pin of the hinge, across the tool.
  mesh.add(20, 1, [](float u, float v) {
    const float angle = 2.0F * kPi * u;
    return QVector3D(0.7F * std::cos(angle), kHinge_mm + 0.7F * std::sin(angle), 5.2F * (v - 0.5F));
  });
  for (const float side : {-1.0F, 1.0F}) {
    mesh.add(20, 1, [side](float u, float v) {
      const float angle = side * 2.0F * kPi * u;
      const float r = 0.7F * (1.0F - v);
      return QVector3D(r * std::cos(angle), kHinge_mm + r * std::sin(angle), side * 2.6F);
    });
  }
}

/// Half width (across the tool) and thickness of a jaw at a distance from its tip.
std::array<float, 2> jawSize(float y) {
  const float tip = std::sqrt(std::clamp(y / 2.4F, 0.0F, 1.0F) * (2.0F - std::clamp(y / 2.4F, 0.0F, 1.0F)));
  const float along = y / kHinge_mm;
  return {tip * (1.55F + 0.35F * along), tip * (1.0F + 0.9F * along)};
}

void buildJaw(PatchMesh& mesh) {
  constexpr float kToothDepth_mm = 0.28F;
  constexpr float kTooth_mm = 1.1F;
  // Rounded back, from one edge over to the other.
  mesh.add(14, 26, [](float u, float v) {
    const float y = kHinge_mm * v;
    const auto [half, thick] = jawSize(y);
    const float angle = kPi * (1.0F - u);
    return QVector3D(thick * std::sin(angle), y, -half * std::cos(angle));
  });
  // Toothed face.
  mesh.add(2, 96, [](float u, float v) {
    const float y = kHinge_mm * v;
    const auto [half, thick] = jawSize(y);
    const float phase = std::fmod(y, kTooth_mm) / kTooth_mm;
    const float tooth = y < 14.0F ? kToothDepth_mm * std::abs(2.0F * phase - 1.0F) : kToothDepth_mm;
    return QVector3D(std::min(tooth, 0.4F * thick), y, half * (1.0F - 2.0F * u));
  });
}

}  // namespace

InstrumentGeometry::InstrumentGeometry() {
  static_assert(sizeof(Corner) == 6 * sizeof(float));
  setStride(sizeof(Corner));
  setPrimitiveType(PrimitiveType::Triangles);
  addAttribute(Attribute::PositionSemantic, 0, Attribute::F32Type);
  addAttribute(Attribute::NormalSemantic, 3 * sizeof(float), Attribute::F32Type);
  addAttribute(Attribute::IndexSemantic, 0, Attribute::U32Type);
  build();
}

void InstrumentGeometry::setPart(Part part) {
  if (part == part_) return;
  part_ = part;
  build();
  Q_EMIT partChanged();
}

void InstrumentGeometry::build() {
  PatchMesh mesh;
  switch (part_) {
    case Shaft:
      buildShaft(mesh);
      break;
    case Hinge:
      buildHinge(mesh);
      break;
    case Jaw:
      buildJaw(mesh);
      break;
  }
  constexpr float kHuge = std::numeric_limits<float>::max();
  QVector3D low(kHuge, kHuge, kHuge);
  QVector3D high(-kHuge, -kHuge, -kHuge);
  for (const Corner& corner : mesh.corners()) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], corner.position[k]);
      high[k] = std::max(high[k], corner.position[k]);
    }
  }
  setVertexData({reinterpret_cast<const char*>(mesh.corners().data()),
                 static_cast<qsizetype>(mesh.corners().size() * sizeof(Corner))});
  setIndexData({reinterpret_cast<const char*>(mesh.indices().data()),
                static_cast<qsizetype>(mesh.indices().size() * sizeof(std::uint32_t))});
  setBounds(low, high);
  update();
}

}  // namespace torsio::gui
