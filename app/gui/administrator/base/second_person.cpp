// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/second_person.h"

#include <algorithm>

#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"

namespace torsio::gui {

namespace {

struct SecondPerson {
  Q_DECLARE_TR_FUNCTIONS(SecondPerson)
};

QString noteOf(const QString& login, PasswordPart part) {
  switch (part) {
    case PasswordPart::kFirstHalf:
      return SecondPerson::tr(
                 "This is the first half of the start password of %1. Give it to them; the second half comes "
                 "from the administrator who confirms. It is shown only now.")
          .arg(login);
    case PasswordPart::kSecondHalf:
      return SecondPerson::tr(
                 "This is the second half of the start password of %1, after the first half and a hyphen. "
                 "Give it to them; the first half comes from whoever asked. It is shown only now.")
          .arg(login);
    case PasswordPart::kWhole:
      break;
  }
  return SecondPerson::
      tr("Give this start password to %1. It is shown only now, and must be changed at the first sign-in.")
          .arg(login);
}

bool wantsToAsk(QWidget* parent) {
  QuestionDialog dialog(
      parent, SecondPerson::tr("Two people"),
      SecondPerson::tr("This needs two people: you ask for it, and another administrator confirms it. Ask "
                       "for it now?"));
  dialog.setObjectName(QStringLiteral("askSecondPerson"));
  dialog.finish(SecondPerson::tr("&Ask"));
  return dialog.exec() == QDialog::Accepted;
}

void sayAsked(ShellContext& shell) {
  shell.notify(SecondPerson::tr("Asked. Another administrator confirms it under Users, Requests"));
}

}  // namespace

void showStartPassword(QWidget* parent, const QString& login, const QString& password, PasswordPart part) {
  QuestionDialog dialog(parent, SecondPerson::tr("Start password"));
  dialog.addNote(noteOf(login, part));
  auto* shown = new QLineEdit(password, &dialog);
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
    showStartPassword(parent, login, toQString(half), PasswordPart::kFirstHalf);
  }
  sayAsked(shell);
  return true;
}

bool offerToAskForAll(QWidget* parent, ShellContext& shell, const std::vector<DutyWish>& wishes) {
  if (!wantsToAsk(parent)) {
    return false;
  }
  const std::vector<OpenRequest> open = openRequests(shell.session());
  for (const DutyWish& wish : wishes) {
    if (std::none_of(open.begin(), open.end(), [&](const OpenRequest& one) {
          return one.request.act == wish.act && one.request.subject == wish.subject;
        })) {
      static_cast<void>(askSecondPerson(shell.session(), wish));
    }
  }
  sayAsked(shell);
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
