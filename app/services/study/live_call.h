// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/rating/assignment.h"
#include "assessment/domain/study/occasion.h"
#include "sim/core/text.h"

namespace torsio {

/// A trainee to call to the real arm.
struct CallRequest {
  CohortId cohortId{};
  EnrolmentId enrolmentId{};
  std::string occasionCode{};  ///< empty: the one due
  std::string room{};
  /// Required if the curriculum does not expect it now; recorded as a deviation.
  std::string reason{};
};

/// Result of checkCall().
struct CallCheck {
  Occasion occasion{};
  /// Why the curriculum does not expect it now: "has trained 0 of 40 min"; empty: it is due.
  std::optional<Text> objection{};
};
/// Checks a call without making it. kStudySetup. Throws Error{kBadData} if the person is not in this cohort
/// or withdrawn, no occasion is due, no live sheet is requested, or all sheets are in.
[[nodiscard]] CallCheck checkCall(SessionContext& session, const CallRequest& request);

/// Calls a trainee: opens the sheets of all assigned raters. Calling the same case in the same room again
/// returns the open call. Audited. kStudySetup. Throws Error like checkCall(); {kBadParameter} without a
/// room, or with an objection but no reason; {kBadData} if the room or the trainee is in another call.
LiveCallId callTrainee(SessionContext& session, const CallRequest& request);

/// Ends a call when the trainee leaves the arm. Missing sheets stay open and count as late. Audited.
/// kStudySetup.
void endCall(SessionContext& session, const CohortId& cohortId, const LiveCallId& callId);
/// Cancels a call made for the wrong person: closes the sheets until the next call. Audited. kStudySetup.
/// Throws Error{kBadData} once a sheet of this call is submitted.
void cancelCall(SessionContext& session, const CohortId& cohortId, const LiveCallId& callId,
                const std::string& reason);

/// A call and the progress of its sheets, without marks.
struct CalledCase {
  LiveCall call{};
  std::string caseLabel{};  ///< shown to raters
  std::string traineeCode{};
  Occasion occasion{};
  std::size_t asked = 0;
  std::size_t submitted = 0;
  std::vector<std::string> missing{};  ///< codes of raters with missing sheets
  /// The call is open and no sheet has been submitted since: cancelCall() accepts it.
  bool mayCancel = false;
};
/// Returns the codes of `missing`: "R-01, R-03".
[[nodiscard]] std::string missingCodes(const CalledCase& called);
/// Names the raters whose sheets are missing: "still to come: R-01" while the call is open, "missing: R-01"
/// after it. Empty if none is, or if the call is open and no sheet is in. `codes`: those raters, or
/// the first of them.
[[nodiscard]] Text missingText(const CalledCase& called, const std::string& codes);
/// Returns open calls, then ended ones with missing sheets, oldest first. kStudySetup.
[[nodiscard]] std::vector<CalledCase> calledCases(SessionContext& session, const CohortId& cohortId);

/// Returns the text of a message to the raters whose sheets of a case are missing.
[[nodiscard]] Text reminderText(const CalledCase& called);
/// Audits that this text was copied for a message outside Torsio. kStudySetup.
void noteCopiedReminder(SessionContext& session, const CohortId& cohortId, const CalledCase& called);

/// Returns a text that differs after each change of calls. Needs no right: it says nothing else.
[[nodiscard]] std::string callStamp(SessionContext& session);

/// Returns the enrolment of a typed or scanned code, ignoring case and surrounding spaces. kStudySetup.
/// Throws Error{kBadData} if it is not in this cohort.
[[nodiscard]] EnrolmentId enrolmentWithCode(SessionContext& session, const CohortId& cohortId,
                                            const std::string& code);

}  // namespace torsio
