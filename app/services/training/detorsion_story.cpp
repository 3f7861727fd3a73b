// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/detorsion_story.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "assessment/attempt/recorded_detorsion.h"
#include "sim/core/contracts.h"
#include "sim/servo/detorsion.h"
#include "sim/servo/exercise.h"
#include "sim/servo/replay_trial.h"

namespace torsio {

namespace {

constexpr std::size_t kStoryPoints = 4000;

/// Tracks what holds the organ and whether a check is running, tick by tick, like the servo.
class StoryTeller {
 public:
  StoryTeller(DetorsionStory& story, const DetorsionRules& rules) : story_(story), rules_(rules) {}

  void take(const Sample& sample, std::int64_t at_us, double at_s) {
    switches_.obey(sample);
    mark(clipped_, switches_.clipped(), at_s, DetorsionMoment::kClipOn, DetorsionMoment::kClipOff);
    const bool holds = sample.phase == ExercisePhase::kTwisting;
    mark(holds_, holds, at_s, DetorsionMoment::kGrip, DetorsionMoment::kLetGo);
    mark(venting_, switches_.venting() && rules_.vent, at_s, DetorsionMoment::kVentOpen,
         DetorsionMoment::kVentShut);
    setCheck(sample, at_us, at_s);
    angle_rad_ = sample.response.angle_rad;
  }

  [[nodiscard]] DetorsionDoing doing() const noexcept {
    if (ready_us_ >= 0) {
      return DetorsionDoing::kChecking;
    }
    if (holds_) {
      return DetorsionDoing::kTurning;
    }
    if (clipped_) {
      return DetorsionDoing::kClipped;
    }
    return std::abs(angle_rad_) <= rules_.residual_rad ? DetorsionDoing::kWaiting
                                                       : DetorsionDoing::kSearching;
  }

 private:
  void mark(bool& state, bool now, double at_s, DetorsionMoment on, DetorsionMoment off) {
    if (state != now) {
      story_.events.push_back({at_s, now ? on : off});
      state = now;
    }
  }

  void setCheck(const Sample& sample, std::int64_t at_us, double at_s) {
    if (sample.command.kind == ServoCommand::Kind::kCheckFlow && ready_us_ < 0) {
      const auto check = static_cast<FlowCheck>(static_cast<int>(sample.command.value));
      ready_us_ = at_us + flowCheckCost(check).time_us;
      checkedAt_rad_ = sample.response.angle_rad;
      story_.events.push_back({at_s, DetorsionMoment::kCheck});
    }
    const bool broken = holds_ && std::abs(sample.response.angle_rad - checkedAt_rad_) > kCheckTurn_rad;
    if (ready_us_ >= 0 && (broken || at_us >= ready_us_)) {
      ready_us_ = -1;
    }
  }

  DetorsionStory& story_;
  const DetorsionRules& rules_;
  RecordedSwitches switches_;
  double angle_rad_ = 0.0;
  double checkedAt_rad_ = 0.0;
  std::int64_t ready_us_ = -1;
  bool holds_ = false;
  bool clipped_ = false;
  bool venting_ = false;
};

}  // namespace

DetorsionStory detorsionStory(std::span<const Sample> samples, std::span<const std::int64_t> times_us,
                              const DetorsionRules& rules, const Outcome<DetorsionMetrics>& metrics) {
  TORSIO_EXPECTS(times_us.size() == samples.size());
  DetorsionStory story;
  story.timeScale = rules.timeScale;
  story.residual_rad = rules.residual_rad;
  story.enoughFlow = rules.enoughFlow;
  if (metrics) {
    story.metrics = *metrics;
  }
  StoryTeller teller(story, rules);
  const std::size_t stride = std::max<std::size_t>(1, (samples.size() + kStoryPoints - 1) / kStoryPoints);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Sample& sample = samples[i];
    const double at_s = static_cast<double>(times_us[i] - times_us.front()) * 1e-6;
    teller.take(sample, times_us[i], at_s);
    if (i + 1 < samples.size()) {
      story.spent_s[static_cast<std::size_t>(teller.doing())] +=
          static_cast<double>(times_us[i + 1] - times_us[i]) * 1e-6;
    }
    if (i % stride == 0 || i + 1 == samples.size()) {
      story.time_s.push_back(at_s);
      story.angle_rad.push_back(sample.response.angle_rad);
      story.flow.push_back(sample.hollow.flow);
      story.dose.push_back(sample.hollow.dose);
      story.pressure_Pa.push_back(sample.hollow.pressure_Pa);
    }
  }
  return story;
}

void addMishaps(const Scene& scene, const TrialHeader& header, std::span<const Sample> samples,
                std::span<const std::int64_t> times_us, DetorsionStory& story) {
  TORSIO_EXPECTS(times_us.size() == samples.size());
  constexpr std::pair<ExerciseEvent, DetorsionMoment> kMishaps[] = {
      {kEventBruised, DetorsionMoment::kBruise},
      {kEventTorn, DetorsionMoment::kTear},
      {kEventSlipped, DetorsionMoment::kSlip},
      {kEventRelapsing, DetorsionMoment::kRelapse}};
  std::uint32_t wanted = kEventNone;
  for (const auto& [event, mishap] : kMishaps) {
    wanted |= event;
  }
  for (const ExerciseMoment& moment : rerunMoments(scene, header, samples, wanted)) {
    const auto at =
        std::lower_bound(samples.begin(), samples.end(), moment.tick,
                         [](const Sample& sample, std::int64_t tick) { return sample.tick < tick; });
    const std::int64_t at_us = times_us[static_cast<std::size_t>(at - samples.begin())];
    for (const auto& [event, mishap] : kMishaps) {
      if ((moment.events & event) != 0) {
        story.events.push_back({static_cast<double>(at_us - times_us.front()) * 1e-6, mishap});
      }
    }
  }
  std::stable_sort(story.events.begin(), story.events.end(),
                   [](const auto& a, const auto& b) { return a.at_s < b.at_s; });
  story.mishapsKnown = true;
}

}  // namespace torsio
