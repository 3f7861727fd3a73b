// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/detorsion_story.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/recording/recorded_run.h"
#include "app/services/training/next_steps.h"
#include "app/services/training/trend.h"
#include "assessment/attempt/recorded_twists.h"
#include "assessment/catalogue/quantity.h"
#include "sim/core/angle.h"
#include "sim/record/sample_codec.h"
#include "tests/app/support/training_centre.h"
#include "tests/sim/servo/bar_scene.h"

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

DetorsionStory storyWith(std::initializer_list<std::pair<Quantity, double>> measures) {
  DetorsionStory story;
  story.mishapsKnown = true;
  for (const auto& [quantity, value] : measures) {
    story.metrics.set(quantity, value);
  }
  return story;
}

std::string toldOf(const DetorsionStory& story) {
  std::string all;
  for (const UntwistingFinding& finding : findingsOf(story)) {
    all += finding.text().str() + "\n";
  }
  return all;
}

bool isSaid(const DetorsionStory& story, const std::string& words) {
  return toldOf(story).find(words) != std::string::npos;
}

TEST(UntwistingFindings, DescribeTheMeasuresInSentences) {
  const DetorsionStory story = storyWith({{Quantity::kFirstDirection, 0.0}, {Quantity::kDose, 1.2}});

  EXPECT_EQ(toldOf(story),
            "The first turn went the wrong way.\n"
            "Blood flow did not return in this run.\n"
            "The ischaemic dose reached 1.20: from 1 the tissue is lost.\n");
}

TEST(UntwistingFindings, FormatTimesInMinutesAndSeconds) {
  const DetorsionStory story = storyWith({{Quantity::kTimeToFlow, 65.12}, {Quantity::kOverloadTime, 5.1}});

  // 65.12 s of the hand are 65 minutes of the tissue.
  EXPECT_TRUE(isSaid(story, "Blood flow returned after 1:05.1; 1:05 h for the tissue.")) << toldOf(story);
  EXPECT_TRUE(isSaid(story, "For 0:05.1, jaw pressure")) << toldOf(story);
  EXPECT_EQ(findingsOf(story).front().at_s, 65.12);
}

TEST(UntwistingFindings, DoNotReportThatFlowReturnedIfItNeverStopped) {
  const DetorsionStory story = storyWith({{Quantity::kTimeToFlow, 0.0}});

  EXPECT_TRUE(isSaid(story, "Blood flow was sufficient from the start."));
  EXPECT_FALSE(isSaid(story, "returned"));
}

TEST(UntwistingFindings, OmitInvisibleTurns) {
  EXPECT_FALSE(isSaid(storyWith({{Quantity::kWrongWay, 0.01}, {Quantity::kSlipBack, 0.01}}), "\u00b0"));
  const DetorsionStory seen =
      storyWith({{Quantity::kWrongWay, radians(30.0)}, {Quantity::kSlipBack, radians(12.0)}});
  EXPECT_TRUE(isSaid(seen, "The organ was twisted 30\u00b0 further than at the start."));
  EXPECT_TRUE(isSaid(seen, "12\u00b0 were lost again between grips"));
}

TEST(UntwistingFindings, CountMishapsAndSayIfTheyAreUnknown) {
  DetorsionStory known = storyWith({});
  known.events = {
      {1.0, DetorsionMoment::kBruise}, {2.0, DetorsionMoment::kTear}, {3.0, DetorsionMoment::kBruise}};
  DetorsionStory unknown;

  EXPECT_TRUE(isSaid(known, "Bruises from the jaw: 2."));
  EXPECT_TRUE(isSaid(known, "Tears in the wall: 1."));
  EXPECT_FALSE(isSaid(known, "Slips of"));
  EXPECT_FALSE(isSaid(known, "not marked"));
  EXPECT_TRUE(isSaid(unknown, "not marked: the organ of this run is not on this machine"));
  const std::vector<UntwistingFinding> found = findingsOf(known);
  const auto tears = std::find_if(found.begin(), found.end(), [](const UntwistingFinding& finding) {
    return finding.kind == UntwistingFinding::Kind::kTears;
  });
  EXPECT_EQ(tears->at_s, 2.0);
}

// Progress of a trainee in untwisting: metrics, units, and what passes.

TrainingCentre::Setup undone(std::vector<MasteryCriterion> rules) {
  TrainingCentre::Setup setup;
  setup.sceneId = "testis";
  setup.patternId = "detorse";
  setup.mastery = std::move(rules);
  return setup;
}

const MasteryCriterion kUndone{.metric = idOf(Quantity::kUntwisted), .threshold = 1.0, .unit = "1"};
const MasteryCriterion kSmallDose{
    .metric = idOf(Quantity::kDose), .comparison = "at_most", .threshold = 0.9, .unit = "1"};

TEST(UntwistingTrend, FollowsTheDoseAndPassesByAllRulesOfTheModule) {
  TrainingCentre centre(undone({kUndone, kSmallDose}));
  centre.untwist("first", "practice");
  centre.untwist("first", "practice", 1);  // one turn of the hand is left

  const Trend way = trend(centre.session(), centre.person(), centre.module("first"));

  EXPECT_TRUE(way.untwisting);
  EXPECT_EQ(way.quantity, Quantity::kDose);  // the first rule that has a scale
  EXPECT_TRUE(way.lowerIsBetter);
  EXPECT_EQ(way.threshold, 0.9);
  ASSERT_EQ(way.points.size(), 2U);
  ASSERT_TRUE(way.points[0].value);
  ASSERT_TRUE(way.points[1].value);
  EXPECT_LT(*way.points[1].value, 0.9);  // the dose alone would pass
  EXPECT_EQ(way.points[0].outcome, RunOutcome::kPassed);
  EXPECT_EQ(way.points[1].outcome, RunOutcome::kNotPassed);
}

TEST(UntwistingTrend, ShowsOnlySuccessIfNoRuleHasAScale) {
  TrainingCentre centre(undone({kUndone}));
  centre.untwist("first", "practice", 1);

  const Trend way = trend(centre.session(), centre.person(), centre.module("first"));
  const Trend residual =
      trend(centre.session(), centre.person(), centre.module("first"), Quantity::kResidual);

  EXPECT_EQ(way.quantity, Quantity::kUntwisted);
  EXPECT_FALSE(way.lowerIsBetter);
  ASSERT_TRUE(way.distance);
  EXPECT_EQ(*way.distance, 1.0);  // wanted 1, was 0
  EXPECT_TRUE(way.curve.empty());
  EXPECT_FALSE(way.noCurveReason.empty());
  ASSERT_TRUE(residual.points.at(0).value);
  EXPECT_GT(*residual.points[0].value, 1.57);  // omitted: at least 360 degrees / 3 turns; some slips back
}

TEST(UntwistingTrend, KnowsBeforeTheFirstAttemptThatTheModuleIsAboutUntwisting) {
  TrainingCentre centre(undone({kUndone}));

  const Trend way = trend(centre.session(), centre.person(), centre.module("first"));

  EXPECT_TRUE(way.untwisting);
  EXPECT_TRUE(way.points.empty());
}

TEST(UntwistingTrend, MastersAModuleByItsRules) {
  TrainingCentre centre(undone({kUndone, kSmallDose}));
  centre.untwist("first", "practice", 1);
  EXPECT_EQ(nextSteps(centre.session(), centre.person()).modules.at(0).state, StepState::kOpen);

  centre.untwist("first", "practice");

  EXPECT_EQ(nextSteps(centre.session(), centre.person()).modules.at(0).state, StepState::kMastered);
}

}  // namespace
}  // namespace torsio
