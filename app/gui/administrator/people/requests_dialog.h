// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <QDialog>

#include "app/gui/base/page_id.h"
#include "app/services/access/two_people.h"

class QPushButton;

namespace torsio::gui {

class DataTable;
class ShellContext;

/// What waits for a second person: who asks for what, and why; confirm or decline.
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
  /// Several at once; shows the second halves of their start passwords together.
  void confirmAccounts(const std::vector<OpenRequest>& requests);
  /// Shows the links that go with the codes of whoever asked.
  void confirmInvitations(const std::vector<OpenRequest>& requests);
  /// Of the chosen requests those for invitations that somebody else has asked for.
  [[nodiscard]] std::vector<OpenRequest> chosenInvitations() const;
  /// Of the chosen requests those about accounts that somebody else has asked for.
  [[nodiscard]] std::vector<OpenRequest> chosenAccounts() const;
  [[nodiscard]] const OpenRequest* current() const;

  ShellContext& shell_;
  DataTable* table_;
  QPushButton* confirm_;
  QPushButton* decline_;
  std::vector<OpenRequest> requests_;
};

}  // namespace torsio::gui
