// SPDX-License-Identifier: GPL-3.0-or-later
// The live sheet follows an administrator's call.
#include "app/gui/physician/live_page.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include <QLabel>
#include <QPointer>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <gtest/gtest.h>

#include "app/gui/base/language.h"
#include "app/gui/base/page.h"
#include "app/gui/base/translated_text.h"
#include "app/gui/widgets/child.h"
#include "app/services/review/sheet_editor.h"
#include "app/services/study/cohort_service.h"
#include "app/services/study/live_call.h"
#include "assessment/domain/rating/sheet_check.h"
#include "tests/app/gui/physician/desk_of.h"
#include "tests/app/gui/support/visible_texts.h"
#include "tests/app/support/review_centre.h"

namespace torsio::gui {
namespace {

using torsio::testing::ReviewCentre;

/// Speeds up a page's timers until their data has been read and shown. False: they do not run.
bool looksAnew(const QWidget& page) {
  constexpr int kRings = 20;
  constexpr int kEvery_ms = 100;
  constexpr int kLongest_ms = 20'000;
  int rings = 0;
  QObject here;
  for (QTimer* clock : page.findChildren<QTimer*>(Qt::FindDirectChildrenOnly)) {
    if (clock->isActive()) {
      clock->setInterval(kEvery_ms);
      QObject::connect(clock, &QTimer::timeout, &here, [&rings] { ++rings; });
    }
  }
  return QTest::qWaitFor([&] { return rings >= kRings; }, kLongest_ms);
}

constexpr int kPatience_ms = 20'000;  // the page refreshes every two seconds

class LivePageFollows : public ::testing::Test {
 protected:
  LiveCallId call(std::size_t trainee, const char* room) {
    const CohortId cohortId = cohorts(*office_).at(0).cohort.id;
    const std::vector<Enrolment> all = enrolments(*office_, cohortId);
    return callTrainee(*office_, {cohortId, all.at(trainee).id, "post", room, {}});
  }
  void end(const LiveCallId& id) { endCall(*office_, cohorts(*office_).at(0).cohort.id, id); }
  [[nodiscard]] QString label(std::size_t trainee) {
    return QStringLiteral("Case %1").arg(
        toQString(openSheet(desk_.session(), centre_.cases(0, true).at(trainee)).shown.label));
  }
  /// The case's name is also in the list at the left.
  [[nodiscard]] bool shows(const LivePage& page, std::size_t trainee) {
    const QString wanted = label(trainee);
    const QList<QLabel*> labels = page.findChildren<QLabel*>();
    return std::any_of(labels.begin(), labels.end(),
                       [&](const QLabel* one) { return one->isVisible() && one->text() == wanted; });
  }
  void scoreAll() {
    desk_.press({Qt::Key_6, Qt::Key_Down, Qt::Key_7, Qt::Key_Down, Qt::Key_5});
    desk_.finish(2);
  }

  ReviewCentre centre_{{.trainees = 3, .trial_s = 0.2, .live = true, .called = false}};
  std::unique_ptr<SessionContext> office_{centre_.administrator()};
  DeskOf desk_{centre_, 0};
};

TEST_F(LivePageFollows, OpensTheSheetOfTheCaseThatIsCalled) {
  auto& page = desk_.open<LivePage>();
  EXPECT_TRUE(wordsOf(page).contains(QStringLiteral("Nobody is called yet")));
  EXPECT_EQ(editorOf(page), nullptr);

  call(1, "room 1");

  EXPECT_TRUE(QTest::qWaitFor([&] { return wordsOf(page).contains(label(1)); }, kPatience_ms));
  ASSERT_NE(editorOf(page), nullptr);
  scoreAll();
  EXPECT_EQ(openSheet(desk_.session(), centre_.cases(0, true).at(1)).state, SheetState::kSubmitted);
}

TEST_F(LivePageFollows, StartsTheNextSheetAtItsFirstRow) {
  end(call(0, "room 1"));
  auto& page = desk_.open<LivePage>();
  ASSERT_TRUE(shows(page, 0)) << "looked at, and not begun";

  call(1, "room 1");
  ASSERT_TRUE(QTest::qWaitFor([&] { return shows(page, 1); }, kPatience_ms));
  desk_.press(Qt::Key_6);

  ASSERT_NE(editorOf(page), nullptr);
  EXPECT_TRUE(editorOf(page)->answer(editorOf(page)->order().front()).score_steps.has_value());
  EXPECT_FALSE(editorOf(page)->answer(kOverallRow).score_steps.has_value());
}

TEST_F(LivePageFollows, APressedLineIsNotRebuiltBeforeItsRelease) {
  call(2, "room 1");
  auto& page = desk_.open<LivePage>();
  const QList<QToolButton*> all = page.findChildren<QToolButton*>();
  const auto line = std::find_if(all.begin(), all.end(), [&](const QToolButton* one) {
    return one->isVisible() && one->text().contains(label(2));
  });
  ASSERT_NE(line, all.end());
  const QPointer<QToolButton> pressed(*line);
  const QSignalSpy clicks(pressed, &QToolButton::clicked);
  QTest::mousePress(pressed, Qt::LeftButton);

  call(1, "room 2");
  ASSERT_TRUE(looksAnew(page));

  ASSERT_FALSE(pressed.isNull());
  EXPECT_TRUE(pressed->isVisible() && pressed->isDown());
  QTest::mouseRelease(pressed, Qt::LeftButton);
  EXPECT_EQ(clicks.count(), 1);
}

TEST_F(LivePageFollows, StaysWithItsRoom) {
  const LiveCallId first = call(0, "room 1");
  auto& page = desk_.open<LivePage>();
  ASSERT_TRUE(shows(page, 0));

  call(1, "room 2");

  auto& hint = child<QLabel>(page, "called");
  ASSERT_TRUE(QTest::qWaitFor([&] { return hint.isVisible(); }, kPatience_ms));
  EXPECT_TRUE(shows(page, 0)) << "nobody marked it yet, but the trainee is still there";
  EXPECT_TRUE(hint.text().contains(label(1))) << hint.text().toStdString();
  EXPECT_TRUE(hint.text().contains(QStringLiteral("room 2"))) << hint.text().toStdString();
  end(first);
  EXPECT_TRUE(QTest::qWaitFor([&] { return shows(page, 1) && !hint.isVisible(); }, kPatience_ms))
      << "when the trainee has left, the sheet follows";
}

TEST_F(LivePageFollows, NeverReplacesAStartedSheet) {
  call(0, "room 1");
  auto& page = desk_.open<LivePage>();
  ASSERT_TRUE(wordsOf(page).contains(label(0)));
  desk_.press(Qt::Key_6);

  call(1, "room 2");

  auto& hint = child<QLabel>(page, "called");
  EXPECT_TRUE(QTest::qWaitFor([&] { return hint.isVisible(); }, kPatience_ms));
  EXPECT_TRUE(hint.text().contains(label(1)));
  EXPECT_TRUE(wordsOf(page).contains(label(0))) << "the begun sheet stays";
  scoreAll();
  EXPECT_TRUE(wordsOf(page).contains(label(1))) << "and the called one follows when it is in";
  EXPECT_FALSE(hint.isVisible());
  EXPECT_EQ(openSheet(desk_.session(), centre_.cases(0, true).at(0)).state, SheetState::kSubmitted);
}

TEST_F(LivePageFollows, KeepsInputDuringADatabaseOutage) {
  call(0, "room 1");
  auto& page = desk_.open<LivePage>();
  ASSERT_TRUE(shows(page, 0));
  desk_.press(Qt::Key_6);
  Connection& record = centre_.connection();
  record.executeVerbatim(
      "CREATE TRIGGER away BEFORE UPDATE ON mark_draft BEGIN SELECT RAISE(ABORT, 'away'); END");
  desk_.press(Qt::Key_7);
  EXPECT_TRUE(wordsOf(page).contains(QStringLiteral("Not saved")));
  EXPECT_EQ(desk_.failures().size(), 1);
  record.executeVerbatim("DROP TRIGGER away");

  QEvent answered(databaseAnsweredEvent());
  QCoreApplication::sendEvent(&page, &answered);

  EXPECT_FALSE(wordsOf(page).contains(QStringLiteral("Not saved")));
  const OpenedSheet kept = openSheet(desk_.session(), centre_.cases(0, true).at(0));
  const auto scores = [](const Sheet& sheet) {
    std::map<std::string, std::optional<std::int64_t>> byRow;
    for (const SheetRow& row : sheet.rows) {
      byRow[row.code] = row.score_steps;
    }
    return byRow;
  };
  EXPECT_EQ(scores(kept.sheet), scores(editorOf(page)->sheet()));
}

TEST_F(LivePageFollows, RepeatsMessagesInTheLanguageChosenLast) {
  call(0, "room 1");
  auto& page = desk_.open<LivePage>();
  ASSERT_TRUE(shows(page, 0));
  desk_.press(Qt::Key_6);
  ASSERT_TRUE(wordsOf(page).contains(QStringLiteral("Saved on this machine")));
  call(1, "room 2");
  auto& hint = child<QLabel>(page, "called");
  ASSERT_TRUE(QTest::qWaitFor([&] { return hint.isVisible(); }, kPatience_ms));

  LanguageSwitch language;
  language.choose(Language::kSimplifiedChinese);
  page.retranslate();

  EXPECT_FALSE(wordsOf(page).contains(QStringLiteral("Saved on this machine")));
  EXPECT_FALSE(hint.text().contains(QStringLiteral("is called"))) << hint.text().toStdString();
  EXPECT_TRUE(hint.text().contains(QStringLiteral("room 2"))) << hint.text().toStdString();
  language.choose(Language::kEnglish);
  page.retranslate();
  EXPECT_TRUE(wordsOf(page).contains(QStringLiteral("Saved on this machine")));
}

TEST_F(LivePageFollows, ALateSheetCanBeSubmittedAfterTheCall) {
  end(call(0, "room 1"));
  call(1, "room 1");
  auto& page = desk_.open<LivePage>();
  EXPECT_TRUE(wordsOf(page).contains(label(1))) << "who stands at the arm comes first";
  QStringList lines;
  for (const QToolButton* button : page.findChildren<QToolButton*>()) {
    lines << button->text();
  }
  EXPECT_TRUE(lines.join(u'\n').contains(label(0) + QStringLiteral(", late")))
      << lines.join(u'\n').toStdString();
  EXPECT_TRUE(lines.join(u'\n').contains(label(1) + QStringLiteral(", called now")));
  scoreAll();
  EXPECT_TRUE(wordsOf(page).contains(label(0)));
  scoreAll();
  EXPECT_EQ(openSheet(desk_.session(), centre_.cases(0, true).at(0)).state, SheetState::kSubmitted);
}

TEST_F(LivePageFollows, ALateSheetCanBeOpenedWhileAnotherCaseIsCalled) {
  end(call(0, "room 1"));
  call(1, "room 1");
  auto& page = desk_.open<LivePage>();
  ASSERT_TRUE(wordsOf(page).contains(label(1)));

  for (QToolButton* button : page.findChildren<QToolButton*>()) {
    if (button->text().contains(label(0))) {
      button->click();
      break;
    }
  }

  EXPECT_TRUE(wordsOf(page).contains(label(0)));
  EXPECT_TRUE(child<QLabel>(page, "called").text().contains(label(1))) << "says who is called meanwhile";
}

TEST_F(LivePageFollows, AHastyCtrlEnterDoesNotReachTheNextSheet) {
  end(call(1, "room 1"));
  const AssignmentId next = centre_.cases(0, true).at(1);
  static_cast<void>(saveSheet(desk_.session(), next, torsio::testing::reviewSheet(5, 6, 5), {}));
  call(0, "room 1");  // before the late one
  auto& page = desk_.open<LivePage>();
  ASSERT_TRUE(shows(page, 0));
  scoreAll();
  ASSERT_TRUE(shows(page, 1));

  for (int i = 0; i < 3; ++i) {
    desk_.press(Qt::Key_Return, Qt::ControlModifier);
  }
  EXPECT_TRUE(desk_.notices().join(u' ').contains(QStringLiteral("This is the next case")));
  EXPECT_EQ(openSheet(desk_.session(), next).state, SheetState::kDraft);

  desk_.press(Qt::Key_Down);
  desk_.finish(2);
  EXPECT_EQ(openSheet(desk_.session(), next).state, SheetState::kSubmitted);
}

}  // namespace
}  // namespace torsio::gui
