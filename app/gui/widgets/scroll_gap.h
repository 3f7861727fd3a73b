// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QLayout;
class QScrollArea;

namespace torsio::gui {

/// Keeps `content`, the layout of the area's widget, clear of the vertical scroll bar if there is one;
/// otherwise it is as wide as what is above and below the area.
void keepOffScrollBar(QScrollArea& area, QLayout& content);

}  // namespace torsio::gui
