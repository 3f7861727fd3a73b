// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDialog>

#include "app/gui/base/page.h"
#include "app/services/access/two_people.h"

class QPushButton;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// Requests for a second person: who asks for what, and why; to confirm or decline.
class RequestsDialog : public QDialog {
  Q_OBJECT

 public:
  explicit RequestsDialog(ShellContext& shell, QWidget* parent = nullptr);

 private:
  void read();
  void showButtons();
  void confirm();
  void decline();
  void goTo(PageId page, const QString& sentence);
  void erase(const OpenRequest& request);
  void confirmAccount(const OpenRequest& request);
  /// Confirms several requests; shows the second halves of their start passwords together.
  void confirmAccounts(const std::vector<OpenRequest>& requests);
  /// Confirms invitations; shows the links for the requesters' codes.
  void confirmInvitations(const std::vector<OpenRequest>& requests);
  /// Returns the selected requests of others for invitations.
  [[nodiscard]] std::vector<OpenRequest> chosenInvitations() const;
  /// Returns the selected requests of others about accounts.
  [[nodiscard]] std::vector<OpenRequest> chosenAccounts() const;
  [[nodiscard]] const OpenRequest* current() const;

  ShellContext& shell_;
  DataTable* table_;
  QPushButton* confirm_;
  QPushButton* decline_;
  std::vector<OpenRequest> requests_;
};

}  // namespace torsio::gui
