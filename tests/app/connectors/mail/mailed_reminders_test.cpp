// SPDX-License-Identifier: GPL-3.0-or-later
// Reminders by mail and their audit entries.
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/connectors/mail/mail_settings.h"
#include "app/connectors/mail/mailing.h"
#include "app/services/access/audit_service.h"
#include "sim/core/error.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/fake_mail_server.h"

namespace torsio {
namespace {

using testing::FakeMailServer;
using testing::StudyCentre;

/// Three raters with a missing sheet each; the second one's address is rejected.
std::vector<MailedReminder> owedByThree(StudyCentre& centre) {
  const std::vector<RaterId> chiefs = centre.addChiefs(3);
  std::vector<MailedReminder> mailed;
  for (std::size_t i = 0; i < chiefs.size(); ++i) {
    MailedReminder one{.subject = "Sheets", .body = "case"};
    one.reminder.raterId = chiefs[i];
    one.reminder.email = i == 1 ? "nobody@example.org" : "chief@example.org";
    one.reminder.sheets = {{.caseLabel = "7" + std::string(1, static_cast<char>('A' + i))}};
    mailed.push_back(one);
  }
  return mailed;
}

void setServer(StudyCentre& centre, quint16 port) {
  MailSettings settings{.from = "office@example.org"};
  settings.server = {.host = "127.0.0.1", .port = port, .encryption = MailEncryption::kNone};
  setMailSettings(centre.as("administrator"), settings);
}

/// Details of this action's audit entries by the code of their subjects.
std::map<std::string, std::string> remindedBy(StudyCentre& centre, const std::string& action) {
  SessionContext& office = centre.as("administrator");
  const std::map<std::string, std::string> codes = auditSubjectCodes(office, 0);
  std::map<std::string, std::string> reminded;
  for (const AuditEntry& entry : auditEntries(centre.as("administrator"))) {
    if (entry.action == action) {
      reminded[codes.at(entry.objectId)] = entry.newJson;
    }
  }
  return reminded;
}

TEST(MailedReminders, OnlyAcceptedMessagesAreAudited) {
  StudyCentre centre;
  const std::vector<MailedReminder> mailed = owedByThree(centre);
  FakeMailServer server;
  setServer(centre, server.port());

  const std::vector<Text> refusals = sendReminders(centre.as("administrator"), "", mailed);

  EXPECT_EQ(refusals, (std::vector<Text>{"", std::string("550 nobody of this name"), ""}));
  EXPECT_EQ(
      remindedBy(centre, "reminder.mail"),
      (std::map<std::string, std::string>{{"R-01", R"({"cases":["7A"]})"}, {"R-03", R"({"cases":["7C"]})"}}));
}

TEST(MailedReminders, CancellingKeepsTheEntriesOfSentMessages) {
  StudyCentre centre;
  const std::vector<MailedReminder> mailed = owedByThree(centre);
  FakeMailServer server;
  setServer(centre, server.port());
  struct GivenUp {};

  EXPECT_THROW(
      (void)sendReminders(centre.as("administrator"), "", mailed, [](const Progress&) { throw GivenUp(); }),
      GivenUp);

  EXPECT_EQ(server.taken().size(), 1U);
  EXPECT_EQ(remindedBy(centre, "reminder.mail"),
            (std::map<std::string, std::string>{{"R-01", R"({"cases":["7A"]})"}}));
}

TEST(MailedReminders, WithoutAServerNothingIsSentAndCopiedOnesAreRecordedAsCopied) {
  StudyCentre centre;
  const std::vector<MailedReminder> mailed = owedByThree(centre);

  EXPECT_THROW((void)sendReminders(centre.as("administrator"), "", mailed), Error);
  noteReminders(centre.as("administrator"), std::vector<Reminder>{mailed[2].reminder}, ReminderWay::kCopied);

  EXPECT_TRUE(remindedBy(centre, "reminder.mail").empty());
  EXPECT_EQ(remindedBy(centre, "reminder.copy"),
            (std::map<std::string, std::string>{{"R-03", R"({"cases":["7C"]})"}}));
}

}  // namespace
}  // namespace torsio
