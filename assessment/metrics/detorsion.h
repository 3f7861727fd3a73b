// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "assessment/catalogue/quantity.h"
#include "assessment/metrics/trial_metrics.h"
#include "sim/core/angle.h"
#include "sim/core/hollow_pose.h"
#include "sim/core/staged_turn.h"

namespace torsio {

/// Net turn of a held organ from which its direction counts as chosen.
inline constexpr double kChosenTurn_rad = radians(15.0);
/// Whoever lets go of an organ that is turned further than this has to grip it again.
inline constexpr double kRegripFrom_rad = radians(30.0);
/// The content counts as let out once the way was open for so long in all: two thirds of it have left then.
inline constexpr double kLetOut_s = 3.0;
/// Blood has come back when it has flowed for so long.
inline constexpr double kFlowBack_s = 5.0;

/// By what the untwisting of an organ is judged, as the scene of its recording states it.
struct DetorsionRules {
  double residual_rad = radians(15.0);  ///< largest angle that counts as undone
  double patency = 0.8;                 ///< least that counts as undone
  double flow = 0.8;                    ///< least that counts as undone
  double handsOff_s = 10.0;             ///< for so long without hand and clip
  double enoughFlow = 0.5;              ///< from which blood has come back
  double relapseFrom_rad = radians(90.0);
  double jaw_Pa = 500e3;     ///< of a jaw that is closed fully
  double bruise_Pa = 330e3;  ///< which sound tissue bears
  double tear_Pa = 660e3;    ///< at which a jaw tears sound tissue
  double pull_N = 10.0;      ///< which sound tissue bears
  double timeScale = 60.0;   ///< seconds of the tissue for a second of the hand
  bool vent = false;         ///< whether the content can be let out
  TurnStages stages{};       ///< in which it is to be undone
  friend bool operator==(const DetorsionRules&, const DetorsionRules&) = default;
};

/// What a tick of an untwisting was like.
struct DetorsionTick {
  std::int64_t time_us = 0;
  double angle_rad = 0.0;  ///< of the mobile part; the first tick's is that with which the organ came
  double patency = 1.0;
  double flow = 1.0;
  double dose = 0.0;
  double force_N = 0.0;              ///< magnitude on the organ
  double jaw_Pa = 0.0;               ///< on what is held; read only while held
  std::optional<double> shear_Pa{};  ///< largest of the wall; empty: not known
  bool held = false;                 ///< by the hand
  bool clipped = false;              ///< by a clip or an assistant
  bool handGone = false;             ///< the device was lost: what it lets go of, the hand does not
  bool venting = false;
  friend bool operator==(const DetorsionTick&, const DetorsionTick&) = default;
};

/// What an untwisting comes to.
struct DetorsionMetrics : MetricValues {
  DetorsionMetrics() : MetricValues({QuantityScope::kUntwisting}) {}

  double start_rad = 0.0;          ///< angle with which the organ came, signed
  std::optional<double> done_s{};  ///< when it was done, since the first tick; the time hands off included
};

/// Returns how often a hand that turns kHandTurn_rad must grip again to undo an angle: ceil(|angle| / turn)
/// - 1.
[[nodiscard]] double leastRegrips(double start_rad) noexcept;

/// Measures an untwisting, from the first tick to the last. Times are those of the hand. Throws
/// Error{kBadData} for fewer than two ticks, times that do not rise, or a gap of more than 20 ms.
[[nodiscard]] DetorsionMetrics measureDetorsion(std::span<const DetorsionTick> ticks,
                                                const DetorsionRules& rules);

}  // namespace torsio
