// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"
#include "assessment/domain/people/person.h"

namespace torsio {

/// A missing sheet. Its rater knows only its case label.
struct SheetAwaited {
  std::string caseLabel{};
  bool live = false;
  std::int64_t calledUtc_us = 0;            ///< live: time of the call
  std::optional<std::int64_t> dueUtc_us{};  ///< recorded: the deadline
  bool late = false;                        ///< past its deadline, or the call has ended
};
/// A rater with missing sheets.
struct Reminder {
  RaterId raterId{};
  std::string raterCode{};
  std::string name{};                  ///< empty: the actor may not see names, or none is stored
  std::string email{};                 ///< like `name`
  std::vector<SheetAwaited> sheets{};  ///< late ones first, then by label
};
/// Returns whom to remind of called live sheets and open recorded cases. Raters by code; omits those without
/// missing sheets. kStudySetup.
[[nodiscard]] std::vector<Reminder> reminders(SessionContext& session, const CohortId& cohortId);

/// How a reminder was sent.
enum class ReminderWay {
  kMail,    ///< accepted by the mail server
  kCopied,  ///< text copied for a message outside Torsio
};
/// Audits reminders: an entry per rater, with the case labels. kStudySetup.
void noteReminders(SessionContext& session, std::span<const Reminder> reminded, ReminderWay way);

/// Result of reassignAll().
struct SheetsMoved {
  std::size_t moved = 0;
  std::size_t submitted = 0;     ///< unchanged: submitted in the meantime
  std::size_t askedAlready = 0;  ///< unchanged: the new rater is already assigned to these cases
};
/// Withdraws sheets that were not submitted; with `newRaterId`, assigns them to that rater under new labels.
/// A rater who lost such a sheet before gets it back with its draft; a withdrawn sheet can only go back to
/// its own rater. All or nothing; sheets that cannot be moved are skipped and counted. Audited for each
/// sheet. kStudySetup. Throws Error{kBadData} without a reason, for an unknown sheet or rater, or if nothing
/// can be moved.
SheetsMoved reassignAll(SessionContext& session, std::span<const AssignmentId> assignmentIds,
                        const RaterId& newRaterId, const std::string& reason);

}  // namespace torsio
