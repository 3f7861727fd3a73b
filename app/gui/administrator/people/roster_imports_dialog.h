// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDialog>

#include "app/services/people/roster_undo.h"

class QPushButton;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// Imported rosters; wrong imports can be undone. GUI thread.
class RosterImportsDialog : public QDialog {
  Q_OBJECT

 public:
  RosterImportsDialog(ShellContext& shell, QWidget* parent);

 private:
  void read();
  void showButtons();
  void takeBack();
  [[nodiscard]] QString stateText(const ImportedRoster& one) const;
  /// Returns the selected imports that have not been undone.
  [[nodiscard]] std::vector<const ImportedRoster*> chosen() const;

  ShellContext& shell_;
  std::vector<ImportedRoster> imports_;
  DataTable* table_;
  QPushButton* takeBack_;
};

}  // namespace torsio::gui
