// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <QVector3D>

#include "app/gui/scene/moving_geometry.h"
#include "app/gui/scene/organ_surface.h"
#include "sim/scene/scene.h"

namespace torsio::gui {

/// A point fixed to the skin: three corners and their weights. Moves exactly with the drawn skin.
struct SkinAnchor {
  std::array<std::uint32_t, 3> corners{};
  std::array<float, 3> weights{};
};

/// A ridge or the outline of a section.
struct SkinLine {
  std::vector<SkinAnchor> anchors;
  bool closed = false;
};

/// The lattice of the paper's section 3.1, and the section to grasp.
struct LatticeLines {
  std::vector<SkinLine> lattice;  ///< ridges first, then sections
  std::vector<SkinLine> grasp;    ///< a single line
};

/// Projects ridges and sections onto the skin. Thousands of closest-point queries: tens of milliseconds.
[[nodiscard]] LatticeLines latticeLines(const Scene& scene);

/// Returns the skin point nearest to a point of the organ at rest, world frame.
[[nodiscard]] SkinAnchor skinAnchor(const Scene& scene, const Vec3& point_m);

/// Flat ribbons along skin lines. GUI thread.
class RibbonGeometry : public MovingGeometry {
  Q_OBJECT

 public:
  RibbonGeometry();
  enum class Shape : std::uint8_t {
    kFlat,      ///< on the skin
    kStanding,  ///< flat, and a second upright ribbon, visible where the skin turns away
  };
  /// `width_mm`: of the ribbon; `surface`: the skin that the anchors refer to.
  void setLines(std::vector<SkinLine> lines, float width_mm, const OrganSurface& surface,
                Shape shape = Shape::kFlat);
  /// Updates the lines after the skin has moved.
  void follow(const OrganSurface& surface);

 private:
  std::vector<SkinLine> lines_;
  float halfWidth_mm_ = 0.3F;
  std::uint32_t strips_ = 1;
};

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
