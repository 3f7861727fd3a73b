// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include <QImage>
#include <QVector3D>

#include "app/gui/scene/lattice_overlay.h"
#include "app/gui/scene/moving_geometry.h"

namespace torsio::gui {

struct Theme;

/// A place of a loop of bowel at which its mesentery hangs: the skin round it, whose mean is its middle.
using MesenteryHold = std::array<SkinAnchor, 4>;

/// The holds of a loop from its first foot to its second.
[[nodiscard]] std::vector<MesenteryHold> mesenteryHolds(const Scene& scene);

/// Where a fan is rooted: in the view frame, mm; `from` below the first foot.
struct MesenteryRoot {
  QVector3D from;
  QVector3D to;
};

/// The root of the fan of a loop at rest, on the ground below it. `radius_mm`: of the loop.
[[nodiscard]] MesenteryRoot mesenteryRoot(std::span<const MesenteryHold> holds, const OrganSurface& rest,
                                          float radius_mm, float ground_mm);

/// The painted fan: thin tissue with its vessels, clear at the root and at the sides; bottom row at the root,
/// first column at the first foot.
[[nodiscard]] QImage paintMesentery(const Theme& theme);

/// The thin sheet between a loop and its root. For the eye only: it follows the middle of the loop, has no
/// stiffness and touches nothing; mesentery.vert puts it behind all but the painted square. GUI thread.
class MesenteryGeometry : public MovingGeometry {
  Q_OBJECT

 public:
  MesenteryGeometry();
  /// `surface`: the skin that the holds mean.
  void hang(std::vector<MesenteryHold> holds, const MesenteryRoot& root, const OrganSurface& surface);
  /// The skin moved.
  void follow(const OrganSurface& surface);

 private:
  std::vector<MesenteryHold> holds_;
  MesenteryRoot root_;
};

}  // namespace torsio::gui
