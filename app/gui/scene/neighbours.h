// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>

#include "app/gui/scene/surroundings.h"

class QPainter;

namespace torsio::gui {

/// Where the drawn oesophagus and duodenum continue those of a stomach's own mesh: behind the end of the stub
/// and behind the bulb in the camera's front view, in units of the organ's radius.
inline constexpr QPointF kStubEnd{-0.13, 0.69};
inline constexpr QPointF kBulbEnd{-0.62, -0.28};

/// Where the bowel continues at the feet of a loop, likewise.
inline constexpr QPointF kLoopFirstFoot{0.86, -0.30};
inline constexpr QPointF kLoopSecondFoot{-0.86, -0.30};

/// Draws the organs beside the treated one, in shade and paler: in units of its radius, y up, as seen by a
/// surgeon in front of the patient.
void drawNeighbours(QPainter& painter, Surroundings kind, const Theme& theme);

}  // namespace torsio::gui
