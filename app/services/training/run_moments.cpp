// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/training/run_moments.h"

#include <algorithm>
#include <cmath>

#include "assessment/attempt/recorded_loads.h"
#include "assessment/attempt/recorded_twists.h"

namespace torsio {

namespace {

constexpr double kMoment_s = 0.5;  // before and after the time of a maximum

double torqueSize(const Sample& sample) {
  return std::abs(sample.response.torque_Nm);
}

/// Returns the moment around the largest `size` among the samples [first, end), which must not be empty.
template <typename Size>
double timeOfLargest(const Timeline& line, std::size_t first, std::size_t end, Size&& size) {
  const auto begin = line.samples.begin();
  const auto largest =
      std::max_element(begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(end),
                       [&size](const Sample& a, const Sample& b) { return size(a) < size(b); });
  return line.at_s(static_cast<std::size_t>(largest - begin));
}

/// Returns the first sample after the grip before this twist: peaks of force from there on belong to it.
std::size_t sinceBefore(const MeasuredTrial& run, const MeasuredTwist& twist) {
  std::size_t since = 0;
  for (const MeasuredTwist& other : run.twists) {
    if (other.twist.letGo <= twist.twist.first) {
      since = std::max(since, other.twist.letGo);
    }
  }
  return since;
}

Seconds around(double at_s) {
  return {std::max(0.0, at_s - kMoment_s), at_s + kMoment_s};
}

/// Returns the twist that was released farthest from its target; null: each was on target. One that was cut
/// off counts as missed, after all others.
const MeasuredTwist* farthestMiss(const MeasuredTrial& run) {
  const MeasuredTwist* found = nullptr;
  const auto rank = [](const MeasuredTwist& one) {
    return one.twist.completed() ? one.twist.error_rad() : -1.0;
  };
  for (const MeasuredTwist& one : run.twists) {
    if (!one.onTarget && (found == nullptr || rank(one) > rank(*found))) {
      found = &one;
    }
  }
  return found;
}

const MeasuredTwist* shortestHold(const MeasuredTrial& run) {
  const MeasuredTwist* found = nullptr;
  for (const MeasuredTwist* one : run.completed()) {
    if (one->onTarget && (found == nullptr || one->held_s < found->held_s)) {
      found = one;
    }
  }
  return found;
}

/// Returns the longest time without a twist, where another one would have had room.
Seconds longestPause(const MeasuredTrial& run) {
  Seconds longest{};
  double since_s = 0.0;
  const auto end = [&](double now_s) {
    if (now_s - since_s > longest.to_s - longest.from_s) {
      longest = {since_s, now_s};
    }
  };
  for (const MeasuredTwist& one : run.twists) {
    end(one.start_s);
    since_s = one.letGo_s;
  }
  end(run.duration_s());
  return longest;
}

/// Returns the moment of the completed twist whose value is farthest on the wrong side of a requirement.
std::optional<Seconds> worstTwist(const TargetCheck& check, Quantity quantity, const Timeline& line,
                                  const MeasuredTrial& run) {
  const MeasuredTwist* found = nullptr;
  double worst = 0.0;
  for (const MeasuredTwist* one : run.completed()) {
    const std::optional<double> value = one->metrics ? one->metrics->valueOf(quantity) : std::nullopt;
    if (value && (found == nullptr || (check.atLeast ? *value < worst : *value > worst))) {
      found = one;
      worst = *value;
    }
  }
  return found == nullptr ? std::nullopt : std::optional(momentInTwist(quantity, worst, line, run, *found));
}

/// Returns where the largest load of a whole recording is; empty for other quantities.
std::optional<Seconds> momentOfLoad(Quantity quantity, const Timeline& line) {
  const std::size_t all = line.samples.size();
  const bool force = quantity == Quantity::kPeakForce;
  if (all == 0 || (!force && quantity != Quantity::kPeakTorque)) {
    return std::nullopt;
  }
  return around(force ? timeOfLargest(line, 0, all, tissueForce_N) : timeOfLargest(line, 0, all, torqueSize));
}

std::optional<Seconds> momentOfMiss(const TargetCheck& check, Quantity quantity, const Timeline& line,
                                    const MeasuredTrial& run) {
  const auto release = [&](const MeasuredTwist* twist) {
    return twist == nullptr ? std::nullopt : std::optional(around(twist->letGo_s));
  };
  switch (quantity) {
    case Quantity::kOnTarget:
    case Quantity::kTargetsReached:
      return release(farthestMiss(run));
    case Quantity::kCompletedTwists:
      return longestPause(run);
    case Quantity::kShortestHold:
      return release(check.value ? shortestHold(run) : farthestMiss(run));
    case Quantity::kPeakForce:
    case Quantity::kPeakTorque:
      return momentOfLoad(quantity, line);
    default:
      return worstTwist(check, quantity, line, run);
  }
}

/// Returns what is new in `missed` after `earlier` ones: each advice is given once, and each moment with it.
std::optional<MissedTarget> newIn(MissedTarget missed,
                                  const std::vector<std::optional<MissedTarget>>& earlier) {
  const auto told = std::find_if(earlier.begin(), earlier.end(),
                                 [&missed](const auto& one) { return one && one->advice == missed.advice; });
  if (told == earlier.end()) {
    return missed;
  }
  if ((*told)->when == missed.when) {
    return std::nullopt;
  }
  missed.advice = {};
  return missed;
}

/// Tells for each check that was missed what `momentOf` finds, with the advice of its quantity.
template <typename MomentOf>
std::vector<std::optional<MissedTarget>> forMissed(const RunVerdict& verdict, MomentOf&& momentOf) {
  std::vector<std::optional<MissedTarget>> all;
  for (const TargetCheck& check : verdict.checks) {
    const bool lost = verdict.torn && !check.value;
    std::optional<MissedTarget> missed;
    if (!check.passed && !lost && check.quantity) {
      const Quantity quantity = *check.quantity;
      missed = newIn({momentOf(check, quantity), Text(rowOf(quantity).traits.advice)}, all);
    }
    all.push_back(missed);
  }
  return all;
}

/// Finds where an untwisting shows a quantity, in the curves and events of its story.
class UntwistingMoments {
 public:
  explicit UntwistingMoments(const DetorsionStory& story) : story_(story) {}

  /// Returns the time since the first sample; empty: nothing shows it.
  [[nodiscard]] std::optional<double> of(const TargetCheck& check, Quantity quantity) const {
    switch (quantity) {
      case Quantity::kFirstDirection:
      case Quantity::kVentedFirst:
        return first(DetorsionMoment::kGrip);
      case Quantity::kWrongWay:
        return ofLargest(story_.angle_rad, [](double angle_rad) { return std::abs(angle_rad); });
      case Quantity::kDose:
        return ofLargest(story_.dose, [](double dose) { return dose; });
      case Quantity::kTimeToFlow:
        return check.value;
      case Quantity::kRegrips:
      case Quantity::kSlipBack:
        return first(DetorsionMoment::kLetGo);
      case Quantity::kPeakJaw:
      case Quantity::kOverloadTime:
        return first(DetorsionMoment::kBruise);
      case Quantity::kLongestStage:
      case Quantity::kInStages:
        return largestTurn();
      case Quantity::kUntwisted:
        if (const auto tear_s = first(DetorsionMoment::kTear)) {
          return tear_s;
        }
        [[fallthrough]];
      case Quantity::kRelapse:
        if (const auto relapse_s = first(DetorsionMoment::kRelapse)) {
          return relapse_s;
        }
        [[fallthrough]];
      case Quantity::kResidual:
        return last(DetorsionMoment::kLetGo);
      default:
        return std::nullopt;
    }
  }

 private:
  using Event = DetorsionStory::Event;

  [[nodiscard]] std::optional<double> first(DetorsionMoment what) const {
    const auto found = std::find_if(story_.events.begin(), story_.events.end(),
                                    [what](const Event& event) { return event.what == what; });
    return found == story_.events.end() ? std::nullopt : std::optional(found->at_s);
  }
  [[nodiscard]] std::optional<double> last(DetorsionMoment what) const {
    const auto found = std::find_if(story_.events.rbegin(), story_.events.rend(),
                                    [what](const Event& event) { return event.what == what; });
    return found == story_.events.rend() ? std::nullopt : std::optional(found->at_s);
  }
  template <typename Size>
  [[nodiscard]] std::optional<double> ofLargest(const std::vector<double>& curve, Size&& size) const {
    const auto largest = std::max_element(curve.begin(), curve.end(),
                                          [&size](double a, double b) { return size(a) < size(b); });
    return largest == curve.end()
               ? std::nullopt
               : std::optional(story_.time_s[static_cast<std::size_t>(largest - curve.begin())]);
  }
  /// Returns the start of the grip that turned the organ back most.
  [[nodiscard]] std::optional<double> largestTurn() const {
    std::optional<double> found_s;
    double most_rad = 0.0;
    double from_s = 0.0;
    for (const Event& event : story_.events) {
      if (event.what == DetorsionMoment::kGrip) {
        from_s = event.at_s;
      } else if (event.what == DetorsionMoment::kLetGo) {
        const double turned_rad = angleAt(from_s) - angleAt(event.at_s);
        if (turned_rad > most_rad) {
          most_rad = turned_rad;
          found_s = from_s;
        }
      }
    }
    return found_s;
  }
  /// Returns the size of the angle at a time within the story.
  [[nodiscard]] double angleAt(double time_s) const {
    const auto next = std::lower_bound(story_.time_s.begin(), story_.time_s.end(), time_s);
    return next == story_.time_s.end()
               ? 0.0
               : std::abs(story_.angle_rad[static_cast<std::size_t>(next - story_.time_s.begin())]);
  }

  const DetorsionStory& story_;
};

}  // namespace

Timeline::Timeline(const TrialHeader& header, std::span<const Sample> all)
    : samples(all), times_us(sampleTimes(header, all).us) {}

double Timeline::at_s(std::size_t sample) const {
  return static_cast<double>(times_us[sample] - times_us.front()) * 1e-6;
}

Seconds momentInTwist(Quantity quantity, double value, const Timeline& line, const MeasuredTrial& run,
                      const MeasuredTwist& twist) {
  const Seconds whole{twist.start_s, twist.letGo_s};
  const auto largest = [&](std::size_t first, auto&& size) {
    const double t = timeOfLargest(line, first, twist.twist.letGo, size);
    // A peak before the grip is shown up to the grip, so that some of the twist is always visible.
    return Seconds{std::max(std::min(whole.from_s, t), t - kMoment_s),
                   std::min(whole.to_s + kMoment_s, std::max(t, whole.from_s) + kMoment_s)};
  };
  switch (rowOf(quantity).traits.moment) {
    case QuantityMoment::kPeakForce:
      return largest(sinceBefore(run, twist), tissueForce_N);
    case QuantityMoment::kPeakTorque:
      return largest(sinceBefore(run, twist), torqueSize);
    case QuantityMoment::kFarthestTurn: {
      const double sign = twist.twist.target_rad < 0.0 ? -1.0 : 1.0;
      return largest(twist.twist.first, [sign](const Sample& s) { return sign * s.response.angle_rad; });
    }
    case QuantityMoment::kFromGrip:
      return {whole.from_s, std::min(whole.to_s, whole.from_s + value)};
    case QuantityMoment::kHold:
      return {std::max(whole.from_s, whole.to_s - twist.held_s), whole.to_s};
    case QuantityMoment::kRelease:
      return around(whole.to_s);
    case QuantityMoment::kWholeTwist:
      break;
  }
  return whole;
}

std::vector<std::optional<MissedTarget>> missedTargets(const RunVerdict& verdict, const Timeline& line,
                                                       const MeasuredTrial& run) {
  return forMissed(verdict, [&](const TargetCheck& check, Quantity quantity) {
    return momentOfMiss(check, quantity, line, run);
  });
}

std::vector<std::optional<MissedTarget>> missedTargets(const RunVerdict& verdict, const Timeline& line,
                                                       const DetorsionStory& story) {
  const UntwistingMoments moments(story);
  return forMissed(verdict, [&](const TargetCheck& check, Quantity quantity) {
    const std::optional<double> at_s = moments.of(check, quantity);
    return at_s ? std::optional(around(*at_s)) : momentOfLoad(quantity, line);
  });
}

}  // namespace torsio
