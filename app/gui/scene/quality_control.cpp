// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/scene/quality_control.h"

#include <algorithm>

namespace torsio::gui {

namespace {

constexpr double kSlow_s = 1.0 / 24.0;   // below the frame rate of films, motion looks jerky
constexpr double kQuick_s = 1.0 / 50.0;  // unthrottled rate on a 60 Hz display
constexpr double kIdle_s = 0.25;         // nothing moved, so it is not a measurement
constexpr double kSmoothing = 0.15;
constexpr double kDownAfter_s = 1.5;
constexpr double kLongestWait_s = 120.0;

}  // namespace

bool QualityControl::note(double frame_s) noexcept {
  if (!mayBeFine_) {
    return false;
  }
  if (frame_s <= 0.0 || frame_s > kIdle_s) {
    watched_s_ = 0.0;
    return false;
  }
  mean_s_ = mean_s_ == 0.0 ? frame_s : mean_s_ + kSmoothing * (frame_s - mean_s_);
  const bool wrong = fine_ ? mean_s_ > kSlow_s : mean_s_ < kQuick_s;
  watched_s_ = wrong ? watched_s_ + frame_s : 0.0;
  if (fine_ && watched_s_ >= kDownAfter_s) {
    wait_s_ = std::min(2.0 * wait_s_, kLongestWait_s);
    change(false);
    return true;
  }
  if (!fine_ && watched_s_ >= wait_s_) {
    change(true);
    return true;
  }
  return false;
}

void QualityControl::change(bool fine) noexcept {
  fine_ = fine;
  mean_s_ = 0.0;
  watched_s_ = 0.0;
}

}  // namespace torsio::gui
