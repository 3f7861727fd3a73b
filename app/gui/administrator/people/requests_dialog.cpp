// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/requests_dialog.h"

#include <algorithm>
#include <memory>

#include <QDialogButtonBox>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/copies_text.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/base/second_person.h"
#include "app/gui/administrator/people/user_dialogs.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/maintenance/person_package.h"

namespace torsio::gui {

RequestsDialog::RequestsDialog(ShellContext& shell, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      table_(new DataTable(QStringLiteral("requests"), this)),
      confirm_(listButton(table_)),
      decline_(listButton(table_)) {
  setObjectName(QStringLiteral("requestsDialog"));
  setWindowTitle(tr("Requests"));
  resize(1080, 460);
  confirm_->setObjectName(QStringLiteral("confirmRequest"));
  decline_->setObjectName(QStringLiteral("declineRequest"));
  confirm_->setText(tr("&Confirm\u2026"));
  QVBoxLayout* column = pageColumn(this);
  QLabel* words = sentence(this);
  words->setText(
      tr("What needs two people waits here for two weeks. Nobody confirms what they asked for "
         "themselves."));
  column->addWidget(words);
  column->addWidget(table_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  column->addWidget(buttons);
  table_->setColumns(
      {{tr("What")}, {tr("About")}, {tr("Roles")}, {tr("Asked by")}, {tr("When")}, {tr("Why")}});
  table_->setEmptyText(tr("Nothing waits for a second person."));
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
    rows.push_back(
        {toQString(one.request.id),
         {{toQString(Text(termsOf(one.request.act)[static_cast<std::size_t>(one.request.act)].label))},
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

void RequestsDialog::confirm() {
  const OpenRequest* one = current();
  if (one == nullptr) {
    return;
  }
  const OpenRequest request = *one;
  switch (request.request.act) {
    case DutyAct::kErase:
      return erase(request);
    case DutyAct::kRestore:
      return goTo(
          PageId::kRestore,
          tr("Choose the backup %1: restoring it confirms the request").arg(toQString(request.shown)));
    case DutyAct::kRevealAllocation:
      return goTo(PageId::kAllocation,
                  tr("The keeper of the allocation opens it on this page: that confirms the request"));
    default:
      return confirmAccount(request);
  }
}

/// Another page confirms it, and says so there: this window would hide what passes by.
void RequestsDialog::goTo(PageId page, const QString& sentence) {
  accept();
  shell_.open(page);
  shell_.notify(sentence);
}

void RequestsDialog::erase(const OpenRequest& request) {
  QString copies;
  attempt(shell_, [&] { copies = copiesText(shell_.session(), request.request.subject, locale()); });
  QuestionDialog dialog(this, tr("Erase a person"),
                        tr("%1 asks to erase %2: \u201C%3\u201D. The identity is gone for good; marks stay "
                           "under the code.")
                                .arg(toQString(request.requestedBy), toQString(request.shown),
                                     toQString(request.request.reason)) +
                            copies);
  dialog.finish(tr("&Erase"));
  if (dialog.exec() != QDialog::Accepted) {
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
  dialog.finish(tr("&Confirm"));
  if (dialog.exec() != QDialog::Accepted) {
    return;
  }
  const auto half = std::make_shared<std::string>();
  const PasswordCost cost = shell_.session().passwordCost();
  shell_.run(
      tr("Sealing the start password"),
      [half, cost, id = request.request.id](SessionContext& session, const ProgressCallback&) {
        session.setPasswordCost(cost);
        *half = confirmRequest(session, id);
      },
      [dialog = QPointer<RequestsDialog>(this), half, login = toQString(request.shown)] {
        if (dialog.isNull()) {
          return;
        }
        dialog->read();
        if (!half->empty()) {
          showStartPassword(dialog, login, toQString(*half), PasswordPart::kSecondHalf);
        }
      });
}

void RequestsDialog::decline() {
  const OpenRequest* one = current();
  if (one == nullptr) {
    return;
  }
  const std::optional<std::string> why = askReason(this, one->own ? tr("Take back") : tr("Decline"),
                                                   tr("The request is closed and stays in the audit trail."));
  if (!why) {
    return;
  }
  attempt(shell_, [&] { declineRequest(shell_.session(), one->request.id, *why); });
  read();
}

}  // namespace torsio::gui
