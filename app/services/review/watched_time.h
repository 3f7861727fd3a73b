// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/review/watch_log.h"
#include "assessment/domain/rating/sheet_check.h"
#include "assessment/domain/rating/watch_account.h"
#include "sim/core/text.h"

namespace torsio {

/// A stretch that a player reports as played without seeking.
struct PlayedStretch {
  std::int64_t from_us = 0;
  std::int64_t to_us = 0;
  double speed = 1.0;  ///< 1: real time
};

/// A longer time without a key press or playback counts as a break.
inline constexpr std::int64_t kLongestPause_us = 60'000'000;

/// Returns what a player reports. Throws Error{kBadParameter} for a reversed stretch and a speed that is not
/// allowed. Pure function.
[[nodiscard]] std::vector<PlayedStretch> playable(std::vector<PlayedStretch> played,
                                                  const ViewingRules& rules, const Text& where);

/// A log, and how much of the rater's time it took.
struct CreditedLog {
  WatchLog log{};
  std::int64_t used_us = 0;
};
/// Adds a report, limited to `budget_us` at each stretch's speed. Anything beyond is cut off at the end. Pure
/// function.
[[nodiscard]] CreditedLog creditedLog(WatchLog log, const std::vector<PlayedStretch>& played,
                                      std::int64_t budget_us);

/// The functions below keep the account of the actor's watched time (WatchAccount). `recording`: an
/// assignment's id, or modelRecording(). kEvaluationSubmit, which raters of cases have, too.

/// Starts a recording in a browser: time gone by before counts for nothing.
void beginWatching(SessionContext& session, const std::string& recording);
/// Adds what a browser reports, limited to the time gone by on the session's clock since the last report of
/// this recording. Call inside the transaction that stores the log.
[[nodiscard]] WatchLog watchedInBrowser(SessionContext& session, const std::string& recording, WatchLog log,
                                        const std::vector<PlayedStretch>& played);
/// Returns what counts of a window's log. `kept`: what counted before. The window's player keeps real time,
/// so everything new counts unless a browser or another window has reported since: then no more than the time
/// gone by.
[[nodiscard]] WatchLog watchedInWindow(SessionContext& session, const std::string& recording,
                                       const WatchLog& kept, const WatchLog& played);
/// Returns the name of a model of an evaluation in the account.
[[nodiscard]] std::string modelRecording(const std::string& campaignId, const std::string& hiddenLabel);

}  // namespace torsio
