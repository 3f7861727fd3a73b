// SPDX-License-Identifier: GPL-3.0-or-later
// Ways to sign in without a password at a station: kiosk cards and browser links.
#include <algorithm>
#include <optional>
#include <utility>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/people/invitations_dialog.h"
#include "app/gui/administrator/people/kiosk_cards_dialog.h"
#include "app/gui/administrator/people/review_desk_dialog.h"
#include "app/gui/administrator/people/users_page.h"
#include "app/gui/base/placed_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/services/access/access_service.h"
#include "app/services/access/first_run.h"
#include "app/services/access/invitations.h"
#include "app/services/access/kiosk_codes.h"

namespace torsio::gui {

void UsersPage::makeKioskCards() {
  std::vector<UserId> ids = chosenUsers();
  if (ids.empty()) {  // without a selection: all active trainees
    for (const UserAccount& user : users_) {
      if (user.active && user.roles == std::vector<std::string>{"trainee"}) {
        ids.push_back(user.id);
      }
    }
  }
  attempt(shell(), [&] {
    std::vector<KioskCardText> cards;
    for (const KioskCard& card : makeKioskCodes(shell().session(), ids)) {
      const auto user = std::find_if(users_.begin(), users_.end(),
                                     [&](const UserAccount& one) { return one.id == card.userId; });
      const std::string person = user == users_.end() ? std::string() : personCodes_[user->personId];
      cards.push_back({person.empty() ? card.login : person, card.login, card.code});
    }
    KioskCardsDialog(cards, centreSign(shell().session().connectionWithoutRight()).name, this).exec();
    enter({});
  });
}

void UsersPage::revokeKioskCards() {
  const std::vector<UserId> ids = chosenUsers();
  const std::optional<std::string> reason =
      askReason(this, tr("Revoke cards"), tr("The cards of the selected users no longer open a kiosk."));
  if (!reason) {
    return;
  }
  attempt(shell(), [&] {
    const std::size_t revoked = revokeKioskCodes(shell().session(), ids, *reason);
    enter({});
    shell().notify(tr("Cards revoked: %1").arg(revoked));
  });
}

void UsersPage::inviteChosen() {
  const std::vector<UserId> ids = chosenUsers();
  attempt(shell(), [&] {
    std::map<UserId, std::string> codes;
    bool byTwo = false;
    QStringList logins;
    for (const UserAccount& user : users_) {
      if (std::find(ids.begin(), ids.end(), user.id) == ids.end()) {
        continue;
      }
      logins << toQString(user.login);
      codes[user.id] = personCodes_[user.personId].empty() ? user.login : personCodes_[user.personId];
      byTwo = byTwo || passwordNeedsTwo(shell().session(), user);
    }
    const std::string known = browserAddress(shell().session());
    const std::optional<InvitationWish> wish = askInvitation(this, firstFew(logins), known, byTwo);
    if (!wish) {
      return;
    }
    if (wish->address != known) {
      setBrowserAddress(shell().session(), wish->address);
    }
    const std::string address = browserAddress(shell().session());
    std::vector<InvitationCardText> cards;
    for (const HandedInvitation& one : inviteOrAsk(shell().session(), ids, wish->reason)) {
      cards.push_back({.personCode = codes[one.userId],
                       .login = one.login,
                       .link = one.secret.empty() ? "" : invitationLink(address, one.secret, false),
                       .code = one.code,
                       .expiresUtc_us = one.expiresUtc_us});
    }
    InvitationsDialog(std::move(cards), centreSign(shell().session().connectionWithoutRight()).name, this)
        .exec();
    enter({});
  });
}

void UsersPage::revokeInvitations() {
  const std::vector<UserId> ids = chosenUsers();
  const std::optional<std::string> reason =
      askReason(this, tr("Revoke invitations"), tr("The links of the selected users stop working."));
  if (!reason) {
    return;
  }
  attempt(shell(), [&] {
    const std::size_t revoked = torsio::revokeInvitations(shell().session(), ids, *reason);
    enter({});
    shell().notify(tr("Invitations revoked: %1").arg(revoked));
  });
}

void UsersPage::endSessions() {
  const std::vector<UserId> ids = chosenUsers();
  attempt(shell(), [&] {
    for (const UserId& id : ids) {
      endBrowserSessions(shell().session(), id);
    }
    shell().notify(tr("Signed out of every browser: %1. Drafts are kept.").arg(ids.size()));
  });
}

void UsersPage::showReviewDesk() {
  ReviewDeskDialog(shell(), ReviewDeskDialog::ownPlace(), this).exec();
}

ReviewDeskDialog& UsersPage::placeReviewDesk(const DeskPlace& place) {
  auto* dialog = new ReviewDeskDialog(shell(), place, window());
  placeDialog(*dialog);
  return *dialog;
}

}  // namespace torsio::gui
