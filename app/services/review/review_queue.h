// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/review/blinded_case.h"
#include "assessment/domain/rating/assignment.h"

namespace torsio {

/// One line of a rater's queue.
struct QueueLine {
  BlindedCase shown{};
  SheetState state = SheetState::kOpen;
  double estimate_min = 0.0;         ///< 0 if submitted
  bool overdue = false;              ///< past its day, or the trainee has left the arm; not submitted
  std::int64_t submittedUtc_us = 0;  ///< of the latest version; 0: not submitted
  std::optional<CallNotice> call{};  ///< of a called live case
};

/// A physician's start page.
struct ReviewQueue {
  std::vector<QueueLine> lines{};  ///< recorded cases in the rater's order, submitted ones last
  std::size_t waiting = 0;         ///< recorded, not started
  std::size_t drafts = 0;
  std::size_t submitted = 0;
  std::size_t liveCalled = 0;   ///< on the real arm, called and not submitted, including drafts
  std::size_t liveWaiting = 0;  ///< on the real arm, not called yet
  std::size_t liveSubmitted = 0;
  std::size_t overdue = 0;
  std::optional<std::int64_t> nextDueUtc_us{};
  double minutes = 0.0;             ///< estimate for all remaining recorded cases
  std::size_t inTenMinutes = 0;     ///< how many of the next recorded cases fit into ten minutes
  std::int64_t worked_us = 0;       ///< spent on all submitted recorded cases
  bool fromOwnPace = false;         ///< estimate from the median of the rater's last cases; false: from the
                                    ///< length of the recordings
  bool calibrationWaiting = false;  ///< there are reference runs without this rater's score
  std::size_t disagreements = 0;    ///< cases pending in the discrepancy review
  std::size_t models = 0;           ///< models not yet submitted in the actor's evaluations
  std::optional<std::string>
      next{};  ///< assignment for "continue": the first draft, else the first one waiting
};

/// kMarkSubmit.
[[nodiscard]] ReviewQueue reviewQueue(SessionContext& session);

/// Returns the actor's live cases that were called or submitted, in the order of the calls: scored without a
/// recording. kMarkSubmit.
[[nodiscard]] std::vector<QueueLine> liveLines(SessionContext& session);

/// What a rater's page does about an open call.
struct CallGuide {
  std::optional<QueueLine> called{};  ///< the latest open call without the rater's sheet, if it is not shown
  bool opens = false;                 ///< its sheet is to be opened by itself
  bool otherRoom = false;             ///< the trainee of the sheet shown is at another arm
};
/// Decides whether the page follows a call: not while a sheet is begun or its trainee is still at the arm,
/// and each call once. `lines`: liveLines(). `shown`: the sheet on the page, may be empty. `busy`: it has
/// changes that are not stored, or a running timer. `followed`: the sheet last opened by itself. Pure
/// function.
[[nodiscard]] CallGuide guideToCall(const std::vector<QueueLine>& lines, const AssignmentId& shown, bool busy,
                                    const AssignmentId& followed);
/// Returns whether calls are going on, so that a waiting page is not locked: one is open, or was made within
/// the last half hour. Pure function.
[[nodiscard]] bool callsGoOn(const std::vector<QueueLine>& lines, std::int64_t now_us);
/// Returns whether a sheet was sealed on an earlier day, so that a list of today leaves it out. Pure
/// function.
[[nodiscard]] bool isOfEarlierDay(const QueueLine& line, std::int64_t now_us);

}  // namespace torsio
