// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/gui/scene/surroundings.h"

class QPainter;

namespace torsio::gui {

/// Draws the organs beside the one that is treated, out of the light and paler than it: in units of its
/// radius, y upwards, as a surgeon in front of the patient sees them.
void drawNeighbours(QPainter& painter, Surroundings kind, const Theme& theme);

}  // namespace torsio::gui
