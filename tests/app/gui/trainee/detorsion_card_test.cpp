// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/detorsion_card.h"

#include <set>

#include <gtest/gtest.h>

#include "app/services/training/detorsion_story.h"
#include "tests/app/gui/support/visible_texts.h"

namespace torsio::gui {
namespace {

TEST(DetorsionCard, ListsTheTimeSpentLongestFirst) {
  DetorsionStory story;
  story.spent_s = {2.0, 6.0, 0.0, 0.0, 2.0};  // searching, turning, clip, checking, waiting: 10 s in total

  const QStringList text = DetorsionCard::secondsText(story);

  ASSERT_EQ(text.size(), 3);
  EXPECT_EQ(text[0], QStringLiteral("Turning in the jaw: 0:06.0 (60 %)"));
  EXPECT_EQ(text[1], QStringLiteral("Searching, not holding: 0:02.0 (20 %)"));
  EXPECT_EQ(text[2], QStringLiteral("Waiting with hands off: 0:02.0 (20 %)"));
}

/// Ten seconds in which an organ is untwisted; its content has a pressure of 12 mmHg.
DetorsionStory tenSeconds() {
  DetorsionStory story;
  for (int i = 0; i <= 10; ++i) {
    story.time_s.push_back(i);
    story.angle_rad.push_back(3.0 - 0.3 * i);
    story.flow.push_back(0.1 * i);
    story.dose.push_back(0.02 * i);
    story.pressure_Pa.push_back(12.0 * kPascalsPerMmHg);
  }
  story.mishapsKnown = true;
  return story;
}

/// The plot of a story, wide enough for every symbol.
class PlotOf {
 public:
  explicit PlotOf(const DetorsionStory& story) {
    plot.resize(1000, 420);
    plot.setStory(story);
  }
  [[nodiscard]] QString painted() { return paintedWordsOf(plot).join(QLatin1Char(' ')); }

  DetorsionPlot plot;
};

TEST(DetorsionPlot, MarksMishapsWithTheirOwnSymbolAndALegend) {
  DetorsionStory story = tenSeconds();
  story.events = {{1.0, DetorsionMoment::kGrip},
                  {2.0, DetorsionMoment::kBruise},
                  {2.0, DetorsionMoment::kTear},
                  {5.0, DetorsionMoment::kSlip},
                  {5.5, DetorsionMoment::kRelapse}};
  PlotOf drawn(story);

  const QString painted = drawn.painted();

  for (const DetorsionMoment what : {DetorsionMoment::kBruise, DetorsionMoment::kTear, DetorsionMoment::kSlip,
                                     DetorsionMoment::kRelapse}) {
    // On the time line and in the legend.
    EXPECT_GE(painted.count(DetorsionPlot::momentSign(what)), 2) << static_cast<int>(what);
    EXPECT_TRUE(painted.contains(DetorsionPlot::momentName(what))) << static_cast<int>(what);
  }
  EXPECT_FALSE(painted.contains(QStringLiteral("gas out")));
}

/// Counts the pixels of `colour` in a picture below `top`.
int pixelsOf(const QImage& picture, const QColor& colour, int top) {
  int found = 0;
  for (int y = top; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      found += picture.pixelColor(x, y) == colour ? 1 : 0;
    }
  }
  return found;
}

TEST(DetorsionPlot, SymbolsInTheLegendHaveTheColoursOfTheTimeLine) {
  DetorsionStory story = tenSeconds();
  const QColor caution = theme(ThemeKind::kLight).caution;
  story.events = {{1.0, DetorsionMoment::kGrip}};
  constexpr int kBelowLanes = 420 - 34;
  EXPECT_EQ(pixelsOf(PlotOf(story).plot.grab().toImage(), caution, kBelowLanes), 0);

  story.events.push_back({2.0, DetorsionMoment::kBruise});
  EXPECT_GT(pixelsOf(PlotOf(story).plot.grab().toImage(), caution, kBelowLanes), 5);
}

TEST(DetorsionPlot, UsesADifferentSymbolForEachInstant) {
  std::set<QString> signs;
  std::set<QString> names;
  for (int what = 0; what <= static_cast<int>(DetorsionMoment::kRelapse); ++what) {
    signs.insert(DetorsionPlot::momentSign(static_cast<DetorsionMoment>(what)));
    names.insert(DetorsionPlot::momentName(static_cast<DetorsionMoment>(what)));
  }

  EXPECT_EQ(signs.size(), 11U);
  EXPECT_EQ(names.size(), 11U);
  EXPECT_EQ(signs.count(QString()) + names.count(QString()), 0U);
}

TEST(DetorsionPlot, ShowsTheInstantAtThePointerWithBothTimes) {
  DetorsionStory story = tenSeconds();
  story.events = {{5.0, DetorsionMoment::kTear}};
  PlotOf drawn(story);

  // The time axis starts 52 pixels from the left and ends 16 from the right: 5 of 10 s are at 52 + 932 / 2.
  const QString there = drawn.plot.tipAt(518.0);
  const QString beside = drawn.plot.tipAt(530.0);

  EXPECT_EQ(there, QStringLiteral("tear at 0:05.0 (0:05 h of the tissue)"));
  EXPECT_TRUE(beside.isEmpty());
  EXPECT_TRUE(drawn.plot.accessibleDescription().contains(there));
}

TEST(DetorsionPlot, HasNeitherSymbolsNorLegendForARunWithoutInstants) {
  PlotOf drawn(tenSeconds());

  const QString painted = drawn.painted();

  for (int what = 0; what <= static_cast<int>(DetorsionMoment::kRelapse); ++what) {
    EXPECT_FALSE(painted.contains(DetorsionPlot::momentName(static_cast<DetorsionMoment>(what)))) << what;
  }
  EXPECT_FALSE(painted.contains(DetorsionPlot::momentSign(DetorsionMoment::kBruise)));
}

TEST(DetorsionPlot, DrawsThePressureOfAnOrganWhoseContentHasOne) {
  DetorsionStory solid = tenSeconds();
  solid.pressure_Pa.assign(solid.pressure_Pa.size(), 0.0);
  PlotOf hollow(tenSeconds());
  PlotOf cord(solid);

  EXPECT_TRUE(hollow.painted().contains(QStringLiteral("Pressure of the content in mmHg")));
  EXPECT_TRUE(hollow.painted().contains(QStringLiteral("15")));  // 12 mmHg on a scale with steps of 5
  EXPECT_TRUE(
      hollow.plot.accessibleDescription().contains(QStringLiteral("Pressure from 12.0 to 12.0 mmHg.")));
  EXPECT_FALSE(cord.painted().contains(QStringLiteral("Pressure")));
  EXPECT_FALSE(cord.plot.accessibleDescription().contains(QStringLiteral("Pressure")));
}

TEST(DetorsionCard, ShowsTheFindingsOfTheStoryInTheirWords) {
  DetorsionStory story = tenSeconds();
  story.events = {{1.0, DetorsionMoment::kBruise}};

  const QStringList text = DetorsionCard::findings(story);

  ASSERT_EQ(static_cast<std::size_t>(text.size()), findingsOf(story).size());
  EXPECT_TRUE(text.join(QLatin1Char('\n')).contains(QStringLiteral("Bruises from the jaw: 1.")));
}

}  // namespace
}  // namespace torsio::gui
