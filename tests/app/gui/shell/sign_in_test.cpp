// SPDX-License-Identifier: GPL-3.0-or-later
// The window before anybody works: first run, visit, sign-in, changing a start password. Access to the
// window: the lock and what it covers, signatures, guests, the kiosk.

#include <cstdint>
#include <functional>
#include <string>

#include <QApplication>
#include <QDialog>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/gui/base/job_panel.h"
#include "app/gui/base/sign_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/problem_panel.h"
#include "app/gui/shell/screen_lock.h"
#include "app/gui/shell/sign_in_panel.h"
#include "app/gui/widgets/child.h"
#include "app/gui/widgets/theme.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/first_run.h"
#include "app/services/access/kiosk_codes.h"
#include "app/services/access/second_factor.h"
#include "app/services/access/signing.h"
#include "app/services/maintenance/retention.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/person.h"
#include "assessment/domain/people/signature.h"
#include "db/connection/connection.h"
#include "db/repository/people/one_time_code.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/clock.h"
#include "sim/core/file_io.h"
#include "sim/core/time_units.h"
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
  EXPECT_TRUE(says(*window_, QStringLiteral("everybody here is simulated")));
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
  EXPECT_TRUE(QTest::qWaitFor([this] { return !window_->background().working(); }, 300'000));
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

TEST_F(Shell, AnIdleDeskWarnsThenLocksAndReopensUnchanged) {
  ShellSetup with = setup();
  with.idle = IdleLimits{.warn_us = 10'000'000, .lock_us = 20'000'000};
  openFoundedCentre(with);
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  Desk* desk = window_->desk();
  const std::int64_t shown_us = window_->session()->actor().passwordShownUtc_us;
  window_->watchIdleness();

  clock_.advance_us(12'000'000);
  window_->watchIdleness();
  EXPECT_TRUE(says(*window_, QStringLiteral("The screen will be locked in 0:08")));
  clock_.advance_us(9'000'000);
  window_->watchIdleness();
  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("lock"));

  named<QLineEdit>(*window_, QStringLiteral("Password"))->setText(QStringLiteral("not this one at all"));
  press(*window_, QStringLiteral("Unlock"));
  testing::waitFor(window_->background());
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("lock"));
  named<QLineEdit>(*window_, QStringLiteral("Password"))->setText(QString::fromLatin1(kAdminPassword));
  press(*window_, QStringLiteral("Unlock"));
  testing::waitFor(window_->background());
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_EQ(window_->desk(), desk);
  EXPECT_GT(window_->session()->actor().passwordShownUtc_us, shown_us) << "it signs anew";
}

TEST_F(Shell, ASignatureAsksForThePasswordUntilItIsRightAndShowsItsMeaning) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  constexpr SignatureMeaning meaning = SignatureMeaning::kFroze;
  EXPECT_TRUE(readyToSign(window_.get(), window_->desk()->context(), meaning)) << "shown a moment ago";
  setCentreSetting<kSignMinutes>(window_->desk()->context().session(), 0);
  ASSERT_TRUE(window_->signOut());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));

  QTimer::singleShot(0, window_.get(), [&] {
    auto& dialog = *QApplication::activeModalWidget();
    EXPECT_EQ(dialog.objectName(), QStringLiteral("signDialog"));
    EXPECT_TRUE(says(dialog, toQString(labelOf(meaning))));
    EXPECT_TRUE(says(dialog, QStringLiteral("as admin")));
    auto* password = dialog.findChild<QLineEdit*>(QStringLiteral("password"));
    auto* sign = dialog.findChild<QPushButton*>(QStringLiteral("sign"));
    EXPECT_FALSE(sign->isEnabled());
    password->setText(QStringLiteral("not this one at all"));
    QTest::mouseClick(sign, Qt::LeftButton);
    EXPECT_TRUE(says(dialog, QStringLiteral("The password is not right")));
    EXPECT_TRUE(password->text().isEmpty());
    EXPECT_EQ(QApplication::activeModalWidget(), &dialog);
    EXPECT_GE(dialog.height(), dialog.layout()->totalHeightForWidth(dialog.width())) << "something is cut";
    password->setText(QString::fromLatin1(kAdminPassword));
    QTest::mouseClick(sign, Qt::LeftButton);
  });
  EXPECT_TRUE(readyToSign(window_.get(), window_->desk()->context(), meaning));

  EXPECT_FALSE(passwordIsDue(*window_->session()));
  endSigning(*window_->session());
  EXPECT_TRUE(passwordIsDue(*window_->session()));
}

/// Returns the cover over a dialog of a locked place.
QWidget* veilOf(const QWidget& dialog) {
  return dialog.findChild<QWidget*>(QStringLiteral("lockVeil"));
}

TEST_F(Shell, TheLockCoversAnOpenDialogAndKeepsItsInput) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  QDialog dialog(&page());
  auto* typed = new QLineEdit(QStringLiteral("half a sentence"), &dialog);
  dialog.setModal(true);
  dialog.show();

  ASSERT_TRUE(window_->lock());

  auto* lock = window_->findChild<DialogLock*>();
  ASSERT_NE(lock, nullptr);
  EXPECT_TRUE(lock->isVisible());
  EXPECT_EQ(QApplication::activeModalWidget(), lock);
  ASSERT_NE(veilOf(dialog), nullptr);
  EXPECT_EQ(veilOf(dialog)->geometry(), dialog.rect());
  EXPECT_TRUE(veilOf(dialog)->isVisible());
  lock->reject();  // Escape
  EXPECT_TRUE(lock->isVisible());
  named<QLineEdit>(*lock, QStringLiteral("Password"))->setText(QString::fromLatin1(kAdminPassword));
  press(*lock, QStringLiteral("Unlock"));
  testing::waitFor(window_->background());
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_FALSE(lock->isVisible());
  EXPECT_TRUE(dialog.isVisible());
  EXPECT_EQ(veilOf(dialog), nullptr);
  EXPECT_EQ(typed->text(), QStringLiteral("half a sentence"));
}

TEST_F(Shell, SigningOutFromTheLockRejectsDialogsFirst) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  bool returned = false;
  QTimer::singleShot(0, window_.get(), [this] {
    ASSERT_TRUE(window_->lock());
    press(*window_->findChild<DialogLock*>(), QStringLiteral("Sign out"));
    EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("lock"));  // the page awaits its dialog
  });
  {
    QDialog dialog(&page());  // on the stack, as in pages: it must not be destroyed with the desk
    EXPECT_EQ(dialog.exec(), QDialog::Rejected);
    returned = window_->desk() != nullptr;
  }
  QApplication::processEvents();

  EXPECT_TRUE(returned);
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
}

TEST_F(Shell, WhoLooksRoundHasTimeAndIsToldWhenTheSampleIsGone) {
  const ShellSetup with = setup();
  open(with);
  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("first run"));
  press(*window_, QStringLiteral("As a trainee"));
  ASSERT_TRUE(
      QTest::qWaitFor([this] { return testing::screenOf(*window_) == QStringLiteral("desk"); }, 300'000));
  window_->watchIdleness();

  clock_.advance_us(20 * kMinute_us);
  window_->watchIdleness();
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  clock_.advance_us(11 * kMinute_us);
  window_->watchIdleness();
  QApplication::processEvents();

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("first run"));
  EXPECT_TRUE(says(*window_, QStringLiteral("nobody was here. The sample data have been deleted")));
}

TEST_F(Shell, TheIdleLockNeverEndsARun) {
  ShellSetup with = setup();
  with.idle = IdleLimits{.warn_us = 10'000'000, .lock_us = 20'000'000};
  openFoundedCentre(with);
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  page().isBusy = true;

  for (int second = 0; second < 60; ++second) {
    clock_.advance_us(1'000'000);
    window_->watchIdleness();
  }

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_FALSE(window_->lock());
  page().isBusy = false;
}

TEST_F(Shell, AGuestCanOnlyPractise) {
  openFoundedCentre(setup());

  press(*window_, QStringLiteral("Practise as a guest"));

  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_EQ(window_->desk()->pageId(), PageId::kPractice);
  for (const PageId other : {PageId::kNextStep, PageId::kQueue, PageId::kUsers, PageId::kAudit}) {
    EXPECT_FALSE(window_->desk()->open(other)) << pageText(other).toStdString();
  }
  EXPECT_TRUE(says(*window_, QStringLiteral("nothing is recorded")));
  EXPECT_FALSE(window_->session()->may(Operation::kTrialRecordOwn));
}

TEST_F(Shell, AGuestWhoLeavesIsSignedOutInsteadOfLocked) {
  openFoundedCentre(setup());
  press(*window_, QStringLiteral("Practise as a guest"));

  window_->lock();

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
}

TEST_F(Shell, TheKioskDoesNotClose) {
  ShellSetup with = setup();
  with.kiosk = true;
  openFoundedCentre(with);

  EXPECT_FALSE(window_->close());
  EXPECT_TRUE(window_->isVisible());
}

/// Fills in the dialog that leaves the kiosk.
void answerKiosk(const QString& login, const QString& password) {
  QTimer::singleShot(0, qApp, [login, password] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    ASSERT_NE(dialog, nullptr);
    const QList<QLineEdit*> fields = dialog->findChildren<QLineEdit*>();
    ASSERT_EQ(fields.size(), 2);
    fields[0]->setText(login);
    fields[1]->setText(password);
    dialog->accept();
  });
}

TEST_F(Shell, TheKioskOnlyEndsWithAnAdministratorsNameAndPassword) {
  ShellSetup with = setup();
  with.kiosk = true;
  openFoundedCentre(with);
  auto* signIn = window_->findChild<SignInPanel*>();

  answerKiosk(QStringLiteral("admin"), QStringLiteral("not this one at all"));
  Q_EMIT signIn->leaveKioskWanted();
  testing::waitFor(window_->background());
  EXPECT_TRUE(window_->isVisible());
  EXPECT_TRUE(says(*window_, QStringLiteral("Only an administrator can end the kiosk")));
  EXPECT_FALSE(window_->close());

  answerKiosk(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  Q_EMIT signIn->leaveKioskWanted();
  testing::waitFor(window_->background());
  EXPECT_FALSE(window_->isVisible());
}

/// Calls `act` with the next dialog of this name when it is shown.
void whenDialogOpens(const QString& name, const std::function<void(QDialog&)>& act) {
  QTimer::singleShot(20, qApp, [name, act] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (dialog == nullptr || dialog->objectName() != name) {
      whenDialogOpens(name, act);
      return;
    }
    act(*dialog);
  });
}

std::string codeOf(const QString& secret, std::int64_t stepsAhead) {
  QString plain = secret;
  plain.remove(QLatin1Char(' '));
  return oneTimeCode(plain.toStdString(), codeStepAt(utcNow_us()) + stepsAhead);
}

TEST_F(Shell, WhereTheCentreAsksForASecondFactorItIsSetUpAtTheSignInAndAskedForFromThenOn) {
  const ShellSetup with = setup();
  openFoundedCentre(with);
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  setCentreSetting<kSecondFactor>(*window_->session(), "administrators");
  window_->signOut();
  QString secret;
  QStringList recovery;
  whenDialogOpens(QStringLiteral("secondFactorDialog"), [&](QDialog& dialog) {
    EXPECT_FALSE(child<QLabel>(dialog, "qrCode").pixmap(Qt::ReturnByValue).isNull());
    secret = child<QLabel>(dialog, "secret").text();
    child<QLineEdit>(dialog, "code").setText(QStringLiteral("000000"));
    child<QPushButton>(dialog, "switchOn").click();
    EXPECT_TRUE(child<QLabel>(dialog, "wrong").isVisible()) << "a wrong first code switches nothing on";
    child<QLineEdit>(dialog, "code").setText(QString::fromStdString(codeOf(secret, 0)));
    child<QPushButton>(dialog, "switchOn").click();
    recovery = child<QLabel>(dialog, "recoveryCodes").text().split(QLatin1Char('\n'));
    child<QPushButton>(dialog, "taken").click();
  });

  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));

  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_EQ(recovery.size(), 10);
  window_->signOut();
  bool refused = false;
  whenDialogOpens(QStringLiteral("codeDialog"), [&](QDialog& first) {
    whenDialogOpens(QStringLiteral("codeDialog"), [&](QDialog& second) {
      refused = child<QLabel>(second, "wrong").isVisible();
      child<QLineEdit>(second, "code").setText(QString::fromStdString(codeOf(secret, 1)));
      second.accept();
    });
    child<QLineEdit>(first, "code").setText(QStringLiteral("000000"));
    first.accept();
  });
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  testing::waitFor(window_->background());

  EXPECT_TRUE(refused);
  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  ASSERT_TRUE(window_->lock());
  named<QLineEdit>(*window_, QStringLiteral("Password"))->setText(QString::fromLatin1(kAdminPassword));
  press(*window_, QStringLiteral("Unlock"));
  testing::waitFor(window_->background());
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("desk")) << "the lock asks for the password alone";
}

TEST_F(Shell, ASecondFactorThatIsGivenUpAtTheSignInOpensNothing) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  setCentreSetting<kSecondFactor>(*window_->session(), "everybody");
  window_->signOut();
  whenDialogOpens(QStringLiteral("secondFactorDialog"), [](QDialog& dialog) { dialog.reject(); });

  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
  EXPECT_TRUE(window_->session()->actor().userId.empty());
}

TEST_F(Shell, TheUserMenuSwitchesTheSecondFactorOnAndOffAndANewPasswordAsksForTheCode) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  QString secret;
  QString recovery;
  whenDialogOpens(QStringLiteral("secondFactorDialog"), [&](QDialog& dialog) {
    secret = child<QLabel>(dialog, "secret").text();
    child<QLineEdit>(dialog, "password").setText(QString::fromLatin1(kAdminPassword));
    child<QLineEdit>(dialog, "code").setText(QString::fromStdString(codeOf(secret, 0)));
    child<QPushButton>(dialog, "switchOn").click();
    recovery = child<QLabel>(dialog, "recoveryCodes").text().section(QLatin1Char('\n'), 0, 0);
    child<QPushButton>(dialog, "taken").click();
  });
  Q_EMIT window_->desk()->secondFactorWanted();
  ASSERT_FALSE(recovery.isEmpty());

  Q_EMIT window_->desk()->passwordChangeWanted();
  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("password"));
  named<QLineEdit>(*window_, QStringLiteral("Present password"))
      ->setText(QString::fromLatin1(kAdminPassword));
  named<QLineEdit>(*window_, QStringLiteral("New password"))->setText(QString::fromLatin1(kOwnPassword));
  named<QLineEdit>(*window_, QStringLiteral("Repeat password"))->setText(QString::fromLatin1(kOwnPassword));
  EXPECT_FALSE(testing::button(*window_, QStringLiteral("Save password"))->isEnabled())
      << "the code is missing";
  named<QLineEdit>(*window_, QStringLiteral("Code from your app, or a recovery code"))
      ->setText(QString::fromStdString(codeOf(secret, 1)));
  press(*window_, QStringLiteral("Save password"));
  testing::waitFor(window_->background());
  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));

  whenDialogOpens(QStringLiteral("secondFactorState"), [&](QDialog& dialog) {
    child<QLineEdit>(dialog, "password").setText(QString::fromLatin1(kOwnPassword));
    child<QLineEdit>(dialog, "code").setText(recovery);
    child<QPushButton>(dialog, "switchOff").click();
  });
  Q_EMIT window_->desk()->secondFactorWanted();
  EXPECT_FALSE(ownSecondFactor(*window_->session()).on);
}

TEST_F(Shell, OnlyAKioskAcceptsACardsCodeIfTheCentreAllowsIt) {
  ShellSetup with = setup();
  openFoundedCentre(with);
  EXPECT_TRUE(child<QLineEdit>(*window_, "cardCode").isHidden()) << "no kiosk";
  window_.reset();
  std::string code;
  {
    SessionKey key;
    key.locator = with.locator.toStdString();
    key.station = "office";
    SessionContext office(key);
    ASSERT_EQ(torsio::signIn(office, "admin", kAdminPassword).outcome, SignIn::kOk);
    setCentreSetting<kKioskCodes>(office, true);
    std::vector<UserId> trainees;
    for (const UserAccount& user : users(office)) {
      if (user.login == "chen") {
        trainees.push_back(user.id);
      }
    }
    code = makeKioskCodes(office, trainees).at(0).code;
    torsio::signOut(office);
  }
  with.kiosk = true;
  open(with);
  auto* field = window_->findChild<QLineEdit*>(QStringLiteral("cardCode"));
  ASSERT_TRUE(field->isVisible());
  const auto scan = [&](const QString& typed) {  // a scanner types and ends with Enter
    QTest::keyClicks(field, typed);
    QTest::keyClick(field, Qt::Key_Return);
    testing::waitFor(window_->background());
  };

  scan(QStringLiteral("00000000000000000000"));
  EXPECT_TRUE(says(*window_, QStringLiteral("No card with this code is in force")));
  EXPECT_TRUE(field->text().isEmpty());
  scan(QString::fromStdString(code));

  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_EQ(window_->session()->actor().login, "chen");
}

TEST_F(Shell, TheCentreSetsWhenAnEmptyPlaceIsLocked) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  setCentreIdleLimits(*window_->session(), 10, 12);
  window_->signOut();
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  window_->watchIdleness();

  clock_.advance_us(9 * 60'000'000LL);
  window_->watchIdleness();
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));  // the default would have locked
  clock_.advance_us(90'000'000LL);
  window_->watchIdleness();
  EXPECT_TRUE(says(*window_, QStringLiteral("The screen will be locked in 1:30")));
  clock_.advance_us(91'000'000LL);
  window_->watchIdleness();
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("lock"));
}

}  // namespace

}  // namespace torsio::gui
