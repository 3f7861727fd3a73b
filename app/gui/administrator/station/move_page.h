// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "app/gui/base/page.h"
#include "app/services/maintenance/server_move.h"

class QComboBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;

namespace torsio::gui {

class Card;
class PageHeading;

/// Moves the record to a PostgreSQL server in three steps: address with a test connection, copy with
/// comparison, switching this station. The password typed is not stored.
class MovePage : public Page {
  Q_OBJECT

 public:
  explicit MovePage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

  void setAddress(const ServerAddress& address);
  [[nodiscard]] ServerAddress address() const;

 private:
  QWidget* form();
  void layOut();
  void addressChanged();
  void testServer();
  void copyRecord();
  void switchStation();
  [[nodiscard]] bool ready() const;
  void showCheck();
  void showCopy();
  void showButtons();

  std::optional<ServerCheck> check_;
  std::optional<CopyReport> copied_;
  PageHeading* heading_;
  QPushButton* back_;
  Card* server_;
  QLabel* hostLabel_;
  QLineEdit* host_;
  QLabel* portLabel_;
  QSpinBox* port_;
  QLabel* databaseLabel_;
  QLineEdit* database_;
  QLabel* userLabel_;
  QLineEdit* user_;
  QLabel* passwordLabel_;
  QLineEdit* password_;
  QLabel* schemaLabel_;
  QLineEdit* schema_;
  QLabel* tlsLabel_;
  QComboBox* tlsMode_;
  QLabel* rootLabel_;
  QLineEdit* root_;
  QLabel* serverText_;
  QPushButton* test_;
  Card* copyCard_;
  QLabel* copyText_;
  QPushButton* copy_;
  Card* switchCard_;
  QLabel* switchText_;
  QLineEdit* line_;
  QPushButton* copyLine_;
  QPushButton* switch_;
};

}  // namespace torsio::gui
