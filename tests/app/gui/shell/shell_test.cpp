// SPDX-License-Identifier: GPL-3.0-or-later
// The window around the pages: navigation, long jobs, problems, database outages.
#include <chrono>
#include <condition_variable>
#include <mutex>

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QSettings>
#include <QStackedWidget>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/gui/base/job_panel.h"
#include "app/gui/base/language.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/shell/help_dialogs.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/problem_panel.h"
#include "app/gui/shell/rail.h"
#include "app/services/access/access_service.h"
#include "app/services/access/moved_record.h"
#include "app/services/access/signing.h"
#include "app/services/access/two_people.h"
#include "app/services/base/build_info.h"
#include "assessment/domain/people/person.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/repository/people/people_repository.h"
#include "sim/core/error.h"
#include "tests/app/gui/shell/shell_window.h"
#include "tests/app/gui/support/program_window.h"
#include "tests/support/stored_rows.h"

namespace torsio::gui {
namespace {

using testing::press;
using testing::says;

constexpr std::chrono::seconds kLong{20};  // much more than a busy machine needs

TEST_F(Shell, SaysWhereAMovedRecordWent) {
  const ShellSetup with = setup();
  {
    const std::unique_ptr<SessionContext> office = foundCentre(with.locator.toStdString());
    finishMove(office->connectionWithoutRight(), "postgresql://server/torsio", 1);
    torsio::signOut(*office);
  }
  open(with);
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));

  const QString sentence = QStringLiteral("has moved to postgresql://server/torsio");
  EXPECT_TRUE(QTest::qWaitFor([&] { return says(*window_, sentence); }, 20'000));
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

TEST_F(Shell, TheNavigationSaysHowManyRequestsWaitForTheSecondAdministrator) {
  const ShellSetup with = setup();
  {
    const std::unique_ptr<SessionContext> office = foundCentre(with.locator.toStdString());
    addUser(*office, {.login = "second", .roles = {"administrator"}, .startPassword = kStartPassword});
    (void)makeUser(*office, {.login = "rater", .roles = {"rater"}});
    ASSERT_EQ(changeOwnPassword(*office, {"second", kStartPassword, kOwnPassword}).outcome, SignIn::kOk);
    torsio::signOut(*office);
  }
  open(with);
  const auto users = [this] {
    for (const QPushButton* line : window_->desk()->rail().findChildren<QPushButton*>()) {
      if (line->accessibleName().startsWith(QStringLiteral("Users"))) {
        return line->accessibleName();
      }
    }
    return QString();
  };

  enter(QStringLiteral("second"), QString::fromLatin1(kOwnPassword));
  EXPECT_TRUE(QTest::qWaitFor([&] { return users() == QStringLiteral("Users (1)"); }, 20'000))
      << users().toStdString();
  ASSERT_TRUE(window_->signOut());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  QTest::qWait(300);
  EXPECT_EQ(users(), QStringLiteral("Users")) << "their own";
}

TEST_F(Shell, AProblemMovesNothingUnderThePointer) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  const auto place = [this] {
    QApplication::processEvents();
    return QRect(page().mapTo(window_.get(), QPoint()), page().size());
  };
  const QRect before = place();

  page().context().tell([] { return TranslatedError{"Something went wrong", "Try again", "details"}; });

  const auto* panel = window_->desk()->findChild<ProblemPanel*>();
  ASSERT_NE(panel, nullptr);
  EXPECT_EQ(place(), before);
  EXPECT_TRUE(panel->isVisible());
  EXPECT_GT(panel->height(), 20);
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

TEST_F(Shell, PagesAreKeptAndEnteredAgain) {
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

TEST_F(Shell, AnAdministratorReturnsToTheLastPage) {
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
  QSettings::setDefaultFormat(QSettings::IniFormat);
  ShellSetup with = setup();
  with.remember = true;
  openFoundedCentre(with);
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  EXPECT_EQ(window_->desk()->pageId(), PageId::kUsers) << "the first page of one's own work";
  window_->desk()->open(PageId::kAudit);

  ASSERT_TRUE(window_->signOut());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));

  EXPECT_EQ(window_->desk()->pageId(), PageId::kAudit);
}

TEST_F(Shell, ABusyPageBlocksSignOutOtherPagesAndClosing) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  page().isBusy = true;

  EXPECT_FALSE(window_->signOut());
  EXPECT_FALSE(window_->desk()->open(PageId::kAudit));
  EXPECT_FALSE(window_->close());
  EXPECT_TRUE(says(*window_, QStringLiteral("A run is in progress")));

  page().isBusy = false;
  EXPECT_TRUE(window_->signOut());
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
}

TEST_F(Shell, AnUnfinishedPageIsNotLeft) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  page().mayLeave = false;

  EXPECT_FALSE(window_->desk()->open(PageId::kAudit));
  EXPECT_FALSE(window_->signOut());
  EXPECT_EQ(window_->desk()->pageId(), PageId::kUsers);
  page().mayLeave = true;
}

TEST_F(Shell, AnAdministratorSeesASimulatedTraineesDeskAndReturnsThroughSignIn) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  Q_EMIT window_->desk()->simulatedWanted(SimulatedRole::kTrainee);
  EXPECT_EQ(window_->desk()->pageId(), PageId::kUsers);  // there is none
  addUser(*window_->session(),
          {.login = "demo", .roles = {"trainee"}, .startPassword = kStartPassword, .demonstration = true});

  Q_EMIT window_->desk()->simulatedWanted(SimulatedRole::kTrainee);
  QApplication::processEvents();

  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_EQ(window_->session()->actor().login, "demo");
  EXPECT_EQ(window_->desk()->pageId(), PageId::kNextStep);
  EXPECT_FALSE(window_->desk()->open(PageId::kUsers));
  EXPECT_TRUE(window_->lock());  // nobody knows a password to return with
  EXPECT_EQ(testing::screenOf(*window_), QStringLiteral("sign-in"));
}

TEST_F(Shell, AnAdministratorSeesASimulatedPhysiciansDesk) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  addUser(*window_->session(),
          {.login = "demo", .roles = {"rater"}, .startPassword = kStartPassword, .demonstration = true});

  QAction* enters = nullptr;
  for (QAction* action : window_->findChildren<QAction*>()) {
    enters = action->text() == QStringLiteral("Enter as a simulated physician") ? action : enters;
  }
  ASSERT_NE(enters, nullptr);
  enters->trigger();
  QApplication::processEvents();

  ASSERT_EQ(testing::screenOf(*window_), QStringLiteral("desk"));
  EXPECT_EQ(window_->session()->actor().login, "demo");
  EXPECT_EQ(window_->desk()->pageId(), PageId::kQueue);
  EXPECT_TRUE(says(*window_, QStringLiteral("You are a simulated physician")));
}

TEST_F(Shell, AProblemIsShownInPlainWordsWithFoldedDetailsAndCanBeCopied) {
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

TEST_F(Shell, AnOpenProblemFollowsTheLanguage) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  const Error error(ErrorCode::kBadParameter, Text::verbatim("the moment is outside the recording"),
                    Text::verbatim("7F"), Text::verbatim("Choose a time within it"));
  window_->desk()->context().report(std::make_exception_ptr(error));
  auto* panel = window_->desk()->findChild<ProblemPanel*>();
  press(*panel, QStringLiteral("Details"));
  const QString english = panel->wholeText();
  ASSERT_TRUE(english.contains(QStringLiteral("The moment is outside the recording")));

  LanguageSwitch language;
  language.choose(Language::kSimplifiedChinese);
  QApplication::processEvents();

  EXPECT_TRUE(panel->isVisible());
  EXPECT_TRUE(says(*panel, translated(error).happened));
  EXPECT_TRUE(says(*panel, translated(error).remedy));
  EXPECT_FALSE(panel->wholeText().contains(QStringLiteral("outside")));
  EXPECT_TRUE(panel->findChild<QPlainTextEdit*>()->isVisible());  // unfolded details stay unfolded
  language.choose(Language::kEnglish);
  QApplication::processEvents();
  EXPECT_EQ(panel->wholeText(), english);
}

TEST_F(Shell, ALongJobShowsItsProgressAndCanBeCancelled) {
  openFoundedCentre(setup());
  enter(QStringLiteral("admin"), QString::fromLatin1(kAdminPassword));
  ShellContext& context = window_->desk()->context();
  bool done = false;
  std::atomic<bool> seen{false};
  auto* pages = window_->desk()->findChild<Page*>()->parentWidget();
  const QRect before(pages->mapTo(window_.get(), QPoint()), pages->size());

  context.run(
      window_.get(), QStringLiteral("Export"),
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
  EXPECT_TRUE(says(*job, QStringLiteral("0:30 left")));
  EXPECT_EQ(QRect(pages->mapTo(window_.get(), QPoint()), pages->size()), before)
      << "no button of the page moves away from under the pointer";
  EXPECT_FALSE(window_->signOut());
  press(*job, QStringLiteral("Cancel"));
  context.waitForJobs();

  EXPECT_FALSE(done);
  EXPECT_FALSE(job->isVisible());
}

TEST_F(Shell, AnOpenStationSendsHeartbeatsUntilItIsClosed) {
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

TEST_F(Shell, OneMenuCommandRemovesTheDemonstration) {
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

/// A server that can stop responding.
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

TEST_F(Shell, AHangingDatabaseIsReportedAndBlocksNobody) {
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
  EXPECT_TRUE(tells("Your run continues"));
  page().isBusy = false;

  window_->desk()->context().report(std::make_exception_ptr(
      DbError(DbFault::kUnreachable, "SELECT", Text::verbatim("the server is away"), Text(), Text())));
  EXPECT_TRUE(tells("The server is away"));
  EXPECT_FALSE(tells("SELECT")) << "which statement it was helps nobody";

  gate->set(true);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !tells("The database does not answer"); }, 20'000));
  EXPECT_FALSE(tells("The server is away")) << "it is not true any more";
  EXPECT_EQ(page().answered, 1) << "the page tries again";
  testing::waitFor(window_->background());
  EXPECT_TRUE(window_->desk()->open(PageId::kAudit));
}

TEST(AboutBox, ShowsTheBuildAndThatThisIsNoMedicalDevice) {
  const QString text = aboutText();

  EXPECT_TRUE(text.contains(toQString(softwareVersion())));
  EXPECT_TRUE(text.contains(QLatin1String(QT_VERSION_STR)));
  EXPECT_TRUE(text.contains(QStringLiteral("This is a training tool and not a medical device.")));
}

TEST_F(Shell, EverythingFocusableHasANameForScreenReaders) {
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
