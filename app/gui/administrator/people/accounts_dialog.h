// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/access/first_run.h"
#include "app/gui/administrator/people/shown_once_dialog.h"

namespace torsio::gui {

/// The start passwords of new accounts: to be copied, or saved as cards to print.
class AccountsDialog : public ShownOnceDialog {
  Q_OBJECT

 public:
  /// `centre` stands on the cards.
  AccountsDialog(const std::vector<StartAccount>& accounts, const std::string& centre, QWidget* parent);

  void copy();

 private:
  QPushButton* copy_;
};

}  // namespace torsio::gui
