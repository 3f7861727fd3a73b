// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "app/gui/shell/page.h"
#include "app/session/access/access_service.h"

class QPushButton;

namespace torsio::gui {

class DataTable;
class PageHeading;

/// Who may sign in, with which roles. Everything done here is audited by the service.
class UsersPage : public Page {
  Q_OBJECT

 public:
  explicit UsersPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;

 private:
  void show();
  void showButtons();
  [[nodiscard]] const StoredUser* current() const;
  void add();
  void changeRoles();
  void newPassword();
  void switchActive();

  std::vector<StoredUser> users_;
  PageHeading* heading_;
  DataTable* table_;
  QPushButton* add_;
  QPushButton* roles_;
  QPushButton* password_;
  QPushButton* active_;
};

}  // namespace torsio::gui
