// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QImage>
#include <QString>

namespace torsio::gui {

/// One picture of a film strip.
struct StripFrame {
  QString caption;
  QImage picture;
};

/// The frames in rows of equal pictures with their captions below, on white: for papers and slides. Rows have
/// the same number of frames. Null when there are none.
[[nodiscard]] QImage filmStrip(const std::vector<std::vector<StripFrame>>& rows);

}  // namespace torsio::gui
