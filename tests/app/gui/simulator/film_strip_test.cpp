// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "app/gui/simulator/replay_bar.h"
#include "sim/core/angle.h"
#include "sim/record/sample_codec.h"

namespace torsio::gui {
namespace {

std::vector<double> roundedDegrees(const std::vector<double>& angles_rad) {
  std::vector<double> rounded;
  for (const double angle_rad : angles_rad) {
    rounded.push_back(std::round(degrees(angle_rad) * 1e6) / 1e6);
  }
  return rounded;
}

TEST(FilmStrip, StepsByThirtyDegreesAndEndsAtTheLastAngle) {
  EXPECT_EQ(roundedDegrees(stripAngles_rad(radians(90.0))), (std::vector<double>{0, 30, 60, 90}));
  EXPECT_EQ(roundedDegrees(stripAngles_rad(radians(-70.0))), (std::vector<double>{0, -30, -60, -70}));
  EXPECT_EQ(stripAngles_rad(0.0).size(), 1U);
}

TEST(FilmStrip, CaptionsHaveNoNeedlessDigits) {
  EXPECT_EQ(angleCaption(-0.0), QStringLiteral("0\u00b0"));
  EXPECT_EQ(angleCaption(radians(60.0)), QStringLiteral("60\u00b0"));
  EXPECT_EQ(angleCaption(radians(22.5)), QStringLiteral("22.5\u00b0"));
}

TEST(FilmStrip, FindsWhenARecordingFirstReachesEachAngle) {
  // Up to 60 degrees within 2 s, then 3 s back to 0: 30 degrees are passed twice.
  Trial trial;
  trial.header.trialId = "strip";
  std::vector<Sample> samples;
  for (std::int64_t tick = 0; tick < 5000; ++tick) {
    Sample sample;
    sample.tick = tick;
    sample.device.time_us = 1000 * tick;
    sample.response.angle_rad = kRadiansPerDegree * (tick <= 2000 ? 0.03 * static_cast<double>(tick)
                                                                  : 0.02 * static_cast<double>(5000 - tick));
    samples.push_back(sample);
  }
  for (std::int64_t index = 0; index * kSamplesPerChunk < 5000; ++index) {
    const auto from = samples.begin() + index * kSamplesPerChunk;
    const std::vector<Sample> second(from, from + kSamplesPerChunk);
    trial.chunks.push_back(encodeChunk(index, second));
  }
  trial.summary.samples = 5000;

  const std::vector<StripMoment> moments = stripMoments(TrialPlayback(trial));

  ASSERT_EQ(moments.size(), 3U);
  EXPECT_EQ(moments[0].position_us, 0);
  EXPECT_NEAR(static_cast<double>(moments[1].position_us), 1e6, 2000.0);  // a tick either way
  EXPECT_NEAR(static_cast<double>(moments[2].position_us), 2e6, 2000.0);
}

TEST(FilmStrip, PutsFourInARowAndLeavesTheRestOfTheLastRowWhite) {
  QImage red(100, 50, QImage::Format_RGB32);
  red.fill(Qt::red);
  const std::vector<StripFrame> frames(5, StripFrame{QString(), red});

  const QImage strip = filmStrip(stripRows(frames));

  ASSERT_FALSE(strip.isNull());
  const int cell = strip.width() / 4;
  const int row = strip.height() / 2;
  for (int column = 0; column < 4; ++column) {
    EXPECT_EQ(strip.pixelColor(column * cell + cell / 2, row / 3), QColor(Qt::red));
  }
  EXPECT_EQ(strip.pixelColor(cell / 2, row + row / 3), QColor(Qt::red));
  EXPECT_EQ(strip.pixelColor(cell + cell / 2, row + row / 3), QColor(Qt::white));
}

TEST(FilmStrip, MakesNoPictureWithoutFrames) {
  EXPECT_TRUE(filmStrip(stripRows({})).isNull());
  EXPECT_TRUE(filmStrip(stripRows({StripFrame{}})).isNull());
}

}  // namespace
}  // namespace torsio::gui
