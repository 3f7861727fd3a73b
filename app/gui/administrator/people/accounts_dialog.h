// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <QDialog>

#include "app/access/first_run.h"

class QPushButton;

namespace torsio::gui {

class DataTable;

/// The start passwords of new accounts, which are told once: to be copied, or saved as cards to print. Does
/// not close without a question before one of the two was done.
class AccountsDialog : public QDialog {
  Q_OBJECT

 public:
  /// `centre` stands on the cards.
  AccountsDialog(const std::vector<StartAccount>& accounts, const std::string& centre, QWidget* parent);

  /// Throws Error{kFileUnwritable}.
  void saveCards(const std::filesystem::path& file);
  void copy();
  void reject() override;

 private:
  void askCards();

  std::vector<StartAccount> accounts_;
  std::string centre_;
  DataTable* table_;
  QPushButton* copy_;
  QPushButton* cards_;
  bool taken_ = false;
};

}  // namespace torsio::gui
