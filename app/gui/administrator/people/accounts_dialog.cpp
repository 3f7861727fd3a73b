// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/accounts_dialog.h"

#include <utility>

#include "app/gui/administrator/base/printed_cards.h"
#include "app/gui/base/translated_text.h"

namespace torsio::gui {

AccountsDialog::AccountsDialog(const std::vector<StartAccount>& accounts, const std::string& centre,
                               QWidget* parent)
    : ShownOnceDialog(
          tr("Start passwords"),
          tr("These start passwords are shown only now. Give each to its owner, for example on a card in a "
             "sealed envelope. Everybody chooses their own password at the first sign-in."),
          tr("start-passwords.pdf"), parent),
      accounts_(accounts),
      centre_(centre) {
  std::vector<Row> rows;
  for (const StartAccount& account : accounts_) {
    rows.push_back(
        {toQString(account.login),
         {{toQString(account.personCode)}, {toQString(account.login)}, {toQString(account.startPassword)}}});
  }
  setLines({{tr("Person")}, {tr("Sign-in name")}, {tr("Start password")}}, std::move(rows));
}

void AccountsDialog::writeCards(const std::filesystem::path& file) const {
  writeAccountCards(accounts_, centre_, file);
}

}  // namespace torsio::gui
