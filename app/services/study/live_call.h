// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/live_call.h"
#include "assessment/domain/study/occasion.h"
#include "sim/core/text.h"

namespace torsio {

/// Whom to call to the real arm.
struct CallRequest {
  CohortId cohortId{};
  EnrolmentId enrolmentId{};
  std::string occasionCode{};  ///< empty: the one that is due
  std::string room{};
  /// Why now, where the curriculum says another time; becomes a deviation.
  std::string reason{};
};

/// A call as it would be made.
struct CallCheck {
  Occasion occasion{};
  /// Why the curriculum says another time: "has trained 0 of 40 min"; empty: it is due.
  std::optional<Text> objection{};
};
/// Reads only. kStudySetup. Throws Error{kBadData}: nobody of this cohort, withdrawn, no occasion is due, no
/// rater is asked for a live sheet, all sheets are in.
[[nodiscard]] CallCheck checkCall(SessionContext& session, const CallRequest& request);

/// Calls a trainee: from now on every rater who is asked finds the sheet open. The same case in the same room
/// again returns the call that is open. Audited. kStudySetup. Throws Error like checkCall(); {kBadParameter}:
/// no room, or an objection and no reason; {kBadData}: the room or the trainee is at another call.
LiveCallId callTrainee(SessionContext& session, const CallRequest& request);

/// The trainee has left the arm. Sheets that are not in yet stay open and count as late. Audited.
/// kStudySetup.
void endCall(SessionContext& session, const CohortId& cohortId, const LiveCallId& callId);
/// Somebody else stood there: the sheets are closed until the next call. Audited. kStudySetup. Throws
/// Error{kBadData} once a sheet of this call is submitted.
void cancelCall(SessionContext& session, const CohortId& cohortId, const LiveCallId& callId,
                const std::string& reason);

/// A call and how far its sheets are; no marks.
struct CalledCase {
  LiveCall call{};
  std::string caseLabel{};  ///< what the raters see
  std::string traineeCode{};
  Occasion occasion{};
  std::size_t asked = 0;
  std::size_t submitted = 0;
  std::vector<std::string> missing{};  ///< codes of raters whose sheet is not in
};
/// Calls that are open, and ended ones whose sheets are not all in; open ones first, then the oldest.
/// kStudySetup.
[[nodiscard]] std::vector<CalledCase> calledCases(SessionContext& session, const CohortId& cohortId);

/// Who is meant by a code that was typed or scanned, in any case and with blanks around it. kStudySetup.
/// Throws Error{kBadData}: nobody in this cohort.
[[nodiscard]] EnrolmentId enrolmentWithCode(SessionContext& session, const CohortId& cohortId,
                                            const std::string& code);

}  // namespace torsio
