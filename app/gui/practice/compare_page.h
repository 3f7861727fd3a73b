// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "app/gui/base/page.h"
#include "app/gui/simulator/simulation_controller.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;
class QTabWidget;

namespace torsio::gui {

class Card;
class MarkerEditor;
class ModelComparison;

/// Models side by side under the same torque (paper section 4). Tabs: the paper's and Saint-Venant's
/// formulation, each with its angle, largest shear stress and computing time, both moved by one slider; twist
/// model, finite elements and springs (ModelComparison); the markers of this comparison. GUI thread.
class ComparePage : public Page {
  Q_OBJECT

 public:
  explicit ComparePage(ShellContext& shell, QWidget* parent = nullptr);

  void enter(const QVariant& argument) override;
  void retranslate() override;
  void applyTheme(const Theme& theme) override;
  /// Shows the tab of finite elements and springs, or of the markers; loads an organ the first time.
  void showModels();
  void showMarkers();
  /// Returns the comparison with finite elements and springs; created on first use.
  [[nodiscard]] ModelComparison& models();
  /// Returns the editor of its organ's markers; created on first use.
  [[nodiscard]] MarkerEditor& markers();
  /// Returns whether the models, which load in the background, are shown.
  [[nodiscard]] bool loaded() const noexcept { return sides_[0].scene.scene != nullptr; }
  /// Sets the torque on both models, N m.
  void setTorque(double torque_Nm);

 private:
  struct Side {
    Formulation formulation = Formulation::kPaper;
    LoadedScene scene;
    Card* card = nullptr;
    SceneView* view = nullptr;
    QLabel* angle = nullptr;
    QLabel* shear = nullptr;
    QLabel* time = nullptr;
    std::vector<double> times_us;
  };

  QWidget* createFormulations();
  void showTab(int index);
  void nameTabs();
  QWidget* createBar();
  QWidget* createSide(Side& side);
  void load(const QString& organ);
  void adopt(std::array<LoadedScene, 2> scenes);
  void apply();
  void show(Side& side);
  void captureFilmStrip();

  QTabWidget* tabs_;
  ModelComparison* models_ = nullptr;
  MarkerEditor* markers_ = nullptr;
  std::array<Side, 2> sides_;
  QLabel* organLabel_;
  QComboBox* organ_;
  QLabel* torqueLabel_;
  QSlider* torque_;
  QLabel* figure_;
  QPushButton* shearMap_;
  QPushButton* strip_;
  double top_Nm_ = 0.0;
  double torque_Nm_ = 0.0;
};

/// For all users who may practise.
[[nodiscard]] PageEntry comparePage();
[[nodiscard]] std::vector<ScreenEntry> compareScreens();

}  // namespace torsio::gui
