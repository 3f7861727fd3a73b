// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/kiosk_cards_dialog.h"

#include <utility>

#include <QDialogButtonBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "sim/base/error.h"

namespace torsio::gui {

KioskCardsDialog::KioskCardsDialog(std::vector<KioskCardText> cards, std::string centre, QWidget* parent)
    : QDialog(parent),
      cards_(std::move(cards)),
      centre_(std::move(centre)),
      save_(new QPushButton(tr("Save &cards (PDF)\u2026"), this)) {
  setObjectName(QStringLiteral("kioskCards"));
  setWindowTitle(tr("Cards for the kiosk"));
  resize(640, 480);
  QLabel* words = sentence(this);
  words->setText(
      tr("These codes are shown only now. Each opens a kiosk for its trainee; one that is lost is revoked "
         "here, or replaced by making a new one."));
  auto* table = new DataTable(QString(), this);
  table->setColumns({{tr("Person")}, {tr("Sign-in name")}, {tr("Code")}});
  std::vector<Row> rows;
  for (const KioskCardText& card : cards_) {
    rows.push_back({toQString(card.login),
                    {{toQString(card.personCode)}, {toQString(card.login)}, {toQString(card.code)}}});
  }
  table->setRows(std::move(rows));
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(save_, QDialogButtonBox::ActionRole);
  buttons->addButton(tr("Done"), QDialogButtonBox::RejectRole)->setAutoDefault(false);
  save_->setDefault(true);
  save_->setFocus();
  connect(save_, &QPushButton::clicked, this, &KioskCardsDialog::askCards);
  connect(buttons, &QDialogButtonBox::rejected, this, &KioskCardsDialog::reject);
  QVBoxLayout* column = pageColumn(this);
  column->setSpacing(kSpace);
  column->addWidget(words);
  column->addWidget(table, 1);
  column->addWidget(buttons);
}

void KioskCardsDialog::saveCards(const std::filesystem::path& file) {
  writeKioskCards(cards_, centre_, file);
  save_->setText(tr("Cards saved"));
  taken_ = true;
}

void KioskCardsDialog::askCards() {
  const QString file = askFileToSave(this, tr("Save cards"), tr("kiosk-cards.pdf"), tr("PDF (*.pdf)"));
  if (file.isEmpty()) {
    return;
  }
  try {
    saveCards(toPath(file));
  } catch (const Error& error) {
    QMessageBox::warning(this, tr("Save cards"), translatedLine(error));
  }
}

void KioskCardsDialog::reject() {
  if (!taken_ && QMessageBox::question(this, windowTitle(),
                                       tr("No cards were saved, and these codes are not shown again. Close "
                                          "all the same?")) != QMessageBox::Yes) {
    return;
  }
  QDialog::reject();
}

}  // namespace torsio::gui
