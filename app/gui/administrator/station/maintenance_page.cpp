// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/station/maintenance_page.h"

#include <filesystem>
#include <system_error>

#include <QDate>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/gui/administrator/base/administrator_parts.h"
#include "app/gui/administrator/base/question_dialog.h"
#include "app/gui/administrator/station/installation_dialog.h"
#include "app/gui/administrator/station/retention_queue.h"
#include "app/gui/base/shell_context.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/file_choice.h"
#include "app/gui/widgets/form.h"
#include "app/gui/widgets/page_parts.h"
#include "app/gui/widgets/value_text.h"
#include "app/services/access/move_notice.h"
#include "app/services/installation/support_report.h"
#include "app/services/maintenance/anchor.h"
#include "app/services/maintenance/station_anchor.h"

namespace torsio::gui {

namespace {

constexpr int kDiskParts = 1000;

bool isFile(const std::string& locator) {
  return QFileInfo(toQString(locator)).isFile();
}

}  // namespace

MaintenancePage::MaintenancePage(ShellContext& shell)
    : Page(shell),
      heading_(new PageHeading(this)),
      record_(new Card(QString(), this)),
      recordText_(named(sentence(this, false), "recordText")),
      disk_(ranged(new QProgressBar(this), 0, kDiskParts)),
      diskText_(named(sentence(this), "diskText")),
      checkButton_(new QPushButton(this)),
      computerButton_(named(new QPushButton(this), "checkComputer")),
      backup_(new Card(QString(), this)),
      backupText_(named(sentence(this, false), "backupText")),
      backupButton_(primaryButton(this)),
      testButton_(new QPushButton(this)),
      simulated_(new Card(QString(), this)),
      simulatedText_(sentence(this, false)),
      removeButton_(new QPushButton(this)),
      move_(new Card(QString(), this)),
      moveText_(sentence(this, false)),
      restoreButton_(new QPushButton(this)),
      moveButton_(new QPushButton(this)),
      takeBackButton_(named(new QPushButton(this), "takeBackMove")),
      queue_(new RetentionQueue(shell, this)) {
  QVBoxLayout* column = pageColumn(this);
  column->addWidget(heading_);
  column->addWidget(cards());
  column->addWidget(queue_, 1);
  connect(checkButton_, &QPushButton::clicked, this, &MaintenancePage::checkRecord);
  connect(computerButton_, &QPushButton::clicked, this, &MaintenancePage::checkComputer);
  connect(backupButton_, &QPushButton::clicked, this, &MaintenancePage::askBackUp);
  connect(testButton_, &QPushButton::clicked, this, &MaintenancePage::askTest);
  connect(removeButton_, &QPushButton::clicked, this, &MaintenancePage::askRemoveDemonstration);
  connect(restoreButton_, &QPushButton::clicked, this, [this] { this->shell().open(PageId::kRestore); });
  connect(moveButton_, &QPushButton::clicked, this, [this] { this->shell().open(PageId::kMove); });
  connect(takeBackButton_, &QPushButton::clicked, this, &MaintenancePage::askTakeBack);
  retranslate();
}

QWidget* MaintenancePage::cards() {
  auto* box = new QWidget(this);
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(2 * kSpace);
  disk_->setTextVisible(false);
  disk_->setFixedHeight(kSpace);
  const auto fill = [](Card* card, std::initializer_list<QWidget*> content,
                       std::initializer_list<QPushButton*> acts) {
    for (QWidget* widget : content) {
      card->content()->addWidget(widget);
    }
    card->content()->addStretch(1);
    auto* row = new QHBoxLayout;
    for (QPushButton* button : acts) {
      row->addWidget(button);
    }
    row->addStretch(1);
    card->content()->addLayout(row);
  };
  fill(backup_, {backupText_}, {backupButton_, testButton_});
  fill(record_, {recordText_, diskText_, disk_}, {checkButton_, computerButton_});
  fill(simulated_, {simulatedText_}, {removeButton_});
  fill(move_, {moveText_}, {restoreButton_, moveButton_, takeBackButton_});
  int place = 0;
  for (Card* card : {backup_, record_, simulated_, move_}) {
    grid->addWidget(card, 0, place);
    grid->setColumnStretch(place++, 1);
  }
  return box;
}

void MaintenancePage::enter(const QVariant&) {
  read();
}

void MaintenancePage::read() {
  attempt(shell(), [&] {
    if (shell().may(Operation::kPersonErase)) {
      demonstration_ = demonstrationSize(shell().session());
    }
    showRecord();
    queue_->read();
    showButtons();
  });
}

void MaintenancePage::showRecord() {
  const std::string locator = shell().session().key().locator;
  QStringList lines;
  if (isFile(locator)) {
    const QFileInfo file(toQString(locator));
    // Queries the folder itself: the list of mounts misses the disk of a changed root.
    std::error_code failed;
    const std::filesystem::space_info disk = std::filesystem::space(toPath(file.absolutePath()), failed);
    const bool known = !failed && disk.capacity > 0;
    const QString size = locale().formattedDataSize(file.size());
    lines << file.absoluteFilePath();
    lines << (known ? tr("%1, %2 free on the disk")
                          .arg(size, locale().formattedDataSize(static_cast<qint64>(disk.available)))
                    : size);
    if (known) {
      const double used = 1.0 - static_cast<double>(disk.available) / static_cast<double>(disk.capacity);
      disk_->setValue(static_cast<int>(kDiskParts * used));
      diskText_->setText(tr("Disk in use: %1 %").arg(numberText(100.0 * used, 0)));
    }
    disk_->setAccessibleName(tr("Disk in use"));
    disk_->setVisible(known);
    diskText_->setVisible(known);
  } else {
    lines << tr("On a database server");
    disk_->setVisible(false);
    diskText_->setVisible(false);
  }
  if (check_) {
    lines << (check_->sound() ? tr("\u2713 Checked: sound, schema %1, audit entries: %2")
                                    .arg(check_->schemaVersion)
                                    .arg(countText(check_->auditEntries))
                              : tr("\u2717 Checked: %n finding(s), first: %1", nullptr,
                                   static_cast<int>(check_->damage.size() + check_->audit.size()))
                                    .arg(check_->damage.empty() ? toQString(check_->audit.front().what)
                                                                : toQString(check_->damage.front())));
  }
  recordText_->setText(lines.join(QLatin1Char('\n')));
  setLook(recordText_, "caution", check_ && !check_->sound());
  simulatedText_->setText(demonstration_.people == 0
                              ? tr("There are no simulated people in this record.")
                              : tr("Simulated people: %1, recordings: %2, marks: %3. They are marked "
                                   "everywhere and can be removed in one step; real data stay.")
                                    .arg(countText(demonstration_.people), countText(demonstration_.trials),
                                         countText(demonstration_.marks)));
}

void MaintenancePage::showButtons() {
  const bool file = isFile(shell().session().key().locator);
  backupButton_->setEnabled(file && shell().may(Operation::kDatabaseBackup));
  testButton_->setEnabled(shell().may(Operation::kDatabaseBackup));
  checkButton_->setEnabled(shell().may(Operation::kDatabaseBackup));
  computerButton_->setEnabled(shell().may(Operation::kDatabaseBackup));
  removeButton_->setEnabled(demonstration_.people > 0 && shell().may(Operation::kPersonErase));
  restoreButton_->setEnabled(file && shell().may(Operation::kDatabaseRestore));
  moveButton_->setEnabled(file && shell().may(Operation::kDatabaseRestore));
  const Text notice = moveNotice(shell().session().connectionWithoutRight());
  takeBackButton_->setVisible(!notice.empty());
  takeBackButton_->setEnabled(shell().may(Operation::kDatabaseRestore));
  moveButton_->setVisible(notice.empty());
  moveText_->setText(
      !notice.empty() ? toQString(notice)
      : file
          ? tr("A backup takes the place of this record, or the record goes to a database server for several "
               "stations. Both ask first and show what they will do.")
          : tr("This record is on a database server. Its administrator backs it up and restores it with the "
               "server's own tools."));
}

void MaintenancePage::backUp(const std::filesystem::path& file) {
  shell().run(
      this, tr("Backing up"),
      [file](SessionContext& session, const ProgressCallback& progress) {
        const BackupContent content = backUpDatabase(session, file, progress);
        return std::pair(content, anchoredHead(file.string(), stationAnchor().key, session.now_us()));
      },
      [this, file](const std::pair<BackupContent, std::string>& written) {
        const auto& [content, head] = written;
        QString text = tr("\u2713 Written and read back. Recordings: %1, marks: %2.\n%3")
                           .arg(content.trials)
                           .arg(content.marks)
                           .arg(toQString(file));
        text += QLatin1Char('\n') +
                tr("Checkpoint of the audit trail, to be kept elsewhere: %1").arg(toQString(head));
        if (remindOfKey()) {
          text +=
              QLatin1Char('\n') + tr("No key signs the checkpoints of this station, so anybody who can write "
                                     "to that place can replace them. Make one: Audit trail, Checkpoints.");
        }
        backupText_->setText(text);
      });
}

void MaintenancePage::testBackup(const std::filesystem::path& file) {
  shell().run(
      this, tr("Testing a backup"),
      [file](SessionContext&, const ProgressCallback& progress) { return verifyBackup(file, progress); },
      [this, file](const BackupCheck& found) {
        backupText_->setText(
            found.database.sound()
                ? tr("\u2713 This backup can be restored. Recordings: %1, marks: %2.\n%3")
                      .arg(found.content.trials)
                      .arg(found.content.marks)
                      .arg(toQString(file))
                : tr("\u2717 This backup is not sound. Make a new one.\n%1").arg(toQString(file)));
      });
}

void MaintenancePage::checkRecord() {
  shell().run(
      this, tr("Checking the database"),
      [](SessionContext& session, const ProgressCallback& progress) {
        return checkDatabase(session, progress);
      },
      [this](DatabaseCheck found) {
        check_ = std::move(found);
        showRecord();
      });
}

void MaintenancePage::checkComputer() {
  shell().run(
      this, tr("Looking at this computer"),
      [](SessionContext& session, const ProgressCallback&) {
        return checkInstallation({.locator = session.key().locator, .now_us = session.now_us()});
      },
      [this](std::vector<InstallationCheck> checks) {
        auto* dialog = new InstallationDialog(std::move(checks), this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        connect(dialog, &InstallationDialog::reportWanted, this, &MaintenancePage::saveSupportReport);
        dialog->open();
      });
}

void MaintenancePage::saveSupportReport(const QString& file) {
  shell().run(
      this, tr("Writing the report"),
      [path = toPath(file)](SessionContext& session, const ProgressCallback&) {
        writeSupportReport(path, {.locator = session.key().locator, .now_us = session.now_us()});
      },
      [this, file] { shell().notify(tr("Saved: %1. Read it before you send it").arg(file)); });
}

void MaintenancePage::askTakeBack() {
  const std::optional<std::string> reason = askReason(this, tr("Take the move back"),
                                                      tr("Why does this record become the living one again? "
                                                         "What was added at the other place since then stays "
                                                         "there."));
  if (reason) {
    attempt(shell(), [&] {
      takeBackMove(shell().session(), *reason);
      shell().changeRecord({.sentence = tr("This record is the living one again")});
    });
  }
}

bool MaintenancePage::removeDemonstration(const std::string& reason) {
  return attempt(shell(), [&] {
    const DemonstrationSize gone = removeDemonstrationData(shell().session(), reason);
    read();
    shell().notify(tr("Removed: simulated people %1, recordings %2")
                       .arg(countText(gone.people), countText(gone.trials)));
  });
}

void MaintenancePage::askBackUp() {
  const QString name = QStringLiteral("torsio-%1.sqlite").arg(QDate::currentDate().toString(Qt::ISODate));
  const QString file = askFileToSave(this, tr("Back up to"), name, tr("Backup (*.sqlite)"));
  if (!file.isEmpty()) {
    backUp(toPath(file));
  }
}

void MaintenancePage::askTest() {
  const QString file = askFileToOpen(this, tr("Test a backup"), tr("Backup (*.sqlite)"));
  if (!file.isEmpty()) {
    testBackup(toPath(file));
  }
}

void MaintenancePage::askRemoveDemonstration() {
  const std::optional<std::string> reason = askReason(
      this, tr("Remove the demonstration"),
      tr("The simulated people (%1) and all that belongs to them go at once. This cannot be taken back.")
          .arg(demonstration_.people));
  if (reason) {
    removeDemonstration(*reason);
  }
}

void MaintenancePage::retranslate() {
  heading_->setTexts(tr("Maintenance of the record"),
                     tr("Back up, test the backup, and review what is due."));
  backup_->setTitle(tr("Backup"));
  backupText_->setText(
      tr("A backup is one file, made while others work and read back at once. Keep it on another machine."));
  backupButton_->setText(tr("&Back up\u2026"));
  testButton_->setText(tr("&Test a backup\u2026"));
  record_->setTitle(tr("This record"));
  checkButton_->setText(tr("&Check the database"));
  computerButton_->setText(tr("Check this c&omputer"));
  simulated_->setTitle(tr("Demonstration"));
  removeButton_->setText(tr("Re&move\u2026"));
  move_->setTitle(tr("Restore or move"));
  restoreButton_->setText(tr("Re&store\u2026"));
  moveButton_->setText(tr("Mo&ve to PostgreSQL\u2026"));
  takeBackButton_->setText(tr("Ta&ke the move back\u2026"));
  queue_->retranslate();
  showRecord();
  showButtons();
}

}  // namespace torsio::gui
