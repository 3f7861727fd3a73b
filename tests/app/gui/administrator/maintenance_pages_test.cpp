// SPDX-License-Identifier: GPL-3.0-or-later
// An administrator restores a backup in the window.
#include <algorithm>
#include <fstream>

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QPlainTextEdit>
#include <QSettings>

#include "app/gui/administrator/station/devices_page.h"
#include "app/gui/administrator/station/heads_page.h"
#include "app/gui/administrator/station/move_page.h"
#include "app/gui/administrator/station/restore_page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/services/access/moved_record.h"
#include "app/services/maintenance/anchor.h"
#include "app/services/maintenance/station_anchor.h"
#include "db/connection/connection.h"
#include "db/migrations/migrations.h"
#include "db/repository/system/audit_verification.h"
#include "tests/app/gui/support/hands.h"
#include "tests/app/gui/support/maintenance_window.h"
#include "tests/support/compared_heads.h"

namespace torsio::gui {
namespace {

using testing::hintBelow;

TEST_F(MaintenancePages, ABackupIsVerifiedComparedConfirmedByAWordAndRestored) {
  maintenancePage().backUp(in("backup.sqlite"));
  context().waitForJobs();
  addPerson(*window_->session(), person());
  auto& page = openBy<RestorePage>("Restore");
  EXPECT_FALSE(child<QPushButton>(page, "restoreButton").isVisible());

  child<QLineEdit>(page, "file").setText(toQString(in("backup.sqlite")));
  click(child<QPushButton>(page, "checkButton"));
  ASSERT_TRUE(child<QLabel>(page, "lossText").isVisible());
  EXPECT_TRUE(
      child<QLabel>(page, "lossText").text().contains(QStringLiteral("recordings 0, marks 0, people 1")));
  EXPECT_FALSE(child<QPushButton>(page, "restoreButton").isEnabled());
  auto& word = child<QLineEdit>(page, "word");
  EXPECT_EQ(hintBelow(page, word), QString());
  testing::retype(word, QStringLiteral("restore"));
  EXPECT_TRUE(hintBelow(page, word).contains(QStringLiteral("RESTORE")));
  EXPECT_FALSE(child<QPushButton>(page, "restoreButton").isEnabled());
  testing::retype(word, QStringLiteral("RESTORE"));
  EXPECT_EQ(hintBelow(page, word), QString());
  word.clear();
  QTest::keyClicks(&child<QLineEdit>(page, "word"), QStringLiteral("RESTORE"));
  click(child<QPushButton>(page, "restoreButton"));
  QTRY_COMPARE_WITH_TIMEOUT(testing::screenOf(*window_), QStringLiteral("sign-in"), 5'000);
  testing::waitFor(window_->background());

  EXPECT_TRUE(says(QStringLiteral("The record was restored from backup.sqlite")));
  EXPECT_EQ(people(record()), 2);
  EXPECT_TRUE(contains(trail(record()), "database.restore"));
  std::string safety;
  for (const auto& entry : fs::directory_iterator(folder_.path().toStdString())) {
    if (entry.path().filename().string().starts_with("torsio-before-restore-")) {
      safety = entry.path().string();
    }
  }
  ASSERT_FALSE(safety.empty());
  EXPECT_EQ(people(safety), 3);
  EXPECT_TRUE(contains(trail(safety), "database.restore_begin"));
  {
    Connection restored = openDatabase(record(), OpenMode::kReadOnly);
    EXPECT_TRUE(verifyAuditTrail(restored).empty());
  }
  signIn();
}

/// Uses separate settings of this account, in which a station stores its key and witness.
class HeadsPages : public MaintenancePages {
 protected:
  void SetUp() override {
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                       folder_.path() + QStringLiteral("/settings"));
    MaintenancePages::SetUp();
  }
  HeadsPage& page() {
    window_->desk()->open(PageId::kAudit);
    QTest::mouseClick(&child<QPushButton>(*window_->desk()->page(), "heads"), Qt::LeftButton);
    return dynamic_cast<HeadsPage&>(*window_->desk()->page());
  }
  QString verdictOn(HeadsPage& page, const QString& lines) {
    child<QPlainTextEdit>(page, "keptHeads").setPlainText(lines);
    click(child<QPushButton>(page, "verifyHeads"));
    return child<QLabel>(page, "headsVerdict").text();
  }
};

TEST_F(HeadsPages, AStationWithoutAKeySaysSoCreatesOneAndReplacesIt) {
  HeadsPage& heads = page();
  EXPECT_TRUE(child<QLabel>(heads, "keyText").text().contains(QStringLiteral("has no key")));
  EXPECT_TRUE(child<QLabel>(heads, "witnessText").text().contains(QStringLiteral("keeps no checkpoints")));
  EXPECT_FALSE(child<QPushButton>(heads, "addHead").isEnabled());
  EXPECT_TRUE(child<QPlainTextEdit>(heads, "head").toPlainText().endsWith(QStringLiteral(" - -")));

  heads.keepIn(in("heads"));
  heads.makeKey(in("key"));
  const std::string first = publicAnchorKey(in("key"));
  EXPECT_TRUE(child<QLabel>(heads, "keyText").text().contains(toQString(first)));
  EXPECT_TRUE(child<QLabel>(heads, "keyText").text().contains(QStringLiteral("beside the record")));
  EXPECT_TRUE(child<QLabel>(heads, "witnessText").text().contains(QStringLiteral("same disk as the record")));
  EXPECT_TRUE(child<QPlainTextEdit>(heads, "head").toPlainText().contains(toQString(first)));
  click(child<QPushButton>(heads, "addHead"));
  context().waitForJobs();
  heads.makeKey(in("second"));
  click(child<QPushButton>(heads, "addHead"));
  context().waitForJobs();

  EXPECT_EQ(stationAnchor().key, in("second"));
  EXPECT_TRUE(fs::exists(in("key"))) << "older heads are checked with it";
  const std::vector<std::string> lines = headsOf(in("heads"));
  ASSERT_EQ(lines.size(), 4U) << "at the choice, with the first key, its replacement, with the second";
  EXPECT_TRUE(lines[2].starts_with("torsio-key 1 "));
  QStringList kept;
  for (const std::string& line : lines) {
    kept << toQString(line);
  }
  EXPECT_TRUE(
      verdictOn(heads, kept.join(QLatin1Char('\n'))).contains(QStringLiteral("nothing has been removed")));
  EXPECT_EQ(std::ranges::count(trail(record()), "setting.change"), 3 + 1) << "and the one of the set-up";
  EXPECT_TRUE(failures_.isEmpty()) << failures_.join(QLatin1Char('\n')).toStdString();
}

TEST_F(HeadsPages, AnAdministratorTakesTheHeadAlongWhenSigningOut) {
  ASSERT_TRUE(window_->signOut());
  auto& notice = child<QWidget>(*window_, "headNotice");
  EXPECT_TRUE(notice.isVisible());
  EXPECT_TRUE(says(QStringLiteral("not signed")));
  EXPECT_TRUE(says(QStringLiteral("This station keeps no checkpoints")));
  QTest::mouseClick(&child<QPushButton>(notice, "copyHead"), Qt::LeftButton);
  const QString line = QGuiApplication::clipboard()->text();
  const std::vector<AuditFinding> findings = compareWithHeads(record(), {line.toStdString()}, {});
  EXPECT_TRUE(findings.empty()) << line.toStdString();
  EXPECT_EQ(child<QLabel>(notice, "headHash").text().remove(QLatin1Char('\n')),
            line.section(QLatin1Char(' '), 3, 3));

  signIn();
  HeadsPage& heads = page();
  fs::create_directory(in("disk"));
  heads.keepIn(in("disk/heads"));
  heads.makeKey(in("key"));
  ASSERT_TRUE(window_->signOut());
  EXPECT_TRUE(says(QStringLiteral("added to the witness file")));
  EXPECT_EQ(headsOf(in("disk/heads")).size(), 2U);
  QTest::mouseClick(&child<QPushButton>(notice, "copyHead"), Qt::LeftButton);
  EXPECT_EQ(QGuiApplication::clipboard()->text().toStdString(), headsOf(in("disk/heads")).at(1));

  signIn();
  fs::remove_all(in("disk"));  // unplugged
  ASSERT_TRUE(window_->signOut());
  EXPECT_TRUE(says(QStringLiteral("The checkpoint was not saved")));
  EXPECT_EQ(child<QLabel>(notice, "headHash").text().size(), 64 + 1);
}

TEST_F(HeadsPages, AClosingWindowPrintsWhereTheHeadIsAndStaysOpenIfItIsNowhere) {
  fs::create_directory(in("disk"));
  page().keepIn(in("disk/heads"));
  fs::rename(in("disk"), in("unplugged"));

  EXPECT_FALSE(window_->close());
  EXPECT_TRUE(window_->isVisible());
  EXPECT_TRUE(says(QStringLiteral("The checkpoint was not saved")));
  EXPECT_TRUE(says(QStringLiteral("Close the window once more")));
  EXPECT_EQ(headsOf(in("unplugged/heads")).size(), 1U);
  fs::rename(in("unplugged"), in("disk"));

  signIn();
  ::testing::internal::CaptureStderr();
  EXPECT_TRUE(window_->close());
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_EQ(headsOf(in("disk/heads")).size(), 2U);
  EXPECT_NE(said.find(in("disk/heads").string()), std::string::npos) << said;
}

TEST_F(HeadsPages, AHeadEnteredByHandRevealsATruncatedTrail) {
  HeadsPage& heads = page();
  QString head = child<QPlainTextEdit>(heads, "head").toPlainText();
  EXPECT_TRUE(verdictOn(heads, QLatin1Char(' ') + head).contains(QStringLiteral("nothing has been removed")));

  QStringList words = head.split(QLatin1Char(' '));
  words[2] = QStringLiteral("4000");
  EXPECT_TRUE(verdictOn(heads, words.join(QLatin1Char(' '))).contains(QStringLiteral("it was truncated")));
  EXPECT_TRUE(failures_.isEmpty());
}

TEST_F(HeadsPages, AnInvalidHeadOrKeyIsReportedBelowItsField) {
  HeadsPage& heads = page();
  auto& lines = child<QPlainTextEdit>(heads, "keptHeads");
  auto& key = child<QLineEdit>(heads, "publicKey");
  auto& verify = child<QPushButton>(heads, "verifyHeads");
  EXPECT_EQ(hintBelow(heads, lines), QString());
  testing::leave(lines);
  EXPECT_FALSE(hintBelow(heads, lines).isEmpty());
  EXPECT_FALSE(verify.isEnabled());

  lines.setPlainText(QStringLiteral("something else"));
  EXPECT_EQ(hintBelow(heads, lines), QString());
  click(verify);
  EXPECT_TRUE(hintBelow(heads, lines).contains(QStringLiteral("not the checkpoint of an audit trail")))
      << hintBelow(heads, lines).toStdString();
  EXPECT_TRUE(failures_.isEmpty());

  lines.setPlainText(child<QPlainTextEdit>(heads, "head").toPlainText());
  testing::retype(key, QStringLiteral("12ab"));
  EXPECT_TRUE(hintBelow(heads, key).contains(QStringLiteral("64 digits")));
  EXPECT_FALSE(verify.isEnabled());
  testing::retype(key, QString());
  EXPECT_EQ(hintBelow(heads, key), QString());
  EXPECT_TRUE(verify.isEnabled());
}

TEST_F(MaintenancePages, TheBackupOfAnotherCentreIsNamedAndNeedsItsNameToRestore) {
  maintenancePage().backUp(in("backup.sqlite"));
  context().waitForJobs();
  {
    Connection other = openRecord(in("backup.sqlite").string(), OpenMode::kReadWrite);
    other.execute("DELETE FROM centre");
    other.execute("INSERT INTO centre (id, name, created_utc_us, demonstration) VALUES (?, ?, ?, ?)",
                  {"another", "Harbour clinic", std::int64_t{1}, false});
  }
  auto& page = openBy<RestorePage>("Restore");

  child<QLineEdit>(page, "file").setText(toQString(in("backup.sqlite")));
  click(child<QPushButton>(page, "checkButton"));

  EXPECT_TRUE(child<QLabel>(page, "lossText")
                  .text()
                  .contains(QStringLiteral("the backup of another centre: Harbour clinic")))
      << child<QLabel>(page, "lossText").text().toStdString();
  child<QLineEdit>(page, "word").setText(QStringLiteral("RESTORE"));
  EXPECT_FALSE(child<QPushButton>(page, "restoreButton").isEnabled());
  child<QLineEdit>(page, "word").setText(QStringLiteral("Harbour clinic"));
  EXPECT_TRUE(child<QPushButton>(page, "restoreButton").isEnabled());
}

TEST_F(MaintenancePages, AMovedRecordSaysSoAndOffersToTakeTheMoveBack) {
  EXPECT_FALSE(child<QPushButton>(maintenancePage(), "takeBackMove").isVisible());
  {
    Connection connection = openRecord(record(), OpenMode::kReadWrite);
    finishMove(connection, "postgresql://server/torsio", 1);
  }

  MaintenancePage& page = maintenancePage();

  EXPECT_TRUE(child<QPushButton>(page, "takeBackMove").isVisible());
  EXPECT_TRUE(says(QStringLiteral("has moved to postgresql://server/torsio")));
}

TEST_F(MaintenancePages, OfAMovedRecordOnlyPagesOpenThatAddNothingToIt) {
  {
    Connection connection = openRecord(record(), OpenMode::kReadWrite);
    finishMove(connection, "postgresql://server/torsio", 1);
  }
  ASSERT_TRUE(window_->signOut());
  signIn();

  for (const PageId page : {PageId::kTodaysSessions, PageId::kUsers, PageId::kDevices}) {
    EXPECT_FALSE(window_->desk()->open(page)) << pageTitle(page).toStdString();
  }
  for (const PageId page : {PageId::kRoster, PageId::kAudit, PageId::kMaintenance}) {
    EXPECT_TRUE(window_->desk()->open(page)) << pageTitle(page).toStdString();
  }
  EXPECT_TRUE(failures_.isEmpty()) << failures_.join(QLatin1Char('\n')).toStdString();
}

TEST_F(MaintenancePages, AMoveThatIsTakenBackLeavesNoLineAndEveryPage) {
  {
    Connection connection = openRecord(record(), OpenMode::kReadWrite);
    finishMove(connection, "postgresql://server/torsio", 1);
  }
  ASSERT_TRUE(window_->signOut());
  signIn();
  auto& line = child<QLabel>(*window_, "movedRecord");
  ASSERT_TRUE(QTest::qWaitFor([&] { return line.isVisible(); }, 20'000));

  testing::answer(testing::giveReason);
  child<QPushButton>(maintenancePage(), "takeBackMove").click();
  QTRY_COMPARE_WITH_TIMEOUT(testing::screenOf(*window_), QStringLiteral("sign-in"), 5'000);
  testing::waitFor(window_->background());

  EXPECT_TRUE(says(QStringLiteral("This record is the living one again")));
  EXPECT_FALSE(line.isVisible());
  EXPECT_TRUE(contains(trail(record()), "database.move_given_up"));
  signIn();
  EXPECT_TRUE(window_->desk()->open(PageId::kUsers));
  EXPECT_FALSE(line.isVisible());
}

TEST_F(MaintenancePages, ARestoreIsRefusedWhileAnotherStationIsConnected) {
  maintenancePage().backUp(in("backup.sqlite"));
  context().waitForJobs();
  showsOtherStation();
  auto& page = openBy<RestorePage>("Restore");

  child<QLineEdit>(page, "file").setText(toQString(in("backup.sqlite")));
  click(child<QPushButton>(page, "checkButton"));

  ASSERT_EQ(failures_.size(), 1);
  EXPECT_EQ(failures_.front(), QStringLiteral("The station room 2 is connected"));
  EXPECT_FALSE(child<QPushButton>(page, "restoreButton").isVisible());
}

TEST_F(MaintenancePages, ACancelledRestoreKeepsTheRecordAndLeavesNoPartialFile) {
  maintenancePage().backUp(in("backup.sqlite"));
  context().waitForJobs();
  const int before = filesBeside();
  auto& page = openBy<RestorePage>("Restore");
  child<QLineEdit>(page, "file").setText(toQString(in("backup.sqlite")));
  click(child<QPushButton>(page, "checkButton"));
  child<QLineEdit>(page, "word").setText(QStringLiteral("RESTORE"));

  clickAndCancel(child<QPushButton>(page, "restoreButton"));

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_EQ(filesBeside(), before);
  EXPECT_EQ(people(record()), 2);
}

TEST_F(MaintenancePages, AnInvalidBackupIsRefusedInPlainWordsBelowItsField) {
  std::ofstream(in("backup.sqlite")) << "not a database at all, only some words in a file";
  auto& page = openBy<RestorePage>("Restore");
  auto& file = child<QLineEdit>(page, "file");
  EXPECT_EQ(hintBelow(page, file), QString());
  testing::leave(file);
  EXPECT_FALSE(hintBelow(page, file).isEmpty());

  for (const char* name : {"backup.sqlite", "missing.sqlite"}) {
    testing::retype(file, toQString(in(name)));
    EXPECT_EQ(hintBelow(page, file), QString()) << name;
    click(child<QPushButton>(page, "checkButton"));

    EXPECT_FALSE(hintBelow(page, file).isEmpty()) << name;
    EXPECT_FALSE(child<QPushButton>(page, "restoreButton").isVisible());
  }
  EXPECT_TRUE(failures_.isEmpty());
}

TEST_F(MaintenancePages, TheStationsDeviceIsChosenByNameAndRemembered) {
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
  window_->desk()->open(PageId::kDevices);
  auto& driver = child<QComboBox>(*window_->desk()->page(), "driver");
  EXPECT_EQ(driver.currentIndex(), 0) << "the first device found";
  const int puck = driver.findText(QStringLiteral("SpaceMouse"));
  ASSERT_GT(puck, 0);

  driver.setCurrentIndex(puck);
  Q_EMIT driver.activated(puck);

  EXPECT_EQ(rememberedDevice().driver, "spacemouse");
  EXPECT_TRUE(says(QStringLiteral("applies at this station")));
  window_->desk()->open(PageId::kMaintenance);
  driver.setCurrentIndex(0);
  window_->desk()->open(PageId::kDevices);
  EXPECT_EQ(driver.currentIndex(), puck) << "it is read whenever the page is opened";
}

TEST_F(MaintenancePages, AnUnreachableServerIsReportedAndNothingIsOffered) {
  auto& page = openBy<MovePage>("Move to PostgreSQL");
  EXPECT_FALSE(child<QPushButton>(page, "testButton").isEnabled());

  page.setAddress({.host = "127.0.0.1", .port = 1, .database = "torsio", .user = "torsio"});
  click(child<QPushButton>(page, "testButton"));

  EXPECT_EQ(failures_.size(), 1);
  EXPECT_FALSE(child<QPushButton>(page, "copyButton").isVisible());
}

}  // namespace
}  // namespace torsio::gui
