// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/person_requests_dialog.h"

#include <algorithm>
#include <optional>

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/chosen_rows.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"
#include "app/services/access/all_or_none.h"
#include "app/services/people/consent_service.h"

namespace torsio::gui {

PersonRequestsDialog::PersonRequestsDialog(ShellContext& shell, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      table_(new DataTable(QStringLiteral("person-requests"), this)),
      goTo_(listButton(table_)),
      done_(listButton(table_)),
      decline_(listButton(table_)) {
  setObjectName(QStringLiteral("personRequests"));
  setWindowTitle(tr("What people asked for"));
  resize(900, 460);
  done_->setObjectName(QStringLiteral("requestDone"));
  decline_->setObjectName(QStringLiteral("requestDeclined"));
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
