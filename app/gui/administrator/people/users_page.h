// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "app/gui/base/page.h"
#include "app/services/access/access_service.h"
#include "app/services/access/outdated_access.h"
#include "app/services/access/two_people.h"
#include "app/services/serving/review_desk.h"
#include "assessment/domain/people/account.h"

class QLabel;
class QPushButton;

namespace torsio::gui {

class DataTable;
class PageHeading;
class ReviewDeskDialog;

/// Accounts and their roles. The service audits every action.
class UsersPage : public Page {
  Q_OBJECT

 public:
  explicit UsersPage(ShellContext& shell);

  void enter(const QVariant& argument) override;
  void retranslate() override;
  /// Shows the dialog of the review desk over the window's content.
  ReviewDeskDialog& placeReviewDesk(const DeskPlace& place);

 private:
  void showContent();
  void showButtons();
  [[nodiscard]] const UserAccount* current() const;
  void add();
  void addForRoster();
  void sayWhyNotAll(const std::exception_ptr& problem);
  void changeRoles();
  void newPassword();
  /// Stores in the background, then shows the user's start password.
  void storeAndShow(const std::function<MadeUser(SessionContext&)>& store, const QString& login);
  void showRequests();
  void switchActive();

  // Cards, invitations and sessions.
  void makeKioskCards();
  void revokeKioskCards();
  void inviteChosen();
  void revokeInvitations();
  void endSessions();
  void showReviewDesk();

  [[nodiscard]] std::vector<UserId> chosenUsers() const;

  std::vector<UserAccount> users_;
  std::size_t waiting_ = 0;                         // open requests for a second person
  std::map<std::string, std::string> personCodes_;  // by person id
  std::map<UserId, std::int64_t> kioskCodes_;       // creation time
  std::map<UserId, std::int64_t> invitations_;      // expiry
  std::set<UserId> secondFactors_;                  // accounts that have one
  OutdatedAccess outdatedAccess_;
  PageHeading* heading_;
  QLabel* outdated_;
  DataTable* table_;
  QPushButton* add_;
  QPushButton* addForRoster_;
  QPushButton* requests_;
  QPushButton* desk_;
  QPushButton* roles_;
  QPushButton* password_;
  QPushButton* active_;
  QPushButton* cards_;
  QPushButton* revoke_;
  QPushButton* invite_;
  QPushButton* uninvite_;
  QPushButton* endSessions_;
};

}  // namespace torsio::gui
