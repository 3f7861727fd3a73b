// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/scoring/remind_dialog.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTableView>
#include <QVBoxLayout>

#include "app/connectors/built_in.h"
#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/base/reminder_text.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/widgets/data_table.h"
#include "app/gui/widgets/form.h"

namespace torsio::gui {

namespace {

constexpr QSize kRemindSize(860, 560);
constexpr int kLargestPort = 65'535;
constexpr int kStartTlsPort = 587;
constexpr int kTlsPort = 465;

struct MailServerDialog {
  Q_DECLARE_TR_FUNCTIONS(MailServerDialog)
};

}  // namespace

std::optional<MailSettings> askMailServer(QWidget* parent, const std::optional<MailSettings>& before) {
  QuestionDialog dialog(parent, MailServerDialog::tr("Mail server"),
                        MailServerDialog::tr("Reminders go through this server of your centre. Its password "
                                             "is not stored: enter it each time you send."));
  const MailSettings known = before.value_or(MailSettings{});
  auto* host = named(new QLineEdit(toQString(known.server.host), &dialog), "mailHost");
  auto* port = ranged(named(new QSpinBox(&dialog), "mailPort"), 1, kLargestPort);
  auto* encryption = named(new QComboBox(&dialog), "mailEncryption");
  auto* user = named(new QLineEdit(toQString(known.server.user), &dialog), "mailUser");
  auto* from = named(new QLineEdit(toQString(known.from), &dialog), "mailFrom");
  host->setPlaceholderText(QStringLiteral("mail.example.org"));
  from->setPlaceholderText(QStringLiteral("skills-laboratory@example.org"));
  encryption->addItem(MailServerDialog::tr("STARTTLS (port 587)"));  // in the order of MailEncryption
  encryption->addItem(MailServerDialog::tr("TLS from the beginning (port 465)"));
  encryption->addItem(MailServerDialog::tr("none: a server on this computer"));
  encryption->setCurrentIndex(static_cast<int>(known.server.encryption));
  port->setValue(known.server.port);
  QObject::connect(encryption, &QComboBox::currentIndexChanged, port, [port](int chosen) {
    if (chosen < 2) {
      port->setValue(chosen == 0 ? kStartTlsPort : kTlsPort);
    }
  });
  auto* form = new QFormLayout;
  form->addRow(MailServerDialog::tr("&Server"), host);
  form->addRow(MailServerDialog::tr("&Encryption"), encryption);
  form->addRow(MailServerDialog::tr("&Port"), port);
  form->addRow(MailServerDialog::tr("Sign-in &name, if it asks for one"), user);
  form->addRow(MailServerDialog::tr("Messages come &from"), from);
  dialog.column()->addLayout(form);
  if (!dialog.ask(MailServerDialog::tr("Save"))) {
    return std::nullopt;
  }
  MailSettings settings;
  settings.server.host = host->text().trimmed().toStdString();
  settings.server.port = static_cast<std::uint16_t>(port->value());
  settings.server.encryption = static_cast<MailEncryption>(encryption->currentIndex());
  settings.server.user = user->text().trimmed().toStdString();
  settings.from = from->text().trimmed().toStdString();
  return settings;
}

RemindDialog::RemindDialog(ShellContext& shell, const CohortId& cohortId, QWidget* parent)
    : QDialog(parent),
      shell_(shell),
      cohortId_(cohortId),
      table_(named(new DataTable(QStringLiteral("reminders"), this), "reminders")),
      server_(sentence(this)),
      password_(named(secretField(this), "mailPassword")),
      set_(named(new QPushButton(tr("Mail ser&ver\u2026"), this), "setMailServer")),
      copy_(new QPushButton(tr("&Copy"), this)),
      send_(named(primaryButton(this), "sendReminders")) {
  setObjectName(QStringLiteral("remindDialog"));
  setWindowTitle(tr("Reminders"));
  resize(kRemindSize);
  table_->setColumns(
      {{tr("Rater")}, {tr("Mail address")}, {tr("Sheets"), true, true}, {tr("Late"), true, true}});
  table_->setEmptyText(tr("No sheets are outstanding."));
  QLabel* words = sentence(this, false);
  words->setText(
      tr("Each selected rater receives a message with the labels of their own cases, and nothing else."));
  auto* row = new QHBoxLayout;
  passwordLabel_ = addField(row, password_);
  nameField(passwordLabel_, tr("Pass&word of the mail server"));
  row->addStretch(1);
  auto* buttons = new QDialogButtonBox(this);
  buttons->addButton(set_, QDialogButtonBox::ActionRole);
  buttons->addButton(copy_, QDialogButtonBox::ActionRole);
  buttons->addButton(send_, QDialogButtonBox::ActionRole);
  buttons->addButton(tr("C&lose"), QDialogButtonBox::RejectRole);
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(words);
  column->addWidget(table_, 1);
  column->addWidget(server_);
  column->addLayout(row);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &RemindDialog::reject);
  connect(set_, &QPushButton::clicked, this, &RemindDialog::askServer);
  connect(copy_, &QPushButton::clicked, this,
          [this] { attempt(shell_, [this] { copyReminders(shell_, cohortId_, locale()); }); });
  connect(send_, &QPushButton::clicked, this, &RemindDialog::send);
  connect(table_, &DataTable::currentChanged, this, &RemindDialog::showButtons);
  for (QWidget* mailing : std::initializer_list<QWidget*>{server_, set_, send_}) {
    mailing->setVisible(kMailBuiltIn);
  }
  read();
  table_->view().selectAll();
}

void RemindDialog::read() {
  attempt(shell_, [&] {
    owed_ = reminders(shell_.session(), cohortId_);
    settings_ = mailSettings(shell_.session());
  });
  std::vector<Row> rows;
  for (const Reminder& one : owed_) {
    qlonglong late = 0;
    for (const SheetAwaited& sheet : one.sheets) {
      late += sheet.late ? 1 : 0;
    }
    const auto count = static_cast<qlonglong>(one.sheets.size());
    rows.push_back({toQString(one.raterCode),
                    {{toQString(one.raterCode)},
                     {one.email.empty() ? tr("none is known") : toQString(one.email)},
                     {QString::number(count), count},
                     {QString::number(late), late}}});
  }
  table_->setRows(std::move(rows));
  showButtons();
}

void RemindDialog::showButtons() {
  server_->setText(
      settings_ ? tr("By %1, from %2").arg(toQString(settings_->server.host), toQString(settings_->from))
                : tr("The centre has set no mail server: set one, or copy the reminders into your "
                     "own mail."));
  const bool signsIn = settings_ && !settings_->server.user.empty();
  passwordLabel_->setVisible(signsIn);
  password_->setVisible(signsIn);
  set_->setEnabled(shell_.may(Operation::kSettingsEdit));
  copy_->setEnabled(!owed_.empty());
  const auto count = static_cast<int>(messages().size());
  send_->setText(tr("&Send %n message(s)", nullptr, count));
  send_->setEnabled(count > 0);
}

void RemindDialog::askServer() {
  const std::optional<MailSettings> settings = askMailServer(this, settings_);
  if (!settings) {
    return;
  }
  attempt(shell_, [&] { setMailSettings(shell_.session(), *settings); });
  read();
}

std::vector<MailedReminder> RemindDialog::messages() const {
  std::vector<MailedReminder> messages;
  const QStringList chosen = table_->selectedIds();
  for (const Reminder& one : owed_) {
    if (settings_ && !one.email.empty() && chosen.contains(toQString(one.raterCode))) {
      messages.push_back({one, tr("Torsio: sheets to submit").toStdString(),
                          reminderText({one}, locale()).toStdString() + "\n"});
    }
  }
  return messages;
}

void RemindDialog::send() {
  const std::string password = password_->text().toStdString();
  password_->clear();
  shell_.run(
      this, tr("Sending reminders"),
      [password, sent = messages()](SessionContext& session, const ProgressCallback& progress) {
        return sendReminders(session, password, sent, progress);
      },
      [this, sent = messages()](const std::vector<Text>& refusals) { showRefusals(sent, refusals); });
}

void RemindDialog::showRefusals(const std::vector<MailedReminder>& sent, const std::vector<Text>& refusals) {
  QStringList refused;
  for (std::size_t i = 0; i < sent.size(); ++i) {
    if (!refusals[i].empty()) {
      refused << tr("%1: %2").arg(toQString(sent[i].reminder.email), toQString(refusals[i]));
    }
  }
  server_->setText(
      refused.isEmpty()
          ? tr("\u2713 The mail server took %n message(s).", nullptr, static_cast<int>(sent.size()))
          : tr("! Refused by the mail server:") + QLatin1Char('\n') + refused.join(QLatin1Char('\n')));
}

}  // namespace torsio::gui
