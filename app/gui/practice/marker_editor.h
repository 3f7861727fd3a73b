// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include <QWidget>

#include "app/gui/scene/orbit_camera.h"
#include "app/gui/scene/scene_view.h"
#include "app/gui/widgets/theme.h"
#include "app/services/comparison/organ_markers.h"

class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;

namespace torsio::gui {

class SceneView;

/// Overlay with the numbers of an organ's markers at rest, the current one filled, those on the far side
/// faint. Follows the camera; ignores the mouse.
class MarkerLabels : public ViewOverlay {
  Q_OBJECT

 public:
  using ViewOverlay::ViewOverlay;

  void setMarkers(std::shared_ptr<const Scene> scene, std::vector<OrganMarker> markers, int chosen);
  /// Returns the position of a marker in the view, pixels.
  [[nodiscard]] QPointF pixelOf(const OrganMarker& marker) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  [[nodiscard]] bool isHidden(const OrganMarker& marker) const;

  std::shared_ptr<const Scene> scene_;
  std::vector<OrganMarker> markers_;
  int chosen_ = 0;  // marker number; 0: none
};

class Card;
class ShellContext;

/// Markers of an organ for comparisons (Fig. 11): displayed on it, moved by a click on its surface or by
/// section and ridge, named, stored in a file. GUI thread.
class MarkerEditor : public QWidget {
  Q_OBJECT

 public:
  explicit MarkerEditor(ShellContext& shell, QWidget* parent = nullptr);

  /// Shows an organ with these markers, to which "Reset" returns; emits nothing.
  void setOrgan(std::shared_ptr<const Scene> scene, const ViewScene& view, std::vector<OrganMarker> markers);
  [[nodiscard]] const std::vector<OrganMarker>& markers() const noexcept { return markers_; }
  /// Replaces the markers by a file's. Throws like readMarkers(); then nothing has changed.
  void open(const std::filesystem::path& file);
  /// Writes the markers. Throws like writeMarkers(), and Error{kBadData} for a missing or duplicate name.
  void save(const std::filesystem::path& file) const;
  /// Moves the current marker to the surface at a pixel of the view; false if there is no organ.
  bool placeAt(const QPointF& pixel);

  void retranslate();
  void setTheme(const Theme& theme);

 Q_SIGNALS:
  /// markers() has changed.
  void changed();

 private:
  QWidget* createPanel();
  [[nodiscard]] int chosen() const;
  void choose(int row);
  void fill(int chosen);
  void showPlace();
  void placeOnLattice();
  void rename(const QString& name);
  void add();
  void remove();
  void showMarkers();
  void took();

  ShellContext& shell_;
  std::shared_ptr<const Scene> scene_;
  std::vector<OrganMarker> markers_;
  std::vector<OrganMarker> first_;
  SceneView* view_;
  MarkerLabels* labels_;
  Card* card_ = nullptr;
  QLabel* hint_ = nullptr;
  QListWidget* list_ = nullptr;
  QLabel* nameLabel_ = nullptr;
  QLineEdit* name_ = nullptr;
  QLabel* sectionLabel_ = nullptr;
  QSpinBox* section_ = nullptr;
  QLabel* ridgeLabel_ = nullptr;
  QSpinBox* ridge_ = nullptr;
  QPushButton* add_ = nullptr;
  QPushButton* remove_ = nullptr;
  QPushButton* reset_ = nullptr;
  QPushButton* open_ = nullptr;
  QPushButton* save_ = nullptr;
};

}  // namespace torsio::gui
