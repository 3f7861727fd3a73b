// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDialog>

#include "app/services/recording/competence_service.h"
#include "assessment/domain/ids.h"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QPlainTextEdit;

namespace torsio::gui {

class ShellContext;

/// Competence rules of the exercises of a published version: shows the present design, previews both error
/// rates of another one, and registers it. GUI thread.
class CompetenceDialog : public QDialog {
  Q_OBJECT

 public:
  /// Reads the designs. Throws Error, DbError.
  CompetenceDialog(ShellContext& shell, const CurriculumVersionId& versionId, QWidget* parent);

  /// Sets the tolerance from the people of the chosen cohort.
  bool takeFromExperts();
  /// Stores the previewed design as the next version for the chosen exercise.
  bool registerDesign();
  /// Excuses the chosen interrupted run with the reason entered.
  bool excuseChosenRun();

 private:
  void build();
  void read();
  void showExercise();
  void showPreview();
  void showInterrupted();
  [[nodiscard]] const ExerciseDesigns* chosen() const;
  [[nodiscard]] CompetenceDesign entered() const;

  ShellContext& shell_;
  CurriculumVersionId versionId_;
  std::vector<ExerciseDesigns> exercises_;
  std::int64_t experts_ = 0;          // number of experts behind the tolerance entered
  EstimatedDependence dependence_{};  // of the exercise's runs
  bool filling_ = false;
  QComboBox* exercise_;
  QLabel* inForce_;
  QComboBox* source_;
  QDoubleSpinBox* tolerance_;
  QComboBox* cohort_;
  QPushButton* take_;
  QLabel* standard_;
  QDoubleSpinBox* adequate_;
  QDoubleSpinBox* inadequate_;
  QSpinBox* attempts_;
  QDoubleSpinBox* falsePass_;
  QDoubleSpinBox* falseFail_;
  QLineEdit* reason_;
  QSpinBox* validDays_;
  QLabel* preview_;
  QComboBox* interrupted_;
  QLineEdit* excuse_;
  QPushButton* excuseRun_;
  QHBoxLayout* excuseRow_;
  QFormLayout* form_;
  QPushButton* register_ = nullptr;
};

/// Standard setting: calculates the cut score from a pasted table of judges or scores at once (like torsio
/// standard-setting). Stores nothing. GUI thread.
class StandardDialog : public QDialog {
  Q_OBJECT

 public:
  explicit StandardDialog(QWidget* parent);

 private:
  void showMethod();
  void showAnswer();
  void readAnswer();

  QComboBox* method_;
  QLabel* asks_;
  QPlainTextEdit* table_;
  QDoubleSpinBox* borderline_;
  QLabel* answer_;
  QFormLayout* form_;
};

}  // namespace torsio::gui
