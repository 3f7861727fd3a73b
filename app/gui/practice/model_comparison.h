// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include "app/gui/simulator/simulation_controller.h"
#include "app/gui/widgets/theme.h"
#include "app/services/comparison/comparison_run.h"
#include "sim/baseline/lattice_surface.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace torsio::gui {

class Card;
class FigureCard;
class ShellContext;

/// An organ for comparisons: lattice and markers, and the data of the views.
struct ComparedScene {
  LoadedScene loaded;
  std::vector<OrganMarker> markers;  ///< its own, or evenly spread
  std::shared_ptr<const LatticeSkin> skin;
  double torque_Nm = 0.0;  ///< usualTorque_Nm()
};

/// The paper's comparison (Figs. 8 to 14): twist model, finite elements and springs side by side under one
/// torque, each with its computing time; tables and figures of `torsio compare`, and its files. GUI thread;
/// models are computed in a worker.
class ModelComparison : public QWidget {
  Q_OBJECT

 public:
  explicit ModelComparison(ShellContext& shell, QWidget* parent = nullptr);

  /// Loads an organ in the background; then emits organChanged().
  void load(const SceneRequest& request);
  [[nodiscard]] const ComparedScene& organ() const noexcept { return organ_; }
  [[nodiscard]] bool loaded() const noexcept { return organ_.loaded.scene != nullptr; }
  /// Returns whether an organ was requested, loaded or not.
  [[nodiscard]] bool asked() const noexcept { return asked_; }
  /// Sets the markers of the next comparison.
  void setMarkers(std::vector<OrganMarker> markers);
  /// Compares in the background with this torque and, for screenshots and tests, resolution.
  void compare(const ComparisonOptions& options);
  /// Returns the result; null before this organ's first comparison.
  [[nodiscard]] const ComparisonResult* result() const noexcept { return result_.get(); }
  /// Writes the files of `torsio compare --out`, with the report in the window's language. Throws
  /// Error{kFileUnwritable}.
  void saveReport(const std::filesystem::path& folder) const;

  void retranslate();
  void setTheme(const Theme& theme);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 Q_SIGNALS:
  void organChanged();
  void compared();

 private:
  struct Side {
    std::string id;  ///< "pm", "fem", "msm"
    Card* card = nullptr;
    SceneView* view = nullptr;
    QLabel* clock = nullptr;
    QLabel* figures = nullptr;
    std::shared_ptr<std::vector<ModelPose>> poses;  ///< poses that the view draws
  };

  QWidget* createBar();
  QWidget* createSide(Side& side);
  void adopt(ComparedScene organ);
  void took(std::shared_ptr<const ComparisonResult> result);
  void replay();
  void replayFrame();
  void showPose(Side& side, double processing_s);
  void showResult();
  void showFigures(const Side& side);
  void chooseFolder();
  void turnOthers(const SceneView& turned);
  void nameOrgans();

  ShellContext& shell_;
  std::array<Side, 3> sides_;
  QLabel* organLabel_ = nullptr;
  QComboBox* organChoice_ = nullptr;
  QLabel* torqueLabel_ = nullptr;
  QDoubleSpinBox* torque_ = nullptr;
  QPushButton* compare_ = nullptr;
  QPushButton* replay_ = nullptr;
  QPushButton* save_ = nullptr;
  QLabel* hint_ = nullptr;
  QLabel* limits_ = nullptr;
  std::vector<FigureCard*> cards_;  // of the report: times, accuracy, meshes, figures 10, 13, 14

  bool asked_ = false;
  ComparedScene organ_;
  std::vector<OrganMarker> markers_;
  std::optional<SceneRequest> ownOrgan_;  // a user's mesh, which no scene names
  std::shared_ptr<const ComparisonResult> result_;
  double generation_ = 0.0;  // distinguishes the poses of successive comparisons for the views
  QTimer replayTimer_;
  QElapsedTimer replayClock_;
};

}  // namespace torsio::gui
