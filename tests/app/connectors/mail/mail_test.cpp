// SPDX-License-Identifier: GPL-3.0-or-later
// Messages to a mail server on this computer.
#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <QByteArray>
#include <gtest/gtest.h>

#include "app/connectors/mail/mailing.h"
#include "app/connectors/mail/smtp_client.h"
#include "app/services/access/audit_service.h"
#include "sim/core/error.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/fake_mail_server.h"
#include "tests/support/refusal.h"

namespace torsio {
namespace {

using testing::refusalCode;

constexpr std::int64_t kNoon_us = 1'763'726'400'000'000;  // 2025-11-21 12:00 UTC

MailServer here(quint16 port) {
  return {.host = "127.0.0.1", .port = port, .encryption = MailEncryption::kNone};
}

std::string bodyOf(const std::string& text) {
  return QByteArray::fromBase64(QByteArray::fromStdString(text.substr(text.find("\n\n")))).toStdString();
}

TEST(Mail, DeliversToKnownRecipientsAndReportsRejectedOnes) {
  testing::FakeMailServer server;
  MailServer way = here(server.port());
  way.user = "office";
  way.password = "a good one";
  const std::vector<MailMessage> messages{
      {"office@example.org", "li@example.org", "Caf\u00e9: \u8bc4\u5206\u8868", "case 7L\n.\ncase 9F"},
      {"office@example.org", "nobody@example.org", "Sheets", "case 1A"},
      {"office@example.org", "wang@example.org", "Sheets", std::string(500, 'x')}};

  const std::vector<Text> refusals = sendMail(way, messages, kNoon_us);

  EXPECT_EQ(refusals, (std::vector<Text>{"", std::string("550 nobody of this name"), ""}));
  ASSERT_EQ(server.taken().size(), 2U);
  const testing::FakeMailServer::Taken& first = server.taken()[0];
  EXPECT_EQ(first.to, "li@example.org");
  EXPECT_NE(first.text.find("Date: 21 Nov 2025 12:00:00 +0000\n"), std::string::npos) << first.text;
  EXPECT_NE(first.text.find("Subject: =?UTF-8?B?" +
                            QByteArray("Caf\u00e9: \u8bc4\u5206\u8868").toBase64().toStdString() + "?=\n"),
            std::string::npos)
      << first.text;
  EXPECT_EQ(bodyOf(first.text), "case 7L\r\n.\r\ncase 9F") << "a line with a dot alone ends nothing";
  EXPECT_EQ(server.taken()[1].to, "wang@example.org");
  EXPECT_EQ(bodyOf(server.taken()[1].text), std::string(500, 'x'));
}

TEST(Mail, AWrongPasswordIsReportedAndNothingIsSent) {
  testing::FakeMailServer server;
  MailServer way = here(server.port());
  way.user = "office";
  way.password = "a bad one";
  const MailMessage message{"office@example.org", "li@example.org", "Sheets", "case 7L"};

  EXPECT_EQ(refusalCode([&] { (void)sendMail(way, {&message, 1}, kNoon_us); }), ErrorCode::kFileUnreadable);

  EXPECT_TRUE(server.taken().empty());
}

TEST(Mail, AddressesCannotInjectHeadersOrRecipients) {
  for (const char* address :
       {"", "li", "@example.org", "li@", "li@example.org\r\nBcc: all@example.org", "li@example.org>",
        "li wang@example.org", "li@a@b", "l\u00ef@example.org", (std::string(250, 'x') + "@a.b").c_str()}) {
    EXPECT_EQ(refusalCode([&] { checkAddress(address); }), ErrorCode::kBadParameter) << address;
  }
  EXPECT_NO_THROW(checkAddress("li.na+study@mail.example.org"));
  const std::string text = written({"a@b.c", "d@e.f", "Two\r\nBcc: all@example.org", "x"}, "id", kNoon_us);
  EXPECT_EQ(text.find("Bcc"), std::string::npos) << text;
  EXPECT_NE(text.find(QByteArray("Two  Bcc: all@example.org").toBase64().toStdString()), std::string::npos)
      << "no line end hides in the packed words either: " << text;
}

TEST(Mail, NothingIsSentUnencryptedToAnotherComputerAndASilentServerIsReported) {
  const MailMessage message{"office@example.org", "li@example.org", "Sheets", "case 7L"};
  EXPECT_EQ(refusalCode([&] {
              (void)sendMail({.host = "mail.example.org", .encryption = MailEncryption::kNone}, {&message, 1},
                             kNoon_us);
            }),
            ErrorCode::kBadParameter);
  for (const char* host : {"127.0.0.1.example.org", "127.example.org", "localhost.example.org"}) {
    EXPECT_EQ(refusalCode([&] {
                (void)sendMail({.host = host, .encryption = MailEncryption::kNone}, {&message, 1}, kNoon_us);
              }),
              ErrorCode::kBadParameter)
        << host;
  }
  quint16 closed = 0;
  {
    testing::FakeMailServer server;
    closed = server.port();
    (void)sendMail(here(closed), {}, kNoon_us);
  }
  EXPECT_EQ(refusalCode([&] {
              (void)sendMail(here(closed), {&message, 1}, kNoon_us);
            }),
            ErrorCode::kFileUnreadable);
}

TEST(MailSettings, AreStoredWithoutAPasswordAndCanBeRemoved) {
  StudyCentre centre;
  EXPECT_FALSE(mailSettings(centre.as("administrator")));
  MailSettings settings{{"mail.example.org", 465, MailEncryption::kTls, "office", "secret"},
                        "office@example.org"};

  setMailSettings(centre.as("administrator"), settings);

  const std::optional<MailSettings> kept = mailSettings(centre.as("administrator"));
  ASSERT_TRUE(kept);
  EXPECT_EQ(kept->server.host, "mail.example.org");
  EXPECT_EQ(kept->server.port, 465);
  EXPECT_EQ(kept->server.encryption, MailEncryption::kTls);
  EXPECT_EQ(kept->server.user, "office");
  EXPECT_EQ(kept->from, "office@example.org");
  EXPECT_TRUE(kept->server.password.empty());
  EXPECT_EQ(centre.audited("setting.change"), 1);
  settings.server.encryption = MailEncryption::kNone;
  EXPECT_EQ(refusalCode([&] { setMailSettings(centre.as("administrator"), settings); }),
            ErrorCode::kBadParameter);
  setMailSettings(centre.as("administrator"), {});
  EXPECT_FALSE(mailSettings(centre.as("administrator")));
}

// Messages over TLS to a server on this computer, and untrusted or misbehaving servers.

using testing::FakeMailServer;
using testing::MailManner;
using Way = MailManner::Way;

constexpr std::int64_t kEvening_us = 1'763'748'000'000'000;  // 2025-11-21 18:00 UTC
const std::vector<MailMessage> kTwo{{"office@example.org", "li@example.org", "Sheets", "case 7L"},
                                    {"office@example.org", "wang@example.org", "Sheets", "case 9F"}};

/// The sender trusts the tests' certificate authority.
class MailByTls : public ::testing::Test {
 protected:
  static MailServer to(const FakeMailServer& server, Way way) {
    return {.host = "127.0.0.1",
            .port = server.port(),
            .encryption = way == Way::kTls     ? MailEncryption::kTls
                          : way == Way::kClear ? MailEncryption::kNone
                                               : MailEncryption::kStartTls,
            .user = "office",
            .password = "a good one",
            .patience_s = 10,
            .authorities = TORSIO_TEST_DATA "/mail/authority.pem"};
  }
  /// Returns the error about the server; empty if the message was sent.
  static std::string refusal(const MailServer& way) {
    try {
      (void)sendMail(way, kTwo, kEvening_us);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kFileUnreadable);
      EXPECT_EQ(error.where(), "127.0.0.1");
      EXPECT_FALSE(error.remedy().empty());
      return error.happened();
    }
    return {};
  }
  static bool tellsASecret(const std::vector<std::string>& lines) {
    const std::string packed = QByteArray("a good one").toBase64().toStdString();
    return std::any_of(lines.begin(), lines.end(), [&](const std::string& line) {
      return line.starts_with("AUTH") || line.starts_with("MAIL") || line.find(packed) != std::string::npos;
    });
  }
};

TEST_F(MailByTls, BothEncryptionsDeliverWithoutUnencryptedContent) {
  for (const Way way : {Way::kTls, Way::kStartTls}) {
    FakeMailServer server({.way = way});

    const std::vector<Text> refusals = sendMail(to(server, way), kTwo, kEvening_us);

    EXPECT_EQ(refusals, (std::vector<Text>{"", ""}));
    ASSERT_EQ(server.taken().size(), 2U);
    EXPECT_EQ(server.taken()[1].to, "wang@example.org");
    EXPECT_EQ(server.inTheClear().size(), way == Way::kTls ? 0U : 2U) << "EHLO and STARTTLS";
    EXPECT_FALSE(tellsASecret(server.inTheClear()));
    EXPECT_TRUE(tellsASecret(server.encrypted()));
  }
}

TEST_F(MailByTls, SignsInByLoginIfOffered) {
  FakeMailServer server({.way = Way::kStartTls, .signIn = "AUTH LOGIN XOAUTH2"});

  EXPECT_EQ(refusal(to(server, Way::kStartTls)), "");

  EXPECT_EQ(server.taken().size(), 2U);
  EXPECT_TRUE(tellsASecret(server.encrypted()));
}

TEST_F(MailByTls, AnInvalidCertificateEndsTheConnectionBeforeAnythingIsSent) {
  for (const Way way : {Way::kTls, Way::kStartTls}) {
    for (const char* certificate : {"foreign.pem", "other_name.pem", "expired.pem"}) {
      FakeMailServer server({.way = way, .certificate = certificate});

      const std::string said = refusal(to(server, way));

      EXPECT_TRUE(said.starts_with("the mail server cannot be trusted: ")) << certificate << ": " << said;
      EXPECT_TRUE(server.taken().empty());
      EXPECT_FALSE(tellsASecret(server.inTheClear()));
      EXPECT_TRUE(server.encrypted().empty());
    }
  }
}

TEST_F(MailByTls, StrippedEncryptionIsDetectedAndNothingIsSent) {
  struct Case {
    MailManner manner{};
    std::string said{};
  };
  const std::vector<Case> cases{{{.way = Way::kClear}, "the mail server offers no safe encryption: "},
                                {{.way = Way::kStartTls, .instead = {{"STARTTLS", "454 not now"}}},
                                 "the mail server refuses: 454 not now"},
                                {{.way = Way::kStartTls, .instead = {{"STARTTLS", "220 go on in the clear"}}},
                                 "the mail server does not answer: "},
                                {{.way = Way::kStartTls, .behindStartTls = "250-AUTH PLAIN\r\n250 mine"},
                                 "the mail server offers no safe encryption: "}};
  for (const Case& one : cases) {
    FakeMailServer server(one.manner);
    MailServer way = to(server, Way::kStartTls);
    way.patience_s = 1;

    const std::string said = refusal(way);

    EXPECT_TRUE(said.starts_with(one.said)) << said << " for " << one.said;
    EXPECT_TRUE(server.taken().empty());
    EXPECT_FALSE(tellsASecret(server.inTheClear())) << one.said;
  }
}

TEST_F(MailByTls, APasswordIsSentOnlyIfRequestedAndAcceptedOnlyByItsReplyCode) {
  const std::vector<std::pair<MailManner, std::string>> cases{
      {{.way = Way::kTls, .signIn = ""}, "the mail server refuses the sign-in: "},
      {{.way = Way::kTls, .signIn = "AUTH CRAM-MD5"}, "the mail server refuses the sign-in: "},
      {{.way = Way::kTls, .password = "another"}, "the mail server refuses the sign-in: 535 wrong"},
      {{.way = Way::kTls, .instead = {{"AUTH", "334 "}}}, "the mail server refuses the sign-in: 334"},
      {{.way = Way::kTls, .instead = {{"GREETING", "554 no service"}}},
       "the mail server refuses: 554 no service"}};
  for (const auto& [manner, words] : cases) {
    FakeMailServer server(manner);

    const std::string said = refusal(to(server, Way::kTls));

    EXPECT_TRUE(said.starts_with(words)) << said << " for " << words;
    EXPECT_TRUE(server.taken().empty());
  }
}

TEST_F(MailByTls, TemporaryAndPermanentRejectionsAreReportedAndTheNextMessageIsSent) {
  FakeMailServer server({.way = Way::kTls,
                         .instead = {{"RCPT TO:<li@", "450 mailbox busy"},
                                     {"RCPT TO:<zhao@", "552-too large\r\n552 for everybody"},
                                     {"RCPT TO:<sun@", "354 not a number for this"}}});
  std::vector<MailMessage> messages = kTwo;
  messages.insert(messages.begin(), {"office@example.org", "zhao@example.org", "Sheets", "case 7L"});
  messages.insert(messages.begin(), {"office@example.org", "sun@example.org", "Sheets", "case 7L"});
  std::vector<std::size_t> taken;

  const std::vector<Text> refusals = sendMail(to(server, Way::kTls), messages, kEvening_us, {},
                                              [&](std::size_t index) { taken.push_back(index); });

  EXPECT_EQ(refusals, (std::vector<Text>{std::string("354 not a number for this"),
                                         std::string("552 too large for everybody"),
                                         std::string("450 mailbox busy"), ""}));
  EXPECT_EQ(taken, (std::vector<std::size_t>{3}));
  ASSERT_EQ(server.taken().size(), 1U);
  EXPECT_EQ(server.taken()[0].to, "wang@example.org");
}

TEST_F(MailByTls, ALostConnectionIsReportedForTheRemainingMessages) {
  const std::vector<std::pair<std::pair<std::string, std::string>, std::string>> cases{
      {{".", ""}, "it is not known whether the server accepted it: "},
      {{".", "drop"}, "it is not known whether the server accepted it: "},
      {{"DATA", "drop"}, "not sent: "},
      {{"MAIL", ""}, "not sent: "}};
  for (const auto& [instead, words] : cases) {
    FakeMailServer server({.way = Way::kTls, .instead = {instead}});
    MailServer way = to(server, Way::kTls);
    way.patience_s = 1;

    const std::vector<Text> refusals = sendMail(way, kTwo, kEvening_us);

    ASSERT_EQ(refusals.size(), 2U);
    EXPECT_TRUE(refusals[0].str().starts_with(words)) << refusals[0];
    EXPECT_TRUE(refusals[1].str().starts_with("not sent: ")) << refusals[1];
  }
  FakeMailServer silent({.way = Way::kTls, .instead = {{"GREETING", ""}, {"QUIT", ""}}});
  MailServer way = to(silent, Way::kTls);
  way.patience_s = 1;
  EXPECT_TRUE(refusal(way).starts_with("the mail server does not answer: "));
}

// Reminders by mail and their audit entries.

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
