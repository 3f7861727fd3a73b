// SPDX-License-Identifier: GPL-3.0-or-later
// The first run with real widgets on a PostgreSQL server.
#include <cstdlib>
#include <fstream>

#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QTest>
#include <QUrl>
#include <QUrlQuery>
#include <gtest/gtest.h>

#include "app/gui/base/translated_text.h"
#include "app/gui/shell/main_window.h"
#include "app/services/access/first_run.h"
#include "assessment/domain/people/account.h"
#include "tests/app/gui/support/program_window.h"
#include "tests/db/test_database.h"

namespace torsio::gui {
namespace {

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
