// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metrics/detorsion.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "assessment/metrics/signal.h"
#include "sim/core/contracts.h"
#include "sim/core/error.h"
#include "sim/core/time_units.h"

namespace torsio {

namespace {

// Ischaemic tissue is weaker: limits x (1 - .5 min(D, 1)); assumed (docs/model.md P).
constexpr double kLostStrength = 0.5;

void checkTicks(std::span<const DetorsionTick> ticks) {
  if (ticks.size() < 2) {
    throw Error(ErrorCode::kBadData, Text::verbatim("an untwisting has fewer than two samples"),
                Text::tr("run"), Text::verbatim("Record it again."));
  }
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    const std::int64_t step_us = ticks[i].time_us - ticks[i - 1].time_us;
    if (step_us <= 0 || static_cast<double>(step_us) / kSecond_us > kLargestGap_s) {
      throw Error(ErrorCode::kBadData, Text::verbatim("the times of an untwisting do not rise evenly"),
                  Text::tr("run"), Text::verbatim("Read the run again."));
    }
  }
}

double yesNo(bool yes) noexcept {
  return yes ? 1.0 : 0.0;
}

/// Calculates the metrics of an untwisting.
class DetorsionMeasurer {
 public:
  DetorsionMeasurer(std::span<const DetorsionTick> ticks, const DetorsionRules& rules, DetorsionMetrics& out)
      : ticks_(ticks), rules_(rules), out_(out) {}

  void run() {
    measureTurning();
    measureStages();
    measureGrips();
    measureBlood();
    measureLoads();
    measureEnd();
  }

 private:
  void set(Quantity quantity, Outcome<double> value) { out_.set(quantity, std::move(value)); }

  /// Returns the time of tick i since the first, s.
  [[nodiscard]] double at_s(std::size_t i) const {
    return static_cast<double>(ticks_[i].time_us - ticks_.front().time_us) / kSecond_us;
  }

  /// Returns the first tick from which `test` holds for this time; the number of ticks if there is none. The
  /// last tick counts as one period.
  template <class Test>
  [[nodiscard]] std::size_t lasting(double duration_s, Test test) const {
    const auto wanted_us = static_cast<std::int64_t>(std::ceil(duration_s * kSecond_us - 0.5));
    std::size_t since = 0;
    for (std::size_t i = 0; i < ticks_.size(); ++i) {
      if (!test(ticks_[i])) {
        since = i + 1;
      } else if (ticks_[i].time_us + kTickPeriod_us - ticks_[since].time_us >= wanted_us) {
        return since;
      }
    }
    return ticks_.size();
  }

  void measureTurning() {
    const double start_rad = out_.start_rad;
    double turned_rad = 0.0;
    double farthest_rad = std::abs(start_rad);
    std::size_t chosen = ticks_.size();
    std::size_t vented = ticks_.size();
    std::int64_t open_us = 0;
    for (std::size_t i = 0; i < ticks_.size(); ++i) {
      farthest_rad = std::max(farthest_rad, std::abs(ticks_[i].angle_rad));
      if (i > 0 && ticks_[i - 1].venting) {
        open_us += ticks_[i].time_us - ticks_[i - 1].time_us;
      }
      if (vented == ticks_.size() && static_cast<double>(open_us) >= kLetOut_s * kSecond_us) {
        vented = i;
      }
      if (chosen == ticks_.size() && i > 0 && ticks_[i].held && ticks_[i - 1].held) {
        turned_rad += ticks_[i].angle_rad - ticks_[i - 1].angle_rad;
        chosen = std::abs(turned_rad) >= kChosenTurn_rad ? i : chosen;
      }
    }
    if (start_rad == 0.0) {
      set(Quantity::kFirstDirection, Outcome<double>::undefined(Text::tr("the organ did not come twisted")));
    } else if (chosen == ticks_.size()) {
      set(Quantity::kFirstDirection,
          Outcome<double>::undefined(Text::tr("the hand never turned the organ by 15 degrees")));
    } else {
      set(Quantity::kFirstDirection, yesNo((turned_rad < 0.0) == (start_rad > 0.0)));
    }
    set(Quantity::kWrongWay, farthest_rad - std::abs(start_rad));
    if (rules_.vent) {
      set(Quantity::kVentedFirst, yesNo(vented < chosen));
    } else {
      set(Quantity::kVentedFirst,
          Outcome<double>::undefined(Text::tr("nothing can be let out of this organ")));
    }
  }

  void measureStages() {
    if (!rules_.stages.asked()) {
      const Text notAsked = Text::tr("this organ is not to be untwisted in stages");
      set(Quantity::kLongestStage, Outcome<double>::undefined(notAsked));
      set(Quantity::kInStages, Outcome<double>::undefined(notAsked));
      return;
    }
    StagedTurn staged(rules_.stages, rules_.timeScale);
    for (std::size_t i = 0; i < ticks_.size(); ++i) {
      staged.take(at_s(i), ticks_[i].angle_rad);
    }
    set(Quantity::kLongestStage, staged.longest_rad());
    set(Quantity::kInStages, yesNo(staged.longest_rad() <= rules_.stages.turn_rad + kStageTolerance_rad));
  }

  void measureGrips() {
    double regrips = 0.0;
    double slipBack_rad = 0.0;
    std::optional<double> letGo_rad;
    for (std::size_t i = 1; i < ticks_.size(); ++i) {
      const double angle_rad = std::abs(ticks_[i].angle_rad);
      if (ticks_[i - 1].held && !ticks_[i].held) {
        const double before_rad = std::abs(ticks_[i - 1].angle_rad);
        regrips += before_rad > kRegripFrom_rad && !ticks_[i].handGone ? 1.0 : 0.0;
        letGo_rad = before_rad;
      } else if (!ticks_[i - 1].held && ticks_[i].held && letGo_rad) {
        slipBack_rad += std::max(0.0, angle_rad - *letGo_rad);
      }
    }
    set(Quantity::kRegrips, regrips);
    set(Quantity::kLeastRegrips, leastRegrips(out_.start_rad));
    set(Quantity::kSlipBack, slipBack_rad);
  }

  void measureBlood() {
    double patency = ticks_.front().patency;
    double dose = ticks_.front().dose;
    for (const DetorsionTick& tick : ticks_) {
      patency = std::min(patency, tick.patency);
      dose = std::max(dose, tick.dose);
    }
    set(Quantity::kLeastPatency, patency);
    set(Quantity::kDose, dose);
    const std::size_t back =
        lasting(kFlowBack_s, [&](const DetorsionTick& tick) { return tick.flow >= rules_.enoughFlow; });
    if (back == ticks_.size()) {
      const Text never = Text::tr("blood did not come back for 5 s before the recording ended");
      set(Quantity::kTimeToFlow, Outcome<double>::undefined(never));
      set(Quantity::kDoseAtFlow, Outcome<double>::undefined(never));
      return;
    }
    set(Quantity::kTimeToFlow, at_s(back));
    set(Quantity::kDoseAtFlow, ticks_[back].dose);
  }

  void measureLoads() {
    std::optional<double> jaw_Pa;
    std::optional<double> shear_Pa;
    double over_s = 0.0;
    for (std::size_t i = 0; i < ticks_.size(); ++i) {
      const DetorsionTick& tick = ticks_[i];
      if (tick.shear_Pa) {
        shear_Pa = std::max(shear_Pa.value_or(0.0), *tick.shear_Pa);
      }
      if (tick.held) {
        jaw_Pa = std::max(jaw_Pa.value_or(0.0), tick.jaw_Pa);
      }
      const double strength = strengthOf(tick);
      const bool crushed = tick.held && tick.jaw_Pa > strength * rules_.bruise_Pa;
      if (crushed || tick.force_N > strength * rules_.pull_N) {
        over_s += i + 1 < ticks_.size() ? at_s(i + 1) - at_s(i) : spanOf_s(1);
      }
    }
    set(Quantity::kOverloadTime, over_s);
    set(Quantity::kPeakJaw, jaw_Pa ? Outcome<double>(*jaw_Pa)
                                   : Outcome<double>::undefined(Text::tr("the hand never held the organ")));
    set(Quantity::kPeakShear,
        shear_Pa ? Outcome<double>(*shear_Pa)
                 : Outcome<double>::undefined(Text::tr("the stress of the wall needs the scene at hand")));
  }

  [[nodiscard]] static bool isFree(const DetorsionTick& tick) noexcept { return !tick.held && !tick.clipped; }

  /// Returns the strength relative to healthy tissue.
  [[nodiscard]] static double strengthOf(const DetorsionTick& tick) noexcept {
    return 1.0 - kLostStrength * std::min(tick.dose, 1.0);
  }

  [[nodiscard]] bool tears(const DetorsionTick& tick) const noexcept {
    const double strength = strengthOf(tick);
    return tick.held &&
           (tick.jaw_Pa >= strength * rules_.tear_Pa || tick.force_N >= strength * rules_.pull_N);
  }

  void measureEnd() {
    const std::size_t undone = lasting(rules_.handsOff_s, [&](const DetorsionTick& tick) {
      return isFree(tick) && std::abs(tick.angle_rad) <= rules_.residual_rad &&
             tick.patency >= rules_.patency && tick.flow >= rules_.flow;
    });
    const bool torn =
        std::any_of(ticks_.begin(), ticks_.end(), [&](const DetorsionTick& tick) { return tears(tick); });
    const bool done = undone < ticks_.size() && !torn;
    set(Quantity::kUntwisted, yesNo(done));
    if (done) {
      out_.done_s = at_s(undone) + rules_.handsOff_s;
      const bool relapsed = std::any_of(
          ticks_.begin() + static_cast<std::ptrdiff_t>(undone), ticks_.end(),
          [&](const DetorsionTick& tick) { return std::abs(tick.angle_rad) > rules_.relapseFrom_rad; });
      set(Quantity::kRelapse, yesNo(relapsed));
    } else {
      set(Quantity::kRelapse,
          Outcome<double>::undefined(torn ? Text::tr("the wall was torn: that does not count as untwisted")
                                          : Text::tr("the organ was never untwisted")));
    }
    set(Quantity::kResidual, residual());
  }

  /// Returns the angle at handsOff_s after hand and clip let go for the last time.
  [[nodiscard]] Outcome<double> residual() const {
    std::size_t freeSince = ticks_.size();
    while (freeSince > 0 && isFree(ticks_[freeSince - 1])) {
      --freeSince;
    }
    if (freeSince == ticks_.size()) {
      return Outcome<double>::undefined(Text::tr("the organ was still held when the recording ended"));
    }
    const auto wanted_us = static_cast<std::int64_t>(std::ceil(rules_.handsOff_s * kSecond_us - 0.5));
    for (std::size_t i = freeSince; i < ticks_.size(); ++i) {
      if (ticks_[i].time_us + kTickPeriod_us - ticks_[freeSince].time_us >= wanted_us) {
        return std::abs(ticks_[i].angle_rad);
      }
    }
    return Outcome<double>::undefined(Text::tr("the recording ended too soon after the organ was released"));
  }

  std::span<const DetorsionTick> ticks_;
  const DetorsionRules& rules_;
  DetorsionMetrics& out_;
};

}  // namespace

double leastRegrips(double start_rad) noexcept {
  constexpr double kRounding = 1e-4;  // tolerance, so that a recorded 310 degrees is two turns of a hand
  return std::max(0.0, std::ceil(std::abs(start_rad) / kHandTurn_rad - kRounding) - 1.0);
}

DetorsionMetrics measureDetorsion(std::span<const DetorsionTick> ticks, const DetorsionRules& rules) {
  checkTicks(ticks);
  DetorsionMetrics out;
  out.start_rad = ticks.front().angle_rad;
  DetorsionMeasurer(ticks, rules, out).run();
  return out;
}

}  // namespace torsio
