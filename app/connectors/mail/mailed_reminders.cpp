// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/mail/mailed_reminders.h"

#include <optional>

#include "app/connectors/mail/mail_settings.h"
#include "app/connectors/mail/smtp_client.h"
#include "sim/core/error.h"

namespace torsio {

std::vector<Text> sendReminders(SessionContext& session, const std::string& password,
                                std::span<const MailedReminder> mailed, const ProgressCallback& progress) {
  session.require(Operation::kStudySetup);
  std::optional<MailSettings> settings = mailSettings(session);
  if (!settings) {
    refuseParameter(Text::tr("the centre has set no mail server"), "", Text::tr("Set one first"));
  }
  settings->server.password = password;
  std::vector<MailMessage> messages;
  for (const MailedReminder& one : mailed) {
    messages.push_back({settings->from, one.reminder.email, one.subject, one.body});
  }
  return sendMail(settings->server, messages, session.now_us(), progress, [&](std::size_t index) {
    noteReminders(session, {&mailed[index].reminder, 1}, ReminderWay::kMail);
  });
}

}  // namespace torsio
