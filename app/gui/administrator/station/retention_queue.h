// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QString>
#include <QWidget>

#include "app/services/maintenance/retention.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/retention.h"

class QLabel;
class QPushButton;
class QWidget;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// Records due for review; a decision applies to all selected people.
class RetentionQueue : public QWidget {
  Q_OBJECT

 public:
  RetentionQueue(ShellContext& shell, QWidget* parent);

  /// Rereads the queue, if the actor may. Throws Error.
  void read();
  void retranslate();

 private:
  void showRows();
  void showButtons();
  void changeRules();
  void keepLonger();
  void lock();
  void erase();
  /// Returns the selected people who are held, or who are not.
  [[nodiscard]] std::vector<const RetentionItem*> chosen(bool held) const;
  [[nodiscard]] std::vector<const RetentionItem*> chosen() const;

  ShellContext& shell_;
  std::vector<RetentionItem> due_;
  QLabel* title_;
  DataTable* table_;
  QPushButton* keep_;
  QPushButton* lock_;
  QPushButton* erase_;
  QPushButton* rules_;
};

/// Names a category of records in the user's language; the code of an unknown one.
[[nodiscard]] QString retentionCategoryName(const std::string& code);

/// An administrator's changes to the retention rules.
struct RetentionRulesEdit {
  std::vector<RetentionRule> set{};    ///< new or changed
  std::vector<std::string> removed{};  ///< categories now kept without limit
};
/// Asks for retention period and lawful basis of each category. Object names of fields: "trainee" (enabled),
/// "trainee.days", "trainee.basis". Empty: cancelled.
[[nodiscard]] std::optional<RetentionRulesEdit> askRetentionRules(QWidget* parent,
                                                                  const std::vector<RetentionRule>& rules);

}  // namespace torsio::gui
