// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <QDialog>

#include "app/gui/administrator/base/printed_cards.h"

class QPushButton;

namespace torsio::gui {

class DataTable;

/// The codes that were just made, to print as cards; they are not shown again. GUI thread.
class KioskCardsDialog : public QDialog {
  Q_OBJECT

 public:
  KioskCardsDialog(std::vector<KioskCardText> cards, std::string centre, QWidget* parent);

  /// Throws Error{kFileUnwritable}.
  void saveCards(const std::filesystem::path& file);

 public Q_SLOTS:
  void reject() override;

 private:
  void askCards();

  std::vector<KioskCardText> cards_;
  std::string centre_;
  QPushButton* save_;
  bool taken_ = false;
};

}  // namespace torsio::gui
