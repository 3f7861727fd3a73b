// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "app/gui/base/page.h"
#include "app/services/maintenance/record_restore.h"
#include "sim/core/error.h"

class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace torsio::gui {

class Card;
class FieldChecks;
class PageHeading;

/// Replaces the record by a backup, in three steps one below the other: file and its verification; what is
/// lost and kept, in numbers; confirmation by a typed word. Afterwards the program returns to sign-in.
class RestorePage : public Page {
  Q_OBJECT

 public:
  explicit RestorePage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

 private:
  void layOut();
  void choose();
  void check();
  void restore();
  void askSecond();
  void fileChanged();
  void showPlan();
  void showButtons();
  /// Returns the word to type; for another centre's backup, that centre's name.
  [[nodiscard]] QString wantedWord() const;
  void nameWord();

  std::optional<RestorePlan> plan_;
  PageHeading* heading_;
  QPushButton* back_;
  Card* backup_;
  QLabel* backupText_;
  QLabel* fileLabel_;
  QLineEdit* file_;
  QPushButton* choose_;
  QPushButton* check_;
  Card* compare_;
  QGridLayout* numbers_ = nullptr;
  QLabel* loss_;
  Card* confirm_;
  QLabel* confirmText_;
  QLabel* wordLabel_;
  QLineEdit* word_;
  QPushButton* restore_;
  FieldChecks* checks_;
  std::optional<Error> unusable_;  ///< error of the file
};

}  // namespace torsio::gui
