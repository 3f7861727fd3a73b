// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/gui/scene/lattice_overlay.h"

namespace torsio::gui {

/// Returns the ten marker points of the paper's Fig. 11 (or the organ's own) as skin points, from
/// organMarkersFile(). `assets`: the assets folder. Empty if the organ has none. Throws Error{kBadData} for
/// an invalid file.
[[nodiscard]] std::vector<SkinAnchor> organMarkers(const Scene& scene, const std::filesystem::path& assets);

/// Returns the present position of a marker, view frame.
[[nodiscard]] QVector3D markerPlace(const SkinAnchor& marker, const OrganSurface& surface);

/// The markers as small balls. GUI thread.
class MarkerGeometry : public QQuick3DGeometry {
  Q_OBJECT

 public:
  MarkerGeometry();
  /// `centres`: view frame; `radius_mm`: in its unit.
  void setMarkers(const std::vector<QVector3D>& centres, float radius_mm);
};

}  // namespace torsio::gui
