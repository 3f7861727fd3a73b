// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/detorsion_story.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/recording/pipeline.h"
#include "assessment/attempt/recorded_twists.h"
#include "sim/record/sample_codec.h"
#include "tests/sim/servo/hollow_bar.h"

namespace torsio {
namespace {

constexpr std::int64_t kTenth_us = 100'000;

/// One second per stage, ten samples each: free and twisted, gripped, held by the clip alone, free and
/// untwisted.
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

TEST(DetorsionStory, EverySecondCountsForWhatHeldTheOrgan) {
  const std::vector<Sample> samples = fourSeconds();

  const DetorsionStory story = detorsionStory(samples, tenths(samples.size()), {}, kNoMetrics);

  EXPECT_NEAR(spent(story, DetorsionDoing::kSearching), 1.0, 1e-9);
  EXPECT_NEAR(spent(story, DetorsionDoing::kTurning), 1.0, 1e-9);
  EXPECT_NEAR(spent(story, DetorsionDoing::kClipped), 1.0, 1e-9);
  EXPECT_NEAR(spent(story, DetorsionDoing::kWaiting), 1.0, 1e-9);
}

TEST(DetorsionStory, ACheckIsCountedInsteadOfOtherActivities) {
  std::vector<Sample> samples = fourSeconds();
  samples[0].command = {.kind = ServoCommand::Kind::kCheckFlow, .value = 1.0};  // a visual check: 1 s

  const DetorsionStory story = detorsionStory(samples, tenths(samples.size()), {}, kNoMetrics);

  EXPECT_NEAR(spent(story, DetorsionDoing::kChecking), 1.0, 1e-9);
  EXPECT_NEAR(spent(story, DetorsionDoing::kSearching), 0.0, 1e-9);
}

TEST(DetorsionStory, ListsGripsAndClipsInOrder) {
  const std::vector<Sample> samples = fourSeconds();

  const DetorsionStory story = detorsionStory(samples, tenths(samples.size()), {}, kNoMetrics);

  ASSERT_EQ(story.events.size(), 4U);
  EXPECT_EQ(story.events[0].what, DetorsionMoment::kGrip);
  EXPECT_NEAR(story.events[0].at_s, 1.0, 1e-9);
  EXPECT_EQ(story.events[1].what, DetorsionMoment::kClipOn);
  EXPECT_EQ(story.events[2].what, DetorsionMoment::kLetGo);
  EXPECT_EQ(story.events[3].what, DetorsionMoment::kClipOff);
}

TEST(DetorsionStory, MarksTheClipSetWithTheSecondButtonAtTheOrgan) {
  std::vector<Sample> samples = fourSeconds();
  samples[19].command = {};
  samples[30].command = {};
  samples[5].device.buttons = kButtonSecond;   // away from the organ
  samples[15].device.buttons = kButtonSecond;  // while the jaw holds

  const DetorsionStory story = detorsionStory(samples, tenths(samples.size()), {}, kNoMetrics);

  ASSERT_EQ(story.events.size(), 3U);
  EXPECT_EQ(story.events[0].what, DetorsionMoment::kGrip);
  EXPECT_EQ(story.events[1].what, DetorsionMoment::kClipOn);
  EXPECT_NEAR(story.events[1].at_s, 1.5, 1e-9);
  EXPECT_EQ(story.events[2].what, DetorsionMoment::kLetGo);
}

/// A tube under a jaw of `jawArea_m2`, untwisted by the scripted expert, and its recording.
struct Undone {
  explicit Undone(double jawArea_m2)
      : scene([jawArea_m2] {
          Detorsion tube = twistedTube();
          tube.limits.jawArea_m2 = jawArea_m2;
          return hollowScene(tube);
        }()),
        trial(expertRun(scene, 0.0)),
        samples(decodeTrial(trial)) {}

  [[nodiscard]] DetorsionStory story() const {
    const std::vector<std::int64_t> times_us = sampleTimes(trial.header, samples).us;
    DetorsionStory told = detorsionStory(samples, times_us, {}, kNoMetrics);
    addMishaps(scene, trial.header, samples, times_us, told);
    return told;
  }

  Scene scene;
  Trial trial;
  std::vector<Sample> samples;
};

std::vector<double> timesOf(const DetorsionStory& story, DetorsionMoment what) {
  std::vector<double> times_s;
  for (const DetorsionStory::Event& event : story.events) {
    if (event.what == what) {
      times_s.push_back(event.at_s);
    }
  }
  return times_s;
}

TEST(DetorsionMishaps, DoNotOccurWithACarefulHand) {
  const Undone careful(20e-6);  // 180 kPa if held with care

  const DetorsionStory story = careful.story();

  EXPECT_TRUE(story.mishapsKnown);
  EXPECT_TRUE(std::none_of(story.events.begin(), story.events.end(),
                           [](const DetorsionStory::Event& event) { return isMishap(event.what); }));
  EXPECT_EQ(timesOf(story, DetorsionMoment::kGrip).size(), 2U);  // 270 degrees, 155 per hand turn
}

TEST(DetorsionMishaps, ABruiseIsMarkedThreeTenthsOfASecondAfterEachHardGrip) {
  const Undone hard(8e-6);  // at least 6 N x 0.6 / 8 mm2 = 450 kPa; the wall tolerates 330 for 0.3 s

  const DetorsionStory story = hard.story();

  const std::vector<double> grips_s = timesOf(story, DetorsionMoment::kGrip);
  const std::vector<double> bruises_s = timesOf(story, DetorsionMoment::kBruise);
  ASSERT_EQ(bruises_s.size(), grips_s.size());
  for (std::size_t i = 0; i < grips_s.size(); ++i) {
    EXPECT_NEAR(bruises_s[i] - grips_s[i], 0.3, 0.2) << i;  // while the jaw is closing
  }
  EXPECT_TRUE(timesOf(story, DetorsionMoment::kSlip).empty());
  EXPECT_TRUE(std::is_sorted(story.events.begin(), story.events.end(),
                             [](const auto& a, const auto& b) { return a.at_s < b.at_s; }));
}

TEST(DetorsionMishaps, ATearIsMarkedIfTheJawPressesTwiceAsHard) {
  const Undone crushed(4e-6);  // 900 kPa; the wall tears from 660

  const DetorsionStory story = crushed.story();

  EXPECT_FALSE(timesOf(story, DetorsionMoment::kTear).empty());
}

TEST(DetorsionMishaps, AnOrganThatNothingHoldsBetweenTwoGripsTurnsBack) {
  Undone unclipped(20e-6);
  for (Sample& sample : unclipped.samples) {
    sample.device.buttons &= ~static_cast<std::uint32_t>(kButtonSecond);
    sample.command = sample.command.kind == ServoCommand::Kind::kHoldOrgan ? ServoCommand{} : sample.command;
  }

  const DetorsionStory story = unclipped.story();

  // The first grip ends beyond 90 degrees, from where the organ relapses at once.
  const std::vector<double> letGo_s = timesOf(story, DetorsionMoment::kLetGo);
  const std::vector<double> back_s = timesOf(story, DetorsionMoment::kRelapse);
  ASSERT_FALSE(letGo_s.empty());
  ASSERT_FALSE(back_s.empty());
  EXPECT_NEAR(back_s.front(), letGo_s.front(), 0.005);
}

TEST(DetorsionMishaps, AHandThatIsPulledAlongTheOrganSlipsOff) {
  Undone pulled(20e-6);
  const auto grip = std::find_if(pulled.samples.begin(), pulled.samples.end(), [](const Sample& sample) {
    return sample.phase == ExercisePhase::kTwisting;
  });
  ASSERT_NE(grip, pulled.samples.end());
  for (auto at = grip + 100; at != grip + 200; ++at) {
    at->device.position[2] +=
        static_cast<std::int32_t>(0.03 / kPositionStep_m);  // 30 mm; it slips from 20 on
  }

  const DetorsionStory story = pulled.story();

  const double grip_s = timesOf(story, DetorsionMoment::kGrip).front();
  ASSERT_FALSE(timesOf(story, DetorsionMoment::kSlip).empty());
  EXPECT_NEAR(timesOf(story, DetorsionMoment::kSlip).front(), grip_s + 0.1, 0.002);
}

}  // namespace
}  // namespace torsio
