// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/untwisting_findings.h"

#include <algorithm>

#include "assessment/catalogue/quantity.h"
#include "sim/core/clock.h"

namespace torsio {

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
