// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/domain/rating/watch_account.h"

#include <algorithm>

namespace torsio {

std::int64_t passed_us(const WatchAccount& account, const std::string& recording, std::int64_t now_us) {
  return account.recording == recording ? std::max<std::int64_t>(0, now_us - account.charged_utc_us) : 0;
}

std::int64_t budget_us(const WatchAccount& account, const std::string& recording, std::int64_t now_us) {
  return passed_us(account, recording, now_us) + account.slack_us;
}

WatchAccount charged(const std::string& recording, const std::string& player, std::int64_t now_us,
                     std::int64_t left_us) {
  return {.recording = recording,
          .player = player,
          .charged_utc_us = now_us,
          .slack_us = std::clamp<std::int64_t>(left_us, 0, kWatchSlack_us)};
}

}  // namespace torsio
