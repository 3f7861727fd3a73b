// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QQuick3DGeometry>

namespace torsio::gui {

/// One rigid part of the grasper. Its frame: origin between the closed jaw tips, the shaft runs away from the
/// organ along +z of the tool, the jaws open in the tool's x. Millimetres, view frame.
class InstrumentGeometry : public QQuick3DGeometry {
  Q_OBJECT
  Q_PROPERTY(Part part READ part WRITE setPart NOTIFY partChanged)

 public:
  enum Part {
    Shaft,  ///< insulated tube with its steel end
    Hinge,  ///< steel clevis that carries the jaws
    Jaw,    ///< the upper jaw, closed; turn it about the hinge to open, mirror it for the lower one
  };
  Q_ENUM(Part)

  InstrumentGeometry();
  [[nodiscard]] Part part() const noexcept { return part_; }
  void setPart(Part part);

  static constexpr float kJawLength_mm = 18.0F;  ///< tip to hinge

 Q_SIGNALS:
  void partChanged();

 private:
  void build();

  Part part_ = Shaft;
};

}  // namespace torsio::gui
