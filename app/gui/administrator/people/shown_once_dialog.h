// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include <QDialog>
#include <QString>

#include "app/gui/widgets/data_table.h"

class QPushButton;

namespace torsio::gui {

/// Secrets shown once, one row per person, to copy or to save as cards. Asks before closing if neither was
/// done. GUI thread.
class ShownOnceDialog : public QDialog {
  Q_OBJECT

 public:
  /// Throws Error{kFileUnwritable}.
  void saveCards(const std::filesystem::path& file);
  void copy();
  void reject() override;

 protected:
  /// `fileName`: suggested name of the cards' file.
  ShownOnceDialog(const QString& title, const QString& words, const QString& fileName, QWidget* parent);
  void setLines(const std::vector<Column>& columns, std::vector<Row> rows);
  [[nodiscard]] QString linesAsText() const;

  virtual void writeCards(const std::filesystem::path& file) const = 0;
  /// Returns the text for "Copy"; by default the lines.
  [[nodiscard]] virtual QString copied() const { return linesAsText(); }

 private:
  void askCards();

  QString fileName_;
  DataTable* table_;
  QPushButton* copy_;
  QPushButton* cards_;
  bool taken_ = false;
};

}  // namespace torsio::gui
