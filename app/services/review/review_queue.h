// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/review/blinded_case.h"
#include "assessment/domain/rating/live_call.h"

namespace torsio {

/// One line of a rater's queue.
struct QueueLine {
  BlindedCase shown{};
  SheetState state = SheetState::kOpen;
  double estimate_min = 0.0;  ///< 0 when submitted
  bool overdue = false;       ///< its day has gone by, or whom it is about has left the arm; not submitted
  std::int64_t submittedUtc_us = 0;  ///< of the newest version; 0: not submitted
  std::optional<CallNotice> call{};  ///< of a live case that was called
};

/// What a physician sees first.
struct ReviewQueue {
  std::vector<QueueLine> lines{};  ///< recorded cases in the rater's own order, submitted ones last
  std::size_t waiting = 0;         ///< recorded, not begun
  std::size_t drafts = 0;
  std::size_t submitted = 0;
  std::size_t liveCalled = 0;   ///< on the real arm, called and not submitted, drafts included
  std::size_t liveWaiting = 0;  ///< on the real arm, not called yet
  std::size_t liveSubmitted = 0;
  std::size_t overdue = 0;
  std::optional<std::int64_t> nextDueUtc_us{};
  double minutes = 0.0;             ///< for all recorded cases that are left
  std::size_t inTenMinutes = 0;     ///< how many of the next recorded cases fit into ten minutes
  std::int64_t worked_us = 0;       ///< given to all submitted recorded cases so far
  bool fromOwnPace = false;         ///< true: median of own last cases; false: length of the recordings
  bool calibrationWaiting = false;  ///< reference runs that this rater has not scored
  std::size_t disagreements = 0;    ///< committed cases that wait in the discrepancy review
  std::size_t models = 0;           ///< of evaluations that ask the actor, not submitted yet
  std::optional<std::string>
      next{};  ///< assignment id of "continue": the first draft, else the first waiting
};

/// kMarkSubmit.
[[nodiscard]] ReviewQueue reviewQueue(SessionContext& session);

/// Live cases of the actor that were called to the real arm or are submitted, in the order of the calls:
/// scored without a recording. kMarkSubmit.
[[nodiscard]] std::vector<QueueLine> liveLines(SessionContext& session);

}  // namespace torsio
