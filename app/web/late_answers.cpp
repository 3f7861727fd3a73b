// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/late_answers.h"

#include <algorithm>
#include <iterator>

namespace torsio::web {

std::chrono::milliseconds LateAnswers::delayFor(std::size_t waiting) noexcept {
  // Sixty clients that ask again as soon as they are answered then leave four waiting, not sixty: a right
  // password is checked within a second.
  constexpr std::size_t kFew = 2;
  constexpr std::chrono::milliseconds kEach{3'000};
  constexpr std::chrono::milliseconds kLongest{45'000};
  return waiting <= kFew ? std::chrono::milliseconds(0)
                         : std::min(kEach * static_cast<int>(waiting), kLongest);
}

void LateAnswers::keep(SteadyTime due, std::function<void()> give) {
  {
    const std::lock_guard lock(mutex_);
    if (!ended_) {
      kept_.emplace_back(due, std::move(give));
      return;
    }
  }
  give();
}

void LateAnswers::tick(SteadyTime now) {
  std::vector<std::pair<SteadyTime, std::function<void()>>> due;
  {
    const std::lock_guard lock(mutex_);
    const auto later =
        std::partition(kept_.begin(), kept_.end(), [now](const auto& one) { return one.first <= now; });
    std::move(kept_.begin(), later, std::back_inserter(due));
    kept_.erase(kept_.begin(), later);
  }
  for (const auto& [when, give] : due) {
    give();
  }
}

void LateAnswers::end() {
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
  }
  tick(SteadyTime::max());
}

}  // namespace torsio::web
