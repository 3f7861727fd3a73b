// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QDialog>

#include "assessment/domain/people/retention.h"

class QPushButton;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// Requests of people about their own records, and the answers. GUI thread.
class PersonRequestsDialog : public QDialog {
  Q_OBJECT

 public:
  PersonRequestsDialog(ShellContext& shell, QWidget* parent);

  /// Returns the person to show in the roster; empty: none.
  [[nodiscard]] const PersonId& person() const noexcept { return person_; }

 private:
  void read();
  void showButtons();
  void answer(bool done);
  [[nodiscard]] const PersonRequest* current() const;
  /// Returns the selected unanswered requests.
  [[nodiscard]] std::vector<const PersonRequest*> waiting() const;

  ShellContext& shell_;
  PersonId person_;
  std::vector<PersonRequest> requests_;
  DataTable* table_;
  QPushButton* goTo_;
  QPushButton* done_;
  QPushButton* decline_;
};

}  // namespace torsio::gui
