// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/users_page.h"

#include <algorithm>
#include <exception>
#include <optional>
#include <utility>

#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/people/requests_dialog.h"
#include "app/gui/administrator/people/review_desk_dialog.h"
#include "app/gui/administrator/people/shown_once_dialog.h"
#include "app/gui/administrator/people/user_dialogs.h"
#include "app/gui/base/placed_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/services/access/access_service.h"
#include "app/services/access/all_or_none.h"
#include "app/services/access/first_run.h"
#include "app/services/access/invitations.h"
#include "app/services/access/kiosk_codes.h"
#include "app/services/access/second_factor.h"
#include "app/services/people/people_service.h"
#include "app/services/people/roster_accounts.h"

namespace torsio::gui {

namespace {

/// Returns all people of the record, with names if the actor may see them.
std::vector<PersonChoice> peopleToChoose(ShellContext& shell) {
  std::vector<PersonChoice> choices;
  SessionContext& session = shell.session();
  if (shell.may(Operation::kPersonViewIdentity)) {
    for (const NamedPersonRow& person : namedPeople(session)) {
      const QString code = toQString(person.row.person.code);
      const QString name = toQString(person.identity.fullName);
      choices.push_back(
          {person.row.person.id, name.isEmpty() ? code : QStringLiteral("%1 \u00B7 %2").arg(code, name)});
    }
    return choices;
  }
  for (const PersonRow& person : people(session)) {
    choices.push_back({person.person.id, toQString(person.person.code)});
  }
  return choices;
}

/// Accounts made so far, and the error that stopped the others.
struct IssuedAccounts {
  std::vector<StartAccount> made;
  std::exception_ptr problem;
};

bool isHalf(const StartAccount& account) {
  return account.part != PasswordPart::kWhole;
}

}  // namespace

UsersPage::UsersPage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      outdated_(named(new QLabel(this), "outdatedAccess")),
      table_(named(new DataTable(QStringLiteral("users"), this), "table")),
      add_(primaryButton(this)),
      addForRoster_(new QPushButton(this)),
      requests_(named(new QPushButton(this), "requests")),
      desk_(named(new QPushButton(this), "reviewDeskOfBrowsers")),
      roles_(listButton(table_)),
      password_(listButton(table_)),
      active_(listButton(table_)),
      cards_(named(listButton(table_), "makeKioskCards")),
      revoke_(named(listButton(table_), "revokeKioskCards")),
      invite_(named(listButton(table_), "inviteUsers")),
      uninvite_(named(listButton(table_), "revokeInvitations")),
      endSessions_(named(listButton(table_), "endBrowserSessions")) {
  desk_->setVisible(shell.may(Operation::kSettingsEdit));
  heading_->addAction(desk_);
  heading_->addAction(requests_);
  heading_->addAction(addForRoster_);
  heading_->addAction(add_);
  QVBoxLayout* column = pageColumn(this);
  outdated_->setWordWrap(true);
  outdated_->setProperty("caution", true);
  column->addWidget(heading_);
  column->addWidget(outdated_);
  column->addWidget(table_, 1);

  connect(add_, &QPushButton::clicked, this, &UsersPage::add);
  connect(addForRoster_, &QPushButton::clicked, this, &UsersPage::addForRoster);
  connect(desk_, &QPushButton::clicked, this, &UsersPage::showReviewDesk);
  connect(requests_, &QPushButton::clicked, this, &UsersPage::showRequests);
  connect(roles_, &QPushButton::clicked, this, &UsersPage::changeRoles);
  connect(password_, &QPushButton::clicked, this, &UsersPage::newPassword);
  connect(active_, &QPushButton::clicked, this, &UsersPage::switchActive);
  connect(cards_, &QPushButton::clicked, this, &UsersPage::makeKioskCards);
  connect(revoke_, &QPushButton::clicked, this, &UsersPage::revokeKioskCards);
  connect(invite_, &QPushButton::clicked, this, &UsersPage::inviteChosen);
  connect(uninvite_, &QPushButton::clicked, this, &UsersPage::revokeInvitations);
  connect(endSessions_, &QPushButton::clicked, this, &UsersPage::endSessions);
  connect(table_, &DataTable::currentChanged, this, &UsersPage::showButtons);
  connect(table_, &DataTable::activated, this, &UsersPage::changeRoles);
  retranslate();
}

void UsersPage::enter(const QVariant&) {
  attempt(shell(), [&] {
    users_ = users(shell().session());
    waiting_ = openRequests(shell().session()).size();
    kioskCodes_ = kioskCodesInForce(shell().session());
    invitations_ = invitationsInForce(shell().session());
    secondFactors_ = secondFactors(shell().session());
    outdatedAccess_ = outdatedAccess(shell().session());
    personCodes_.clear();
    for (const PersonRow& row : people(shell().session())) {
      personCodes_[row.person.id] = row.person.code;
    }
    showContent();
  });
}

void UsersPage::retranslate() {
  heading_->setTexts(tr("Users and roles"),
                     tr("Who may sign in, and in which role. Every change is kept in the audit trail."));
  add_->setText(tr("&New user\u2026"));
  addForRoster_->setText(tr("&Accounts for the roster\u2026"));
  desk_->setText(tr("&Browsers\u2026"));
  desk_->setToolTip(tr("Let physicians score from their browsers: opens and closes the review desk here."));
  roles_->setText(tr("&Roles\u2026"));
  password_->setText(tr("New &password\u2026"));
  cards_->setText(tr("&Kiosk cards\u2026"));
  cards_->setToolTip(
      tr("For the selected trainees, or for all: a card with a barcode that opens a kiosk. Any earlier card "
         "stops working."));
  revoke_->setText(tr("Re&voke cards\u2026"));
  invite_->setText(tr("&Invite\u2026"));
  invite_->setToolTip(tr("A link for each selected user to set a password in a browser."));
  uninvite_->setText(tr("Revoke &links\u2026"));
  endSessions_->setText(tr("End &sessions"));
  endSessions_->setToolTip(tr("Ends the browser sessions of the selected users at their next click."));
  table_->setColumns({{tr("Sign-in name")},
                      {tr("Person")},
                      {tr("Roles")},
                      {tr("State")},
                      {tr("Password")},
                      {tr("Station PIN")},
                      {tr("Kiosk card")},
                      {tr("Invited until")},
                      {tr("Since")}});
  table_->setEmptyText(tr("No users yet."));
  showContent();
}

void UsersPage::showContent() {
  const Text outdated = sentenceOf(outdatedAccess_);
  outdated_->setVisible(!outdated.empty());
  outdated_->setText(translatedLines({outdated, remedyForOutdatedAccess()}));
  std::vector<Row> rows;
  for (const UserAccount& user : users_) {
    QStringList roles;
    for (const std::string& role : user.roles) {
      roles << roleName(role);
    }
    rows.push_back({toQString(user.id),
                    {{toQString(user.login)},
                     {orDash(personCodes_[user.personId])},
                     {roles.join(QStringLiteral(", "))},
                     {user.active ? tr("active") : tr("disabled")},
                     {user.mustChangePassword            ? tr("to be changed")
                      : secondFactors_.contains(user.id) ? tr("own, and a code")
                                                         : tr("own")},
                     {user.hasPin ? tr("set") : QStringLiteral("\u2013")},
                     timeCell(kioskCodes_.contains(user.id) ? kioskCodes_[user.id] : 0),
                     timeCell(invitations_.contains(user.id) ? invitations_[user.id] : 0),
                     timeCell(user.createdUtc_us)}});
  }
  table_->setRows(std::move(rows));
  requests_->setText(waiting_ == 0 ? tr("Re&quests\u2026") : tr("Re&quests (%1)\u2026").arg(waiting_));
  requests_->setProperty("caution", waiting_ > 0);
  showButtons();
}

void UsersPage::showRequests() {
  RequestsDialog(shell(), this).exec();
  enter({});
}

void UsersPage::showButtons() {
  const UserAccount* user = current();
  for (QPushButton* button : {roles_, password_, active_}) {
    button->setEnabled(user != nullptr);
  }
  cards_->setEnabled(!users_.empty());
  const std::vector<UserId> chosen = chosenUsers();
  revoke_->setEnabled(
      std::any_of(chosen.begin(), chosen.end(), [&](const UserId& id) { return kioskCodes_.contains(id); }));
  invite_->setEnabled(!chosen.empty());
  endSessions_->setEnabled(!chosen.empty());
  uninvite_->setEnabled(
      std::any_of(chosen.begin(), chosen.end(), [&](const UserId& id) { return invitations_.contains(id); }));
  active_->setText(user != nullptr && !user->active ? tr("&Enable") : tr("&Disable\u2026"));
}

std::vector<UserId> UsersPage::chosenUsers() const {
  std::vector<UserId> ids;
  for (const QString& id : table_->selectedIds()) {
    ids.emplace_back(id.toStdString());
  }
  return ids;
}

const UserAccount* UsersPage::current() const {
  const std::string id = table_->currentId().toStdString();
  const auto found =
      std::find_if(users_.begin(), users_.end(), [&id](const UserAccount& user) { return user.id == id; });
  return found == users_.end() ? nullptr : &*found;
}

void UsersPage::add() {
  attempt(shell(), [&] {
    const std::optional<NewUser> user = askNewUser(this, peopleToChoose(shell()));
    if (!user) {
      return;
    }
    storeAndShow([user = *user](SessionContext& session) { return makeUser(session, user); },
                 toQString(user->login));
  });
}

void UsersPage::addForRoster() {
  attempt(shell(), [&] {
    const std::vector<PersonRow> without = peopleWithoutAccount(shell().session());
    if (without.empty()) {
      shell().notify(tr("Everybody of the roster has an account"));
      return;
    }
    PeopleDialog dialog(
        tr("Accounts for the roster"),
        tr("These people have no account yet. Each gets one: the code in small letters is the "
           "sign-in name, trainees train, raters score."),
        without, this);
    if (dialog.exec() != QDialog::Accepted) {
      return;
    }
    shell().run(
        this, tr("Making accounts"),
        [chosen = dialog.chosen(), cost = shell().session().passwordCost()](
            SessionContext& session, const ProgressCallback& progress) {
          session.setPasswordCost(cost);
          IssuedAccounts issued;
          try {
            addAccounts(session, chosen, issued.made, progress);
          } catch (...) {
            if (issued.made.empty()) {
              throw;
            }
            issued.problem = std::current_exception();
          }
          return issued;
        },
        [page = QPointer<UsersPage>(this)](const IssuedAccounts& issued) {
          page->enter({});
          AccountsDialog(issued.made, centreSign(page->shell().session().connectionWithoutRight()).name, page)
              .exec();
          if (!page.isNull() && std::any_of(issued.made.begin(), issued.made.end(), isHalf)) {
            attempt(page->shell(), [&] { sayAsked(page, page->shell()); });
          }
          if (!page.isNull() && issued.problem) {
            page->sayWhyNotAll(issued.problem);
          }
        });
  });
}

void UsersPage::sayWhyNotAll(const std::exception_ptr& problem) {
  attempt(
      shell(), [&] { std::rethrow_exception(problem); }, tr("Cancelled; the accounts that were shown stay"));
}

void UsersPage::storeAndShow(const std::function<MadeUser(SessionContext&)>& store, const QString& login) {
  // Hashing a password takes a second by design: not in the GUI thread.
  const PasswordCost cost = shell().session().passwordCost();
  shell().run(
      this, tr("Sealing the start password"),
      [store, cost](SessionContext& session, const ProgressCallback&) {
        session.setPasswordCost(cost);
        return store(session);
      },
      [page = QPointer<UsersPage>(this), login](const MadeUser& made) {
        page->enter({});
        page->table_->select(toQString(made.id));
        showStartPassword(page,
                          {.login = login.toStdString(),
                           .startPassword = made.startPassword,
                           .part = made.awaitsSecond ? PasswordPart::kFirstHalf : PasswordPart::kWhole});
        if (!page.isNull() && made.awaitsSecond) {
          attempt(page->shell(), [&] { sayAsked(page, page->shell()); });
        }
      });
}

void UsersPage::changeRoles() {
  const UserAccount* user = current();
  if (user == nullptr) {
    return;
  }
  attempt(shell(), [&] {
    const std::optional<RolesChange> change = askRoles(this, toQString(user->login), user->roles);
    if (!change) {
      return;
    }
    const DutyWish wish{
        .act = DutyAct::kGrantRoles, .subject = user->id, .roles = change->roles, .reason = change->reason};
    actOrAsk(
        this, shell(), wish,
        [&] { setUserRoles(shell().session(), user->id, change->roles, change->reason); },
        toQString(user->login));
    shell().readRights();
    enter({});
  });
}

void UsersPage::newPassword() {
  const UserAccount* user = current();
  if (user == nullptr) {
    return;
  }
  attempt(shell(), [&] {
    const QString login = toQString(user->login);
    const std::optional<std::string> reason = askReason(
        this, tr("New start password"),
        tr("The present password of %1 stops working at once, and a second factor is removed.").arg(login));
    if (!reason) {
      return;
    }
    if (passwordNeedsTwo(shell().session(), *user)) {
      (void)offerToAsk(this, shell(),
                       {.act = DutyAct::kResetPassword, .subject = user->id, .reason = *reason}, login);
      return;
    }
    storeAndShow(
        [id = user->id, reason = *reason](SessionContext& session) {
          const std::string password = randomStartPassword();
          resetPassword(session, id, password, reason);
          return MadeUser{.id = id, .startPassword = password};
        },
        login);
  });
}

void UsersPage::switchActive() {
  const UserAccount* user = current();
  if (user == nullptr) {
    return;
  }
  // All selected users with the same state as the current one.
  const bool active = user->active;
  const std::vector<UserId> chosen = chosenUsers();
  std::vector<UserId> ids;
  QStringList logins;
  for (const UserAccount& one : users_) {
    if (one.active == active && std::find(chosen.begin(), chosen.end(), one.id) != chosen.end()) {
      ids.push_back(one.id);
      logins << toQString(one.login);
    }
  }
  attempt(shell(), [&] {
    const QString login = firstFew(logins);
    const std::optional<std::string> reason =
        active ? askReason(this, tr("Disable user"),
                           tr("%1 cannot sign in any more; everything recorded stays.").arg(login))
               : askReason(this, tr("Enable user"), tr("%1 can sign in again.").arg(login));
    if (!reason) {
      return;
    }
    allOrNone(shell().session(), ids,
              [&](const UserId& id) { setUserActive(shell().session(), id, !active, *reason); });
    enter({});
  });
}

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
    const bool asked = std::any_of(cards.begin(), cards.end(),
                                   [](const InvitationCardText& card) { return !card.code.empty(); });
    InvitationsDialog(std::move(cards), centreSign(shell().session().connectionWithoutRight()).name, this)
        .exec();
    enter({});
    if (asked) {
      sayAsked(this, shell());
    }
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
