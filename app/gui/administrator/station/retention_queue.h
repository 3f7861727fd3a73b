// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QWidget>

#include "app/services/maintenance/retention.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/retention.h"

class QLabel;
class QPushButton;

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

}  // namespace torsio::gui
