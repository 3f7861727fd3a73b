// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDialog>

#include "app/services/people/roster_undo.h"

class QPushButton;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// The rosters that were imported; a wrong one is taken back. GUI thread.
class RosterImportsDialog : public QDialog {
  Q_OBJECT

 public:
  RosterImportsDialog(ShellContext& shell, QWidget* parent);

 private:
  void read();
  void showButtons();
  void takeBack();
  [[nodiscard]] QString stateText(const ImportedRoster& one) const;
  /// Of the chosen ones those that are not taken back yet.
  [[nodiscard]] std::vector<const ImportedRoster*> chosen() const;

  ShellContext& shell_;
  std::vector<ImportedRoster> imports_;
  DataTable* table_;
  QPushButton* takeBack_;
};

}  // namespace torsio::gui
