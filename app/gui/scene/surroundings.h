// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QtQuick3D/QQuick3DTextureData>

class QPainter;

namespace torsio::gui {

struct Theme;

/// What is behind an organ in the operating room.
enum class Surroundings : std::uint8_t {
  kDrape,    ///< a limb or a testis on a draped table
  kArm,      ///< like kDrape, with the upper arm under the drape
  kStomach,  ///< open abdomen with a stomach whose mesh includes oesophagus and bulb, which go on into those
             ///< painted here (continuation.h), with outlines of liver, spleen and colon
  kBareStomach,       ///< open abdomen with a stomach without them: both are drawn up to it
  kBareTurnedAntrum,  ///< like kBareStomach, without the way from pylorus to duodenum
  kIntestine,         ///< open abdomen: loops of bowel in outline
  kBowelLoop,   ///< like kIntestine, with a loop of small bowel, continued at its feet, and its mesentery
  kClosedLoop,  ///< the same with a loop whose feet lie side by side
  kMidgut,      ///< like kIntestine, with the root that a stalk and a jejunal limb come down from
  kPelvis,      ///< open lower abdomen: descending colon, rectum, bladder and small bowel in outline
};

/// Returns the surroundings for a scene's id, like tissueLook(); unknown ones get a drape. `former`: the
/// former state of the scene (SceneRequest::former).
[[nodiscard]] Surroundings surroundingsOf(std::string_view sceneId, bool former = false);

/// Returns the colour of drapes.
[[nodiscard]] QColor clothColour(const Theme& theme);

/// Returns the colour of the gut beside the organ.
[[nodiscard]] QColor neighbourColour(const Theme& theme);

/// Half side of the painted square, in radii of the organ.
inline constexpr float kSurroundingsReach = 3.2F;

/// Returns whether the instrument enters through a port, as in an abdomen.
[[nodiscard]] bool throughPort(Surroundings kind) noexcept;

/// Paints the square behind an organ seen from the front: cloth or tissue in the light of the operating lamp,
/// and outlines. Identical on every machine; its lightness follows the theme's backdrop, so that the same
/// things stand out from both. Without the organ's shadow (OrganShadow).
[[nodiscard]] QImage paintSurroundings(Surroundings kind, const Theme& theme);

/// The painted square as a texture. GUI thread.
class SurroundingsTexture : public QQuick3DTextureData {
  Q_OBJECT

 public:
  void setPicture(const QImage& picture);
};

/// Where the bowel continues at the feet of a loop, likewise.
inline constexpr QPointF kLoopFirstFoot{0.86, -0.30};
inline constexpr QPointF kLoopSecondFoot{-0.86, -0.30};
inline constexpr QPointF kClosedFirstFoot{0.17, -0.82};
inline constexpr QPointF kClosedSecondFoot{-0.17, -0.82};

/// Where descending colon and rectum meet the feet of a sigmoid, likewise.
inline constexpr QPointF kDescendingEnd{0.24, -0.80};
inline constexpr QPointF kRectumEnd{-0.20, -0.80};

/// Where the stalk of a midgut and its jejunal limb end, likewise.
inline constexpr QPointF kStalkRoot{0.13, 0.50};
inline constexpr QPointF kLimbEnd{-0.07, 0.60};

/// Draws the organs beside the treated one, in shade and paler: in units of its radius, y up, as seen by a
/// surgeon in front of the patient.
void drawNeighbours(QPainter& painter, Surroundings kind, const Theme& theme);

}  // namespace torsio::gui
