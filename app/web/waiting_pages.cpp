// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/web/waiting_pages.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace torsio::web {

std::uint64_t WaitingPages::news() {
  const std::lock_guard lock(mutex_);
  return news_;
}

bool WaitingPages::hold(std::uint64_t seen, SteadyTime until, Again again) {
  const std::lock_guard lock(mutex_);
  if (ended_ || seen != news_) {
    return false;
  }
  held_.push_back({until, std::move(again)});
  return true;
}

std::size_t WaitingPages::size() {
  const std::lock_guard lock(mutex_);
  return held_.size();
}

void WaitingPages::tell() {
  {
    const std::lock_guard lock(mutex_);
    ++news_;
  }
  runAgain([](const Held&) { return true; }, false);
}

void WaitingPages::tick(SteadyTime now) {
  runAgain([now](const Held& held) { return held.until <= now; }, false);
}

void WaitingPages::end() {
  runAgain([](const Held&) { return true; }, true);
}

void WaitingPages::runAgain(const std::function<bool(const Held&)>& which, bool ends) {
  std::vector<Held> now;
  {
    const std::lock_guard lock(mutex_);
    ended_ = ended_ || ends;
    const auto rest =
        std::stable_partition(held_.begin(), held_.end(), [&](const Held& held) { return !which(held); });
    now.assign(std::make_move_iterator(rest), std::make_move_iterator(held_.end()));
    held_.erase(rest, held_.end());
  }
  for (const Held& held : now) {
    held.again();
  }
}

}  // namespace torsio::web
