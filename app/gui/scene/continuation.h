// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include <QPointF>
#include <QVector3D>

#include "app/gui/scene/moving_geometry.h"
#include "app/gui/scene/skin_overlays.h"

namespace torsio::gui {

/// An open end of the organ that goes on into what is painted behind it: oesophagus, duodenum.
struct Continuation {
  std::array<SkinAnchor, 4> end;     ///< round the organ's end
  std::array<SkinAnchor, 4> before;  ///< round the organ a little before it
  QPointF painted;  ///< where the painted part begins, in radii of the organ (surroundings.h)
  QPointF onwards;  ///< unit, in which direction it goes on from there
};

/// Returns the open ends of a stomach; none if the organ is another one than the shipped stomach.
[[nodiscard]] std::vector<Continuation> stomachContinuations(const Scene& scene);

/// The place of a painted point on the ground behind the organ, view frame.
struct PaintedGround {
  QVector3D centre_mm;  ///< of the organ, in the plane of the ground
  float radius_mm = 1.0F;

  [[nodiscard]] QVector3D at(const QPointF& painted) const {
    return centre_mm +
           radius_mm * QVector3D(static_cast<float>(painted.x()), static_cast<float>(painted.y()), 0.0F);
  }
};

/// The tubes from the organ's open ends to what is painted behind it, so that an end that moves hangs
/// nowhere. Visual only: they touch nothing. GUI thread.
class ContinuationGeometry : public MovingGeometry {
  Q_OBJECT

 public:
  ContinuationGeometry();
  /// `surface`: the skin that the ends refer to.
  void join(std::vector<Continuation> ends, const PaintedGround& ground, const OrganSurface& surface);
  /// Updates the tubes after the skin has moved.
  void follow(const OrganSurface& surface);
  /// Returns the middles of the first and of the last ring of a tube as drawn.
  [[nodiscard]] std::array<QVector3D, 2> endsOf(std::size_t tube) const { return drawnEnds_.at(tube); }

 private:
  std::vector<Continuation> ends_;
  PaintedGround ground_;
  std::vector<std::array<QVector3D, 2>> drawnEnds_;
};

}  // namespace torsio::gui
