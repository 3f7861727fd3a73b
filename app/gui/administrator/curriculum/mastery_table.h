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

/// The rules by which an exercise is mastered: a row of fields a rule. It writes nothing but its own copy of
/// the rules, which the editor takes when they were edited. GUI thread.
class MasteryTable : public QTableWidget {
  Q_OBJECT

 public:
  explicit MasteryTable(QWidget* parent = nullptr);

  /// Shows these rules in place of those before. Emits nothing.
  void setRules(const std::vector<MasteryCriterion>& rules);
  [[nodiscard]] const std::vector<MasteryCriterion>& rules() const noexcept { return rules_; }
  /// Lets rules be added, changed and removed, or not.
  void setEditable(bool editable);
  /// The buttons that add and remove a rule, in a row; the caller puts it somewhere, once.
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
