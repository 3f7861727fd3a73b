// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <QWidget>

#include "app/gui/widgets/theme.h"
#include "app/services/comparison/organ_markers.h"

namespace torsio::gui {

class SceneView;

/// Overlay with the numbers of an organ's markers at rest, the current one filled, those on the far side
/// faint. Follows the camera; ignores the mouse.
class MarkerLabels : public QWidget {
  Q_OBJECT

 public:
  /// Covers all of `view`, its parent.
  explicit MarkerLabels(SceneView& view);

  void setMarkers(std::shared_ptr<const Scene> scene, std::vector<OrganMarker> markers, int chosen);
  void setTheme(const Theme& theme);
  /// Returns the position of a marker in the view, pixels.
  [[nodiscard]] QPointF pixelOf(const OrganMarker& marker) const;

  bool eventFilter(QObject* watched, QEvent* event) override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] bool isHidden(const OrganMarker& marker) const;

  SceneView& view_;
  std::shared_ptr<const Scene> scene_;
  std::vector<OrganMarker> markers_;
  int chosen_ = 0;  // marker number; 0: none
  Theme theme_;
};

}  // namespace torsio::gui
