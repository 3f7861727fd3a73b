// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/mail/mailing.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/connectors/mail/smtp_client.h"
#include "app/services/access/access_service.h"
#include "app/services/access/centre_settings.h"
#include "app/services/access/two_people.h"
#include "db/connection/connection.h"
#include "db/repository/people/people_repository.h"
#include "db/repository/system/setting_repository.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr std::array kEncryptions{"starttls", "tls", "none"};  // indexed by MailEncryption

}  // namespace

std::optional<MailSettings> mailSettings(SessionContext& session) {
  session.require(Operation::kStudySetup);
  const std::string stored = centreSetting<kMailServer>(session.connection());
  const nlohmann::json json = nlohmann::json::parse(stored, nullptr, false);
  if (!json.is_object() || json.value("host", "").empty()) {
    return std::nullopt;
  }
  MailSettings settings;
  settings.server.host = json.value("host", "");
  settings.server.port = json.value("port", settings.server.port);
  const auto encryption = std::find(kEncryptions.begin(), kEncryptions.end(), json.value("encryption", ""));
  settings.server.encryption = encryption == kEncryptions.end()
                                   ? MailEncryption::kStartTls
                                   : static_cast<MailEncryption>(encryption - kEncryptions.begin());
  settings.server.user = json.value("user", "");
  settings.from = json.value("from", "");
  return settings;
}

void setMailSettings(SessionContext& session, const MailSettings& settings) {
  session.require(Operation::kSettingsEdit);
  const std::string& host = settings.server.host;
  if (host.empty()) {
    setCentreSetting<kMailServer>(session, "");
    return;
  }
  if (std::any_of(host.begin(), host.end(), [](unsigned char letter) { return std::isspace(letter) != 0; })) {
    refuseParameter(Text::tr("not a server name"), host, Text::tr("Write it like mail.example.org"));
  }
  checkAddress(settings.from);
  requireProtectedWay(settings.server);
  setCentreSetting<kMailServer>(
      session,
      nlohmann::json{{"host", host},
                     {"port", settings.server.port},
                     {"encryption", kEncryptions[static_cast<std::size_t>(settings.server.encryption)]},
                     {"user", settings.server.user},
                     {"from", settings.from}}
          .dump());
}

namespace {

/// Mail addresses by user; users without one are left out.
std::map<UserId, std::string> addressesOf(SessionContext& session) {
  std::map<PersonId, std::string> ofPeople;
  for (const Identity& identity : PeopleRepository(session.connection()).identities()) {
    ofPeople[identity.personId] = identity.email;
  }
  std::map<UserId, std::string> addresses;
  for (const UserAccount& user : users(session)) {
    const auto found = ofPeople.find(user.personId);
    if (found != ofPeople.end() && !found->second.empty()) {
      addresses[user.id] = found->second;
    }
  }
  return addresses;
}

/// Sends each message to its user and audits the accepted ones as `action`.
std::vector<Text> sendToUsers(SessionContext& session, const std::string& password,
                              std::span<const MailedWord> mailed, AuditAction action) {
  session.require(Operation::kUserManage);
  session.require(Operation::kPersonViewIdentity);
  std::optional<MailSettings> settings = mailSettings(session);
  if (!settings) {
    refuseParameter(Text::tr("the centre has set no mail server"), "", Text::tr("Set one first"));
  }
  settings->server.password = password;
  const std::map<UserId, std::string> addresses = addressesOf(session);
  std::vector<Text> problems(mailed.size());
  std::vector<MailMessage> messages;
  std::vector<std::size_t> whose;
  for (std::size_t i = 0; i < mailed.size(); ++i) {
    const auto address = addresses.find(mailed[i].userId);
    if (address == addresses.end()) {
      problems[i] = Text::tr("no mail address is known");
      continue;
    }
    messages.push_back({settings->from, address->second, mailed[i].subject, mailed[i].body});
    whose.push_back(i);
  }
  if (messages.empty()) {
    return problems;
  }
  const std::vector<Text> said =
      sendMail(settings->server, messages, session.now_us(), {}, [&](std::size_t index) {
        Transaction transaction(session.connection());
        session.note(action, AuditObject::kAppUser, mailed[whose[index]].userId, {{"mailed", true}});
        transaction.commit();
      });
  for (std::size_t i = 0; i < said.size(); ++i) {
    problems[whose[i]] = said[i];
  }
  return problems;
}

}  // namespace

bool canMailInvitations(SessionContext& session) {
  session.require(Operation::kUserManage);
  return session.may(Operation::kPersonViewIdentity) && session.may(Operation::kStudySetup) &&
         mailSettings(session).has_value();
}

std::vector<Text> sendInvitations(SessionContext& session, const std::string& password,
                                  std::span<const MailedWord> mailed) {
  return sendToUsers(session, password, mailed, AuditAction::kInvitationMake);
}

bool canMailAdministrators(SessionContext& session) {
  if (!canMailInvitations(session)) {
    return false;
  }
  const std::map<UserId, std::string> addresses = addressesOf(session);
  const std::vector<UserAccount> others = otherAdministrators(session);
  return std::any_of(others.begin(), others.end(),
                     [&](const UserAccount& user) { return addresses.contains(user.id); });
}

std::vector<Text> mailAdministrators(SessionContext& session, const std::string& password,
                                     const std::string& subject, const std::string& body) {
  session.require(Operation::kUserManage);
  session.require(Operation::kPersonViewIdentity);
  const std::map<UserId, std::string> addresses = addressesOf(session);
  std::vector<MailedWord> mailed;
  for (const UserAccount& user : otherAdministrators(session)) {
    if (addresses.contains(user.id)) {
      mailed.push_back({user.id, subject, body});
    }
  }
  return sendToUsers(session, password, mailed, AuditAction::kReminderMail);
}

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
