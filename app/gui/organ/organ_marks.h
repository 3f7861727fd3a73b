// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "app/gui/organ/organ_trial.h"
#include "app/gui/widgets/theme.h"

namespace torsio::gui {

class SceneView;

/// Overlay with an organ's axis and named landmarks. Follows the camera; ignores the mouse.
class OrganMarks : public QWidget {
  Q_OBJECT

 public:
  /// Covers all of `view`, its parent.
  explicit OrganMarks(SceneView& view);

  void setAxis(std::vector<Vec3> axis_m, std::vector<OrganLandmark> landmarks);
  void setTheme(const Theme& theme);
  /// Names a landmark in the window's language.
  [[nodiscard]] static QString nameOf(OrganLandmark::Kind kind);

  bool eventFilter(QObject* watched, QEvent* event) override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] QPointF pixelOf(const Vec3& place_m) const;
  void drawName(QPainter& painter, const QPointF& at, const QString& name) const;

  SceneView& view_;
  std::vector<Vec3> axis_m_;
  std::vector<OrganLandmark> landmarks_;
  Theme theme_;
};

}  // namespace torsio::gui
