// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/gui/scene/lattice_overlay.h"

namespace torsio::gui {

/// The ten marker points of the paper's Fig. 11 (or an organ's own), tied to the skin.
/// `assets`: the assets folder; the file is organMarkersFile(). Empty when the organ has none.
/// Throws Error{kBadData} for a file that breaks its rules.
[[nodiscard]] std::vector<SkinAnchor> organMarkers(const Scene& scene, const std::filesystem::path& assets);

/// Where a marker is now, view frame.
[[nodiscard]] QVector3D markerPlace(const SkinAnchor& marker, const OrganSurface& surface);

/// The markers as small balls. GUI thread.
class MarkerGeometry : public QQuick3DGeometry {
  Q_OBJECT

 public:
  MarkerGeometry();
  /// Centres in the view frame, radius in its unit (mm).
  void setMarkers(const std::vector<QVector3D>& centres, float radius_mm);
};

}  // namespace torsio::gui
