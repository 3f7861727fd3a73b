// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

class QLayout;
class QScrollArea;

namespace torsio::gui {

/// Keeps what stands in `content`, the layout of the area's widget, off the vertical scroll bar while there
/// is one. Without one it reaches as far to the right as what stands above and below the area.
void keepOffScrollBar(QScrollArea& area, QLayout& content);

}  // namespace torsio::gui
