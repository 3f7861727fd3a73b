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

/// A reminder and its message, in the sender's language.
struct MailedReminder {
  Reminder reminder{};  ///< has a mail address
  std::string subject{};
  std::string body{};
};

/// Sends the reminders through the centre's mail server, signing in with `password`. Returns refusals like
/// sendMail(). Each accepted message is audited at once. kStudySetup. Throws Error{kBadParameter} if no
/// server is set, and what sendMail() throws. A worker thread.
[[nodiscard]] std::vector<Text> sendReminders(SessionContext& session, const std::string& password,
                                              std::span<const MailedReminder> mailed,
                                              const ProgressCallback& progress = {});

}  // namespace torsio
