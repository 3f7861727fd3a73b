// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

#include <QColor>
#include <QImage>
#include <QtQuick3D/QQuick3DTextureData>

namespace torsio::gui {

struct Theme;

/// What lies behind an organ in the operating room.
enum class Surroundings : std::uint8_t {
  kDrape,             ///< a limb or a testis on a draped table
  kArm,               ///< the same; the upper arm lies under the drape
  kStomach,           ///< the opened abdomen about a stomach with oesophagus and bulb: where both go on, and
                      ///< liver, spleen and colon in outline
  kTurnedAntrum,      ///< the same without the way from the bulb into the duodenum
  kBareStomach,       ///< the opened abdomen about a stomach without them: they are drawn up to it
  kBareTurnedAntrum,  ///< the same without the way from pylorus to duodenum
  kIntestine,         ///< the opened abdomen: loops of bowel in outline
  kBowelLoop,  ///< the same about a loop of small bowel, which goes on at its feet and has its mesentery
  kPelvis,     ///< the opened abdomen below: descending colon, rectum, bladder and small bowel in outline
};

/// Chooses by the scene's id, as tissueLook() does; anything unknown lies on a drape. `former`: the former
/// state of the scene (SceneRequest::former).
[[nodiscard]] Surroundings surroundingsOf(std::string_view sceneId, bool former = false);

/// Of the drapes.
[[nodiscard]] QColor clothColour(const Theme& theme);

/// Half of the side of the painted square, in radii of the organ.
inline constexpr float kSurroundingsReach = 3.2F;

/// Whether an instrument comes to the organ through a port, as into an abdomen.
[[nodiscard]] bool throughPort(Surroundings kind) noexcept;

/// Paints the square behind an organ seen from the front: cloth or tissue in the light of the operating lamp,
/// and outlines. The same picture on every machine; its lightness follows the theme's backdrop, so that what
/// stands out from that stands out from this. The organ's shadow is not on it (OrganShadow).
[[nodiscard]] QImage paintSurroundings(Surroundings kind, const Theme& theme);

/// The painted square as a picture for the graphics card. GUI thread.
class SurroundingsTexture : public QQuick3DTextureData {
  Q_OBJECT

 public:
  void setPicture(const QImage& picture);
};

}  // namespace torsio::gui
