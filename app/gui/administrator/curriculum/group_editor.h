// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <QWidget>

#include "app/gui/administrator/base/ordered_list.h"
#include "app/gui/administrator/curriculum/curriculum_parts.h"
#include "app/services/study/curriculum_content.h"
#include "assessment/domain/study/curriculum.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QTableWidget;

namespace torsio::gui {

/// Editor of a study's groups: their ordered timed phases on the simulator or the real arm, and the rest
/// allowed. A field writes only what it shows: opening changes nothing.
class GroupEditor : public QWidget {
  Q_OBJECT

 public:
  /// `content` must outlive this.
  explicit GroupEditor(CurriculumVersion& content, QWidget* parent = nullptr);

  /// Refills the fields after the content or its exercises changed.
  void fill();
  void select(int row);
  /// Makes everything read-only.
  void setReadOnly(bool readOnly);
  void retranslate();
  /// Shows the errors of the chosen group beside its fields.
  void showProblems(const std::vector<CurriculumProblem>& problems);

 Q_SIGNALS:
  void edited();

 private:
  QWidget* form();
  void showContent();
  void showHints();
  void showPhases(const StudyArm& arm, int current);
  void addPhaseRow(int row, const TrainingPhase& phase);
  void showTotals(const StudyArm& arm);
  void take(const std::function<void(StudyArm&)>& change);
  void takePhase(const QWidget* cell, const std::function<void(TrainingPhase&)>& change);
  void takeCode();
  void add();
  void remove();
  void move(int by);
  void showOrder(std::optional<int> row);
  void addPhase();
  void removePhase();
  void movePhase(int by);
  [[nodiscard]] StudyArm* group();
  [[nodiscard]] QStringList lines() const;

  CurriculumVersion& content_;
  bool filling_ = false;
  bool readOnly_ = false;
  FormTexts texts_;
  FieldHints hints_;
  std::vector<CurriculumProblem> problems_;

  CodeField code_;
  OrderedList* list_ = nullptr;
  QLineEdit* label_;
  QDoubleSpinBox* rest_;
  QCheckBox* splittable_;
  QTableWidget* phases_;
  QLabel* totals_;
  QPushButton* addPhase_;
  QPushButton* removePhase_;
  QPushButton* phaseUp_;
  QPushButton* phaseDown_;
};

}  // namespace torsio::gui
