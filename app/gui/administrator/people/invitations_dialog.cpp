// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/people/invitations_dialog.h"

#include <utility>

#include <QCoreApplication>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/access/invitations.h"

namespace torsio::gui {

namespace {

struct InvitationQuestion {
  Q_DECLARE_TR_FUNCTIONS(InvitationQuestion)
};

}  // namespace

InvitationsDialog::InvitationsDialog(std::vector<InvitationCardText> cards, std::string centre,
                                     QWidget* parent)
    : ShownOnceDialog(
          tr("Invitations"),
          tr("Links and codes are shown only now. Each is for one person; a link works once and for a week. "
             "Send each code by a different channel from the link, which another administrator hands over."),
          tr("invitations.pdf"), parent),
      cards_(std::move(cards)),
      centre_(std::move(centre)) {
  setObjectName(QStringLiteral("invitations"));
  std::vector<Row> rows;
  for (const InvitationCardText& card : cards_) {
    rows.push_back(
        {toQString(card.login),
         {{toQString(card.personCode)}, {toQString(card.login)}, {orDash(card.link)}, {orDash(card.code)}}});
  }
  setLines({{tr("Person")}, {tr("Sign-in name")}, {tr("Link")}, {tr("Code")}}, std::move(rows));
}

void InvitationsDialog::writeCards(const std::filesystem::path& file) const {
  writeInvitationCards(cards_, centre_, file);
}

QString InvitationsDialog::copied() const {
  QStringList mails;
  for (const InvitationCardText& card : cards_) {
    const QString greeting = tr("For %1:").arg(toQString(card.login)) + QLatin1Char('\n');
    mails << greeting +
                 toQString(card.link.empty()
                               ? invitationCodeWords(centre_, card.code)
                               : invitationWords(centre_, card.login, card.link,
                                                 shownTime(card.expiresUtc_us, locale()).toStdString()));
  }
  return mails.join(QStringLiteral("\n\n"));
}

std::optional<InvitationWish> askInvitation(QWidget* parent, const QString& logins,
                                            const std::string& address, bool byTwo) {
  QuestionDialog dialog(
      parent, InvitationQuestion::tr("Invite"),
      InvitationQuestion::tr(
          "%1: each receives a link to set a password in a browser. Any earlier link stops working.")
          .arg(logins));
  auto* where = new QLineEdit(toQString(address), &dialog);
  where->setObjectName(QStringLiteral("browserAddress"));
  where->setPlaceholderText(QStringLiteral("https://desk.example.org"));
  auto* why = new QLineEdit(&dialog);
  why->setObjectName(QStringLiteral("reason"));
  auto* form = new QFormLayout;
  form->addRow(InvitationQuestion::tr("&Address of the review desk"), where);
  if (byTwo) {
    form->addRow(InvitationQuestion::tr("&Reason"), why);
  }
  why->setVisible(byTwo);
  dialog.column()->addLayout(form);
  dialog.addNote(byTwo ? InvitationQuestion::tr("This needs two people: you receive a code for each person, "
                                                "and another administrator, who confirms, receives the link.")
                       : InvitationQuestion::tr(
                             "The address that torsio serve shows when it starts, or that of your proxy."));
  QPushButton* ok = dialog.finish(InvitationQuestion::tr("&Invite"));
  const auto check = [&] {
    ok->setEnabled(!where->text().trimmed().isEmpty() && (!byTwo || !why->text().trimmed().isEmpty()));
  };
  QObject::connect(where, &QLineEdit::textChanged, &dialog, check);
  QObject::connect(why, &QLineEdit::textChanged, &dialog, check);
  check();
  (address.empty() ? where : why)->setFocus();
  if (dialog.exec() != QDialog::Accepted) {
    return std::nullopt;
  }
  return InvitationWish{where->text().trimmed().toStdString(), why->text().trimmed().toStdString()};
}

}  // namespace torsio::gui
