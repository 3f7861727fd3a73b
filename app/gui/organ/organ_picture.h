// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include <QWidget>

#include "app/gui/organ/organ_trial.h"
#include "app/gui/scene/orbit_camera.h"
#include "app/gui/widgets/theme.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSlider;

namespace torsio::gui {

class SceneView;

/// Overlay with an organ's axis and named landmarks. Follows the camera; ignores the mouse.
class OrganMarks : public ViewOverlay {
  Q_OBJECT

 public:
  using ViewOverlay::ViewOverlay;

  void setAxis(std::vector<Vec3> axis_m, std::vector<OrganLandmark> landmarks);
  /// Names a landmark in the window's language.
  [[nodiscard]] static QString nameOf(OrganLandmark::Kind kind);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void drawName(QPainter& painter, const QPointF& at, const QString& name) const;

  std::vector<Vec3> axis_m_;
  std::vector<OrganLandmark> landmarks_;
};

class SceneView;

/// A judged organ: its axis, sections, ridges and landmarks, and a manual trial twist. Clicks select a place.
/// GUI thread.
class OrganPicture : public QWidget {
  Q_OBJECT

 public:
  explicit OrganPicture(QWidget* parent = nullptr);

  void setTrial(const OrganTrial& trial);
  /// Twists the organ about its own axis, gripped at the free end.
  void twist(double angle_deg);
  /// Emits the place at a pixel of the view; false if there is no organ.
  bool pickAt(const QPointF& pixel);
  [[nodiscard]] SceneView& view() const noexcept { return *view_; }

  void retranslate();
  void setTheme(const Theme& theme);

 Q_SIGNALS:
  /// A place on the surface was clicked; rest coordinates, m.
  void picked(const torsio::Vec3& place_m);

 private:
  QWidget* createBar();
  void look(ViewPreset preset);
  void showTwist(int angle_deg);
  void showAxis();
  [[nodiscard]] OrganState state() const;

  OrganTrial trial_;
  SceneView* view_;
  OrganMarks* marks_;
  QLabel* none_;
  QLabel* twistLabel_ = nullptr;
  QSlider* twist_ = nullptr;
  QLabel* angle_ = nullptr;
  QCheckBox* axis_ = nullptr;
  QCheckBox* lattice_ = nullptr;
  QCheckBox* mesh_ = nullptr;
  QPushButton* front_ = nullptr;
  QPushButton* side_ = nullptr;
  QPushButton* top_ = nullptr;
};

}  // namespace torsio::gui
