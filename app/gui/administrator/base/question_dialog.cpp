// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/base/question_dialog.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "app/connectors/mail/mailing.h"
#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/field_checks.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/first_run.h"
#include "app/services/people/waiting_requests.h"

namespace torsio::gui {

namespace {

constexpr int kDialogWidth = 440;

struct ReasonDialog {
  Q_DECLARE_TR_FUNCTIONS(ReasonDialog)
};

struct LossDialog {
  Q_DECLARE_TR_FUNCTIONS(LossDialog)
};

}  // namespace

QString reasonWanted() {
  return ReasonDialog::tr("Say why: the reason stays in the record.");
}

QuestionDialog::QuestionDialog(QWidget* parent, const QString& title, const QString& question)
    : QDialog(parent), column_(new QVBoxLayout(this)) {
  setWindowTitle(title);
  setMinimumWidth(kDialogWidth);
  column_->setContentsMargins(3 * kSpace, 3 * kSpace, 3 * kSpace, 2 * kSpace);
  column_->setSpacing(2 * kSpace);
  if (!question.isEmpty()) {
    addNote(question);
  }
}

void QuestionDialog::addNote(const QString& text) {
  auto* label = new QLabel(text, this);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setProperty("quiet", true);
  column_->addWidget(label);
}

QPushButton* QuestionDialog::finish(const QString& accept) {
  return addButtons(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this), accept);
}

bool QuestionDialog::ask(const QString& accept, FieldChecks* checks) {
  QPushButton* ok = finish(accept);
  if (checks != nullptr) {
    checks->decide(ok);
  }
  return exec() == QDialog::Accepted;
}

QPushButton* QuestionDialog::finishWithoutCancel(const QString& accept) {
  return addButtons(new QDialogButtonBox(QDialogButtonBox::Ok, this), accept);
}

QPushButton* QuestionDialog::addButtons(QDialogButtonBox* buttons, const QString& accept) {
  QPushButton* ok = buttons->button(QDialogButtonBox::Ok);
  ok->setText(accept);
  ok->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column_->addWidget(buttons);
  return ok;
}

std::optional<std::string> askReason(QWidget* parent, const QString& title, const QString& question) {
  QuestionDialog dialog(parent, title, question);
  auto* reason = new QLineEdit(&dialog);
  reason->setObjectName(QStringLiteral("reason"));
  auto* form = new QFormLayout;
  form->addRow(ReasonDialog::tr("&Reason"), reason);
  FieldChecks checks(&dialog);
  checks.addNeeded(form, reason, reasonWanted());
  dialog.column()->addLayout(form);
  reason->setFocus();
  if (!dialog.ask(title, &checks)) {
    return std::nullopt;
  }
  return reason->text().trimmed().toStdString();
}

bool mayLoseChanges(QWidget* parent) {
  QuestionDialog sure(parent, LossDialog::tr("Close without publishing"),
                      LossDialog::tr("The changes are not published and will be lost."));
  return sure.ask(LossDialog::tr("&Discard"));
}

void pressNothingByEnter(QDialog& dialog) {
  for (QPushButton* button : dialog.findChildren<QPushButton*>()) {
    button->setAutoDefault(false);
  }
}

PeopleDialog::PeopleDialog(const QString& title, const QString& question,
                           const std::vector<PersonRow>& people, QWidget* parent)
    : QDialog(parent), table_(new DataTable(QString(), this)) {
  setWindowTitle(title);
  resize(640, 520);
  auto* words = new QLabel(question, this);
  words->setWordWrap(true);
  table_->setColumns({{tr("Code")}, {tr("Sex")}, {tr("Level")}, {tr("Experience")}, {tr("Class of raters")}});
  table_->setEmptyText(tr("There is nobody left to choose."));
  std::vector<Row> rows;
  for (const PersonRow& row : people) {
    rows.push_back({toQString(row.person.id),
                    {{toQString(row.person.code)},
                     {levelName(row.person.sex)},
                     {orDash(row.person.level)},
                     {orDash(row.person.experience)},
                     {raterClassName(row.raterClass)}}});
  }
  table_->setRows(std::move(rows));
  table_->view().setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->view().selectAll();
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  QPushButton* take = buttons->button(QDialogButtonBox::Ok);
  const auto sayHowMany = [this, take] {
    const auto chosen = static_cast<int>(table_->selectedIds().size());
    take->setText(tr("Add %n", nullptr, chosen));
    take->setEnabled(chosen > 0);
  };
  connect(table_, &DataTable::currentChanged, this, sayHowMany);
  sayHowMany();
  take->setFocus();  // Enter accepts everybody; the list is for exceptions
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  QVBoxLayout* column = pageColumn(this);
  column->setSpacing(kSpace);
  column->addWidget(words);
  column->addWidget(table_, 1);
  column->addWidget(buttons);
}

std::vector<PersonId> PeopleDialog::chosen() const {
  std::vector<PersonId> out;
  for (const QString& id : table_->selectedIds()) {
    out.push_back(id.toStdString());
  }
  return out;
}

namespace {

struct SecondPerson {
  Q_DECLARE_TR_FUNCTIONS(SecondPerson)
};

bool wantsToAsk(QWidget* parent) {
  QuestionDialog dialog(
      parent, SecondPerson::tr("Two people"),
      SecondPerson::tr("This needs two people: you ask for it, and another administrator confirms it. Ask "
                       "for it now?"));
  dialog.setObjectName(QStringLiteral("askSecondPerson"));
  return dialog.ask(SecondPerson::tr("&Ask"));
}

}  // namespace

void sayAsked(QWidget* parent, ShellContext& shell) {
  shell.notify(SecondPerson::tr("Asked. Another administrator confirms it under Users, Requests"));
  if (!shell.may(Operation::kUserManage) || !canMailAdministrators(shell.session())) {
    return;
  }
  QuestionDialog dialog(parent, SecondPerson::tr("Tell by mail"),
                        SecondPerson::tr("Tell the other administrators by mail that a request waits?"));
  dialog.setObjectName(QStringLiteral("tellAdministrators"));
  auto* password = named(secretField(&dialog), "mailPassword");
  auto* form = new QFormLayout;
  form->addRow(SecondPerson::tr("Pass&word of the mail server"), password);
  dialog.column()->addLayout(form);
  const std::optional<MailSettings> settings = mailSettings(shell.session());
  form->setRowVisible(password, settings && !settings->server.user.empty());
  if (!dialog.ask(SecondPerson::tr("&Send"))) {
    return;
  }
  const std::vector<OpenRequest> open = openRequests(shell.session());
  const auto own = static_cast<std::size_t>(
      std::count_if(open.begin(), open.end(), [](const OpenRequest& one) { return one.own; }));
  const std::string centre = centreSign(shell.session().connectionWithoutRight()).name;
  shell.run(
      parent, SecondPerson::tr("Telling the other administrators"),
      [secret = password->text().toStdString(), subject = toQString(waitingMailSubject(centre)).toStdString(),
       body = toQString(waitingMailWords(centre, shell.session().actor().login, own)).toStdString()](
          SessionContext& session, const ProgressCallback&) {
        return mailAdministrators(session, secret, subject, body + "\n");
      },
      [&shell](const std::vector<Text>& refusals) {
        for (const Text& refusal : refusals) {
          if (!refusal.empty()) {
            return shell.notify(SecondPerson::tr("Refused by the mail server: %1").arg(toQString(refusal)));
          }
        }
        shell.notify(SecondPerson::tr("Administrators told by mail: %1").arg(refusals.size()));
      });
}

void showStartPassword(QWidget* parent, const StartAccount& account) {
  QuestionDialog dialog(parent, SecondPerson::tr("Start password"));
  dialog.addNote(toQString(handOverWords(account)));
  auto* shown = new QLineEdit(toQString(account.startPassword), &dialog);
  shown->setObjectName(QStringLiteral("password"));
  shown->setReadOnly(true);
  shown->setAccessibleName(SecondPerson::tr("Start password"));
  dialog.column()->addWidget(shown);
  auto* copy = new QPushButton(SecondPerson::tr("&Copy"), &dialog);
  QObject::connect(copy, &QPushButton::clicked, shown, [shown, copy] {
    QApplication::clipboard()->setText(shown->text());
    copy->setText(SecondPerson::tr("Copied"));
  });
  dialog.column()->addWidget(copy, 0, Qt::AlignLeft);
  // A second, hasty Enter must not close what is shown only once.
  dialog.finishWithoutCancel(SecondPerson::tr("Done"))->setAutoDefault(false);
  copy->setDefault(true);
  copy->setFocus();
  dialog.exec();
}

bool offerToAsk(QWidget* parent, ShellContext& shell, const DutyWish& wish, const QString& login) {
  if (!wantsToAsk(parent)) {
    return false;
  }
  const std::string half = askSecondPerson(shell.session(), wish);
  if (!half.empty()) {
    showStartPassword(
        parent, {.login = login.toStdString(), .startPassword = half, .part = PasswordPart::kFirstHalf});
  }
  sayAsked(parent, shell);
  return true;
}

bool offerToAskForAll(QWidget* parent, ShellContext& shell, const std::vector<DutyWish>& wishes) {
  if (!wantsToAsk(parent)) {
    return false;
  }
  for (const DutyWish& wish : wishes) {
    if (!isRequested(shell.session(), wish)) {
      static_cast<void>(askSecondPerson(shell.session(), wish));
    }
  }
  sayAsked(parent, shell);
  return true;
}

std::size_t actOrAskForAll(QWidget* parent, ShellContext& shell, const std::vector<DutyWish>& wishes,
                           const std::function<void(const DutyWish&)>& act) {
  std::vector<DutyWish> waiting;
  for (const DutyWish& wish : wishes) {
    try {
      act(wish);
    } catch (const SecondPersonNeeded&) {
      waiting.push_back(wish);
    }
  }
  if (!waiting.empty()) {
    static_cast<void>(offerToAskForAll(parent, shell, waiting));
  }
  return wishes.size() - waiting.size();
}

bool actOrAsk(QWidget* parent, ShellContext& shell, const DutyWish& wish, const std::function<void()>& act,
              const QString& login) {
  try {
    act();
    return true;
  } catch (const SecondPersonNeeded&) {
    (void)offerToAsk(parent, shell, wish, login);
  }
  return false;
}

}  // namespace torsio::gui
