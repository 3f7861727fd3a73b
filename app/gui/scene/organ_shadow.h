// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <QVector3D>
#include <QtQuick3D/QQuick3DTextureData>

#include "app/gui/scene/organ_surface.h"

namespace torsio::gui {

/// Half side of the shaded square, in radii of the organ.
inline constexpr float kShadowReach = 2.0F;

/// The soft shadow of an organ in its present shape, cast by the operating lamp on what is behind. Takes a
/// few tenths of a millisecond per frame. Plain value.
class OrganShadow {
 public:
  static constexpr int kSide_px = 96;

  OrganShadow();
  /// `ground_mm`: depth of the surface that receives the shadow, in the viewing direction.
  OrganShadow(const QVector3D& centre_mm, float radius_mm, float ground_mm);

  /// Returns the shading, 0 to 255: rows from below, kSide_px squared. `of`: the vertices that are in place;
  /// empty: all.
  std::span<const std::uint8_t> cast(const OrganSurface& organ, std::span<const std::uint32_t> of = {});

 private:
  void put(const SurfaceVertex& v, int spot);

  QVector3D centre_mm_;
  float radius_mm_ = 0.0F;
  float ground_mm_ = 0.0F;
  std::vector<std::uint8_t> shade_;
  std::vector<std::uint8_t> other_;  // buffer of a filter pass
};

/// The shadow as a texture, rewritten each frame. GUI thread.
class ShadowTexture : public QQuick3DTextureData {
  Q_OBJECT

 public:
  void setShade(std::span<const std::uint8_t> shade);

 protected:
  QSSGRenderGraphObject* updateSpatialNode(QSSGRenderGraphObject* node) override;
};

}  // namespace torsio::gui
