// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

#include <QImage>
#include <QVector3D>
#include <QtQuick3D/QQuick3DTextureData>

#include "app/gui/scene/organ_surface.h"

namespace torsio::gui {

struct Theme;

/// What lies behind an organ in the operating room.
enum class Surroundings : std::uint8_t {
  kDrape,      ///< a limb or a testis on a draped table
  kStomach,    ///< the opened abdomen: liver, spleen and colon in outline
  kIntestine,  ///< the opened abdomen: loops of bowel in outline
};

/// Chooses by the scene's id, as tissueLook() does; anything unknown lies on a drape.
[[nodiscard]] Surroundings surroundingsOf(std::string_view sceneId);

/// Half of the side of the painted square, in radii of the organ.
inline constexpr float kSurroundingsReach = 4.0F;

/// Paints the square behind an organ seen from the front, its centre behind `centre_mm`: cloth or tissue,
/// outlines, and the shadow that the lamp throws of the organ at rest. The same picture on every machine; its
/// lightness follows the theme's backdrop, so that what stands out from that stands out from this.
[[nodiscard]] QImage paintSurroundings(Surroundings kind, const Theme& theme, const OrganSurface& organ,
                                       const QVector3D& centre_mm, float radius_mm);

/// The painted square as a picture for the graphics card. GUI thread.
class SurroundingsTexture : public QQuick3DTextureData {
  Q_OBJECT

 public:
  void setPicture(const QImage& picture);
};

}  // namespace torsio::gui
