// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include <QImage>
#include <QVector3D>

#include "app/gui/scene/moving_geometry.h"
#include "app/gui/scene/skin_overlays.h"

namespace torsio::gui {

struct Theme;

/// An attachment of the mesentery to a loop of bowel: skin points round the loop, whose mean is its centre.
using MesenteryHold = std::array<SkinAnchor, 4>;

/// Returns the attachments of a loop from its first foot to its second.
[[nodiscard]] std::vector<MesenteryHold> mesenteryHolds(const Scene& scene);

/// The root of a fan, in the view frame, mm; `from` is below the first foot.
struct MesenteryRoot {
  QVector3D from;
  QVector3D to;
};

/// Returns the root of a loop's fan at rest, on the ground below it, or of a closed loop between its feet.
/// `radius_mm`: of the loop.
[[nodiscard]] MesenteryRoot mesenteryRoot(std::span<const MesenteryHold> holds, const OrganSurface& rest,
                                          float radius_mm, float ground_mm, bool closed = false);

/// Paints the fan: thin tissue with vessels, transparent at the root and the sides; bottom row at the root,
/// first column at the first foot.
[[nodiscard]] QImage paintMesentery(const Theme& theme);

/// The thin sheet between a loop and its root. Visual only: it follows the centre line of the loop, has no
/// stiffness and touches nothing; mesentery.vert puts it behind everything except the painted square. GUI
/// thread.
class MesenteryGeometry : public MovingGeometry {
  Q_OBJECT

 public:
  MesenteryGeometry();
  /// `surface`: the skin that the holds refer to.
  void hang(std::vector<MesenteryHold> holds, const MesenteryRoot& root, const OrganSurface& surface);
  /// Updates the sheet after the skin has moved.
  void follow(const OrganSurface& surface);

 private:
  std::vector<MesenteryHold> holds_;
  MesenteryRoot root_;
};

}  // namespace torsio::gui
