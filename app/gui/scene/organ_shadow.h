// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <QVector3D>
#include <QtQuick3D/QQuick3DTextureData>

#include "app/gui/scene/organ_surface.h"

namespace torsio::gui {

/// Half of the side of the square that is shaded, in radii of the organ.
inline constexpr float kShadowReach = 2.0F;

/// The soft shadow that the operating lamp throws of an organ, as it lies now, on what is behind it. Some
/// tenth of a millisecond a frame; plain value.
class OrganShadow {
 public:
  static constexpr int kSide_px = 96;

  OrganShadow();
  /// `ground_mm`: where the shadow falls, along the viewer's direction.
  OrganShadow(const QVector3D& centre_mm, float radius_mm, float ground_mm);

  /// How much of the lamp is taken, 0 to 255: rows from below, kSide_px squared.
  std::span<const std::uint8_t> cast(const OrganSurface& organ);

 private:
  QVector3D centre_mm_;
  float radius_mm_ = 0.0F;
  float ground_mm_ = 0.0F;
  std::vector<std::uint8_t> shade_;
  std::vector<std::uint8_t> other_;  // of a step of softening
};

/// The shadow as a picture for the graphics card, written anew each frame. GUI thread.
class ShadowTexture : public QQuick3DTextureData {
  Q_OBJECT

 public:
  void setShade(std::span<const std::uint8_t> shade);

 protected:
  QSSGRenderGraphObject* updateSpatialNode(QSSGRenderGraphObject* node) override;
};

}  // namespace torsio::gui
