// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/kiosk_cards_dialog.h"

#include <utility>

#include "app/gui/base/translated_text.h"

namespace torsio::gui {

KioskCardsDialog::KioskCardsDialog(std::vector<KioskCardText> cards, std::string centre, QWidget* parent)
    : ShownOnceDialog(tr("Cards for the kiosk"),
                      tr("These codes are shown only now. Each opens a kiosk for its trainee; one that is "
                         "lost is revoked "
                         "here, or replaced by making a new one."),
                      tr("kiosk-cards.pdf"), parent),
      cards_(std::move(cards)),
      centre_(std::move(centre)) {
  setObjectName(QStringLiteral("kioskCards"));
  std::vector<Row> rows;
  for (const KioskCardText& card : cards_) {
    rows.push_back({toQString(card.login),
                    {{toQString(card.personCode)}, {toQString(card.login)}, {toQString(card.code)}}});
  }
  setLines({{tr("Person")}, {tr("Sign-in name")}, {tr("Code")}}, std::move(rows));
}

void KioskCardsDialog::writeCards(const std::filesystem::path& file) const {
  writeKioskCards(cards_, centre_, file);
}

}  // namespace torsio::gui
