// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/accounts_dialog.h"

#include <QApplication>
#include <QClipboard>
#include <QPushButton>
#include <QTableView>

#include "app/gui/administrator/base/printed_cards.h"
#include "app/gui/base/translated_text.h"

namespace torsio::gui {

namespace {

std::vector<Row> accountRows(const std::vector<StartAccount>& accounts) {
  std::vector<Row> rows;
  for (const StartAccount& account : accounts) {
    rows.push_back(
        {toQString(account.login),
         {{toQString(account.personCode)}, {toQString(account.login)}, {toQString(account.startPassword)}}});
  }
  return rows;
}

}  // namespace

AccountsDialog::AccountsDialog(const std::vector<StartAccount>& accounts, const std::string& centre,
                               QWidget* parent)
    : ShownOnceDialog(
          {.title = tr("Start passwords"),
           .said = tr("These start passwords are shown only now. Hand each to its person, on a card in a "
                      "closed envelope for example. At the first sign-in everybody chooses a password of "
                      "their own."),
           .secret = tr("Start password"),
           .fileName = tr("start-passwords.pdf"),
           .question = tr("Nothing was copied or saved, and these passwords are not shown again. Close all "
                          "the same?")},
          accountRows(accounts),
          [accounts, centre](const std::filesystem::path& file) {
            writeAccountCards(accounts, centre, file);
          },
          parent),
      copy_(new QPushButton(tr("&Copy"), this)) {
  addWay(copy_);
  connect(copy_, &QPushButton::clicked, this, &AccountsDialog::copy);
}

void AccountsDialog::copy() {
  table()->view().clearSelection();
  QApplication::clipboard()->setText(table()->asText());
  copy_->setText(tr("Copied"));
  noteTaken();
}

}  // namespace torsio::gui
