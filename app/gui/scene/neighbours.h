// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>

#include "app/gui/scene/surroundings.h"

class QPainter;

namespace torsio::gui {

/// Where the drawn oesophagus and duodenum go on from those of a stomach that has its own: behind the end of
/// the stub and behind the bulb as the camera sees them in front, in units of the organ's radius.
inline constexpr QPointF kStubEnd{-0.13, 0.69};
inline constexpr QPointF kBulbEnd{-0.62, -0.28};

/// The same of the bowel that goes on at the feet of a loop.
inline constexpr QPointF kLoopFirstFoot{0.86, -0.30};
inline constexpr QPointF kLoopSecondFoot{-0.86, -0.30};

/// Draws the organs beside the one that is treated, out of the light and paler than it: in units of its
/// radius, y upwards, as a surgeon in front of the patient sees them.
void drawNeighbours(QPainter& painter, Surroundings kind, const Theme& theme);

}  // namespace torsio::gui
