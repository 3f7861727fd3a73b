// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "assessment/catalogue/quantity.h"
#include "assessment/metrics/trial_metrics.h"
#include "sim/core/angle.h"
#include "sim/core/organ_pose.h"
#include "sim/core/staged_turn.h"

namespace torsio {

/// Net turn of a held organ that counts as a choice of direction.
inline constexpr double kChosenTurn_rad = radians(15.0);
/// A release beyond this angle counts as a regrip.
inline constexpr double kRegripFrom_rad = radians(30.0);
/// The content counts as let out once the vent has been open for this time in total, when two thirds of it
/// have escaped.
inline constexpr double kLetOut_s = 3.0;
/// Blood flow counts as restored after this time.
inline constexpr double kFlowBack_s = 5.0;

/// Rules for judging an untwisting, from its recording's scene.
struct DetorsionRules {
  double residual_rad = radians(15.0);  ///< maximum angle that counts as untwisted
  double patency = 0.8;                 ///< minimum that counts as untwisted
  double flow = 0.8;                    ///< minimum that counts as untwisted
  double handsOff_s = 10.0;             ///< time without hand and clip
  double enoughFlow = 0.5;              ///< at which blood flow counts as restored
  double relapseFrom_rad = radians(90.0);
  double jaw_Pa = 500e3;     ///< of the fully closed jaw
  double bruise_Pa = 330e3;  ///< strength of healthy tissue
  double tear_Pa = 660e3;    ///< at which a jaw tears healthy tissue
  double pull_N = 10.0;      ///< limit for healthy tissue
  double timeScale = 60.0;   ///< seconds of tissue time per second of the hand
  bool vent = false;         ///< the content can be let out
  TurnStages stages{};       ///< required stages
  friend bool operator==(const DetorsionRules&, const DetorsionRules&) = default;
};

/// State in a tick of an untwisting.
struct DetorsionTick {
  std::int64_t time_us = 0;
  double angle_rad = 0.0;  ///< of the mobile part; the first tick has the initial angle
  double patency = 1.0;
  double flow = 1.0;
  double dose = 0.0;
  double force_N = 0.0;              ///< magnitude on the organ
  double jaw_Pa = 0.0;               ///< on the held part; used only while held
  std::optional<double> shear_Pa{};  ///< maximum in the wall; empty: unknown
  bool held = false;                 ///< by the hand
  bool clipped = false;              ///< by a clip or an assistant
  bool handGone = false;             ///< the device was lost: its release is not the hand's
  bool venting = false;
  friend bool operator==(const DetorsionTick&, const DetorsionTick&) = default;
};

/// Results of an untwisting.
struct DetorsionMetrics : MetricValues {
  DetorsionMetrics() : MetricValues({QuantityScope::kUntwisting}) {}

  double start_rad = 0.0;          ///< initial angle, signed
  std::optional<double> done_s{};  ///< time of success since the first tick, including the hands-off time
};

/// Returns how often a hand that turns kHandTurn_rad must regrip to undo an angle: ceil(|angle| / turn) - 1.
[[nodiscard]] double leastRegrips(double start_rad) noexcept;

/// Measures an untwisting over all ticks. Times are the hand's. Throws Error{kBadData} for fewer than two
/// ticks, times that do not increase, or a gap of more than 20 ms.
[[nodiscard]] DetorsionMetrics measureDetorsion(std::span<const DetorsionTick> ticks,
                                                const DetorsionRules& rules);

}  // namespace torsio
