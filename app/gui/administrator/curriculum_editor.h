// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include <QTabWidget>

#include "app/study/curriculum_content.h"

class QCheckBox;
class QDoubleSpinBox;
class QLabel;
class QListWidget;

namespace torsio::gui {

class ExerciseEditor;
class GroupEditor;

/// The parts of a curriculum to fill in: exercises with targets and mastery, groups with phases and rest,
/// scoring points, and in words what still keeps it from being published. What is shown and not touched comes
/// out as it went in.
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
  static constexpr std::size_t kPoints = 3;  // pre, mid, post

  QWidget* pointsTab();
  void fillPoints();
  void takePoint(std::size_t point);
  void changed();
  void judge();

  std::filesystem::path assets_;
  StoredCurriculumVersion content_;
  std::vector<CurriculumProblem> problems_;
  bool filling_ = false;

  ExerciseEditor* exercises_;
  GroupEditor* groups_;
  QLabel* pointsText_;
  std::array<QCheckBox*, kPoints> wanted_{};
  std::array<QDoubleSpinBox*, kPoints> after_{};
  QListWidget* problemList_;
};

}  // namespace torsio::gui
