// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/detorsion_card.h"

#include <gtest/gtest.h>

namespace torsio::gui {
namespace {

TEST(DetorsionCard, SaysWhereTheSecondsWentTheLongestFirst) {
  DetorsionStory story;
  story.spent_s = {2.0, 6.0, 0.0, 0.0, 2.0};  // searching, turning, clip, checking, waiting: 10 s in all

  const QStringList text = DetorsionCard::secondsText(story);

  ASSERT_EQ(text.size(), 3);
  EXPECT_EQ(text[0], QStringLiteral("Turning in the jaw: 6.0 s (60 %)"));
  EXPECT_EQ(text[1], QStringLiteral("Searching, nothing held: 2.0 s (20 %)"));
  EXPECT_EQ(text[2], QStringLiteral("Waiting with hands off: 2.0 s (20 %)"));
}

TEST(DetorsionCard, SaysInSentencesWhatTheMeasuresComeTo) {
  DetorsionStory story;
  story.metrics = {{"detorse.first_direction", Outcome<double>(0.0)}, {"detorse.dose", Outcome<double>(1.2)}};

  const QStringList text = DetorsionCard::verdicts(story);

  EXPECT_TRUE(text.contains(QStringLiteral("The first turn went the wrong way.")));
  EXPECT_TRUE(text.contains(QStringLiteral("Blood did not come back in this run.")));
  EXPECT_TRUE(text.join(QLatin1Char(' ')).contains(QStringLiteral("from 1 on the tissue is lost")));
}

}  // namespace
}  // namespace torsio::gui
