// SPDX-License-Identifier: GPL-3.0-or-later
// Access to the window: the lock and what it covers, signatures, guests, the kiosk.
#include <QApplication>
#include <QDialog>
#include <QLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTimer>
#include <gtest/gtest.h>

#include "app/gui/base/sign_dialog.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/shell/main_window.h"
#include "app/gui/shell/screen_lock.h"
#include "app/gui/shell/sign_in_panel.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/kiosk_codes.h"
#include "app/services/access/signing.h"
#include "assessment/domain/people/account.h"
#include "assessment/domain/people/signature.h"
#include "tests/app/gui/shell/shell_window.h"
#include "tests/app/gui/support/program_window.h"

namespace torsio::gui {
namespace {

using testing::named;
using testing::press;
using testing::says;

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

TEST_F(Shell, OnlyAKioskAcceptsACardsCodeIfTheCentreAllowsIt) {
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
