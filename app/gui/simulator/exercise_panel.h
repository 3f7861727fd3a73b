// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <QToolButton>
#include <QWidget>

#include "app/gui/base/scene_titles.h"
#include "sim/core/text.h"
#include "sim/scene/scene.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace torsio::gui {

class Card;

/// Selection of organ, pattern, model and target.
class ExercisePanel : public QWidget {
  Q_OBJECT

 public:
  explicit ExercisePanel(QWidget* parent = nullptr);

  /// Lists the scenes of this assets folder.
  void setOrgans(const std::filesystem::path& assets);
  /// Shows what is loaded; emits nothing. `ownOrgan`: a user's mesh replaces the shipped one.
  void showScene(const Scene& scene, double target_rad, bool ownOrgan);
  /// Shows the rate of an asynchronous model, or that it does not respond (`late`). `rate_per_s`: 0 before
  /// its first response; empty: no such model, shows nothing.
  void showBeside(std::optional<double> rate_per_s, bool late);
  /// Disabled while a trial is recorded or replayed, because the exercise must not change.
  void setChangeable(bool changeable);

  void retranslate();

 Q_SIGNALS:
  void organChosen(const QString& id);
  void patternChosen(const QString& id);
  void formulationChosen(torsio::Formulation formulation);
  /// An asynchronous model was chosen.
  void tissueChosen(torsio::TissueModel tissue);
  void targetChosen(double target_rad);

 private:
  /// Shows the full title of the chosen organ, and the tool tips of the lists.
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

/// A "?" beside a scene's title: shows what is measured, sourced and assumed in an untwisting, and which
/// limits of the law of the wall it is beyond as it comes. Hidden for other scenes.
class ValidityButton : public QToolButton {
  Q_OBJECT

 public:
  explicit ValidityButton(QWidget* parent = nullptr);

  /// Takes the text of a scene; null: none.
  void setScene(const Scene* scene);
  void retranslate();

 private:
  void tell();

  std::string words_;  // as in the scene file
  Text checked_;
};

}  // namespace torsio::gui
