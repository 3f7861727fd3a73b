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

/// Puts a backup in the place of the record, in three steps one below the other: the file, which is verified;
/// what is lost and what is kept, in numbers; a typed word. Then the program goes back to sign-in.
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
  /// What has to be typed: for the backup of another centre that centre's name.
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
  std::optional<Error> unusable_;  ///< what is wrong with the file
};

}  // namespace torsio::gui
