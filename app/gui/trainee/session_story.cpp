// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/trainee/session_story.h"

#include <cmath>
#include <utility>

namespace torsio::gui {

void SessionStory::begin(std::int64_t now_us) {
  begunUtc_us_ = begunUtc_us_.value_or(now_us);
}

bool SessionStory::add(const Debrief& debrief) {
  const bool ofThisSession = begunUtc_us_ && debrief.startedUtc_us >= *begunUtc_us_;
  if (!ofThisSession || debrief.verdict.outcome == RunOutcome::kInterrupted ||
      !seen_.insert(debrief.trialId).second) {
    return false;
  }
  bool better = false;
  for (const TwistResult& twist : debrief.twists) {
    ++twists_;
    if (!twist.passed) {
      continue;
    }
    ++onTarget_;
    const double error_rad = std::abs(twist.released_rad - twist.target_rad);
    if (!best_ || error_rad < best_->error_rad) {
      best_ = BestTwist{debrief.trialId, debrief.moduleTitle, twist, error_rad, {}};
      better = true;
    }
  }
  return better;
}

void SessionStory::setPicture(QImage picture) {
  if (best_) {
    best_->picture = std::move(picture);
  }
}

}  // namespace torsio::gui
