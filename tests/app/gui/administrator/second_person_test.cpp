// SPDX-License-Identifier: GPL-3.0-or-later
// What two administrators do together: halves of start passwords, requests that wait, mail about them.
#include <memory>
#include <string>
#include <vector>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/connectors/built_in.h"
#include "app/connectors/mail/mailing.h"
#include "app/gui/administrator/people/requests_dialog.h"
#include "app/gui/administrator/people/roster_page.h"
#include "app/gui/administrator/people/shown_once_dialog.h"
#include "app/gui/administrator/people/users_page.h"
#include "app/gui/administrator/study/todays_sessions_page.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/data_table.h"
#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/people/people_service.h"
#include "app/services/people/roster_accounts.h"
#include "db/repository/people/access_repository.h"
#include "db/repository/system/setting_repository.h"
#include "tests/app/gui/support/administrator_desk.h"
#include "tests/app/gui/support/hands.h"
#include "tests/support/eventually.h"
#include "tests/support/fake_mail_server.h"

namespace torsio::gui {
namespace {

using testing::AdministratorDesk;
using testing::press;

/// Two chiefs without an account, and two administrators who must act together.
class SecondPerson : public ::testing::Test {
 protected:
  SecondPerson() {
    chiefs_ = office_.centre.addChiefs(2);
    SettingRepository(office_.centre.connection()).set(kTwoPeople.name, "yes", 0);
    office_.centre.as("administrator");
    second_ = addPerson(
        office_.centre.session(),
        {.fullName = "Second Office", .externalId = "A-2", .email = "second@example.org", .trainee = true});
    AccessRepository access(office_.centre.connection(), PasswordCost::kTest);
    access.addUser({.id = "u-second", .login = "second", .personId = second_, .roles = {"administrator"}},
                   kStudyPassword);
    access.setPassword("u-second", access.sealPassword("second", kStudyPassword), false);
  }
  std::vector<StartAccount> ask() {
    std::vector<StartAccount> made;
    office_.centre.as("administrator");
    addAccounts(office_.centre.session(), {chiefs_[0], chiefs_[1]}, made);
    return made;
  }
  AdministratorDesk office_;
  std::vector<RaterId> chiefs_;
  PersonId second_;
};

TEST_F(SecondPerson, ListsOfStartPasswordsSayWhichPartEachIs) {
  const std::vector<StartAccount> made = ask();
  AccountsDialog dialog(made, "Centre", nullptr);
  bool said = false;
  for (const QLabel* label : dialog.findChildren<QLabel*>()) {
    said = said || label->text().contains(QStringLiteral("only the first half"));
  }
  EXPECT_TRUE(said);
  dialog.copy();
  const QString copied = QApplication::clipboard()->text();
  EXPECT_TRUE(copied.contains(QStringLiteral("R-01 \u00B7 Chief 1"))) << copied.toStdString();
  EXPECT_TRUE(copied.contains(QStringLiteral("first half; the second comes from the administrator")));
}

TEST_F(SecondPerson, TheOnesWhoConfirmReadOnTheFirstPageThatRequestsWait) {
  auto page = office_.open<TodaysSessionsPage>("administrator");
  EXPECT_TRUE(child<QPushButton>(*page, "requestsWait").isHidden());
  ask();
  page->enter({});
  EXPECT_TRUE(child<QPushButton>(*page, "requestsWait").isHidden()) << "nobody confirms their own";

  office_.centre.as("second");
  page->enter({});

  EXPECT_FALSE(child<QPushButton>(*page, "requestsWait").isHidden());
  EXPECT_EQ(child<QPushButton>(*page, "requestsWait").text(),
            QStringLiteral("2 requests wait for you as the second person: Users, Requests"));
}

TEST_F(SecondPerson, TheButtonsOfUsersAndRosterHaveDifferentNames) {
  auto users = office_.open<UsersPage>("administrator");
  auto roster = office_.open<RosterPage>("administrator");

  EXPECT_TRUE(child<QPushButton>(*users, "requests").text().contains(QStringLiteral("quests")));
  EXPECT_FALSE(child<QPushButton>(*roster, "personRequests").text().contains(QStringLiteral("equest")));
}

TEST_F(SecondPerson, OthersAreToldByMailWhereMailIsSetUp) {
  if constexpr (!kMailBuiltIn) {
    GTEST_SKIP() << "built without mail";
  }
  torsio::testing::FakeMailServer server;
  MailSettings settings{.from = "office@example.org"};
  settings.server = {.host = "127.0.0.1", .port = server.port(), .encryption = MailEncryption::kNone};
  setMailSettings(office_.centre.as("administrator"), settings);
  auto page = office_.open<UsersPage>("administrator");
  bool told = false;
  QTimer looks;
  QObject::connect(&looks, &QTimer::timeout, [&] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (auto* shown = qobject_cast<AccountsDialog*>(dialog); shown != nullptr) {
      shown->copy();
      shown->reject();
    } else if (dialog != nullptr) {
      told = told || dialog->objectName() == QStringLiteral("tellAdministrators");
      dialog->accept();
    }
  });
  looks.start(1);

  press(*page, QStringLiteral("Accounts for the roster"));
  office_.shell().waitForJobs();
  ASSERT_TRUE(torsio::testing::eventually([&] {
    office_.shell().waitForJobs();
    QApplication::processEvents();
    return server.taken().size() == 1U;
  }));
  EXPECT_TRUE(told);

  EXPECT_EQ(server.taken()[0].to, "second@example.org");
  const std::string& text = server.taken()[0].text;
  const QByteArray body = QByteArray::fromBase64(QByteArray::fromStdString(text.substr(text.find("\n\n"))));
  EXPECT_TRUE(body.contains("Requests that wait: 2.")) << body.toStdString();
  EXPECT_FALSE(body.contains("Chief")) << "nobody is named but who asks";
  EXPECT_EQ(office_.centre.audited("reminder.mail"), 1);
}

TEST_F(SecondPerson, AnOpenBoardOfTheDayShowsCohortsThatCameFromOutside) {
  auto page = office_.open<TodaysSessionsPage>("administrator");
  auto& cohort = child<QComboBox>(*page, "cohort");
  EXPECT_EQ(cohort.count(), 0);
  (void)office_.centre.addStudy(2);

  page->findChild<QTimer*>(QString(), Qt::FindDirectChildrenOnly)->start(1);

  EXPECT_TRUE(torsio::testing::eventually([&] {
    QApplication::processEvents();
    return cohort.count() == 1;
  }));
  EXPECT_EQ(cohort.currentText(), QStringLiteral("Study"));
}

}  // namespace
}  // namespace torsio::gui
