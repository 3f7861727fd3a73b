// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include <QTabWidget>

#include "app/services/study/curriculum_content.h"
#include "assessment/domain/study/curriculum.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QGridLayout;
class QListWidget;
class QPushButton;

namespace torsio::gui {

class ExerciseEditor;
class GroupEditor;

/// Editor of a curriculum: exercises with targets and mastery, groups with phases and rest, occasions, and
/// what still prevents publication. Content that is not edited is returned unchanged.
class CurriculumEditor : public QTabWidget {
  Q_OBJECT

 public:
  CurriculumEditor(std::filesystem::path assets, QWidget* parent = nullptr);

  /// Sets the occasions to offer; call before setContent().
  void setOccasions(Occasions occasions);
  void setContent(const CurriculumVersion& content);
  [[nodiscard]] const CurriculumVersion& content() const noexcept { return content_; }
  [[nodiscard]] const std::vector<CurriculumProblem>& problems() const noexcept { return problems_; }
  void setReadOnly(bool readOnly);
  void retranslate();

 Q_SIGNALS:
  void edited();
  /// The user wants an occasion that does not exist yet.
  void occasionWanted();

 private:
  struct PointRow {
    QCheckBox* wanted;
    QDoubleSpinBox* after;
    QLabel* hint;  // error message
  };

  QWidget* pointsTab();
  void fillPoints();
  void addPointRow(std::size_t point);
  void takePoint(std::size_t point);
  void namePoints();
  void changed();
  void judge();
  void showHints();

  std::filesystem::path assets_;
  Occasions occasions_;
  CurriculumVersion content_;
  std::vector<CurriculumProblem> problems_;
  bool filling_ = false;

  ExerciseEditor* exercises_;
  GroupEditor* groups_;
  QLabel* pointsText_;
  QGridLayout* pointGrid_ = nullptr;
  std::vector<PointRow> points_;  // one per occasion
  QPushButton* addOccasion_;
  QListWidget* problemList_;
};

}  // namespace torsio::gui
