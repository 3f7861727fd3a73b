// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/kiosk_cards_dialog.h"

#include "app/gui/base/translated_text.h"

namespace torsio::gui {

namespace {

std::vector<Row> kioskRows(const std::vector<KioskCardText>& cards) {
  std::vector<Row> rows;
  for (const KioskCardText& card : cards) {
    rows.push_back({toQString(card.login),
                    {{toQString(card.personCode)}, {toQString(card.login)}, {toQString(card.code)}}});
  }
  return rows;
}

}  // namespace

KioskCardsDialog::KioskCardsDialog(const std::vector<KioskCardText>& cards, const std::string& centre,
                                   QWidget* parent)
    : ShownOnceDialog(
          {.title = tr("Cards for the kiosk"),
           .said = tr("These codes are shown only now. Each opens a kiosk for its trainee; one that is lost "
                      "is revoked here, or replaced by making a new one."),
           .secret = tr("Code"),
           .fileName = tr("kiosk-cards.pdf"),
           .question = tr("No cards were saved, and these codes are not shown again. Close all the same?")},
          kioskRows(cards),
          [cards, centre](const std::filesystem::path& file) { writeKioskCards(cards, centre, file); },
          parent) {
  setObjectName(QStringLiteral("kioskCards"));
}

}  // namespace torsio::gui
