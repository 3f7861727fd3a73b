// SPDX-License-Identifier: GPL-3.0-or-later
// A PostgreSQL server in the window: moving a record to it, and the first run on it.

#include <cstdlib>
#include <fstream>

#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QTest>
#include <QUrl>
#include <gtest/gtest.h>

#include "app/gui/administrator/station/move_page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/widgets/child.h"
#include "app/services/access/first_run.h"
#include "assessment/domain/people/account.h"
#include "db/connection/connection.h"
#include "db/connection/locator.h"
#include "db/migrations/migrations.h"
#include "tests/app/gui/support/maintenance_window.h"
#include "tests/app/gui/support/program_window.h"
#include "tests/db/test_database.h"

namespace torsio::gui {

namespace {

/// Uses the server named by TORSIO_TEST_POSTGRES, with a separate schema.
class ServerMove : public MaintenancePages {
 protected:
  void SetUp() override {
    const char* server = std::getenv("TORSIO_TEST_POSTGRES");
    if (server == nullptr) {
      GTEST_SKIP()
          << "no PostgreSQL server: export TORSIO_TEST_POSTGRES=$(tests/support/start-postgres.sh start)";
    }
    server_ = server;
    const Locator locator = parseLocator(server_);
    address_ = {.host = locator.host,
                .port = locator.port,
                .database = locator.database,
                .user = locator.user,
                .password = locator.password,
                .schema = "torsio_move_" + std::to_string(std::hash<std::string>{}(record()))};
    openDatabase(server_, OpenMode::kReadWrite).executeVerbatim("CREATE SCHEMA " + address_.schema);
    qputenv("PGPASSFILE", QByteArray::fromStdString(in("pgpass").string()));
    MaintenancePages::SetUp();
  }
  void TearDown() override {
    window_.reset();
    if (server_.empty()) {
      return;
    }
    qunsetenv("PGPASSFILE");
    Connection connection = openDatabase(server_, OpenMode::kReadWrite);
    connection.executeVerbatim("SET client_min_messages = warning");
    connection.executeVerbatim("DROP SCHEMA " + address_.schema + " CASCADE");
  }
  void writePasswordFile() {
    std::string line = passwordFileLine(address_);
    line.replace(line.find("PASSWORD"), std::string("PASSWORD").size(), address_.password);
    std::ofstream(in("pgpass")) << line << "\n";
    fs::permissions(in("pgpass"), fs::perms::owner_read | fs::perms::owner_write);
  }

  /// Counts tables, indexes, views, sequences and functions in the schema of the move.
  [[nodiscard]] std::int64_t thingsOnTheServer() const {
    Connection connection = openDatabase(server_, OpenMode::kReadOnly);
    Statement row = connection.prepare(
        "SELECT (SELECT count(*) FROM pg_class c JOIN pg_namespace n ON n.oid = c.relnamespace"
        " WHERE n.nspname = ?) + (SELECT count(*) FROM pg_proc p JOIN pg_namespace n ON n.oid ="
        " p.pronamespace WHERE n.nspname = ?)");
    row.execute({address_.schema, address_.schema});
    std::int64_t count = 0;
    while (row.step()) {
      count = row.int64(0);
    }
    return count;
  }
  /// Cancels when all rows are on the server and are being compared.
  void giveUpWhileComparing() {
    for (int i = 0; i < 600; ++i) {  // progress is reported every 500 rows
      window_->session()->connectionWithoutRight().execute(
          "INSERT INTO setting (name, value, changed_utc_us) VALUES (?, ?, ?)",
          {std::string("s").append(std::to_string(i)), "", 1});
    }
    const auto giveUp = [](const Progress& now) {
      if (now.step.pattern() == "Comparing %1") {
        throw Error(ErrorCode::kUsage, Text::verbatim("given up"), "", "");
      }
    };
    EXPECT_THROW((void)moveToServer(*window_->session(), address_, giveUp, in("unstored")), Error);
  }

  std::string server_;
  ServerAddress address_;
};

TEST_F(ServerMove, TheRecordIsCopiedComparedAndTheStationSwitchesToTheServer) {
  auto& page = openBy<MovePage>("Move to PostgreSQL");
  page.setAddress(address_);
  click(child<QPushButton>(page, "testButton"));
  EXPECT_TRUE(child<QLabel>(page, "serverText").text().contains(QStringLiteral("The database is empty")));
  click(child<QPushButton>(page, "copyButton"));
  EXPECT_TRUE(child<QLabel>(page, "copyText").text().contains(QStringLiteral("same counts and hashes")));

  click(child<QPushButton>(page, "switchButton"));  // no password file yet
  ASSERT_EQ(failures_.size(), 1);
  EXPECT_EQ(failures_.front(),
            QStringLiteral("The server does not let this station in without the typed password"));
  EXPECT_TRUE(says(QStringLiteral("Torsio stores no password")));
  writePasswordFile();
  click(child<QPushButton>(page, "switchButton"));
  QTRY_COMPARE_WITH_TIMEOUT(testing::screenOf(*window_), QStringLiteral("sign-in"), 5'000);
  testing::waitFor(window_->background());

  EXPECT_TRUE(says(QStringLiteral("This station now works with the record at postgresql://127.0.0.1")));
  signIn();
  EXPECT_EQ(window_->session()->key().locator, lastingLocator(address_));
  EXPECT_EQ(window_->session()->key().locator.find(address_.password), std::string::npos);
  EXPECT_EQ(people(typedLocator(address_)), 2);
  EXPECT_TRUE(contains(trail(typedLocator(address_)), "database.switch"));
  EXPECT_TRUE(contains(trail(record()), "database.move"));
  EXPECT_TRUE(contains(trail(typedLocator(address_)), "database.move"));
}

TEST_F(ServerMove, AUsedDatabaseIsNoTargetButAStationMayJoinIt) {
  {
    Connection used = openRecord(typedLocator(address_), OpenMode::kCreate, {.softwareVersion = "test"});
    used.execute("INSERT INTO setting (name, value, changed_utc_us) VALUES ('a', 'b', 1)");
  }
  SessionKey other = window_->session()->key();
  other.locator = typedLocator(address_);
  writePasswordFile();
  auto& page = openBy<MovePage>("Move to PostgreSQL");

  page.setAddress(address_);
  click(child<QPushButton>(page, "testButton"));
  EXPECT_TRUE(child<QLabel>(page, "serverText")
                  .text()
                  .contains(QStringLiteral("There is a record in this database already")));
  EXPECT_FALSE(child<QPushButton>(page, "copyButton").isVisible());
  click(child<QPushButton>(page, "switchButton"));
  ASSERT_EQ(failures_.size(), 1);
  EXPECT_EQ(failures_.front(), QStringLiteral("The record in this database contains no centre"));
  setUpCentre(*std::make_unique<SessionContext>(other),
              {.centre = "Old hospital", .login = "chief", .password = "a long enough password"});
  click(child<QPushButton>(page, "switchButton"));
  QTRY_COMPARE_WITH_TIMEOUT(window_->session()->key().locator, lastingLocator(address_), 5'000);
  testing::waitFor(window_->background());

  EXPECT_TRUE(contains(trail(typedLocator(address_)), "database.join"));
  EXPECT_TRUE(contains(trail(record()), "database.join"));
  EXPECT_EQ(people(typedLocator(address_)), 0);  // nothing was copied
}

TEST_F(ServerMove, WritingAfterTheCopyPreventsTheSwitch) {
  writePasswordFile();
  auto& page = openBy<MovePage>("Move to PostgreSQL");
  page.setAddress(address_);
  click(child<QPushButton>(page, "testButton"));
  click(child<QPushButton>(page, "copyButton"));
  addPerson(*window_->session(), person());

  click(child<QPushButton>(page, "switchButton"));

  ASSERT_EQ(failures_.size(), 1);
  EXPECT_EQ(failures_.front(), QStringLiteral("Something was written to this record after it was copied"));
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
}

TEST_F(ServerMove, ACancelledCopyKeepsNothingOnTheServerAndCanBeRepeated) {
  auto& page = openBy<MovePage>("Move to PostgreSQL");
  page.setAddress(address_);
  click(child<QPushButton>(page, "testButton"));

  clickAndCancel(child<QPushButton>(page, "copyButton"));

  EXPECT_FALSE(contains(trail(record()), "database.move"));
  EXPECT_FALSE(child<QLabel>(page, "copyText").text().contains(QStringLiteral("same counts and hashes")));
  click(child<QPushButton>(page, "testButton"));
  EXPECT_TRUE(
      child<QLabel>(page, "serverText").text().contains(QStringLiteral("the record can be moved there")));
  click(child<QPushButton>(page, "copyButton"));
  EXPECT_TRUE(child<QLabel>(page, "copyText").text().contains(QStringLiteral("same counts and hashes")));
}

TEST_F(ServerMove, ACancelledMoveLeavesAnEmptyDatabaseEmpty) {
  ASSERT_EQ(thingsOnTheServer(), 0);

  giveUpWhileComparing();

  EXPECT_EQ(thingsOnTheServer(), 0);
  EXPECT_TRUE(contains(trail(record()), "database.move_given_up"));
}

TEST_F(ServerMove, ACancelledMoveKeepsWhatWasThere) {
  {
    Connection there = openDatabase(typedLocator(address_), OpenMode::kReadWrite);
    migrate(there, embeddedMigrations(), {.softwareVersion = "older"});  // empty tables
    there.executeVerbatim("CREATE TABLE somebody_else (note TEXT)");
  }
  const std::int64_t before = thingsOnTheServer();

  giveUpWhileComparing();

  EXPECT_EQ(thingsOnTheServer(), before);
  Connection there = openDatabase(typedLocator(address_), OpenMode::kReadOnly);
  EXPECT_EQ(checkSchema(there, embeddedMigrations()).version, embeddedMigrations().back().version);
}

TEST_F(ServerMove, ACopyIsRefusedWhileAnotherStationIsConnected) {
  auto& page = openBy<MovePage>("Move to PostgreSQL");
  page.setAddress(address_);
  click(child<QPushButton>(page, "testButton"));
  showsOtherStation();

  click(child<QPushButton>(page, "copyButton"));

  ASSERT_EQ(failures_.size(), 1);
  EXPECT_EQ(failures_.front(), QStringLiteral("The station room 2 is connected"));
  EXPECT_FALSE(child<QPushButton>(page, "switchButton").isVisible());
}

constexpr const char* kPassword = "a short sentence for the lab";

/// The server's password is in a password file, never in the address.
class FirstRunOnServer : public DatabaseTest {
 protected:
  void SetUp() override {
    qputenv("TORSIO_DB_TEST_ENGINE", "postgresql");
    DatabaseTest::SetUp();
    if (IsSkipped()) {
      return;
    }
    QUrl address(toQString(locator()));
    const std::filesystem::path file = folder_.path() / "pgpass";
    std::ofstream(file) << "*:*:*:*:" << address.password().toStdString() << '\n';
    std::filesystem::permissions(file,
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    qputenv("PGPASSFILE", QByteArray::fromStdString(file.string()));
    address.setPassword({});
    address_ = address.toString();
    window_ = testing::openWindow(testing::windowSetup(folder_.path()));
  }
  void TearDown() override {
    window_.reset();
    qunsetenv("PGPASSFILE");
    DatabaseTest::TearDown();
  }
  QLineEdit* field(const char* name) { return testing::named<QLineEdit>(*window_, QLatin1String(name)); }
  void press(const char* text) { testing::press(*window_, QLatin1String(text)); }
  bool says(const char* part) { return testing::says(*window_, QLatin1String(part)); }
  void fillUntilTheDatabase() {
    field("Name of the centre")->setText(QStringLiteral("City hospital"));
    press("Next");
    field("Sign-in name")->setText(QStringLiteral("admin"));
    field("Password")->setText(QString::fromLatin1(kPassword));
    field("Repeat password")->setText(QString::fromLatin1(kPassword));
    press("Next");
    for (QRadioButton* choice : window_->findChildren<QRadioButton*>()) {
      if (choice->text().contains(QStringLiteral("SQL")) && choice->isVisible()) {
        choice->click();
      }
    }
  }

  TemporaryFolder folder_;
  QString address_;
  std::unique_ptr<MainWindow> window_;
};

TEST_F(FirstRunOnServer, CreatesTheCentreOnTheServerAndSignsItsAdministratorIn) {
  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("first run"));
  fillUntilTheDatabase();
  field("Address of the server")->setText(address_);
  press("Test the database");
  EXPECT_TRUE(QTest::qWaitFor([this] { return says("The database answers and is empty"); }, 20'000));
  const auto* focused = qobject_cast<QPushButton*>(window_->focusWidget());
  ASSERT_NE(focused, nullptr);
  EXPECT_EQ(focused->text().remove(QLatin1Char('&')), QStringLiteral("Next")) << "Enter goes on";
  press("Next");
  {
    Connection looked = open();
    EXPECT_EQ(numberFrom(looked, "SELECT count(*) FROM pg_tables WHERE schemaname = current_schema()"), 0)
        << "written before the last step";
  }
  press("Set up");
  testing::waitFor(window_->background());

  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk")) << address_.toStdString();
  EXPECT_EQ(window_->session()->connectionWithoutRight().engine(), Engine::kPostgresql);
  EXPECT_EQ(centreSign(window_->session()->connectionWithoutRight()).name, "City hospital");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "torsio.sqlite-wal"));
  ASSERT_TRUE(window_->line()->settled(std::chrono::seconds(20)));
  EXPECT_EQ(numberFrom(window_->session()->connectionWithoutRight(), "SELECT count(*) FROM station_state"),
            1);
}

TEST_F(FirstRunOnServer, ReportsAnExistingCentreAndLetsItsPeopleSignIn) {
  {
    SessionContext office(SessionKey{locator(), "other", {}});
    office.setPasswordCost(PasswordCost::kTest);
    setUpCentre(office, {.centre = "Old hospital", .login = "chief", .password = kPassword});
  }
  fillUntilTheDatabase();
  field("Address of the server")->setText(address_);
  press("Test the database");
  EXPECT_TRUE(QTest::qWaitFor([this] { return says("A centre keeps its records there already"); }, 20'000));
  press("Next");
  press("Set up");
  testing::waitFor(window_->background());
  testing::waitFor(window_->background());  // recordings waiting in files are settled next

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
  EXPECT_TRUE(says("Old hospital"));
}

TEST_F(FirstRunOnServer, AnUnreachableServerIsReportedAndNothingIsWritten) {
  fillUntilTheDatabase();
  QUrl nowhere(address_);
  nowhere.setPort(9);  // the discard service, which nobody runs
  field("Address of the server")->setText(nowhere.toString());
  press("Next");
  press("Set up");
  testing::waitFor(window_->background());

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("first run"));
  EXPECT_TRUE(says("cannot be reached"));
}

}  // namespace

}  // namespace torsio::gui
