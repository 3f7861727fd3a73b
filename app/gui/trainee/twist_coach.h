// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QCoreApplication>
#include <QString>

#include "assessment/attempt/twist_count.h"
#include "assessment/domain/study/curriculum.h"
#include "sim/core/live_types.h"

namespace torsio::gui {

/// What a trainee is told about the twists of one recording while it goes on: what is asked for, how many are
/// done, how the latest was let go, and what to do next. A plain value. GUI thread.
class TwistCoach {
  Q_DECLARE_TR_FUNCTIONS(TwistCoach)

 public:
  /// A recording begins. `haptic`: the hand feels force; otherwise the cues name mouse and keys.
  void begin(const TrainingModule& module, double target_rad, bool haptic);
  /// Takes the next frame.
  void follow(const LiveState& state, bool onTarget);

  [[nodiscard]] std::int64_t completed() const noexcept { return twists_.completed(); }
  /// How much of the time to be held on target is over, from 0; 1 and more: all of it.
  [[nodiscard]] double heldShare() const noexcept { return heldShare_; }
  [[nodiscard]] QString goal() const;
  [[nodiscard]] QString count() const;
  /// How the latest twist was let go, and what to do better.
  [[nodiscard]] QString verdict() const;
  [[nodiscard]] QString cue(const LiveState& state) const;

 private:
  [[nodiscard]] double heldShareOf(const LiveState& state, bool onTarget);
  [[nodiscard]] QString twistingCue(double angle_rad) const;

  TrainingModule module_;
  double target_rad_ = 0.0;
  bool haptic_ = false;
  TwistCount twists_;
  std::int64_t released_ = 0;          // on target
  std::int64_t onTargetFrom_us_ = -1;  // of the present stay on target; -1: not there
  double heldShare_ = 0.0;
  bool held_ = false;       // the present twist, as long as is asked for
  bool letGoHeld_ = false;  // the latest twist was
};

}  // namespace torsio::gui
