// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/detorsion_story.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "assessment/attempt/recorded_detorsion.h"
#include "assessment/catalogue/quantity.h"
#include "sim/core/clock.h"
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

namespace {

using Kind = UntwistingFinding::Kind;

constexpr double kVisibleTurn_rad = 0.02;  ///< about a degree: smaller turns are not mentioned
constexpr double kLethalDose = 1.0;

/// Formats "0:12 h".
Text tissueTime(double tissue_s) {
  const auto minutes = static_cast<std::int64_t>(tissue_s / 60.0);
  const std::string rest = std::to_string(minutes % 60);
  return Text::tr("%1:%2 h", minutes / 60, (rest.size() < 2 ? "0" : "") + rest);
}

/// Collects the findings of one course.
class Finder {
 public:
  explicit Finder(const DetorsionStory& story) : story_(story) {}

  std::vector<UntwistingFinding> run() {
    findTurning();
    findBlood();
    findGrips();
    findStages();
    if (const auto over_s = measure(Quantity::kOverloadTime); over_s && *over_s > 0.0) {
      add(Kind::kOverload, *over_s);
    }
    findMishaps();
    if (const auto relapse = measure(Quantity::kRelapse); relapse && *relapse != 0.0) {
      add(Kind::kRelapsed, 0.0, 0.0, firstOf(DetorsionMoment::kRelapse));
    }
    if (const auto residual = measure(Quantity::kResidual)) {
      add(Kind::kResidual, *residual);
    }
    if (!story_.mishapsKnown) {
      add(Kind::kMishapsUnknown);
    }
    return std::move(found_);
  }

 private:
  [[nodiscard]] std::optional<double> measure(Quantity quantity) const {
    return story_.metrics.valueOf(quantity);
  }
  void add(Kind kind, double value = 0.0, double other = 0.0, std::optional<double> at_s = {}) {
    found_.push_back({kind, value, other, at_s});
  }
  [[nodiscard]] std::optional<double> firstOf(DetorsionMoment what) const {
    const auto first =
        std::find_if(story_.events.begin(), story_.events.end(),
                     [what](const DetorsionStory::Event& event) { return event.what == what; });
    return first == story_.events.end() ? std::nullopt : std::optional(first->at_s);
  }

  void findTurning() {
    if (const auto right = measure(Quantity::kFirstDirection)) {
      add(*right != 0.0 ? Kind::kFirstTurnRight : Kind::kFirstTurnWrong, 0.0, 0.0,
          firstOf(DetorsionMoment::kGrip));
    }
    if (const auto wrong = measure(Quantity::kWrongWay); wrong && *wrong > kVisibleTurn_rad) {
      add(Kind::kTwistedFurther, *wrong);
    }
  }

  void findBlood() {
    if (const auto back_s = measure(Quantity::kTimeToFlow); !back_s) {
      add(Kind::kNoFlow);
    } else if (*back_s <= 0.0) {
      add(Kind::kFlowFromStart);
    } else {
      add(Kind::kFlowBack, *back_s, *back_s * story_.timeScale, *back_s);
    }
    if (const auto dose = measure(Quantity::kDose)) {
      add(*dose >= kLethalDose ? Kind::kLost : Kind::kSurvives, *dose);
    }
  }

  void findGrips() {
    const auto regrips = measure(Quantity::kRegrips);
    const auto least = measure(Quantity::kLeastRegrips);
    if (regrips && least) {
      add(Kind::kRegrips, *regrips, *least);
    }
    if (const auto slip = measure(Quantity::kSlipBack); slip && *slip > kVisibleTurn_rad) {
      add(Kind::kSlipBack, *slip);
    }
  }

  void findStages() {
    const auto stage = measure(Quantity::kLongestStage);
    if (const auto staged = measure(Quantity::kInStages); staged && stage) {
      add(*staged != 0.0 ? Kind::kInStages : Kind::kTooFast, *stage);
    }
  }

  void findMishaps() {
    constexpr std::pair<DetorsionMoment, Kind> kMishaps[] = {{DetorsionMoment::kTear, Kind::kTears},
                                                             {DetorsionMoment::kBruise, Kind::kBruises},
                                                             {DetorsionMoment::kSlip, Kind::kSlips}};
    for (const auto& [moment, kind] : kMishaps) {
      const auto times = std::count_if(story_.events.begin(), story_.events.end(),
                                       [what = moment](const auto& event) { return event.what == what; });
      if (times > 0) {
        add(kind, static_cast<double>(times), 0.0, firstOf(moment));
      }
    }
  }

  const DetorsionStory& story_;
  std::vector<UntwistingFinding> found_;
};

}  // namespace

Text UntwistingFinding::text() const {
  const auto shown = [this](Quantity quantity) { return shownValue(quantity, value); };
  const auto number = static_cast<std::int64_t>(value);
  switch (kind) {
    case Kind::kFirstTurnRight:
      return Text::tr("The first turn went the right way.");
    case Kind::kFirstTurnWrong:
      return Text::tr("The first turn went the wrong way.");
    case Kind::kTwistedFurther:
      return Text::tr("The organ was twisted %1 further than at the start.", shown(Quantity::kWrongWay));
    case Kind::kFlowFromStart:
      return Text::tr("Blood flow was sufficient from the start.");
    case Kind::kFlowBack:
      return Text::tr("Blood flow returned after %1; %2 for the tissue.", clockTenthsText(value),
                      tissueTime(other));
    case Kind::kNoFlow:
      return Text::tr("Blood flow did not return in this run.");
    case Kind::kLost:
      return Text::tr("The ischaemic dose reached %1: from 1 the tissue is lost.", shown(Quantity::kDose));
    case Kind::kSurvives:
      return Text::tr("The ischaemic dose reached %1: the tissue survives; at 1 it would be lost.",
                      shown(Quantity::kDose));
    case Kind::kRegrips:
      return Text::tr("Re-grips: %1; a hand with the usual range of motion needs at least %2.", number,
                      static_cast<std::int64_t>(other));
    case Kind::kSlipBack:
      return Text::tr("%1 were lost again between grips: set the clip before releasing.",
                      shown(Quantity::kSlipBack));
    case Kind::kInStages:
      return Text::tr("Untwisted in stages: at most %1 without a rest.", shown(Quantity::kLongestStage));
    case Kind::kTooFast:
      return Text::tr("Turned back by %1 without a rest: let blood flow return in stages.",
                      shown(Quantity::kLongestStage));
    case Kind::kOverload:
      return Text::tr("For %1, jaw pressure or force exceeded what the ischaemic wall bears.",
                      clockTenthsText(value));
    case Kind::kTears:
      return Text::tr("Tears in the wall: %1. A torn organ does not count as untwisted.", number);
    case Kind::kBruises:
      return Text::tr(
          "Bruises from the jaw: %1. Grip more gently: ischaemic tissue bears only half the pressure.",
          number);
    case Kind::kSlips:
      return Text::tr("Slips of the instrument: %1.", number);
    case Kind::kRelapsed:
      return Text::tr("The organ twisted again after it had been untwisted.");
    case Kind::kResidual:
      return Text::tr("Remaining twist: %1.", shown(Quantity::kResidual));
    case Kind::kMishapsUnknown:
      break;
  }
  return Text::tr(
      "Bruises, tears, slips and relapses are not marked: the organ of this run is not on this machine.");
}

std::vector<UntwistingFinding> findingsOf(const DetorsionStory& story) {
  return Finder(story).run();
}

}  // namespace torsio
