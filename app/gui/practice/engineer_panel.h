// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "sim/scene/model_choice.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QToolButton;

namespace torsio::gui {

class Card;

/// Switches of the twist model's parts, named after the paper's equations: for engineers, in free practice
/// only. Initially folded. Disables what the present formulation does not have. GUI thread.
class EngineerPanel : public QWidget {
  Q_OBJECT

 public:
  explicit EngineerPanel(QWidget* parent = nullptr);

  /// Shows the model of the organ on view; emits nothing. `built`: its options, from scene or engineer;
  /// `chosen`: an engineer chose them.
  void showModel(const TwistModelOptions& options, const Material& material, const ModelChoice& built,
                 bool chosen);
  /// Returns the input.
  [[nodiscard]] ModelChoice choice() const;
  void setFolded(bool folded);
  /// Disabled while a trial is recorded or replayed.
  void setChangeable(bool changeable);
  void retranslate();

 Q_SIGNALS:
  /// The organ is to be rebuilt with this model.
  void chosen(const torsio::ModelChoice& choice);

 private:
  QWidget* createFields();
  void noteChange();

  Card* card_;
  QToolButton* head_;
  QWidget* body_ = nullptr;
  QLabel* hint_ = nullptr;
  QLabel* state_ = nullptr;
  QLabel* modulusLabel_ = nullptr;
  QDoubleSpinBox* modulus_ = nullptr;
  QLabel* driftLabel_ = nullptr;
  QComboBox* drift_ = nullptr;
  QLabel* interpolationLabel_ = nullptr;
  QComboBox* interpolation_ = nullptr;
  QLabel* betaLabel_ = nullptr;
  QDoubleSpinBox* beta_ = nullptr;
  QCheckBox* clampLift_ = nullptr;
  QCheckBox* poynting_ = nullptr;
  QCheckBox* restrainedEnds_ = nullptr;
  QCheckBox* taper_ = nullptr;
  QCheckBox* shearCentre_ = nullptr;
  QLabel* foundationLabel_ = nullptr;
  QDoubleSpinBox* foundation_ = nullptr;
  QLabel* stiffeningLabel_ = nullptr;
  QDoubleSpinBox* stiffening_ = nullptr;
  QPushButton* apply_ = nullptr;
  QPushButton* reset_ = nullptr;
  std::vector<QWidget*> ofPaper_;
  std::vector<QWidget*> ofSaintVenant_;
  Formulation formulation_ = Formulation::kSaintVenant;
  ModelChoice shown_;
  bool chosen_ = false;  // by an engineer, not the scene
};

}  // namespace torsio::gui
