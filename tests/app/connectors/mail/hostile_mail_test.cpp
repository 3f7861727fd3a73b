// SPDX-License-Identifier: GPL-3.0-or-later
// A mail server that means harm, or that somebody put in the place of the centre's: whatever it answers, the
// sender gives up in time, takes little memory, sends no password in the clear and shows plain text.
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/connectors/mail/smtp_client.h"
#include "sim/core/error.h"
#include "tests/support/cost.h"
#include "tests/support/raw_server.h"

namespace torsio {
namespace {

using testing::Cost;
using testing::RawServer;
using Guest = RawServer::Guest;

constexpr std::int64_t kAny_us = 1'763'726'400'000'000;
constexpr int kPatience_s = 1;
constexpr double kLongest_s = 6.0;  // four times the patience for a message, and the farewell
constexpr std::int64_t kMaxMemory_bytes = 50'000'000;
constexpr std::size_t kMegabyte = 1'048'576;

struct Hostile {
  const char* name;
  std::function<void(Guest&)> talk;
  const char* said;  ///< part of what the sender is told
  MailEncryption encryption = MailEncryption::kNone;
};

void forever(Guest& guest, const std::string& words) {
  while (guest.say(words)) {
  }
}

/// Up to the sender's first command after the greeting.
void welcome(Guest& guest, const std::string& offers = "250 8BITMIME\r\n") {
  guest.say("220 here\r\n");
  (void)guest.hear("\r\n");
  guest.say(offers);
  (void)guest.hear("\r\n");
}

/// Takes commands and answers each with `words`; a message's text as well.
void answerAll(Guest& guest, const std::string& words) {
  for (std::string heard = "x"; !heard.empty() && guest.say(words);) {
    heard = guest.hear("\r\n");
  }
}

std::vector<Hostile> hostileServers() {
  const std::chrono::milliseconds tenth(100);
  std::string lines;
  for (int i = 0; i < 10'000; ++i) {
    lines += "220-line " + std::to_string(i) + "\r\n";
  }
  std::string offers = lines;
  for (std::size_t at = 0; (at = offers.find("220-", at)) != std::string::npos;) {
    offers.replace(at, 3, "250");
  }
  return {
      {"a greeting of one line without end", [](auto& guest) { forever(guest, std::string(kMegabyte, '2')); },
       "does not answer"},
      {"a greeting of lines without end", [=](auto& guest) { forever(guest, lines); }, "does not answer"},
      {"a greeting of one line, a byte every tenth of a second",
       [=](auto& guest) { guest.trickle(std::string(900, '2'), tenth); }, "does not answer"},
      {"a greeting of lines, one every tenth of a second",
       [=](auto& guest) {
         while (guest.say("220-wait\r\n")) {
           std::this_thread::sleep_for(tenth);
         }
       },
       "does not answer"},
      {"silence", [](auto& guest) { (void)guest.hear("never"); }, "does not answer"},
      {"an end at once", [](auto& /*guest*/) {}, "does not answer"},
      {"offers without end",
       [=](auto& guest) {
         guest.say("220 here\r\n");
         (void)guest.hear("\r\n");
         forever(guest, offers);
       },
       "does not answer"},
      {"offers of NUL without end",
       [=](auto& guest) {
         guest.say("220 here\r\n");
         (void)guest.hear("\r\n");
         forever(guest, std::string(kMegabyte, '\0'));
       },
       "does not answer"},
      {"a refusal without end",
       [=](auto& guest) {
         welcome(guest);
         for (bool open = true; open;) {
           open = guest.say("550-" + std::string(900, 'x') + "\r\n");
         }
       },
       ""},
      {"a farewell without end",
       [=](auto& guest) {
         welcome(guest);
         guest.say("554 no\r\n");
         (void)guest.hear("\r\n");
         for (bool open = true; open;) {
           open = guest.say("221-" + std::string(900, 'x') + "\r\n");
         }
       },
       ""},
      {"a farewell of lines, one every tenth of a second",
       [=](auto& guest) {
         welcome(guest);
         guest.say("554 no\r\n");
         (void)guest.hear("\r\n");
         while (guest.say("221-bye\r\n")) {
           std::this_thread::sleep_for(tenth);
         }
       },
       ""},
      {"every answer 999", [](auto& guest) { answerAll(guest, "999 no\r\n"); }, ""},
      {"every answer 000", [](auto& guest) { answerAll(guest, "000 no\r\n"); }, ""},
      {"every answer a word", [](auto& guest) { answerAll(guest, "welcome\r\n"); }, ""},
      {"every answer 334", [](auto& guest) { answerAll(guest, "334 more\r\n"); }, ""},
      {"every answer 354", [](auto& guest) { answerAll(guest, "354 more\r\n"); }, ""},
      {"every answer 421", [](auto& guest) { answerAll(guest, "421 go\r\n"); }, "421 go"},
      {"every answer empty", [](auto& guest) { answerAll(guest, "\r\n"); }, "does not answer"},
      {"a refusal that commands the terminal",
       [](auto& guest) {
         welcome(guest);
         answerAll(guest,
                   std::string("550 \x1b[2J\x07 \xff\xfe \u202egnp.exe\u2066 \u200b a") + '\0' + "b\r\n");
       },
       "550 \uFFFD[2J\uFFFD \uFFFD\uFFFD \uFFFDgnp.exe"},
      {"no encryption",
       [](auto& guest) {
         welcome(guest);
         answerAll(guest, "502 no\r\n");
       },
       "no safe encryption", MailEncryption::kStartTls},
      {"encryption that is refused",
       [](auto& guest) {
         welcome(guest, "250-STARTTLS\r\n250 AUTH PLAIN\r\n");
         answerAll(guest, "454 TLS not available\r\n");
       },
       "454 TLS not available", MailEncryption::kStartTls},
      {"encryption that never begins",
       [](auto& guest) {
         welcome(guest, "250-STARTTLS\r\n250 AUTH PLAIN\r\n");
         guest.say("220 go on\r\n");
         (void)guest.hear("never");
       },
       "does not answer", MailEncryption::kStartTls},
      {"encryption of noise without end",
       [](auto& guest) {
         welcome(guest, "250-STARTTLS\r\n250 AUTH PLAIN\r\n");
         guest.say("220 go on\r\n");
         (void)guest.hear("\x01");
         forever(guest, std::string(kMegabyte, 'x'));
       },
       "does not answer", MailEncryption::kStartTls},
      {"encryption that trickles",
       [=](auto& guest) {
         guest.trickle(std::string("\x16\x03\x03\x40\x00", 5) + std::string(900, 'x'), tenth);
       },
       "does not answer", MailEncryption::kTls},
  };
}

TEST(HostileMail, WhateverTheServerAnswersIsToldInTimeWithLittleMemory) {
  const MailMessage message{"office@example.org", "li@example.org", "Sheets", "case 7L"};
  for (const Hostile& one : hostileServers()) {
    SCOPED_TRACE(one.name);
    RawServer server(one.talk);
    bool taken = false;
    std::string told;
    const Cost cost;
    try {
      for (const Text& refusal : sendMail({.host = "127.0.0.1",
                                 .port = server.port(),
                                 .encryption = one.encryption,
                                 .user = one.encryption == MailEncryption::kNone ? "" : "office",
                                 .password = "a good one",
                                 .patience_s = kPatience_s},
                                          {&message, 1}, kAny_us, {}, [&](std::size_t) { taken = true; })) {
        told += refusal.str();
      }
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kFileUnreadable);
      told = error.what();
    }

    std::cout << "  " << one.name << ": " << cost << ", " << server.sent_bytes()
              << " bytes sent: " << told.substr(0, 100) << " (" << told.size() << " bytes)\n";
    EXPECT_FALSE(taken);
    EXPECT_FALSE(told.empty());
    EXPECT_NE(told.find(one.said), std::string::npos) << told.substr(0, 300);
    EXPECT_EQ(told, Text(told).str()) << "plain already";
    EXPECT_LT(told.size(), 2'000U) << "a sentence that a person can read";
    EXPECT_LT(cost.time_s(), kLongest_s);
    EXPECT_LT(cost.memory_bytes(), kMaxMemory_bytes);
    EXPECT_LT(server.sent_bytes(), std::int64_t{16} << 20);
  }
}

}  // namespace
}  // namespace torsio
