// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include <QWidget>

#include "app/gui/administrator/base/ordered_list.h"
#include "app/gui/administrator/curriculum/curriculum_parts.h"
#include "app/services/study/curriculum_content.h"
#include "assessment/domain/study/curriculum.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QListWidgetItem;
class QSpinBox;

namespace torsio::gui {

class MasteryTable;

/// Editor of a curriculum's ordered exercises: organ and target angle, limits, prerequisites, and mastery
/// rules. A field writes only what it shows: opening changes nothing.
class ExerciseEditor : public QWidget {
  Q_OBJECT

 public:
  /// `content` must outlive this.
  ExerciseEditor(std::filesystem::path assets, CurriculumVersion& content, QWidget* parent = nullptr);

  void select(int row);
  /// Makes everything read-only.
  void setReadOnly(bool readOnly);
  void retranslate();
  /// Shows the errors of the chosen exercise beside its fields.
  void showProblems(const std::vector<CurriculumProblem>& problems);

 Q_SIGNALS:
  void edited();

 private:
  QWidget* form();
  void connectFields();
  void connectLists();
  void showContent();
  void showHints();
  void showPlaces(const TrainingModule& module);
  void showPrerequisites(const TrainingModule& module);
  void take(const std::function<void(TrainingModule&)>& change);
  void takeCode();
  void takeScene();
  void takePrerequisite(const QListWidgetItem* item);
  void add();
  void remove();
  void move(int by);
  void showOrder(std::optional<int> row);
  [[nodiscard]] TrainingModule* exercise();
  [[nodiscard]] QStringList lines() const;

  std::filesystem::path assets_;
  CurriculumVersion& content_;
  bool filling_ = false;
  bool readOnly_ = false;
  FormTexts texts_;
  FieldHints hints_;
  std::vector<CurriculumProblem> problems_;

  CodeField code_;
  OrderedList* list_ = nullptr;
  QLineEdit* title_;
  QComboBox* scene_;
  QComboBox* pattern_;
  QComboBox* mode_;
  QDoubleSpinBox* target_;
  QDoubleSpinBox* tolerance_;
  QDoubleSpinBox* hold_;
  QSpinBox* twists_;
  QDoubleSpinBox* force_;
  QDoubleSpinBox* torque_;
  QSpinBox* attempts_;
  QListWidget* after_;
  MasteryTable* mastery_;
};

}  // namespace torsio::gui
