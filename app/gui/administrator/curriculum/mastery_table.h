// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QTableWidget>

#include "app/services/study/curriculum_content.h"
#include "assessment/domain/study/curriculum.h"

class QBoxLayout;
class QPushButton;

namespace torsio::gui {

/// Table of mastery rules, one row of fields per rule. It changes only its own copy of the rules, which the
/// editor takes after an edit. GUI thread.
class MasteryTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit MasteryTable(QWidget* parent = nullptr);

  /// Replaces the rules. Emits nothing.
  void setRules(const std::vector<MasteryCriterion>& rules);
  [[nodiscard]] const std::vector<MasteryCriterion>& rules() const noexcept { return rules_; }
  /// Enables or disables adding, changing and removing rules.
  void setEditable(bool editable);
  /// Creates the row of buttons that add and remove a rule; the caller places it. Call once.
  [[nodiscard]] QBoxLayout* buttons();
  void retranslate();

 Q_SIGNALS:
  void edited();

 private:
  void fill();
  void addFields(int row, const MasteryCriterion& rule);
  void nameFields(int row);
  void takeMetric(const QWidget* cell, const std::string& metric);
  void take(const QWidget* cell, const std::function<void(MasteryCriterion&)>& change);
  void addRule();
  void removeRule();
  void enableButtons();

  std::vector<MasteryCriterion> rules_;
  bool editable_ = true;
  QPushButton* add_;
  QPushButton* remove_;
};

}  // namespace torsio::gui
