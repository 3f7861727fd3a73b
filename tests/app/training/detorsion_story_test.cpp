// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/training/detorsion_story.h"

#include <vector>

#include <gtest/gtest.h>

namespace torsio {
namespace {

constexpr std::int64_t kTenth_us = 100'000;

/// A second a stage, ten samples each: free and twisted, gripped, held by the clip alone, free and undone.
std::vector<Sample> fourSeconds() {
  std::vector<Sample> samples;
  for (int i = 0; i <= 40; ++i) {
    Sample sample;
    sample.rules = kRulesOfDetorsion;
    sample.phase = i >= 10 && i < 20 ? ExercisePhase::kTwisting : ExercisePhase::kTracking;
    sample.response.angle_rad = i < 30 ? 3.0 : 0.0;
    samples.push_back(sample);
  }
  samples[19].command = {.kind = ServoCommand::Kind::kHoldOrgan, .value = 1.0};
  samples[30].command = {.kind = ServoCommand::Kind::kHoldOrgan, .value = 0.0};
  return samples;
}

std::vector<std::int64_t> tenths(std::size_t count) {
  std::vector<std::int64_t> times_us;
  for (std::size_t i = 0; i < count; ++i) {
    times_us.push_back(static_cast<std::int64_t>(i) * kTenth_us);
  }
  return times_us;
}

const auto kNoMetrics = Outcome<DetorsionMetrics>::undefined(Text::tr("not measured"));

double spent(const DetorsionStory& story, DetorsionDoing doing) {
  return story.spent_s[static_cast<std::size_t>(doing)];
}

TEST(DetorsionStory, EverySecondGoesToWhatHeldTheOrgan) {
  const std::vector<Sample> samples = fourSeconds();

  const DetorsionStory story = detorsionStory(samples, tenths(samples.size()), {}, kNoMetrics);

  EXPECT_NEAR(spent(story, DetorsionDoing::kSearching), 1.0, 1e-9);
  EXPECT_NEAR(spent(story, DetorsionDoing::kTurning), 1.0, 1e-9);
  EXPECT_NEAR(spent(story, DetorsionDoing::kClipped), 1.0, 1e-9);
  EXPECT_NEAR(spent(story, DetorsionDoing::kWaiting), 1.0, 1e-9);
}

TEST(DetorsionStory, ACheckTakesItsTimeFromWhatElseWasDone) {
  std::vector<Sample> samples = fourSeconds();
  samples[0].command = {.kind = ServoCommand::Kind::kCheckFlow, .value = 1.0};  // a look: 1 s

  const DetorsionStory story = detorsionStory(samples, tenths(samples.size()), {}, kNoMetrics);

  EXPECT_NEAR(spent(story, DetorsionDoing::kChecking), 1.0, 1e-9);
  EXPECT_NEAR(spent(story, DetorsionDoing::kSearching), 0.0, 1e-9);
}

TEST(DetorsionStory, NamesGripsAndClipsInTheirOrder) {
  const std::vector<Sample> samples = fourSeconds();

  const DetorsionStory story = detorsionStory(samples, tenths(samples.size()), {}, kNoMetrics);

  ASSERT_EQ(story.events.size(), 4U);
  EXPECT_EQ(story.events[0].what, DetorsionMoment::kGrip);
  EXPECT_NEAR(story.events[0].at_s, 1.0, 1e-9);
  EXPECT_EQ(story.events[1].what, DetorsionMoment::kClipOn);
  EXPECT_EQ(story.events[2].what, DetorsionMoment::kLetGo);
  EXPECT_EQ(story.events[3].what, DetorsionMoment::kClipOff);
}

}  // namespace
}  // namespace torsio
