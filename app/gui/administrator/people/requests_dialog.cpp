// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/people/requests_dialog.h"

#include <algorithm>
#include <array>
#include <exception>
#include <optional>
#include <string>

#include <QDialogButtonBox>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/copies_text.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/people/shown_once_dialog.h"
#include "app/gui/administrator/people/user_dialogs.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/services/access/all_or_none.h"
#include "app/services/access/first_run.h"
#include "app/services/access/invitations.h"
#include "app/services/base/progress.h"
#include "app/services/maintenance/person_package.h"
#include "app/services/people/consent_service.h"
#include "app/services/people/roster_accounts.h"

namespace torsio::gui {

namespace {

/// Accounts confirmed so far, and the error that stopped the others.
struct Confirmed {
  std::vector<StartAccount> made{};
  std::exception_ptr problem{};
};

}  // namespace

RequestsDialog::RequestsDialog(ShellContext& shell, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      table_(new DataTable(QStringLiteral("requests"), this)),
      confirm_(named(listButton(table_), "confirmRequest")),
      decline_(named(listButton(table_), "declineRequest")) {
  setObjectName(QStringLiteral("requestsDialog"));
  setWindowTitle(tr("Requests"));
  resize(1080, 460);
  confirm_->setText(tr("&Confirm\u2026"));
  QVBoxLayout* column = pageColumn(this);
  QLabel* words = sentence(this);
  words->setText(
      tr("Actions that need two people wait here for two weeks. Nobody can confirm their own request."));
  column->addWidget(words);
  column->addWidget(table_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  column->addWidget(buttons);
  table_->setColumns(
      {{tr("What")}, {tr("About")}, {tr("Roles")}, {tr("Asked by")}, {tr("When")}, {tr("Why")}});
  table_->setEmptyText(tr("Nothing is waiting for a second person."));
  connect(buttons, &QDialogButtonBox::rejected, this, &RequestsDialog::reject);
  connect(confirm_, &QPushButton::clicked, this, &RequestsDialog::confirm);
  connect(decline_, &QPushButton::clicked, this, &RequestsDialog::decline);
  connect(table_, &DataTable::currentChanged, this, &RequestsDialog::showButtons);
  read();
}

void RequestsDialog::read() {
  attempt(shell_, [&] { requests_ = openRequests(shell_.session()); });
  std::vector<Row> rows;
  for (const OpenRequest& one : requests_) {
    QStringList roles;
    for (const std::string& role : one.roles) {
      roles << roleName(role);
    }
    rows.push_back({toQString(one.request.id),
                    {{toQString(labelOf(one.request.act))},
                     {orDash(one.shown)},
                     {roles.isEmpty() ? QStringLiteral("\u2013") : roles.join(QStringLiteral(", "))},
                     {toQString(one.requestedBy)},
                     timeCell(one.request.requestedUtc_us),
                     {toQString(one.request.reason)}}});
  }
  table_->setRows(std::move(rows));
  showButtons();
}

const OpenRequest* RequestsDialog::current() const {
  const std::string id = table_->currentId().toStdString();
  const auto found = std::find_if(requests_.begin(), requests_.end(),
                                  [&id](const OpenRequest& one) { return one.request.id == id; });
  return found == requests_.end() ? nullptr : &*found;
}

void RequestsDialog::showButtons() {
  const OpenRequest* one = current();
  confirm_->setEnabled(one != nullptr && !one->own);
  decline_->setEnabled(one != nullptr);
  decline_->setText(one != nullptr && one->own ? tr("&Take back\u2026") : tr("&Decline\u2026"));
}

std::vector<OpenRequest> RequestsDialog::chosenAccounts() const {
  const QStringList ids = table_->selectedIds();
  std::vector<OpenRequest> chosen;
  for (const OpenRequest& one : requests_) {
    const bool account =
        one.request.act == DutyAct::kGrantRoles || one.request.act == DutyAct::kResetPassword;
    if (account && !one.own && ids.contains(toQString(one.request.id))) {
      chosen.push_back(one);
    }
  }
  return chosen;
}

std::vector<OpenRequest> RequestsDialog::chosenInvitations() const {
  const QStringList ids = table_->selectedIds();
  std::vector<OpenRequest> chosen;
  for (const OpenRequest& one : requests_) {
    if (one.request.act == DutyAct::kInvite && !one.own && ids.contains(toQString(one.request.id))) {
      chosen.push_back(one);
    }
  }
  return chosen;
}

void RequestsDialog::confirmInvitations(const std::vector<OpenRequest>& requests) {
  QStringList about;
  for (const OpenRequest& one : requests) {
    about << toQString(one.shown);
  }
  QuestionDialog dialog(this, tr("Confirm"),
                        tr("%1 asks to invite %2. Do you know of it, and is it right? You get the links, and "
                           "hand each to its person.")
                            .arg(toQString(requests.front().requestedBy), firstFew(about)));
  if (!dialog.ask(tr("&Confirm"))) {
    return;
  }
  std::vector<InvitationCardText> cards;
  attempt(shell_, [&] {
    const std::string address = browserAddress(shell_.session());
    const std::vector<StartAccount> whose = accountsOf(shell_.session(), requests);
    for (std::size_t i = 0; i < requests.size(); ++i) {
      cards.push_back({.personCode = whose[i].personCode, .login = whose[i].login});
      cards.back().link =
          invitationLink(address, confirmRequest(shell_.session(), requests[i].request.id), true);
      cards.back().expiresUtc_us = shell_.session().now_us() + kInvitationLife_us;
    }
  });
  std::erase_if(cards, [](const InvitationCardText& card) { return card.link.empty(); });
  read();
  if (!cards.empty()) {
    InvitationsDialog(std::move(cards), centreSign(shell_.session().connectionWithoutRight()).name, this)
        .exec();
  }
}

void RequestsDialog::confirm() {
  if (const std::vector<OpenRequest> accounts = chosenAccounts(); accounts.size() > 1) {
    return confirmAccounts(accounts);
  }
  const OpenRequest* one = current();
  if (one == nullptr) {
    return;
  }
  const OpenRequest request = *one;
  switch (request.request.act) {
    case DutyAct::kInvite:
      return confirmInvitations(chosenInvitations());
    case DutyAct::kErase:
      return erase(request);
    case DutyAct::kRestore:
      return goTo(
          PageId::kRestore,
          tr("Choose the backup %1: restoring it confirms the request").arg(toQString(request.shown)));
    case DutyAct::kRevealAllocation:
      return goTo(PageId::kAllocation,
                  tr("The keeper of the allocation opens it on this page: that confirms the request"));
    case DutyAct::kFreezeInterim:
      return goTo(PageId::kReports,
                  tr("Freeze %1 here, under a name and with your own reason: that confirms "
                     "the request")
                      .arg(toQString(request.shown)),
                  toQString(request.request.subject));
    default:
      return confirmAccount(request);
  }
}

/// Another page confirms this request and reports there: this dialog would hide its notification.
void RequestsDialog::goTo(PageId page, const QString& sentence, const QVariant& argument) {
  accept();
  shell_.open(page, argument);
  shell_.notify(sentence);
}

void RequestsDialog::erase(const OpenRequest& request) {
  QString copies;
  attempt(shell_, [&] {
    copies = copiesText(shell_.session(), std::array{PersonId(request.request.subject)}, locale());
  });
  QuestionDialog dialog(this, tr("Erase a person"),
                        tr("%1 asks to erase %2: \u201C%3\u201D. The identity is erased permanently; marks "
                           "stay under the code.")
                                .arg(toQString(request.requestedBy), toQString(request.shown),
                                     toQString(request.request.reason)) +
                            copies);
  if (!dialog.ask(tr("&Erase"))) {
    return;
  }
  attempt(shell_, [&] {
    erasePersonRecord(shell_.session(), request.request.subject, request.request.reason);
    shell_.notify(tr("%1 is erased").arg(toQString(request.shown)));
  });
  read();
}

void RequestsDialog::confirmAccount(const OpenRequest& request) {
  QuestionDialog dialog(this, tr("Confirm"),
                        tr("%1 asks for this: \u201C%2\u201D. Do you know of it, and is it right?")
                            .arg(toQString(request.requestedBy), toQString(request.request.reason)));
  if (!dialog.ask(tr("&Confirm"))) {
    return;
  }
  shell_.run(
      this, tr("Sealing the start password"),
      [cost = shell_.session().passwordCost(), request](SessionContext& session, const ProgressCallback&) {
        session.setPasswordCost(cost);
        std::vector<StartAccount> made;
        torsio::confirmAccounts(session, {&request, 1}, made);
        return made;
      },
      [this](const std::vector<StartAccount>& made) {
        read();
        if (!made.empty()) {
          showStartPassword(this, made.front());
        }
      });
}

void RequestsDialog::confirmAccounts(const std::vector<OpenRequest>& requests) {
  QStringList about;
  for (const OpenRequest& one : requests) {
    about << toQString(one.shown);
  }
  QuestionDialog dialog(this, tr("Confirm"),
                        tr("%1 asks for these %n account(s): %2. Do you know of them, and are they right? "
                           "What is not about an account is confirmed by itself.",
                           nullptr, static_cast<int>(requests.size()))
                            .arg(toQString(requests.front().requestedBy), firstFew(about)));
  if (!dialog.ask(tr("&Confirm"))) {
    return;
  }
  shell_.run(
      this, tr("Sealing the start passwords"),
      [requests, cost = shell_.session().passwordCost()](SessionContext& session,
                                                         const ProgressCallback& progress) {
        session.setPasswordCost(cost);
        Confirmed halves;
        try {
          torsio::confirmAccounts(session, requests, halves.made, progress);
        } catch (...) {
          if (halves.made.empty()) {
            throw;
          }
          halves.problem = std::current_exception();  // shows first what was made: it is shown only once
        }
        return halves;
      },
      [dialog = QPointer<RequestsDialog>(this)](const Confirmed& halves) {
        dialog->read();
        if (!halves.made.empty()) {
          AccountsDialog(halves.made, centreSign(dialog->shell_.session().connectionWithoutRight()).name,
                         dialog)
              .exec();
        }
        if (!dialog.isNull() && halves.problem) {
          attempt(dialog->shell_, [&] { std::rethrow_exception(halves.problem); });
        }
      });
}

void RequestsDialog::decline() {
  const OpenRequest* one = current();
  if (one == nullptr) {
    return;
  }
  const std::optional<std::string> why =
      askReason(this, one->own ? tr("Take back") : tr("Decline"),
                tr("%n request(s) are closed and stay in the audit trail.", nullptr,
                   static_cast<int>(table_->selectedIds().size())));
  if (!why) {
    return;
  }
  attempt(shell_, [&] {
    allOrNone(shell_.session(), table_->selectedIds(),
              [&](const QString& id) { declineRequest(shell_.session(), id.toStdString(), *why); });
  });
  read();
}

PersonRequestsDialog::PersonRequestsDialog(ShellContext& shell, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      table_(new DataTable(QStringLiteral("person-requests"), this)),
      goTo_(listButton(table_)),
      done_(named(listButton(table_), "requestDone")),
      decline_(named(listButton(table_), "requestDeclined")) {
  setObjectName(QStringLiteral("personRequests"));
  setWindowTitle(tr("What people asked for"));
  resize(900, 460);
  goTo_->setText(tr("&Go to the person"));
  done_->setText(tr("&Done\u2026"));
  decline_->setText(tr("De&cline\u2026"));
  QLabel* words = sentence(this);
  words->setText(
      tr("Trainees ask on their page for a copy of their record, or that it be erased. Go to the person, do "
         "it there, then say here that it is done."));
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(words);
  column->addWidget(table_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  column->addWidget(buttons);
  table_->setColumns(
      {{tr("Person")}, {tr("Asked for")}, {tr("When")}, {tr("Answer")}, {tr("Reason")}, {tr("Answered")}});
  table_->setEmptyText(tr("Nobody has asked for anything."));
  connect(buttons, &QDialogButtonBox::rejected, this, &PersonRequestsDialog::reject);
  connect(goTo_, &QPushButton::clicked, this, [this] {
    if (const PersonRequest* one = current()) {
      person_ = one->personId;
      accept();
    }
  });
  connect(done_, &QPushButton::clicked, this, [this] { answer(true); });
  connect(decline_, &QPushButton::clicked, this, [this] { answer(false); });
  connect(table_, &DataTable::currentChanged, this, &PersonRequestsDialog::showButtons);
  read();
}

void PersonRequestsDialog::read() {
  attempt(shell_, [&] { requests_ = personRequests(shell_.session()); });
  std::vector<Row> rows;
  for (const PersonRequest& one : requests_) {
    rows.push_back({toQString(one.id),
                    {{toQString(one.personCode)},
                     {toQString(labelOf(one.kind))},
                     timeCell(one.askedUtc_us),
                     {one.answer ? toQString(labelOf(*one.answer)) : tr("waits")},
                     {orDash(one.reason)},
                     timeCell(one.answeredUtc_us)}});
  }
  table_->setRows(std::move(rows));
  showButtons();
}

const PersonRequest* PersonRequestsDialog::current() const {
  const std::string id = table_->currentId().toStdString();
  const auto found = std::find_if(requests_.begin(), requests_.end(),
                                  [&id](const PersonRequest& one) { return one.id == id; });
  return found == requests_.end() ? nullptr : &*found;
}

void PersonRequestsDialog::showButtons() {
  const PersonRequest* one = current();
  goTo_->setEnabled(one != nullptr);
  done_->setEnabled(!waiting().empty());
  decline_->setEnabled(!waiting().empty());
}

std::vector<const PersonRequest*> PersonRequestsDialog::waiting() const {
  std::vector<const PersonRequest*> chosen =
      chosenRows(*table_, requests_, [](const PersonRequest& one) { return one.id; });
  std::erase_if(chosen, [](const PersonRequest* one) { return one->answer.has_value(); });
  return chosen;
}

void PersonRequestsDialog::answer(bool done) {
  const std::vector<const PersonRequest*> chosen = waiting();
  const QString code = firstFew(namesOf(chosen, [](const PersonRequest& one) { return one.personCode; }));
  const std::optional<std::string> reason =
      done ? askReason(this, tr("Done"), tr("%1: say what was done, and when it was handed over.").arg(code))
           : askReason(this, tr("Decline"), tr("%1 reads this reason on their page.").arg(code));
  if (!reason) {
    return;
  }
  attempt(shell_, [&] {
    allOrNone(shell_.session(), chosen, [&](const PersonRequest* one) {
      answerPersonRequest(shell_.session(), one->id, done, *reason);
    });
  });
  read();
}

}  // namespace torsio::gui
