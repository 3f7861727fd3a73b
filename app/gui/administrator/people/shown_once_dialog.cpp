// SPDX-License-Identifier: GPL-3.0-or-later

#include "app/gui/administrator/people/shown_once_dialog.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QClipboard>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QTableView>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/printed_cards.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/theme.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/access/invitations.h"
#include "sim/core/error.h"

namespace torsio::gui {

namespace {

constexpr QSize kShownOnceSize(720, 520);

}  // namespace

ShownOnceDialog::ShownOnceDialog(const QString& title, const QString& words, const QString& fileName,
                                 QWidget* parent)
    : QDialog(parent),
      fileName_(fileName),
      table_(new DataTable(QString(), this)),
      copy_(new QPushButton(tr("&Copy"), this)),
      cards_(new QPushButton(tr("Save c&ards (PDF)\u2026"), this)) {
  setWindowTitle(title);
  resize(kShownOnceSize);
  QLabel* said = sentence(this, words);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(cards_, QDialogButtonBox::ActionRole);
  buttons->addButton(copy_, QDialogButtonBox::ActionRole);
  buttons->addButton(tr("Done"), QDialogButtonBox::RejectRole)->setAutoDefault(false);
  cards_->setDefault(true);
  cards_->setFocus();
  connect(cards_, &QPushButton::clicked, this, &ShownOnceDialog::askCards);
  connect(copy_, &QPushButton::clicked, this, &ShownOnceDialog::copy);
  connect(buttons, &QDialogButtonBox::rejected, this, &ShownOnceDialog::reject);
  QVBoxLayout* column = pageColumn(this);
  column->setSpacing(kSpace);
  column->addWidget(said);
  column->addWidget(table_, 1);
  column->addWidget(buttons);
}

void ShownOnceDialog::setLines(const std::vector<Column>& columns, std::vector<Row> rows) {
  table_->setColumns(columns);
  table_->setRows(std::move(rows));
}

QString ShownOnceDialog::linesAsText() const {
  table_->view().clearSelection();
  return table_->asText();
}

void ShownOnceDialog::copy() {
  QApplication::clipboard()->setText(copied());
  copy_->setText(tr("Copied"));
  taken_ = true;
}

void ShownOnceDialog::saveCards(const std::filesystem::path& file) {
  writeCards(file);
  cards_->setText(tr("Cards saved"));
  taken_ = true;
}

void ShownOnceDialog::askCards() {
  const QString file = askFileToSave(this, tr("Save cards"), fileName_, tr("PDF (*.pdf)"));
  if (file.isEmpty()) {
    return;
  }
  try {
    saveCards(toPath(file));
  } catch (const Error& error) {
    QMessageBox::warning(this, tr("Save cards"), translatedLine(error));
  }
}

void ShownOnceDialog::reject() {
  if (!taken_ && QMessageBox::question(this, windowTitle(),
                                       tr("Nothing was copied or saved, and this is not shown again. Close "
                                          "all the same?")) != QMessageBox::Yes) {
    return;
  }
  QDialog::reject();
}

AccountsDialog::AccountsDialog(const std::vector<StartAccount>& accounts, const std::string& centre,
                               QWidget* parent)
    : ShownOnceDialog(tr("Start passwords"), toQString(handOverWords(accounts)), tr("start-passwords.pdf"),
                      parent),
      accounts_(accounts),
      centre_(centre) {
  const bool halves = std::any_of(accounts_.begin(), accounts_.end(), [](const StartAccount& account) {
    return account.part != PasswordPart::kWhole;
  });
  std::vector<Column> columns{{tr("Person")}, {tr("Sign-in name")}, {tr("Start password")}};
  if (halves) {
    columns.push_back({tr("Which part")});
  }
  std::vector<Row> rows;
  for (const StartAccount& account : accounts_) {
    const QString code = toQString(account.personCode);
    const QString person = account.personName.empty()
                               ? code
                               : QStringLiteral("%1 \u00B7 %2").arg(code, toQString(account.personName));
    std::vector<Cell> cells{{person}, {toQString(account.login)}, {toQString(writtenPassword(account))}};
    if (halves) {
      cells.push_back({toQString(partWords(account))});
    }
    rows.push_back({toQString(account.login), std::move(cells)});
  }
  setLines(columns, std::move(rows));
}

void AccountsDialog::writeCards(const std::filesystem::path& file) const {
  writeAccountCards(accounts_, centre_, file);
}

KioskCardsDialog::KioskCardsDialog(std::vector<KioskCardText> cards, std::string centre, QWidget* parent)
    : ShownOnceDialog(tr("Cards for the kiosk"),
                      tr("These codes are shown only now. Each opens a kiosk for its trainee; one that is "
                         "lost is revoked "
                         "here, or replaced by making a new one."),
                      tr("kiosk-cards.pdf"), parent),
      cards_(std::move(cards)),
      centre_(std::move(centre)) {
  setObjectName(QStringLiteral("kioskCards"));
  std::vector<Row> rows;
  for (const KioskCardText& card : cards_) {
    rows.push_back({toQString(card.login),
                    {{toQString(card.personCode)}, {toQString(card.login)}, {toQString(card.code)}}});
  }
  setLines({{tr("Person")}, {tr("Sign-in name")}, {tr("Code")}}, std::move(rows));
}

void KioskCardsDialog::writeCards(const std::filesystem::path& file) const {
  writeKioskCards(cards_, centre_, file);
}

namespace {

struct InvitationQuestion {
  Q_DECLARE_TR_FUNCTIONS(InvitationQuestion)
};

}  // namespace

InvitationsDialog::InvitationsDialog(std::vector<InvitationCardText> cards, std::string centre,
                                     QWidget* parent)
    : ShownOnceDialog(
          tr("Invitations"),
          tr("Links and codes are shown only now. Each is for one person; a link works once and expires "
             "after a week. Send each code by a different channel from the link, which another "
             "administrator hands over."),
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
  auto* where = named(new QLineEdit(toQString(address), &dialog), "browserAddress");
  where->setPlaceholderText(QStringLiteral("https://desk.example.org"));
  auto* why = named(new QLineEdit(&dialog), "reason");
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
