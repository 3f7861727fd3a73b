// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include <QDialog>

#include "app/gui/base/page.h"
#include "app/services/access/two_people.h"
#include "assessment/domain/people/retention.h"

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
  void goTo(PageId page, const QString& sentence, const QVariant& argument = {});
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

/// Requests of people about their own records, and the answers. GUI thread.
class PersonRequestsDialog : public QDialog {
  Q_OBJECT

 public:
  PersonRequestsDialog(ShellContext& shell, QWidget* parent);

  /// Returns the person to show in the roster; empty: none.
  [[nodiscard]] const PersonId& person() const noexcept { return person_; }

 private:
  void read();
  void showButtons();
  void answer(bool done);
  [[nodiscard]] const PersonRequest* current() const;
  /// Returns the selected unanswered requests.
  [[nodiscard]] std::vector<const PersonRequest*> waiting() const;

  ShellContext& shell_;
  PersonId person_;
  std::vector<PersonRequest> requests_;
  DataTable* table_;
  QPushButton* goTo_;
  QPushButton* done_;
  QPushButton* decline_;
};

}  // namespace torsio::gui
