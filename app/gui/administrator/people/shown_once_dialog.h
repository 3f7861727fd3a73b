// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include <QDialog>
#include <QString>

#include "app/gui/widgets/data_table.h"

class QDialogButtonBox;
class QPushButton;

namespace torsio::gui {

/// Secrets that are told once, one a person, to be saved as cards to print. Does not close without a question
/// before they were taken. GUI thread.
class ShownOnceDialog : public QDialog {
  Q_OBJECT

 public:
  struct Words {
    QString title;
    QString said;      ///< above the table
    QString secret;    ///< title of the last column
    QString fileName;  ///< proposed
    QString question;  ///< before closing without having taken them
  };
  /// `rows`: person, sign-in name and secret. `write` makes the cards; it may throw Error{kFileUnwritable}.
  ShownOnceDialog(const Words& words, std::vector<Row> rows,
                  std::function<void(const std::filesystem::path&)> write, QWidget* parent);

  /// Throws Error{kFileUnwritable}.
  void saveCards(const std::filesystem::path& file);

 public Q_SLOTS:
  void reject() override;

 protected:
  [[nodiscard]] DataTable* table() const noexcept { return table_; }
  /// Another way to take them, beside the cards.
  void addWay(QPushButton* button);
  void noteTaken() noexcept { taken_ = true; }

 private:
  void askCards();

  Words words_;
  std::function<void(const std::filesystem::path&)> write_;
  DataTable* table_;
  QDialogButtonBox* buttons_;
  QPushButton* cards_;
  bool taken_ = false;
};

}  // namespace torsio::gui
