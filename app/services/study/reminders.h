// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "assessment/domain/ids.h"

namespace torsio {

/// A sheet that somebody waits for. Its case label is all that its rater knows of it.
struct SheetAwaited {
  std::string caseLabel{};
  bool live = false;
  std::int64_t calledUtc_us = 0;            ///< live: when the trainee stood at the arm
  std::optional<std::int64_t> dueUtc_us{};  ///< recorded: the deadline
  bool late = false;                        ///< past its deadline, or the call has ended
};
/// A rater who still owes sheets.
struct Reminder {
  RaterId raterId{};
  std::string raterCode{};
  std::string name{};                  ///< empty: who asks may not see names, or none is kept
  std::string email{};                 ///< the same
  std::vector<SheetAwaited> sheets{};  ///< late ones first, then by label
};
/// Whom to remind: of live sheets that were called, and of recorded cases that are open. Raters by code;
/// those who owe nothing are left out. kStudySetup.
[[nodiscard]] std::vector<Reminder> reminders(SessionContext& session, const CohortId& cohortId);

/// How somebody is reminded.
enum class ReminderWay {
  kMail,    ///< the mail server took the message
  kCopied,  ///< the words were copied, for a message that Torsio does not see
};
/// Audited: an entry for each rater, with the labels of the cases. kStudySetup.
void noteReminders(SessionContext& session, std::span<const Reminder> reminded, ReminderWay way);

}  // namespace torsio
