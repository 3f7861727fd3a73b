// SPDX-License-Identifier: GPL-3.0-or-later
// Messages over TLS to a server on this computer, and untrusted or misbehaving servers.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <QByteArray>
#include <gtest/gtest.h>

#include "app/connectors/mail/smtp_client.h"
#include "sim/core/error.h"
#include "tests/support/fake_mail_server.h"

namespace torsio {
namespace {

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
      {{".", ""}, "it is not known whether it was taken: "},
      {{".", "drop"}, "it is not known whether it was taken: "},
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

}  // namespace
}  // namespace torsio
