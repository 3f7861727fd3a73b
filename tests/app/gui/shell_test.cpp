// SPDX-License-Identifier: GPL-3.0-or-later
// The program's window as its people use it: first run, sign-in, forced change, lock, sign-out.
#include <condition_variable>
#include <mutex>

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QDialog>
#include <QDir>
#include <QFileInfo>
#include <QLabel>
#include <QLayout>
#include <QLineEdit>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStackedWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/access/first_run.h"
#include "app/access/kiosk_codes.h"
#include "app/access/settings_service.h"
#include "app/access/signing.h"
#include "app/base/build_info.h"
#include "app/gui/base/language.h"
#include "app/gui/base/sign_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/shell/about_box.h"
#include "app/gui/shell/dialog_lock.h"
#include "app/gui/shell/job_panel.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/problem_panel.h"
#include "app/gui/shell/rail.h"
#include "app/gui/shell/sign_in_panel.h"
#include "app/gui/widgets/theme.h"
#include "app/maintenance/demonstration_removal.h"
#include "assessment/people/account.h"
#include "assessment/people/person.h"
#include "assessment/people/signature.h"
#include "db/connection/connection.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/trial/station_repository.h"
#include "sim/base/error.h"
#include "sim/base/file_io.h"
#include "tests/app/gui/shown_screen.h"
#include "tests/support/stored_rows.h"

namespace torsio::gui {
namespace {

using testing::named;
using testing::press;
using testing::says;

constexpr std::chrono::seconds kLong{20};  // far more than a busy machine needs
constexpr const char* kAdminPassword = "a short sentence for the lab";
constexpr const char* kStartPassword = "start with these words";
constexpr const char* kOwnPassword = "only I know this sentence";

/// What a role's folder gives to the shell, without any content.
class BarePage : public Page {
 public:
  BarePage(ShellContext& context, QString name) : Page(context), name_(std::move(name)) {
    setAccessibleName(name_);
  }
  void enter(const QVariant& argument) override {
    ++entered;
    argument_ = argument;
  }
  bool leave() override { return mayLeave; }
  bool busy() const override { return isBusy; }
  void retranslate() override {}
  ShellContext& context() { return shell(); }

  int entered = 0;
  bool mayLeave = true;
  bool isBusy = false;
  QVariant argument_;

 private:
  QString name_;
};

PageEntry entry(PageId id) {
  return {id, [id](ShellContext& context) -> Page* { return new BarePage(context, pageTitle(id)); }};
}

std::vector<PageGroup> bareGroups() {
  return {{[] { return QStringLiteral("Training"); }, {entry(PageId::kNextStep), entry(PageId::kPractice)}},
          {[] { return QStringLiteral("Review"); }, {entry(PageId::kQueue)}},
          {[] { return QStringLiteral("Administration"); }, {entry(PageId::kUsers), entry(PageId::kAudit)}}};
}

class Shell : public ::testing::Test {
 protected:
  QTemporaryDir folder_;
  ManualClock clock_;
  std::unique_ptr<MainWindow> window_;

  ShellSetup setup() {
    ShellSetup setup;
    setup.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
    setup.station = "test";
    setup.locator = folder_.filePath(QStringLiteral("torsio.sqlite"));
    setup.groups = bareGroups;
    setup.remember = false;
    setup.clock = &clock_;
    setup.unstored = folder_.filePath(QStringLiteral("unstored")).toStdString();
    setup.passwordCost = PasswordCost::kTest;
    return setup;
  }

  void open(const ShellSetup& with) {
    window_ = std::make_unique<MainWindow>(with);
    window_->QWidget::show();
    window_->start();
    testing::waitFor(window_->background());  // recordings that wait in files are stored first
  }

  /// A centre with an administrator and a trainee who has a start password, nobody signed in.
  void openFoundedCentre(ShellSetup with) {
    SessionKey key;
    key.locator = with.locator.toStdString();
    key.station = "test";
    SessionContext office(key);
    office.setPasswordCost(PasswordCost::kTest);
    FirstRun first;
    first.centre = "City hospital";
    first.login = "admin";
    first.password = kAdminPassword;
    setUpCentre(office, first);
    ASSERT_EQ(torsio::signIn(office, "admin", kAdminPassword).outcome, SignIn::kOk);
    addUser(office, {.login = "chen", .roles = {"trainee"}, .startPassword = kStartPassword});
    torsio::signOut(office);
    open(with);
  }

  void enter(const QString& login, const QString& password) {
    named<QLineEdit>(*window_, QStringLiteral("Sign-in name"))->setText(login);
    named<QLineEdit>(*window_, QStringLiteral("Password"))->setText(password);
    press(*window_, QStringLiteral("Sign in"));
    testing::waitFor(window_->background());
  }

  BarePage& page() { return static_cast<BarePage&>(*window_->desk()->page()); }
};

TEST_F(Shell, TheFirstRunMakesACentreAndLeadsItsAdministratorToTheFirstPage) {
  open(setup());
  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("first run"));

  press(*window_, QStringLiteral("Next"));
  EXPECT_TRUE(says(*window_, QStringLiteral("Enter the name of your centre")));
  {  // right below the field that it is about, which has the keyboard
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
  EXPECT_TRUE(says(*window_, QStringLiteral("The first administrator")));  // a weak password leads nowhere
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

TEST_F(Shell, ALookRoundNeedsNoPasswordAndLeavesNothingBehind) {
  ShellSetup with = setup();
  with.simulatedPeople = [](SessionContext& session, const ProgressCallback&) {
    Trainee simulated;
    simulated.person = {.id = "simulated", .code = "T-99", .demonstration = true};
    PeopleRepository(session.connectionWithoutRight()).addTrainees({&simulated, 1});
    return std::vector<StartAccount>{{.login = "demo.trainee", .role = "trainee"}};
  };
  open(with);
  press(*window_, QStringLiteral("&Look round with simulated people"));
  testing::waitFor(window_->background());

  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_TRUE(says(*window_, QStringLiteral("Everybody here is simulated")));
  const QString file = toQString(window_->session()->key().locator);
  EXPECT_TRUE(QFileInfo::exists(file));
  EXPECT_FALSE(QFileInfo::exists(setup().locator));
  EXPECT_EQ(demonstrationSize(*window_->session()).people, 1);
  window_->chooseTheme(ThemeKind::kDark);
  ASSERT_TRUE(window_->signOut());

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("first run"));
  EXPECT_FALSE(QFileInfo::exists(file));
  EXPECT_FALSE(QFileInfo::exists(QFileInfo(file).absolutePath()));
  EXPECT_TRUE(QDir(folder_.path()).isEmpty());
}

TEST_F(Shell, TheNavigationIsAListAndItsLinesCanBePressed) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  auto* list = window_->findChild<QWidget*>(QStringLiteral("pages"));
  ASSERT_NE(list, nullptr);
  QAccessibleInterface* pages = QAccessible::queryAccessibleInterface(list);
  ASSERT_NE(pages, nullptr);
  EXPECT_EQ(pages->role(), QAccessible::List);
  EXPECT_EQ(pages->text(QAccessible::Name), QStringLiteral("Pages"));

  QAccessibleInterface* audit = nullptr;
  for (int i = 0; i < pages->childCount(); ++i) {
    if (pages->child(i)->text(QAccessible::Name) == QStringLiteral("Audit trail")) {
      audit = pages->child(i);
    }
  }
  ASSERT_NE(audit, nullptr);
  EXPECT_EQ(audit->role(), QAccessible::ListItem);
  EXPECT_FALSE(audit->state().selected);
  ASSERT_TRUE(audit->actionInterface()->actionNames().contains(QAccessibleActionInterface::pressAction()));
  audit->actionInterface()->doAction(QAccessibleActionInterface::pressAction());

  EXPECT_EQ(window_->desk()->pageId(), PageId::kAudit);
  EXPECT_TRUE(audit->state().selected);
}

TEST_F(Shell, ThePagesBeginInTheColoursOfTheSignIn) {
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

TEST_F(Shell, AWrongPasswordSaysNeitherWhichPartWasWrongNorKeepsIt) {
  openFoundedCentre(setup());

  enter(QStringLiteral("admin"), QStringLiteral("not this one at all"));

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
  EXPECT_TRUE(says(*window_, QStringLiteral("Name and password do not fit together")));
  EXPECT_TRUE(named<QLineEdit>(*window_, QStringLiteral("Password"))->text().isEmpty());
}

TEST_F(Shell, TheKeyboardIsInAFieldFromTheStartAndAfterAWrongPassword) {
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

TEST_F(Shell, EnterPressesTheButtonThatHasTheKeyboard) {
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

TEST_F(Shell, AfterTooManyTriesItSaysHowLongToWaitAndLetsNobodyTry) {
  openFoundedCentre(setup());

  for (int i = 0; i < 4; ++i) {
    enter(QStringLiteral("admin"), QStringLiteral("not this one at all"));
  }
  named<QLineEdit>(*window_, QStringLiteral("Password"))->setText(QString::fromLatin1(kAdminPassword));
  press(*window_, QStringLiteral("Sign in"));
  testing::waitFor(window_->background());

  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
  EXPECT_TRUE(says(*window_, QStringLiteral("Please wait")));
}

TEST_F(Shell, AStartPasswordMustBeChangedBeforeAnythingElse) {
  openFoundedCentre(setup());

  enter(QStringLiteral("chen"), QString::fromLatin1(kStartPassword));
  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("password"));
  named<QLineEdit>(*window_, QStringLiteral("New password"))->setText(QString::fromLatin1(kOwnPassword));
  named<QLineEdit>(*window_, QStringLiteral("Repeat password"))->setText(QString::fromLatin1(kOwnPassword));
  press(*window_, QStringLiteral("Save password"));
  testing::waitFor(window_->background());

  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_EQ(window_->desk()->pageId(), PageId::kNextStep);
  window_->signOut();
  enter(QStringLiteral("chen"), QString::fromLatin1(kOwnPassword));
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
}

TEST_F(Shell, TheDeskOffersOnlyWhatItsActorMayOpen) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));

  EXPECT_FALSE(window_->desk()->open(PageId::kQueue));
  EXPECT_FALSE(window_->desk()->open(PageId::kNextStep));
  EXPECT_TRUE(window_->desk()->open(PageId::kAudit));
  EXPECT_TRUE(window_->desk()->open(PageId::kUsers));
  EXPECT_EQ(window_->desk()->pageId(), PageId::kUsers);
}

TEST_F(Shell, PagesAreKeptAndEnteredAnew) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  Desk& desk = *window_->desk();
  Page* first = desk.page();

  desk.context().open(PageId::kAudit, QStringLiteral("argument"));
  EXPECT_EQ(page().argument_.toString(), QStringLiteral("argument"));
  desk.open(PageId::kUsers);

  EXPECT_EQ(desk.page(), first);
  EXPECT_EQ(page().entered, 2);
}

TEST_F(Shell, ABusyPageBlocksSignOutOtherPagesAndClosing) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  page().isBusy = true;

  EXPECT_FALSE(window_->signOut());
  EXPECT_FALSE(window_->desk()->open(PageId::kAudit));
  EXPECT_FALSE(window_->close());
  EXPECT_TRUE(says(*window_, QStringLiteral("A run is going on")));

  page().isBusy = false;
  EXPECT_TRUE(window_->signOut());
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
}

TEST_F(Shell, APageWithSomethingUnfinishedIsNotLeft) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  page().mayLeave = false;

  EXPECT_FALSE(window_->desk()->open(PageId::kAudit));
  EXPECT_FALSE(window_->signOut());
  EXPECT_EQ(window_->desk()->pageId(), PageId::kUsers);
  page().mayLeave = true;
}

TEST_F(Shell, AnIdleDeskWarnsThenLocksAndOpensAsItWas) {
  ShellSetup with = setup();
  with.idle = IdleLimits{.warn_us = 10'000'000, .lock_us = 20'000'000};
  openFoundedCentre(with);
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  Desk* desk = window_->desk();
  const std::int64_t shown_us = window_->session()->actor().passwordShownUtc_us;
  window_->watchIdleness();

  clock_.advance_us(12'000'000);
  window_->watchIdleness();
  EXPECT_TRUE(says(*window_, QStringLiteral("The screen will be locked in 8")));
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

TEST_F(Shell, ASignatureAsksForThePasswordUntilItIsRightAndSaysWhatItMeans) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  const QString meaning = labelOf(SignatureMeaning::kFroze);
  EXPECT_TRUE(readyToSign(window_.get(), window_->desk()->context(), meaning)) << "shown a moment ago";
  setSignMinutes(window_->desk()->context().session(), 0);
  ASSERT_TRUE(window_->signOut());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));

  QTimer::singleShot(0, window_.get(), [&] {
    auto& dialog = *QApplication::activeModalWidget();
    EXPECT_EQ(dialog.objectName(), QStringLiteral("signDialog"));
    EXPECT_TRUE(says(dialog, meaning));
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

/// The veil over a dialog of a locked place.
QWidget* veilOf(const QWidget& dialog) {
  return dialog.findChild<QWidget*>(QStringLiteral("lockVeil"));
}

TEST_F(Shell, TheLockCoversAnOpenDialogAndKeepsWhatWasTypedInIt) {
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

TEST_F(Shell, SigningOutFromTheLockGivesUpTheDialogsFirst) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  bool returned = false;
  QTimer::singleShot(0, window_.get(), [this] {
    ASSERT_TRUE(window_->lock());
    press(*window_->findChild<DialogLock*>(), QStringLiteral("Sign out"));
    EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("lock"));  // the page still waits for its dialog
  });
  {
    QDialog dialog(&page());  // on the stack, as pages have them: it must not die with the desk
    EXPECT_EQ(dialog.exec(), QDialog::Rejected);
    returned = window_->desk() != nullptr;
  }
  QApplication::processEvents();

  EXPECT_TRUE(returned);
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
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

TEST_F(Shell, AGuestPractisesAndReachesNothingElse) {
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

TEST_F(Shell, AnAdministratorSeesTheDeskOfASimulatedTraineeAndComesBackByTheSignIn) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  Q_EMIT window_->desk()->simulatedTraineeWanted();
  EXPECT_EQ(window_->desk()->pageId(), PageId::kUsers);  // there is none
  addUser(*window_->session(),
          {.login = "demo", .roles = {"trainee"}, .startPassword = kStartPassword, .demonstration = true});

  Q_EMIT window_->desk()->simulatedTraineeWanted();
  QApplication::processEvents();

  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_EQ(window_->session()->actor().login, "demo");
  EXPECT_EQ(window_->desk()->pageId(), PageId::kNextStep);
  EXPECT_FALSE(window_->desk()->open(PageId::kUsers));
  EXPECT_TRUE(window_->lock());  // nobody knows a password to come back with
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
}

TEST_F(Shell, AGuestWhoLeavesIsSignedOutNotLocked) {
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

TEST_F(Shell, AProblemIsSaidPlainlyWithItsDetailsFoldedAndCanBeCopied) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));

  window_->desk()->context().report(std::make_exception_ptr(
      Error(ErrorCode::kFileUnwritable, Text::verbatim("the report cannot be written"),
            Text::verbatim("/reports/a.pdf"), Text::verbatim("Choose another folder"))));

  auto* panel = window_->desk()->findChild<ProblemPanel*>();
  ASSERT_TRUE(panel->isVisible());
  EXPECT_TRUE(says(*panel, QStringLiteral("The report cannot be written")));
  EXPECT_TRUE(says(*panel, QStringLiteral("Choose another folder")));
  EXPECT_FALSE(says(*panel, QStringLiteral("/reports/a.pdf")));
  press(*panel, QStringLiteral("Copy"));
  EXPECT_TRUE(QApplication::clipboard()->text().contains(QStringLiteral("/reports/a.pdf")));
  press(*panel, QStringLiteral("Close"));
  EXPECT_FALSE(panel->isVisible());
}

TEST_F(Shell, AProblemThatIsOpenFollowsTheLanguage) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  const Error error(ErrorCode::kBadParameter, Text::verbatim("the moment lies outside the recording"),
                    Text::verbatim("7F"), Text::verbatim("Choose a time within it"));
  window_->desk()->context().report(std::make_exception_ptr(error));
  auto* panel = window_->desk()->findChild<ProblemPanel*>();
  press(*panel, QStringLiteral("Details"));
  const QString english = panel->wholeText();
  ASSERT_TRUE(english.contains(QStringLiteral("The moment lies outside the recording")));

  LanguageSwitch language;
  language.choose(Language::kSimplifiedChinese);
  QApplication::processEvents();

  EXPECT_TRUE(panel->isVisible());
  EXPECT_TRUE(says(*panel, translated(error).happened));
  EXPECT_TRUE(says(*panel, translated(error).remedy));
  EXPECT_FALSE(panel->wholeText().contains(QStringLiteral("outside")));
  EXPECT_TRUE(panel->findChild<QPlainTextEdit*>()->isVisible());  // what was unfolded stays so
  language.choose(Language::kEnglish);
  QApplication::processEvents();
  EXPECT_EQ(panel->wholeText(), english);
}

TEST_F(Shell, LongWorkShowsItsProgressAndCanBeCancelled) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  ShellContext& context = window_->desk()->context();
  bool done = false;
  std::atomic<bool> seen{false};

  context.run(
      QStringLiteral("Export"),
      [&seen](SessionContext&, const ProgressCallback& progress) {
        while (true) {
          progress({Text::verbatim("Writing"), 0.5, 30.0});
          seen.store(true);
        }
      },
      [&done] { done = true; });
  while (!seen.load()) {
    QApplication::processEvents();
  }
  QApplication::processEvents();
  auto* job = window_->desk()->findChild<JobPanel*>();
  EXPECT_TRUE(says(*job, QStringLiteral("50 %")));
  EXPECT_TRUE(says(*job, QStringLiteral("30 s left")));
  const auto* pages = job->parentWidget()->findChild<QStackedWidget*>({}, Qt::FindDirectChildrenOnly);
  ASSERT_NE(pages, nullptr);
  EXPECT_EQ(pages->y(), 0) << "no button of the page moves away from under the pointer";
  EXPECT_GT(job->y(), pages->geometry().bottom());
  EXPECT_FALSE(window_->signOut());
  press(*job, QStringLiteral("Cancel"));
  context.waitForJobs();

  EXPECT_FALSE(done);
  EXPECT_FALSE(job->isVisible());
}

TEST_F(Shell, ARecordingThatCannotBeStoredIsSaidBeforeTheSignInAndToWhoeverSignsIn) {
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

TEST_F(Shell, AnOpenStationGivesSignsOfLifeUntilItIsClosed) {
  openFoundedCentre(setup());
  Connection& connection = window_->session()->connectionWithoutRight();
  ASSERT_TRUE(window_->line()->settled(kLong));
  ASSERT_TRUE(stationOnBoard(connection, "test").has_value());
  EXPECT_EQ(stationOnBoard(connection, "test")->userId, "");

  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  window_->heartbeat();
  ASSERT_TRUE(window_->line()->settled(kLong));
  EXPECT_EQ(stationOnBoard(connection, "test")->userId, window_->session()->actor().userId);
  ASSERT_TRUE(window_->close());

  EXPECT_FALSE(stationOnBoard(connection, "test").has_value());
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

/// Fills the dialog that leaves the kiosk.
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

TEST_F(Shell, TheKioskEndsWithTheNameAndPasswordOfAnAdministratorOnly) {
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

TEST_F(Shell, AKioskTakesTheCodeOfACardWhereTheCentreAllowsItAndNoOtherPlaceDoes) {
  ShellSetup with = setup();
  openFoundedCentre(with);
  EXPECT_TRUE(window_->findChild<QLineEdit*>(QStringLiteral("cardCode"))->isHidden()) << "no kiosk";
  window_.reset();
  std::string code;
  {
    SessionKey key;
    key.locator = with.locator.toStdString();
    key.station = "office";
    SessionContext office(key);
    ASSERT_EQ(torsio::signIn(office, "admin", kAdminPassword).outcome, SignIn::kOk);
    setCentreSetting(office, kKioskCodesSetting, "yes");
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
  const auto scan = [&](const QString& typed) {  // a scanner is a keyboard that ends with Enter
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

TEST_F(Shell, OneChoiceInTheMenuRemovesTheDemonstration) {
  openFoundedCentre(setup());
  Connection& connection = window_->session()->connectionWithoutRight();
  Trainee simulated;
  simulated.person = {.id = "simulated", .code = "T-99", .demonstration = true};
  Trainee real;
  real.person = {.id = "real", .code = "T-01"};
  PeopleRepository(connection).addTrainees({&simulated, 1});
  PeopleRepository(connection).addTrainees({&real, 1});
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));

  QTimer::singleShot(0, qApp, [] {
    auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(question, nullptr);
    EXPECT_TRUE(question->text().contains(QStringLiteral("simulated people (1)")));
    for (QAbstractButton* button : question->buttons()) {
      if (button->text() == QStringLiteral("Remove")) {
        button->click();
      }
    }
  });
  QAction* remove = nullptr;
  for (QAction* action : window_->desk()->findChildren<QAction*>()) {
    if (action->text().startsWith(QStringLiteral("Remove demonstration data"))) {
      remove = action;
    }
  }
  ASSERT_NE(remove, nullptr);
  remove->trigger();
  window_->desk()->context().waitForJobs();

  const std::vector<std::string> codes = PeopleRepository(connection).codes();
  EXPECT_EQ(codes, std::vector<std::string>{"T-01"});
}

TEST_F(Shell, TheCentreSaysWhenAnEmptyPlaceIsLocked) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  setCentreIdleLimits(*window_->session(), 10, 12);
  window_->signOut();
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  window_->watchIdleness();

  clock_.advance_us(9 * 60'000'000LL);
  window_->watchIdleness();
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));  // the usual five minutes would have locked
  clock_.advance_us(90'000'000LL);
  window_->watchIdleness();
  EXPECT_TRUE(says(*window_, QStringLiteral("The screen will be locked in 90")));
  clock_.advance_us(91'000'000LL);
  window_->watchIdleness();
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("lock"));
}

/// A server that may stop to answer.
struct Gate {
  std::mutex mutex;
  std::condition_variable changed;
  bool open = true;
  void set(bool now) {
    const std::lock_guard lock(mutex);
    open = now;
    changed.notify_all();
  }
  void pass() {
    std::unique_lock lock(mutex);
    changed.wait(lock, [this] { return open; });
  }
};

TEST_F(Shell, ADatabaseThatHangsIsSaidCalmlyAndHoldsUpNobody) {
  ShellSetup with = setup();
  using namespace std::chrono_literals;
  with.linePatience = {.again = 10ms, .heartbeat = 10ms, .silence = 100ms, .farewell = 50ms};
  openFoundedCentre(with);
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  const auto gate = std::make_shared<Gate>();
  gate->set(false);
  window_->line()->write([gate](SessionContext&) { gate->pass(); });
  const auto tells = [this](const char* part) {
    window_->heartbeat();
    return says(*window_, QLatin1String(part));
  };

  EXPECT_TRUE(QTest::qWaitFor([&] { return tells("The database does not answer"); }, 20'000));
  EXPECT_FALSE(window_->desk()->open(PageId::kAudit));
  EXPECT_EQ(window_->desk()->pageId(), PageId::kUsers);
  page().isBusy = true;
  EXPECT_TRUE(tells("Your run goes on"));
  page().isBusy = false;

  gate->set(true);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !tells("The database does not answer"); }, 20'000));
  testing::waitFor(window_->background());
  EXPECT_TRUE(window_->desk()->open(PageId::kAudit));
}

TEST(AboutBox, TellsTheBuildAndThatThisIsNoMedicalDevice) {
  const QString text = aboutText();

  EXPECT_TRUE(text.contains(toQString(softwareVersion())));
  EXPECT_TRUE(text.contains(QLatin1String(QT_VERSION_STR)));
  EXPECT_TRUE(text.contains(QStringLiteral("This is a training tool and not a medical device.")));
}

TEST_F(Shell, EverythingThatTakesTheKeyboardHasANameForScreenReaders) {
  openFoundedCentre(setup());
  const auto check = [this] {
    for (QWidget* widget : window_->findChildren<QWidget*>()) {
      if ((widget->focusPolicy() & Qt::TabFocus) == 0 || !widget->isVisible()) {
        continue;
      }
      const auto* button = qobject_cast<QAbstractButton*>(widget);
      if (button != nullptr && !button->text().isEmpty()) {
        continue;
      }
      EXPECT_FALSE(widget->accessibleName().isEmpty()) << widget->metaObject()->className();
    }
  };
  check();
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  check();
  window_->desk()->rail().setNarrow(true);
  check();
}

}  // namespace
}  // namespace torsio::gui
