// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "app/gui/administrator/base/printed_cards.h"
#include "app/gui/administrator/people/shown_once_dialog.h"

namespace torsio::gui {

/// The codes for the kiosk that were just made, to print as cards.
class KioskCardsDialog : public ShownOnceDialog {
  Q_OBJECT

 public:
  KioskCardsDialog(const std::vector<KioskCardText>& cards, const std::string& centre, QWidget* parent);
};

}  // namespace torsio::gui
