// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/accounts_dialog.h"

#include <utility>

#include <QApplication>
#include <QClipboard>
#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/printed_cards.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/theme.h"
#include "sim/base/error.h"

namespace torsio::gui {

AccountsDialog::AccountsDialog(const std::vector<StartAccount>& accounts, const std::string& centre,
                               QWidget* parent)
    : QDialog(parent),
      accounts_(accounts),
      centre_(centre),
      table_(new DataTable(QString(), this)),
      copy_(new QPushButton(tr("&Copy"), this)),
      cards_(new QPushButton(tr("Save &cards (PDF)\u2026"), this)) {
  setWindowTitle(tr("Start passwords"));
  resize(640, 520);
  auto* words = new QLabel(
      tr("These start passwords are shown only now. Hand each to its person, on a card in a closed "
         "envelope for example. At the first sign-in everybody chooses a password of their own."),
      this);
  words->setWordWrap(true);
  table_->setColumns({{tr("Person")}, {tr("Sign-in name")}, {tr("Start password")}});
  std::vector<Row> rows;
  for (const StartAccount& account : accounts_) {
    rows.push_back(
        {toQString(account.login),
         {{toQString(account.personCode)}, {toQString(account.login)}, {toQString(account.startPassword)}}});
  }
  table_->setRows(std::move(rows));
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(cards_, QDialogButtonBox::ActionRole);
  buttons->addButton(copy_, QDialogButtonBox::ActionRole);
  buttons->addButton(tr("Done"), QDialogButtonBox::RejectRole)->setAutoDefault(false);
  cards_->setDefault(true);
  cards_->setFocus();
  connect(cards_, &QPushButton::clicked, this, &AccountsDialog::askCards);
  connect(copy_, &QPushButton::clicked, this, &AccountsDialog::copy);
  connect(buttons, &QDialogButtonBox::rejected, this, &AccountsDialog::reject);
  QVBoxLayout* column = pageColumn(this);
  column->setSpacing(kSpace);
  column->addWidget(words);
  column->addWidget(table_, 1);
  column->addWidget(buttons);
}

void AccountsDialog::copy() {
  table_->view().clearSelection();
  QApplication::clipboard()->setText(table_->asText());
  copy_->setText(tr("Copied"));
  taken_ = true;
}

void AccountsDialog::saveCards(const std::filesystem::path& file) {
  writeAccountCards(accounts_, centre_, file);
  cards_->setText(tr("Cards saved"));
  taken_ = true;
}

void AccountsDialog::askCards() {
  const QString file = askFileToSave(this, tr("Save cards"), tr("start-passwords.pdf"), tr("PDF (*.pdf)"));
  if (file.isEmpty()) {
    return;
  }
  try {
    saveCards(toPath(file));
  } catch (const Error& error) {
    QMessageBox::warning(this, tr("Save cards"), translatedLine(error));
  }
}

void AccountsDialog::reject() {
  if (!taken_ && QMessageBox::question(this, windowTitle(),
                                       tr("Nothing was copied or saved, and these passwords are not shown "
                                          "again. Close all the same?")) != QMessageBox::Yes) {
    return;
  }
  QDialog::reject();
}

}  // namespace torsio::gui
