// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/gui/administrator/people/shown_once_dialog.h"
#include "app/services/access/first_run.h"

namespace torsio::gui {

/// Start passwords of new accounts.
class AccountsDialog : public ShownOnceDialog {
  Q_OBJECT

 public:
  /// `centre`: printed on the cards.
  AccountsDialog(const std::vector<StartAccount>& accounts, const std::string& centre, QWidget* parent);

 private:
  void writeCards(const std::filesystem::path& file) const override;

  std::vector<StartAccount> accounts_;
  std::string centre_;
};

}  // namespace torsio::gui
