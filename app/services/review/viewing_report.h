// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/watch_log.h"
#include "assessment/domain/ids.h"

namespace torsio {

/// A stretch that a player reports as played without seeking.
struct PlayedStretch {
  std::int64_t from_us = 0;
  std::int64_t to_us = 0;
  double speed = 1.0;  ///< 1: real time
};

/// A longer time without a key press or playback counts as a break.
inline constexpr std::int64_t kLongestPause_us = 60'000'000;

/// Adds a player's report, limited to what the elapsed time allows at each stretch's speed. `log`: previous
/// state; `passed_us`: since the last report of the same player, by a clock that the player does not control.
/// Anything beyond it, plus half a second for delays, is cut off at the end. Pure function.
[[nodiscard]] WatchLog creditedLog(WatchLog log, const std::vector<PlayedStretch>& played,
                                   std::int64_t passed_us);

/// Adds the report of a remote player to the viewing data of a case and stores it with the draft. Returns the
/// current sheet. kMarkSubmit, the actor's recorded case, not submitted. Throws Error{kBadParameter} for a
/// reversed stretch and a speed that the centre does not allow, {kBadData} for a live or submitted case.
[[nodiscard]] OpenedSheet reportViewing(SessionContext& session, const AssignmentId& assignmentId,
                                        const std::vector<PlayedStretch>& played, std::int64_t passed_us);

}  // namespace torsio
