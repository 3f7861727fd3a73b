// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

namespace torsio {

/// Time that a rater is credited with beyond the time gone by, once: reports arrive late.
inline constexpr std::int64_t kWatchSlack_us = 500'000;

/// The watched time that a rater may still be credited with, over all sessions, pages and windows: whatever
/// is reported, in any order, the credited time never exceeds the time gone by plus kWatchSlack_us, and time
/// counts for one recording only. A plain value.
struct WatchAccount {
  std::string recording{};          ///< being played: a case, or a model of an evaluation; empty: none yet
  std::string player{};             ///< who reported last
  std::int64_t charged_utc_us = 0;  ///< the time up to here is used
  std::int64_t slack_us = kWatchSlack_us;  ///< what is left of kWatchSlack_us, 0 or more
};

/// Returns the time gone by at `now_us` for a recording since the last charge; 0 if another one was played.
[[nodiscard]] std::int64_t passed_us(const WatchAccount& account, const std::string& recording,
                                     std::int64_t now_us);
/// Returns the time that may be credited at `now_us` for playing a recording.
[[nodiscard]] std::int64_t budget_us(const WatchAccount& account, const std::string& recording,
                                     std::int64_t now_us);
/// Returns the account after a charge at `now_us` that left `left_us` of the budget: it is lost, except for
/// the slack.
[[nodiscard]] WatchAccount charged(const std::string& recording, const std::string& player,
                                   std::int64_t now_us, std::int64_t left_us);

}  // namespace torsio
