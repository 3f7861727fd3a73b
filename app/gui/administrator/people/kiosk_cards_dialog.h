// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/gui/administrator/base/printed_cards.h"
#include "app/gui/administrator/people/shown_once_dialog.h"

namespace torsio::gui {

/// Codes of new kiosk cards.
class KioskCardsDialog : public ShownOnceDialog {
  Q_OBJECT

 public:
  KioskCardsDialog(std::vector<KioskCardText> cards, std::string centre, QWidget* parent);

 private:
  void writeCards(const std::filesystem::path& file) const override;

  std::vector<KioskCardText> cards_;
  std::string centre_;
};

}  // namespace torsio::gui
