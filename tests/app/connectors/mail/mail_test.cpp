// SPDX-License-Identifier: GPL-3.0-or-later
// Messages to a mail server on this computer.
#include <QByteArray>
#include <gtest/gtest.h>

#include "app/connectors/mail/mail_settings.h"
#include "app/connectors/mail/smtp_client.h"
#include "sim/core/error.h"
#include "tests/app/support/study_centre.h"
#include "tests/support/fake_mail_server.h"

namespace torsio {
namespace {

constexpr std::int64_t kNoon_us = 1'763'726'400'000'000;  // 2025-11-21 12:00 UTC

MailServer here(quint16 port) {
  return {.host = "127.0.0.1", .port = port, .encryption = MailEncryption::kNone};
}

std::string bodyOf(const std::string& text) {
  return QByteArray::fromBase64(QByteArray::fromStdString(text.substr(text.find("\n\n")))).toStdString();
}

ErrorCode refusalOf(const auto& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.code();
  }
  return ErrorCode::kInternal;
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

  EXPECT_EQ(refusalOf([&] { (void)sendMail(way, {&message, 1}, kNoon_us); }), ErrorCode::kFileUnreadable);

  EXPECT_TRUE(server.taken().empty());
}

TEST(Mail, AddressesCannotInjectHeadersOrRecipients) {
  for (const char* address :
       {"", "li", "@example.org", "li@", "li@example.org\r\nBcc: all@example.org", "li@example.org>",
        "li wang@example.org", "li@a@b", "l\u00ef@example.org", (std::string(250, 'x') + "@a.b").c_str()}) {
    EXPECT_EQ(refusalOf([&] { checkAddress(address); }), ErrorCode::kBadParameter) << address;
  }
  EXPECT_NO_THROW(checkAddress("li.na+study@mail.example.org"));
  const std::string text = written({"a@b.c", "d@e.f", "Two\r\nBcc: all@example.org", "x"}, "id", kNoon_us);
  EXPECT_EQ(text.find("Bcc"), std::string::npos) << text;
  EXPECT_NE(text.find(QByteArray("Two  Bcc: all@example.org").toBase64().toStdString()), std::string::npos)
      << "no line end hides in the packed words either: " << text;
}

TEST(Mail, NothingIsSentUnencryptedToAnotherComputerAndASilentServerIsReported) {
  const MailMessage message{"office@example.org", "li@example.org", "Sheets", "case 7L"};
  EXPECT_EQ(refusalOf([&] {
              (void)sendMail({.host = "mail.example.org", .encryption = MailEncryption::kNone}, {&message, 1},
                             kNoon_us);
            }),
            ErrorCode::kBadParameter);
  for (const char* host : {"127.0.0.1.example.org", "127.example.org", "localhost.example.org"}) {
    EXPECT_EQ(refusalOf([&] {
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
  EXPECT_EQ(refusalOf([&] {
              (void)sendMail(here(closed), {&message, 1}, kNoon_us);
            }),
            ErrorCode::kFileUnreadable);
}

TEST(MailSettings, AreStoredWithoutAPasswordAndCanBeRemoved) {
  testing::StudyCentre centre;
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
  EXPECT_EQ(refusalOf([&] { setMailSettings(centre.as("administrator"), settings); }),
            ErrorCode::kBadParameter);
  setMailSettings(centre.as("administrator"), {});
  EXPECT_FALSE(mailSettings(centre.as("administrator")));
}

}  // namespace
}  // namespace torsio
