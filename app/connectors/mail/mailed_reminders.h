// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "app/services/study/reminders.h"
#include "sim/core/text.h"

namespace torsio {

/// A reminder and the words of its message, in the language of whoever sends.
struct MailedReminder {
  Reminder reminder{};  ///< with a mail address
  std::string subject{};
  std::string body{};
};

/// Sends each by the mail server of the centre; `password`: of that server. Returns for each what speaks
/// against it, as sendMail(). Audited: an entry for each that the server took, as soon as it did.
/// kStudySetup. Throws Error{kBadParameter} when the centre has set no server, and what sendMail() throws. A
/// worker thread.
[[nodiscard]] std::vector<Text> sendReminders(SessionContext& session, const std::string& password,
                                              std::span<const MailedReminder> mailed,
                                              const ProgressCallback& progress = {});

}  // namespace torsio
