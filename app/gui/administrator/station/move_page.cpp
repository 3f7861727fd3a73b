// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/station/move_page.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"

namespace torsio::gui {

namespace {

constexpr int kLastPort = 65535;

}  // namespace

MovePage::MovePage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      back_(new QPushButton(this)),
      server_(new Card(QString(), this)),
      hostLabel_(new QLabel(this)),
      host_(new QLineEdit(this)),
      portLabel_(new QLabel(this)),
      port_(ranged(new QSpinBox(this), 1, kLastPort)),
      databaseLabel_(new QLabel(this)),
      database_(new QLineEdit(this)),
      userLabel_(new QLabel(this)),
      user_(new QLineEdit(this)),
      passwordLabel_(new QLabel(this)),
      password_(secretField(this)),
      schemaLabel_(new QLabel(this)),
      schema_(new QLineEdit(this)),
      tlsLabel_(new QLabel(this)),
      tlsMode_(new QComboBox(this)),
      rootLabel_(new QLabel(this)),
      root_(new QLineEdit(this)),
      serverText_(named(sentence(this, false), "serverText")),
      test_(named(new QPushButton(this), "testButton")),
      copyCard_(new Card(QString(), this)),
      copyText_(named(sentence(this, false), "copyText")),
      copy_(named(new QPushButton(this), "copyButton")),
      switchCard_(new Card(QString(), this)),
      switchText_(sentence(this, false)),
      line_(new QLineEdit(this)),
      copyLine_(new QPushButton(this)),
      switch_(named(new QPushButton(this), "switchButton")) {
  layOut();
  connect(back_, &QPushButton::clicked, this, [this] { this->shell().open(PageId::kMaintenance); });
  for (QLineEdit* field : {host_, database_, user_, password_, schema_, root_}) {
    connect(field, &QLineEdit::textChanged, this, &MovePage::addressChanged);
    connect(field, &QLineEdit::returnPressed, this, &MovePage::testServer);
  }
  connect(port_, &QSpinBox::valueChanged, this, &MovePage::addressChanged);
  connect(tlsMode_, &QComboBox::currentIndexChanged, this, &MovePage::addressChanged);
  connect(test_, &QPushButton::clicked, this, &MovePage::testServer);
  connect(copy_, &QPushButton::clicked, this, &MovePage::copyRecord);
  connect(switch_, &QPushButton::clicked, this, &MovePage::switchStation);
  connect(copyLine_, &QPushButton::clicked, this, [this] {
    QApplication::clipboard()->setText(line_->text());
    this->shell().notify(tr("The line is in the clipboard"));
  });
  connect(&shell, &ShellContext::jobStarted, this, &MovePage::showButtons);
  connect(&shell, &ShellContext::jobEnded, this, &MovePage::showButtons);
  retranslate();
}

QWidget* MovePage::form() {
  auto* box = new QWidget(server_);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(2 * kSpace);
  grid->setVerticalSpacing(kSpace / 2);
  port_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  port_->setValue(ServerAddress{}.port);
  const auto put = [grid](QLabel* label, QWidget* field, int row, int column) {
    label->setBuddy(field);
    grid->addWidget(label, 2 * row, column);
    grid->addWidget(field, 2 * row + 1, column);
  };
  put(hostLabel_, host_, 0, 0);
  put(portLabel_, port_, 0, 1);
  put(databaseLabel_, database_, 0, 2);
  put(userLabel_, user_, 1, 0);
  put(passwordLabel_, password_, 1, 1);
  put(schemaLabel_, schema_, 1, 2);
  tlsMode_->addItem(QString(), QString());
  tlsMode_->addItem(QString(), QStringLiteral("verify-full"));
  put(tlsLabel_, tlsMode_, 2, 0);
  put(rootLabel_, root_, 2, 1);
  for (const int column : {0, 1, 2}) {
    grid->setColumnStretch(column, 1);
  }
  return box;
}

void MovePage::layOut() {
  heading_->addAction(back_);
  QVBoxLayout* column = scrolledColumn(this);
  column->addWidget(heading_);
  for (Card* card : {server_, copyCard_, switchCard_}) {
    column->addWidget(card);
  }
  column->addStretch(1);
  const auto row = [](Card* card, std::initializer_list<QWidget*> widgets) {
    QHBoxLayout* line = rowOf();
    for (QWidget* widget : widgets) {
      line->addWidget(widget);
    }
    line->addStretch(1);
    card->content()->addLayout(line);
  };
  for (QPushButton* button : {test_, copy_, switch_}) {
    button->setProperty("primary", true);
  }
  server_->content()->addWidget(form());
  server_->content()->addWidget(serverText_);
  row(server_, {test_});
  copyCard_->content()->addWidget(copyText_);
  row(copyCard_, {copy_});
  switchCard_->content()->addWidget(switchText_);
  line_->setReadOnly(true);
  QHBoxLayout* lineRow = rowOf();
  lineRow->addWidget(line_, 1);
  lineRow->addWidget(copyLine_);
  switchCard_->content()->addLayout(lineRow);
  row(switchCard_, {switch_});
}

ServerAddress MovePage::address() const {
  return {.host = host_->text().trimmed().toStdString(),
          .port = port_->value(),
          .database = database_->text().trimmed().toStdString(),
          .user = user_->text().trimmed().toStdString(),
          .password = password_->text().toStdString(),
          .schema = schema_->text().trimmed().toStdString(),
          .tlsMode = tlsMode_->currentData().toString().toStdString(),
          .rootCertificate = root_->text().trimmed().toStdString()};
}

void MovePage::setAddress(const ServerAddress& address) {
  host_->setText(toQString(address.host));
  port_->setValue(address.port);
  database_->setText(toQString(address.database));
  user_->setText(toQString(address.user));
  password_->setText(toQString(address.password));
  schema_->setText(toQString(address.schema));
  tlsMode_->setCurrentIndex(std::max(0, tlsMode_->findData(toQString(address.tlsMode))));
  root_->setText(toQString(address.rootCertificate));
}

void MovePage::enter(const QVariant&) {
  password_->clear();
  addressChanged();
  host_->setFocus();
}

void MovePage::addressChanged() {
  check_.reset();
  copied_.reset();
  showCheck();
}

void MovePage::testServer() {
  if (shell().working()) {
    return;
  }
  shell().run(
      this, tr("Checking the server"),
      [typed = address()](SessionContext& session, const ProgressCallback&) {
        return checkServer(session, typed);
      },
      [this](ServerCheck found) {
        check_ = std::move(found);
        showCheck();
      });
}

void MovePage::copyRecord() {
  if (!check_ || shell().working()) {
    return;
  }
  shell().run(
      this, tr("Moving the record to the server"),
      [typed = address()](SessionContext& session, const ProgressCallback& progress) {
        return moveToServer(session, typed, progress);
      },
      [this](CopyReport report) {
        copied_ = std::move(report);
        showCheck();
      });
}

void MovePage::switchStation() {
  if (!ready() || shell().working()) {
    return;
  }
  shell().run(
      this, tr("Turning this station to the server"),
      [typed = address(), report = copied_](SessionContext& session, const ProgressCallback&) {
        return report ? switchToServer(session, typed, *report) : joinServer(session, typed);
      },
      [this, where = toQString(check_->location)](const std::string& locator) {
        RecordChange change;
        change.locator = toQString(locator);
        change.sentence = tr("This station now works with the record at %1. The old file stays as it was; do "
                             "not use it any more")
                              .arg(where);
        shell().changeRecord(change);
      });
}

bool MovePage::ready() const {
  return copied_ || (check_ && check_->holdsRecord);
}

void MovePage::showCheck() {
  QString words =
      tr("The server's administrator makes an empty database and an account for Torsio. The password is used "
         "for this only and stored nowhere.");
  if (check_) {
    words =
        check_->hindrance.empty()
            ? (check_->schemaVersion == 0
                   ? tr("\u2713 %1 answers at %2. The database is empty: the record can be moved there.")
                   : tr("\u2713 %1 answers at %2. Torsio's tables are there and empty: the record can be "
                        "moved there."))
                  .arg(toQString(check_->server), toQString(check_->location))
            : tr("\u2717 %1 answers at %2, but the record cannot be moved there: %3.")
                  .arg(toQString(check_->server), toQString(check_->location), toQString(check_->hindrance));
    if (check_->holdsRecord) {
      words =
          tr("\u2713 %1 answers at %2. There is a record in this database already: this station can join it.")
              .arg(toQString(check_->server), toQString(check_->location));
    }
    if (copied_) {
      words = tr("\u2713 %1 at %2").arg(toQString(check_->server), toQString(check_->location));
    }
  }
  serverText_->setText(words);
  setLook(serverText_, "caution", check_ && !check_->hindrance.empty() && !check_->holdsRecord);
  showCopy();
  showButtons();
}

void MovePage::showCopy() {
  copyCard_->setVisible(check_ && check_->hindrance.empty());
  copyText_->setText(
      copied_
          ? tr("\u2713 Copied and compared: %1 rows of %2 tables have the same counts and hashes on both "
               "sides, and the audit trail of %3 entries fits.")
                .arg(locale().toString(static_cast<qlonglong>(copied_->rows)),
                     locale().toString(static_cast<qlonglong>(copied_->tables.size())),
                     locale().toString(static_cast<qlonglong>(copied_->auditEntries)))
          : tr("Everything is copied and both sides are compared, row by row. Your record stays as it is. "
               "Nobody may be working meanwhile: close Torsio at all other stations."));
  copy_->setVisible(!copied_);
  switchCard_->setVisible(ready());
  if (!ready()) {
    return;
  }
  const bool open = check_->opensWithoutPassword;
  QString words =
      copied_ ? tr("From then on this station works with the server. At every other station open this "
                   "page, give the same address, and join the record.")
              : tr("From then on this station works with that record, and everybody signs in with "
                   "the names and passwords of that record. The record here stays as it is and is "
                   "not used any more.");
  if (!open) {
    words += QLatin1Char('\n') +
             tr("Torsio stores no password. For this station put the line below, with the real password in "
                "place of the last word, into the password file of this computer's account: .pgpass in the "
                "home "
                "folder, readable by the account only (on Windows %APPDATA%\\postgresql\\pgpass.conf). Then "
                "switch.");
  }
  switchText_->setText(words);
  line_->setVisible(!open);
  copyLine_->setVisible(!open);
  line_->setText(toQString(passwordFileLine(address())));
}

void MovePage::showButtons() {
  const bool free = !shell().working();
  for (QWidget* field :
       std::initializer_list<QWidget*>{host_, port_, database_, user_, password_, schema_, tlsMode_, root_}) {
    field->setEnabled(free);
  }
  const ServerAddress typed = address();
  test_->setEnabled(free && !typed.host.empty() && !typed.database.empty() && !typed.user.empty());
  copy_->setEnabled(free && check_ && check_->hindrance.empty());
  switch_->setEnabled(free && ready());
}

void MovePage::retranslate() {
  heading_->setTexts(tr("Move to PostgreSQL"),
                     tr("One record on a server, for several stations. Today's file stays as it is."));
  back_->setText(tr("&Back to maintenance"));
  server_->setTitle(tr("1  The server"));
  nameField(hostLabel_, tr("&Computer"));
  nameField(portLabel_, tr("P&ort"));
  nameField(databaseLabel_, tr("&Database"));
  nameField(userLabel_, tr("&Account"));
  nameField(passwordLabel_, tr("Pass&word"));
  nameField(schemaLabel_, tr("&Schema (leave empty)"));
  nameField(tlsLabel_, tr("&Encryption"));
  nameField(rootLabel_, tr("Certificate of its authorit&y"));
  tlsMode_->setItemText(0, tr("as the server offers it, unchecked"));
  tlsMode_->setItemText(1, tr("checked: this server and no other"));
  root_->setPlaceholderText(tr("the account's own (~/.postgresql/root.crt)"));
  host_->setPlaceholderText(tr("server.hospital.example"));
  test_->setText(tr("&Test the connection"));
  copyCard_->setTitle(tr("2  Copy and compare"));
  copy_->setText(tr("Co&py the record"));
  switchCard_->setTitle(tr("3  This station"));
  line_->setAccessibleName(tr("Line of the password file"));
  copyLine_->setText(tr("Copy the &line"));
  switch_->setText(tr("Sw&itch this station over"));
  showCheck();
}

}  // namespace torsio::gui
