// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/review/case_sheet.h"
#include "app/services/review/watch_log.h"
#include "assessment/domain/ids.h"

namespace torsio {

/// A stretch of a recording that a player says went by by itself.
struct PlayedStretch {
  std::int64_t from_us = 0;
  std::int64_t to_us = 0;
  double speed = 1.0;  ///< 1: as it happened
};

/// Longer without a key or play is a coffee, not work.
inline constexpr std::int64_t kLongestPause_us = 60'000'000;

/// What can be true of what a player reports: no more of a recording goes by than time has passed. `log` as
/// it was before; `passed_us`: since the last report of the same player, by a clock that the player does not
/// set. What exceeds it, beyond half a second that a report may be late, is cut off at the end. Pure.
[[nodiscard]] WatchLog creditedLog(WatchLog log, const std::vector<PlayedStretch>& played,
                                   std::int64_t passed_us);

/// Adds what a player elsewhere reports to what was watched of a case, and stores it with the draft. Returns
/// the sheet as it is now. kMarkSubmit, own recorded case that is not submitted. Throws Error{kBadParameter}
/// for a stretch that runs backwards and for a speed that the centre does not allow, {kBadData} for a case
/// that is live or submitted.
[[nodiscard]] OpenedSheet reportViewing(SessionContext& session, const AssignmentId& assignmentId,
                                        const std::vector<PlayedStretch>& played, std::int64_t passed_us);

}  // namespace torsio
