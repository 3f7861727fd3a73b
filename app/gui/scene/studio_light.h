// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QQuick3DTextureData>

namespace torsio::gui {

/// The surroundings that a wet surface mirrors: a dim room, a bright operating lamp above and a soft panel at
/// the left, as an equirectangular high-range picture computed here, so that no picture file is shipped.
class StudioLight : public QQuick3DTextureData {
  Q_OBJECT

 public:
  StudioLight();
};

}  // namespace torsio::gui
