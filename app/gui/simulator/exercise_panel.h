// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

#include <QWidget>

#include "app/gui/base/scene_titles.h"
#include "sim/scene/scene.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace torsio::gui {

class Card;

/// Choice of organ, pattern, model and target.
class ExercisePanel : public QWidget {
  Q_OBJECT

 public:
  explicit ExercisePanel(QWidget* parent = nullptr);

  /// Offers the scenes of this folder of assets.
  void setOrgans(const std::filesystem::path& assets);
  /// What is loaded now; emits nothing. `ownOrgan`: a mesh of the user's stands in for the shipped one.
  void showScene(const Scene& scene, double target_rad, bool ownOrgan);
  /// Says at which rate an asynchronous model answers, or that it does not (`late`). `rate_per_s`: 0
  /// before its first answer; none: the servo answers alone, and nothing is said.
  void showBeside(std::optional<double> rate_per_s, bool late);
  /// Off while a trial is recorded or replayed: the exercise must not change under it.
  void setChangeable(bool changeable);

  void retranslate();

 Q_SIGNALS:
  void organChosen(const QString& id);
  void patternChosen(const QString& id);
  void formulationChosen(torsio::Formulation formulation);
  /// An asynchronous model.
  void tissueChosen(torsio::TissueModel tissue);
  void targetChosen(double target_rad);

 private:
  /// Says the whole title of the chosen organ, and shows those of the lists.
  void nameChosen();

  SceneTitles titles_{std::filesystem::path()};
  Card* card_;
  QLabel* organLabel_;
  QLabel* patternLabel_;
  QLabel* formulationLabel_;
  QLabel* targetLabel_;
  QLabel* beside_;
  QComboBox* organ_;
  QComboBox* pattern_;
  QComboBox* formulation_;
  QDoubleSpinBox* target_;
};

}  // namespace torsio::gui
