// SPDX-License-Identifier: GPL-3.0-or-later
// Built instead of the connector (TORSIO_MAIL=OFF): there is no server, and sending is refused.
#include "app/connectors/mail/mailing.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

[[noreturn]] void refuseMail() {
  throw Error(ErrorCode::kUsage, Text::tr("this program was built without mail"), Text(),
              Text::tr("Copy the message into your own mail"));
}

}  // namespace

std::optional<MailSettings> mailSettings(SessionContext& session) {
  session.require(Operation::kStudySetup);
  return std::nullopt;
}

void setMailSettings(SessionContext& session, const MailSettings& /*settings*/) {
  session.require(Operation::kSettingsEdit);
  refuseMail();
}

std::vector<Text> sendReminders(SessionContext& session, const std::string& /*password*/,
                                std::span<const MailedReminder> /*mailed*/,
                                const ProgressCallback& /*progress*/) {
  session.require(Operation::kStudySetup);
  refuseMail();
}

bool canMailInvitations(SessionContext& session) {
  session.require(Operation::kUserManage);
  return false;
}

std::vector<Text> sendInvitations(SessionContext& session, const std::string& /*password*/,
                                  std::span<const MailedWord> /*mailed*/) {
  session.require(Operation::kUserManage);
  refuseMail();
}

bool canMailAdministrators(SessionContext& session) {
  session.require(Operation::kUserManage);
  return false;
}

std::vector<Text> mailAdministrators(SessionContext& session, const std::string& /*password*/,
                                     const std::string& /*subject*/, const std::string& /*body*/) {
  session.require(Operation::kUserManage);
  refuseMail();
}

}  // namespace torsio
