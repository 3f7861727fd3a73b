// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/core/angle.h"
#include "sim/core/organ_pose.h"

namespace torsio {

/// Stages of an untwisting: after each `turn_rad` the organ rests.
struct TurnStages {
  double turn_rad = 0.0;  ///< 0: no stages
  double rest_s = 0.0;    ///< seconds of the tissue
  [[nodiscard]] bool asked() const noexcept { return turn_rad > 0.0; }
  friend bool operator==(const TurnStages&, const TurnStages&) = default;
};

/// An organ that moves by less than this is resting.
inline constexpr double kRestingSway_rad = radians(5.0);
/// By how much a stage may exceed what is asked for.
inline constexpr double kStageTolerance_rad = radians(15.0);

/// Follows how far an organ has been turned back since it last rested. A plain value; any one thread.
class StagedTurn {
 public:
  /// `timeScale`: seconds of the tissue for a second of the hand.
  StagedTurn(const TurnStages& stages, double timeScale) noexcept : stages_(stages), timeScale_(timeScale) {}

  /// Takes the angle at a time of the hand; times rise, the first angle is that with which the organ came.
  void take(double time_s, double angle_rad) noexcept;
  /// Returns how far it has been turned back since its last rest, or since it came.
  [[nodiscard]] double stage_rad() const noexcept { return from_rad_ - size_rad_; }
  /// Returns the longest stage so far.
  [[nodiscard]] double longest_rad() const noexcept { return longest_rad_; }
  /// Returns how long it has lain still, seconds of the tissue.
  [[nodiscard]] double still_s() const noexcept { return still_s_; }
  /// Tells whether it must rest before a hand turns it on: one more turn of a hand would leave the stage.
  [[nodiscard]] bool due() const noexcept {
    const double next_rad = size_rad_ < kHandTurn_rad ? size_rad_ : kHandTurn_rad;
    return stages_.asked() && stage_rad() + next_rad > stages_.turn_rad + kStageTolerance_rad;
  }

 private:
  TurnStages stages_;
  double timeScale_ = 1.0;
  bool begun_ = false;
  double size_rad_ = 0.0;
  double from_rad_ = 0.0;    // where the stage began
  double around_rad_ = 0.0;  // where it has been lying since
  double since_s_ = 0.0;
  double still_s_ = 0.0;
  double longest_rad_ = 0.0;
};

}  // namespace torsio
