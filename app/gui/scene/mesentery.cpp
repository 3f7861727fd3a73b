// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/mesentery.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include <QByteArray>
#include <QPainter>
#include <QPainterPath>

#include "app/gui/scene/skin_overlays.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

namespace {

constexpr int kRows = 7;  // from root to loop

struct FanVertex {
  float position[3];
  float place[2];  // along the loop; from the root to it
};

using Attribute = QQuick3DGeometry::Attribute;

QVector3D middleOf(const MesenteryHold& hold, const OrganSurface& surface) {
  QVector3D sum;
  for (const SkinAnchor& anchor : hold) {
    sum += markerPlace(anchor, surface);
  }
  return sum / static_cast<float>(hold.size());
}

QPointF between(const QPointF& root, const QPointF& loop, double share) {
  return root + share * (loop - root);
}

/// Draws the vessels: trunks that spread from the root, arcades between them, straight ones to the wall.
void drawVessels(QPainter& painter, const QColor& colour) {
  constexpr int kTrunks = 9;
  constexpr int kArcades = 18;
  constexpr int kStraight = 72;
  const auto pen = [&](int alpha, double width) {
    QColor shown = colour;
    shown.setAlpha(alpha);
    QPen made(shown, width, Qt::SolidLine, Qt::RoundCap);
    made.setCosmetic(true);  // the painted square is stretched to a fan
    painter.setPen(made);
  };
  pen(150, 4.0);
  for (int k = 0; k < kTrunks; ++k) {
    const double at = (k + 0.5) / kTrunks;
    const double bend = 0.02 * std::sin(4.1 * k);
    QPainterPath trunk(QPointF(0.5 + 0.9 * (at - 0.5), 0.0));
    trunk.quadTo(QPointF(at + bend, 0.4), QPointF(at, 0.62));
    painter.drawPath(trunk);
  }
  pen(140, 3.0);
  for (int k = 0; k < kArcades; ++k) {
    const double at = (k + 0.5) / kArcades;
    QPainterPath arcade(QPointF(at - 0.5 / kArcades, 0.63));
    arcade.quadTo(QPointF(at, 0.63 + 0.17 + 0.03 * std::sin(2.7 * k)), QPointF(at + 0.5 / kArcades, 0.63));
    painter.drawPath(arcade);
  }
  pen(95, 2.0);
  for (int k = 0; k < kStraight; ++k) {
    const double at = (k + 0.5 + 0.2 * std::sin(3.3 * k)) / kStraight;
    painter.drawLine(between(QPointF(at, 0.4), QPointF(at, 1.0), 0.55), QPointF(at, 1.0));
  }
}

}  // namespace

std::vector<MesenteryHold> mesenteryHolds(const Scene& scene) {
  const SectionLattice& lattice = scene.lattice();
  std::vector<MesenteryHold> holds;
  for (int section = 0; section < lattice.sections(); ++section) {
    MesenteryHold& hold = holds.emplace_back();
    for (std::size_t k = 0; k < hold.size(); ++k) {
      const int ridge = static_cast<int>(k) * lattice.ridges() / static_cast<int>(hold.size());
      hold[k] = skinAnchor(scene, lattice.keyPoint_m(ridge, section));
    }
  }
  return holds;
}

MesenteryRoot mesenteryRoot(std::span<const MesenteryHold> holds, const OrganSurface& rest, float radius_mm,
                            float ground_mm, bool closed) {
  const float below = closed ? 0.06F : 0.42F;  // radii
  const float halfWidth = closed ? 0.06F : 0.17F;
  constexpr float kAboveGround = 0.02F;
  const QVector3D first = middleOf(holds.front(), rest);
  const QVector3D last = middleOf(holds.back(), rest);
  QVector3D middle = 0.5F * (first + last);
  middle.setY(std::min(first.y(), last.y()) - below * radius_mm);
  middle.setZ(ground_mm + kAboveGround * radius_mm);
  const QVector3D half(std::copysign(halfWidth * radius_mm, first.x() - last.x()), 0.0F, 0.0F);
  return {middle + half, middle - half};
}

QImage paintMesentery(const Theme& theme) {
  constexpr int kWide_px = 1024;
  constexpr int kHigh_px = 256;
  const bool dark = theme.kind == ThemeKind::kDark;
  QImage picture(kWide_px, kHigh_px, QImage::Format_ARGB32);
  const QColor tissue = dark ? QColor(0x5A, 0x4E, 0x50) : QColor(0xE4, 0xD8, 0xD6);
  for (int y = 0; y < kHigh_px; ++y) {
    for (int x = 0; x < kWide_px; ++x) {
      const double u = (x + 0.5) / kWide_px;
      const double v = 1.0 - (y + 0.5) / kHigh_px;
      // Soft folds, which open towards the loop.
      const double fold = std::sin(44.0 * u + 1.5 * std::sin(9.0 * u)) + 0.5 * std::sin(83.0 * u + 1.0);
      const double light = 1.0 + (0.02 + 0.04 * v) * fold - 0.10 * (1.0 - v);
      const double side = std::min(1.0, std::min(u, 1.0 - u) / 0.04);
      const double root = std::min(1.0, v / 0.25);
      const auto channel = [light](int value) {
        return static_cast<int>(std::clamp(light * value, 0.0, 255.0));
      };
      picture.setPixelColor(x, y,
                            QColor(channel(tissue.red()), channel(tissue.green()), channel(tissue.blue()),
                                   static_cast<int>(215.0 * side * root)));
    }
  }
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setCompositionMode(QPainter::CompositionMode_SourceAtop);  // no vessels where there is no tissue
  painter.translate(0.0, kHigh_px);
  painter.scale(kWide_px, -kHigh_px);
  drawVessels(painter, dark ? QColor(0x37, 0x2C, 0x36) : QColor(0x9E, 0x8A, 0x90));
  return picture;
}

MesenteryGeometry::MesenteryGeometry() {
  setStride(static_cast<int>(sizeof(FanVertex)));
  setPrimitiveType(PrimitiveType::Triangles);
  addAttribute(Attribute::PositionSemantic, offsetof(FanVertex, position), Attribute::F32Type);
  addAttribute(Attribute::TexCoord0Semantic, offsetof(FanVertex, place), Attribute::F32Type);
  addAttribute(Attribute::IndexSemantic, 0, Attribute::U32Type);
}

void MesenteryGeometry::hang(std::vector<MesenteryHold> holds, const MesenteryRoot& root,
                             const OrganSurface& surface) {
  holds_ = std::move(holds);
  root_ = root;
  std::vector<std::uint32_t> indices;
  for (std::uint32_t column = 0; column + 1 < holds_.size(); ++column) {
    for (std::uint32_t row = 0; row + 1 < kRows; ++row) {
      const std::uint32_t here = column * kRows + row;
      indices.insert(indices.end(), {here, here + 1, here + kRows, here + 1, here + kRows + 1, here + kRows});
    }
  }
  setIndexData({reinterpret_cast<const char*>(indices.data()),
                static_cast<qsizetype>(indices.size() * sizeof(std::uint32_t))});
  reshape();
  follow(surface);
}

void MesenteryGeometry::follow(const OrganSurface& surface) {
  if (holds_.empty()) {
    return;
  }
  std::vector<FanVertex> fan;
  fan.reserve(holds_.size() * kRows);
  constexpr float kHuge = std::numeric_limits<float>::max();
  QVector3D low(kHuge, kHuge, kHuge);
  QVector3D high = -low;
  for (std::size_t column = 0; column < holds_.size(); ++column) {
    const float along = static_cast<float>(column) / static_cast<float>(holds_.size() - 1);
    const QVector3D loop = middleOf(holds_[column], surface);
    const QVector3D root = root_.from + along * (root_.to - root_.from);
    for (int row = 0; row < kRows; ++row) {
      const float share = static_cast<float>(row) / (kRows - 1);
      const QVector3D at = root + share * (loop - root);
      fan.push_back({{at.x(), at.y(), at.z()}, {along, share}});
      for (int k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
    }
  }
  setVertexData(
      {reinterpret_cast<const char*>(fan.data()), static_cast<qsizetype>(fan.size() * sizeof(FanVertex))});
  setBounds(low, high);
  update();
}

}  // namespace torsio::gui
