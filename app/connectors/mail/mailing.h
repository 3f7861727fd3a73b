// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/connectors/mail/smtp_client.h"
#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "app/services/study/open_sheets.h"
#include "assessment/domain/ids.h"
#include "sim/core/text.h"

namespace torsio {

/// The centre's mail server. Its password is never stored; the sender enters it.
struct MailSettings {
  MailServer server{};
  std::string from{};  ///< address of the sender
};

/// Empty: not set. kStudySetup.
[[nodiscard]] std::optional<MailSettings> mailSettings(SessionContext& session);
/// An empty host removes it. Audited. kSettingsEdit. Throws Error{kBadParameter} for an invalid address, a
/// host with spaces, or a server on another computer without encryption.
void setMailSettings(SessionContext& session, const MailSettings& settings);

/// A message to a user of the record, in the sender's language: an invitation link, or a request that waits.
struct MailedWord {
  UserId userId{};
  std::string subject{};
  std::string body{};
};

/// Whether links can be sent by mail: a server is set, and the actor may see addresses. kUserManage.
[[nodiscard]] bool canMailInvitations(SessionContext& session);
/// Sends each message to its person's address through the centre's mail server, signing in with `password`.
/// Returns one entry per message: empty if accepted, otherwise the refusal. Each accepted message is audited,
/// without text and address. kUserManage and kPersonViewIdentity. Throws Error{kBadParameter} if no server is
/// set, and what sendMail() throws. A worker thread.
[[nodiscard]] std::vector<Text> sendInvitations(SessionContext& session, const std::string& password,
                                                std::span<const MailedWord> mailed);

/// Whether another administrator can be told by mail of the actor's requests: a server is set, the actor may
/// see addresses, and one is known. kUserManage.
[[nodiscard]] bool canMailAdministrators(SessionContext& session);
/// Tells the other administrators whose addresses are known. Returns and audits like sendInvitations().
/// kUserManage and kPersonViewIdentity. Throws Error{kBadParameter} if no server is set, and what sendMail()
/// throws. A worker thread.
[[nodiscard]] std::vector<Text> mailAdministrators(SessionContext& session, const std::string& password,
                                                   const std::string& subject, const std::string& body);

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
