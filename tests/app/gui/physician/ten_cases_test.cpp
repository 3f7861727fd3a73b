// SPDX-License-Identifier: GPL-3.0-or-later
// Ten cases in ten minutes, by keyboard alone: every key press is simulated and counted. Its time is
// estimated by the keystroke-level model (Card, Moran and Newell 1980): 1.35 s to decide, 0.28 s to press.
#include <vector>

#include <QRegularExpression>
#include <gtest/gtest.h>

#include "app/gui/physician/case_page.h"
#include "app/gui/physician/queue_page.h"
#include "app/gui/physician/replay_panel.h"
#include "app/gui/widgets/child.h"
#include "app/services/review/case_sheet.h"
#include "sim/core/time_units.h"
#include "tests/app/gui/physician/desk_of.h"
#include "tests/app/gui/support/visible_texts.h"
#include "tests/app/support/review_centre.h"

namespace torsio::gui {
namespace {

using torsio::testing::ReviewCentre;

constexpr int kCases = 10;
constexpr double kDecide_s = 1.35;
constexpr double kPress_s = 0.28;
constexpr double kRecording_s = 40.0;  // ten twists of a practised hand; each recording is watched completely
constexpr double kTenMinutes_s = 600.0;

TEST(QueuePage, ShowsHowManyCasesFitIntoTenMinutesAndThanksTheRater) {
  ReviewCentre centre({.raters = 1, .trainees = 5});
  DeskOf desk(centre, 0);
  const std::vector<AssignmentId> cases = centre.cases(0);
  for (std::size_t i = 0; i < 3; ++i) {
    OpenedSheet opened = openSheet(desk.session(), cases[i]);
    opened.watched.played(0, opened.watched.length_us(), 1.0);
    opened.watched.worked(4 * kMinute_us);
    submitSheet(desk.session(), cases[i], torsio::testing::reviewSheet(5, 5, 5), opened.watched);
  }

  const QString said = paintedWordsOf(desk.open<QueuePage>()).join(u' ');

  EXPECT_TRUE(said.contains(QStringLiteral("3 submitted so far, in 12 min of your time: thank you")))
      << said.toStdString();
  EXPECT_TRUE(said.contains(
      QRegularExpression(QStringLiteral("2 case\\S* fit into ten minutes, at your own pace so far"))))
      << said.toStdString();
}

TEST(TenCases, AreScoredByKeyboardAloneInTenMinutes) {
  ReviewCentre centre({.raters = 1, .trainees = kCases, .trial_s = 1.0});
  DeskOf desk(centre, 0);
  int keys = 0;
  const auto press = [&](Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    ++keys;
    desk.press(key, modifiers);
  };
  desk.open<QueuePage>();
  press(Qt::Key_Return);  // the button to continue has focus
  ASSERT_FALSE(desk.wanted().empty());
  const QVariant first = desk.wanted().back().second;
  desk.wanted().clear();
  desk.open<CasePage>(first);

  int done = 0;
  do {
    auto& replay = child<ReplayPanel>(desk.page(), "replay");
    replay.setRealTime(false);
    press(Qt::Key_Space);
    watchAll(replay);
    press(digit(4 + done % 5));
    press(Qt::Key_Down);
    press(digit(6));
    press(Qt::Key_Down);
    press(digit(5));
    press(Qt::Key_Return, Qt::ControlModifier);
    press(Qt::Key_Return, Qt::ControlModifier);
    ++done;
  } while (desk.follow() && done < 2 * kCases);

  EXPECT_EQ(done, kCases);
  EXPECT_TRUE(desk.failures().isEmpty()) << desk.failures().join(u' ').toStdString();
  for (const AssignmentId& id : centre.cases(0)) {
    EXPECT_EQ(openSheet(desk.session(), id).state, SheetState::kSubmitted);
  }
  const double needed_s = keys * (kDecide_s + kPress_s) + kCases * kRecording_s;
  RecordProperty("keys", keys);
  EXPECT_LE(keys, 9 * kCases);
  EXPECT_LE(needed_s, kTenMinutes_s);
}

}  // namespace
}  // namespace torsio::gui
