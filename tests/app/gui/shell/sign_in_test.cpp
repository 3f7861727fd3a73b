// SPDX-License-Identifier: GPL-3.0-or-later
// The window before anybody works: first run, visit, sign-in, changing a start password.
#include <QApplication>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <gtest/gtest.h>

#include "app/gui/base/job_panel.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/problem_panel.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/first_run.h"
#include "app/services/access/signing.h"
#include "app/services/maintenance/retention.h"
#include "assessment/domain/people/person.h"
#include "db/connection/connection.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/file_io.h"
#include "tests/app/gui/shell/shell_window.h"
#include "tests/app/gui/support/program_window.h"

namespace torsio::gui {
namespace {

using testing::named;
using testing::press;
using testing::says;

TEST_F(Shell, TheFirstRunCreatesACentreAndLeadsItsAdministratorToTheFirstPage) {
  open(setup());
  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("first run"));

  press(*window_, QStringLiteral("Next"));
  EXPECT_TRUE(says(*window_, QStringLiteral("Enter the name of your centre")));
  {  // directly below its field, which has focus
    QApplication::processEvents();
    const auto* field = named<QLineEdit>(*window_, QStringLiteral("Name of the centre"));
    for (const QLabel* label : window_->findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().contains(QStringLiteral("Enter the name of your centre"))) {
        const int gap = label->mapTo(window_.get(), QPoint(0, 0)).y() -
                        field->mapTo(window_.get(), QPoint(0, field->height())).y();
        EXPECT_GE(gap, 0);
        EXPECT_LT(gap, 3 * kSpace);
      }
    }
  }
  named<QLineEdit>(*window_, QStringLiteral("Name of the centre"))->setText(QStringLiteral("City hospital"));
  press(*window_, QStringLiteral("Next"));
  named<QLineEdit>(*window_, QStringLiteral("Sign-in name"))->setText(QStringLiteral("admin"));
  named<QLineEdit>(*window_, QStringLiteral("Password"))->setText(QStringLiteral("short"));
  press(*window_, QStringLiteral("Next"));
  EXPECT_TRUE(says(*window_, QStringLiteral("The first administrator")));  // a weak password is refused
  named<QLineEdit>(*window_, QStringLiteral("Password"))->setText(QString::fromLatin1(kAdminPassword));
  named<QLineEdit>(*window_, QStringLiteral("Repeat password"))->setText(QString::fromLatin1(kAdminPassword));
  press(*window_, QStringLiteral("Next"));
  press(*window_, QStringLiteral("Next"));
  press(*window_, QStringLiteral("Set up"));
  testing::waitFor(window_->background());

  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_EQ(window_->desk()->pageId(), PageId::kUsers);
  EXPECT_TRUE(says(*window_, QStringLiteral("City hospital")));
}

TEST_F(Shell, AVisitNeedsNoPasswordAndLeavesNothingBehind) {
  ShellSetup with = setup();
  with.simulatedPeople = [](SessionContext& session, const ProgressCallback&) {
    Trainee simulated;
    simulated.person = {.id = "simulated", .code = "T-99", .demonstration = true};
    PeopleRepository(session.connectionWithoutRight()).addTrainees({&simulated, 1});
    return std::vector<StartAccount>{{.login = "demo.trainee", .role = "trainee"}};
  };
  open(with);
  press(*window_, QStringLiteral("As an &administrator"));
  testing::waitFor(window_->background());

  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_TRUE(says(*window_, QStringLiteral("Everybody here is simulated")));
  const QString file = toQString(window_->session()->key().locator);
  EXPECT_TRUE(QFileInfo::exists(file));
  EXPECT_FALSE(QFileInfo::exists(setup().locator));
  EXPECT_EQ(demonstrationSize(*window_->session()).people, 1);
  EXPECT_EQ(SettingRepository(window_->session()->connectionWithoutRight()).value("graded_with_mouse"),
            "yes");
  window_->chooseTheme(ThemeKind::kDark);
  addUser(*window_->session(),
          {.login = "demo", .roles = {"trainee"}, .startPassword = kStartPassword, .demonstration = true});
  addUser(*window_->session(),
          {.login = "chief", .roles = {"rater"}, .startPassword = kStartPassword, .demonstration = true});
  for (const auto& [button, login] :
       {std::pair{"Trainee", "demo"}, std::pair{"Physician", "chief"}, std::pair{"Administrator", "visitor"},
        std::pair{"Physician", "chief"}}) {
    press(*window_, QString::fromLatin1(button));
    QApplication::processEvents();
    ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
    EXPECT_EQ(window_->session()->actor().login, login);
    EXPECT_FALSE(passwordIsDue(*window_->session()));  // nobody has one to sign with
    EXPECT_TRUE(QFileInfo::exists(file));
  }
  ASSERT_TRUE(window_->signOut());

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("first run"));
  EXPECT_FALSE(QFileInfo::exists(file));
  EXPECT_FALSE(QFileInfo::exists(QFileInfo(file).absolutePath()));
  EXPECT_TRUE(QDir(folder_.path()).isEmpty());
}

TEST_F(Shell, AVisitStartsAtTheChosenDesk) {
  for (const auto& [button, login] :
       {std::pair{"As a &trainee", "demo"}, std::pair{"As a &physician", "chief"},
        std::pair{"As an &administrator", "visitor"}}) {
    ShellSetup with = setup();
    with.simulatedPeople = [](SessionContext& session, const ProgressCallback&) {
      for (const auto& [name, role] : {std::pair{"demo", "trainee"}, std::pair{"chief", "rater"}}) {
        addUser(session,
                {.login = name, .roles = {role}, .startPassword = kStartPassword, .demonstration = true});
      }
      return std::vector<StartAccount>{};
    };
    open(with);
    press(*window_, QString::fromLatin1(button));
    testing::waitFor(window_->background());
    QApplication::processEvents();

    EXPECT_EQ(window_->session()->actor().login, login);
    const QString file = toQString(window_->session()->key().locator);
    ASSERT_TRUE(window_->signOut());
    EXPECT_FALSE(QFileInfo::exists(QFileInfo(file).absolutePath()));
    window_.reset();
  }
}

TEST_F(Shell, ThePagesStartInTheColoursOfTheSignIn) {
  for (const bool dark : {false, true}) {
    ShellSetup with = setup();
    with.systemIsDark = dark;
    if (dark) {
      open(with);
    } else {
      openFoundedCentre(with);
    }
    const QColor first = QApplication::palette().color(QPalette::Window);
    enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));

    EXPECT_EQ(first, theme(dark ? ThemeKind::kDark : ThemeKind::kLight).window);
    EXPECT_EQ(QApplication::palette().color(QPalette::Window), first);
    window_.reset();
  }
}

TEST_F(Shell, AServerAddressWithAPasswordIsRefusedBeforeItIsStored) {
  open(setup());
  FirstRunChoice choice;
  choice.locator = QStringLiteral("postgresql://torsio:secret@server/torsio");
  auto* panel = window_->findChild<FirstRunPanel*>();

  Q_EMIT panel->chosen(choice);

  EXPECT_FALSE(window_->background().working());
  EXPECT_TRUE(says(*window_, QStringLiteral("Leave the password out of the address")));
}

TEST_F(Shell, AWrongPasswordIsNotKeptNorSaidWhichPartWasWrong) {
  openFoundedCentre(setup());

  enter(QStringLiteral("admin"), QStringLiteral("not this one at all"));

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
  EXPECT_TRUE(says(*window_, QStringLiteral("Name and password do not match")));
  EXPECT_TRUE(named<QLineEdit>(*window_, QStringLiteral("Password"))->text().isEmpty());
}

TEST_F(Shell, AFieldHasFocusFromTheStartAndAfterAWrongPassword) {
  openFoundedCentre(setup());
  window_->activateWindow();
  QApplication::processEvents();
  EXPECT_TRUE(named<QLineEdit>(*window_, QStringLiteral("Sign-in name"))->hasFocus());

  enter(QStringLiteral("admin"), QStringLiteral("not this one at all"));

  EXPECT_TRUE(named<QLineEdit>(*window_, QStringLiteral("Password"))->hasFocus());

  auto* secret = named<QLineEdit>(*window_, QStringLiteral("Password"));
  secret->setText(QStringLiteral("nor is this one"));
  QTest::keyClick(secret, Qt::Key_Return);
  for (const QPushButton* button : window_->findChildren<QPushButton*>()) {
    EXPECT_FALSE(button->isVisible() && button->isEnabled())
        << "an impatient key would press " << button->text().toStdString();
  }
  EXPECT_TRUE(QTest::qWaitFor([this] { return !window_->background().working(); }, 60'000));
}

TEST_F(Shell, EnterPressesTheFocusedButton) {
  openFoundedCentre(setup());
  window_->activateWindow();
  QApplication::processEvents();
  for (QPushButton* button : window_->findChildren<QPushButton*>()) {
    if (button->text() != QStringLiteral("Practise with a PIN") || !button->isVisible()) {
      continue;
    }
    button->setFocus();
    QTest::keyClick(button, Qt::Key_Return);
  }

  EXPECT_TRUE(says(*window_, QStringLiteral("Practice with your PIN")));
}

TEST_F(Shell, AfterTooManyFailuresItShowsTheWaitingTimeAndBlocksAttempts) {
  openFoundedCentre(setup());

  for (int i = 0; i < 4; ++i) {
    enter(QStringLiteral("admin"), QStringLiteral("not this one at all"));
  }
  named<QLineEdit>(*window_, QStringLiteral("Password"))->setText(QString::fromLatin1(kAdminPassword));
  press(*window_, QStringLiteral("Sign in"));
  testing::waitFor(window_->background());

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
  EXPECT_TRUE(says(*window_, QStringLiteral("Please wait 0:")));
}

TEST_F(Shell, AStartPasswordMustBeChangedFirst) {
  openFoundedCentre(setup());

  enter(QStringLiteral("chen"), QString::fromLatin1(kStartPassword));
  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("password"));
  auto* first = named<QLineEdit>(*window_, QStringLiteral("New password"));
  auto* again = named<QLineEdit>(*window_, QStringLiteral("Repeat password"));
  first->setText(QString::fromLatin1(kOwnPassword));
  QTest::keyClick(first, Qt::Key_Return);  // Enter focuses the first empty field, as at sign-in
  EXPECT_EQ(window_->focusWidget(), again);
  again->setText(QString::fromLatin1(kOwnPassword));
  QTest::keyClick(again, Qt::Key_Return);
  testing::waitFor(window_->background());

  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_EQ(window_->desk()->pageId(), PageId::kNextStep);
  window_->signOut();
  enter(QStringLiteral("chen"), QString::fromLatin1(kOwnPassword));
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
}

TEST_F(Shell, AnUnstorableRecordingIsReportedBeforeSignInAndToTheNextUser) {
  const ShellSetup with = setup();
  const std::filesystem::path file = with.unstored / "damaged.torsio-trial";
  std::filesystem::create_directories(with.unstored);
  writeFileAtomically(file, "not a recording");

  openFoundedCentre(with);
  EXPECT_TRUE(says(*window_, QStringLiteral("cannot be read and stays where it is")));
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));

  auto* panel = window_->desk()->findChild<ProblemPanel*>();
  EXPECT_TRUE(panel->isVisible());
  EXPECT_TRUE(says(*panel, QStringLiteral("could not be stored")));
  EXPECT_TRUE(std::filesystem::exists(file));
}

TEST_F(Shell, CancellingTheFirstRunLeavesNoCentre) {
  const ShellSetup with = setup();
  open(with);
  FirstRunChoice choice;
  choice.locator = with.locator;
  choice.first = {
      .centre = "City hospital", .login = "admin", .password = kAdminPassword, .demonstration = true};
  auto* panel = window_->findChild<FirstRunPanel*>();

  Q_EMIT panel->chosen(choice);
  Q_EMIT panel->job().cancelled();
  testing::waitFor(window_->background());

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("first run"));
  EXPECT_TRUE(says(*window_, QStringLiteral("nothing was set up")));
  EXPECT_EQ(lookAtRecord(with.locator.toStdString()), RecordPlace::kEmpty);
}

}  // namespace
}  // namespace torsio::gui
