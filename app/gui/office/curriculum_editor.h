// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <QTabWidget>

#include "app/session/study/curriculum_content.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QSpinBox;
class QTableWidget;

namespace torsio::gui {

/// The parts of a curriculum to fill in: exercises with targets and mastery, groups with phases and rest,
/// scoring points, and in words what still keeps it from being published.
class CurriculumEditor : public QTabWidget {
  Q_OBJECT

 public:
  CurriculumEditor(std::filesystem::path assets, QWidget* parent = nullptr);

  void setContent(const StoredCurriculumVersion& content);
  [[nodiscard]] const StoredCurriculumVersion& content() const noexcept { return content_; }
  [[nodiscard]] const std::vector<CurriculumProblem>& problems() const noexcept { return problems_; }
  void setReadOnly(bool readOnly);
  void retranslate();

 Q_SIGNALS:
  void edited();

 private:
  QWidget* exercisesTab();
  QWidget* groupsTab();
  QWidget* pointsTab();
  void fillExercises();
  void showExercise();
  void takeExercise();
  void fillGroups();
  void showGroup();
  void takeGroup();
  void fillPoints();
  void takePoints();
  void addExercise();
  void removeExercise();
  void addPhase();
  void removePhase();
  void changed();
  void judge();
  [[nodiscard]] StoredModule* exercise();
  [[nodiscard]] StoredArm* group();
  QLabel* label(QFormLayout* form, QWidget* field);

  std::filesystem::path assets_;
  StoredCurriculumVersion content_;
  std::vector<CurriculumProblem> problems_;
  bool filling_ = false;
  std::vector<QLabel*> labels_;  // in the order in which retranslate() names them

  QListWidget* exercises_;
  QPushButton* addExercise_;
  QPushButton* removeExercise_;
  QLineEdit* title_;
  QComboBox* scene_;
  QComboBox* pattern_;
  QComboBox* kind_;
  QComboBox* mode_;
  QDoubleSpinBox* target_;
  QDoubleSpinBox* tolerance_;
  QDoubleSpinBox* hold_;
  QSpinBox* attempts_;
  QComboBox* after_;
  QComboBox* metric_;
  QDoubleSpinBox* threshold_;
  QSpinBox* consecutive_;

  QListWidget* groups_;
  QLineEdit* groupLabel_;
  QDoubleSpinBox* rest_;
  QCheckBox* splittable_;
  QTableWidget* phases_;
  QPushButton* addPhase_;
  QPushButton* removePhase_;

  QTableWidget* points_;
  QListWidget* problemList_;
};

}  // namespace torsio::gui
