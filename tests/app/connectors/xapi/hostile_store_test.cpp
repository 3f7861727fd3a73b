// SPDX-License-Identifier: GPL-3.0-or-later
// A learning record store that means harm, or that somebody put in the place of the centre's: whatever it
// answers, the client gives up in time, takes little memory, goes nowhere else, and nothing is lost.
#include <functional>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/app/connectors/xapi/xapi_centre.h"
#include "tests/support/cost.h"
#include "tests/support/raw_server.h"

namespace torsio {
namespace {

using testing::Cost;
using testing::RawServer;

constexpr std::chrono::milliseconds kPatience{2'000};
constexpr double kLongest_s = 3.5;
constexpr std::int64_t kMaxMemory_bytes = 100'000'000;
constexpr std::size_t kMegabyte = 1'048'576;

/// An answer, and what the client makes of it: a status, or none.
struct Hostile {
  const char* name;
  std::function<void(RawServer::Guest&)> talk;
  int status;
  const char* said;
};

/// Half a megabyte that begins like a gzip stream (RFC 1952): it must come as it is, whatever it would grow
/// to.
std::string packed() {
  return std::string("\x1f\x8b\x08\x00\x00\x00\x00\x00\x00\x03", 10) + std::string(kMegabyte / 2, '\x55');
}

std::vector<Hostile> hostileStores() {
  const auto forever = [](RawServer::Guest& guest, const std::string& head, const std::string& more) {
    for (bool open = guest.say(head); open;) {
      open = guest.say(more);
    }
  };
  const std::string ok = "HTTP/1.1 200 OK\r\n";
  const auto whole = [](const std::string& head, const std::string& body) {
    return "HTTP/1.1 " + head + "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
  };
  return {
      {"one header without end",
       [=](auto& guest) { forever(guest, ok + "X: ", std::string(kMegabyte, 'x')); }, 0, "too long"},
      {"headers without end",
       [=](auto& guest) {
         std::string many;
         for (int i = 0; i < 10'000; ++i) {
           many += "X-" + std::to_string(i) + ": y\r\n";
         }
         forever(guest, ok, many);
       },
       0, ""},
      {"answers of status 100 without end",
       [=](auto& guest) { forever(guest, "", "HTTP/1.1 100 Continue\r\n\r\n"); }, 0, ""},
      {"a body without end", [=](auto& guest) { forever(guest, ok + "\r\n", std::string(kMegabyte, '[')); },
       0, "too long"},
      {"chunks without end",
       [=](auto& guest) {
         forever(guest, ok + "Transfer-Encoding: chunked\r\n\r\n",
                 "100000\r\n" + std::string(kMegabyte, '[') + "\r\n");
       },
       0, "too long"},
      {"a body of a petabyte, promised",
       [=](auto& guest) {
         guest.say(ok + "Content-Length: 1000000000000000\r\n\r\n[") && !guest.hear("\n").empty();
       },
       0, ""},
      {"a body of less than nothing", [=](auto& guest) { guest.say(ok + "Content-Length: -1\r\n\r\n[]"); }, 0,
       ""},
      {"a byte every tenth of a second",
       [=](auto& guest) {
         guest.trickle(whole("200 OK", std::string(600, ' ')), std::chrono::milliseconds(100));
       },
       0, ""},
      {"silence", [](auto& guest) { (void)guest.hear("never"); }, 0, ""},
      {"a redirect to itself",
       [=](auto& guest) { guest.say(whole("302 Found\r\nLocation: /xapi/statements", "")); }, 302, ""},
      {"a redirect to a file",
       [=](auto& guest) { guest.say(whole("307 Elsewhere\r\nLocation: file:///etc/passwd", "")); }, 307, ""},
      {"a gzip bomb", [=](auto& guest) { guest.say(whole("200 OK\r\nContent-Encoding: gzip", packed())); },
       200, ""},
      {"an end in the middle", [=](auto& guest) { guest.say(ok + "Content-Length: 90\r\n\r\n[\"1"); }, 0, ""},
      {"an end in the header", [=](auto& guest) { guest.say(ok + "Content-Le"); }, 200, ""},
      {"an end at once", [](auto& /*guest*/) {}, 0, ""},
      {"no HTTP", [](auto& guest) { guest.say("220 mail.example.org ESMTP\r\n"); }, 0, ""},
      {"a million brackets", [=](auto& guest) { guest.say(whole("200 OK", std::string(1'000'000, '['))); },
       200, ""},
      {"a status of nonsense", [=](auto& guest) { guest.say(whole("99999 What", "")); }, 0, ""},
      {"a wait of centuries",
       [=](auto& guest) { guest.say(whole("503 Busy\r\nRetry-After: 99999999999999999999", "")); }, 503, ""},
  };
}

TEST(HostileStore, WhateverItAnswersIsGivenUpInTimeWithLittleMemory) {
  for (const Hostile& one : hostileStores()) {
    SCOPED_TRACE(one.name);
    RawServer server([&](RawServer::Guest& guest) {
      (void)guest.hear("\r\n\r\n");
      one.talk(guest);
    });
    const Cost cost;
    LrsClient client("http://127.0.0.1:" + std::to_string(server.port()) + "/xapi", {"station", "secret"},
                     kPatience);

    const auto answer = client.post(R"({"id": "1"})");

    std::cout << "  " << one.name << ": " << cost << ", " << server.sent_bytes()
              << " bytes sent: " << answer.status << " " << (answer.status == 0 ? answer.body : "") << "\n";
    EXPECT_EQ(answer.status, one.status) << answer.body.substr(0, 200);
    EXPECT_LE(answer.body.size(), kMegabyte);
    if (std::string(one.name) == "a gzip bomb") {
      EXPECT_EQ(answer.body, packed()) << "unpacked by nobody";
    }
    EXPECT_EQ(server.guests(), 1) << "redirects are not followed";
    EXPECT_LT(cost.time_s(), kLongest_s);
    EXPECT_LT(cost.memory_bytes(), kMaxMemory_bytes);
    EXPECT_LT(server.sent_bytes(), std::int64_t{16} << 20);
    if (answer.status == 0) {
      EXPECT_NE(answer.body.find(one.said), std::string::npos) << answer.body;
    }
  }
}

TEST(HostileStore, NoAnswerLosesAnEntryOrKeepsTheQueueBusy) {
  XapiCentre centre;
  centre.turnOn();
  centre.enrol("T-01");
  centre.enrol("T-01");
  const auto identity = lrsIdentity(centre.connection());
  ASSERT_TRUE(identity);
  for (const Hostile& one : hostileStores()) {
    SCOPED_TRACE(one.name);
    RawServer server([&](RawServer::Guest& guest) {
      (void)guest.hear("\r\n\r\n");
      one.talk(guest);
    });
    LrsClient client("http://127.0.0.1:" + std::to_string(server.port()) + "/xapi", {"station", "secret"},
                     kPatience);
    centre.waitLong();
    const Cost cost;

    const LrsDelivery round = deliverLearningRecords(centre.connection(), *identity, client,
                                                     [&] { return centre.centre().session().now_us(); });

    EXPECT_TRUE(round.stopped);
    EXPECT_EQ(round.delivered + round.dead, 0);
    EXPECT_EQ(server.guests(), 1) << "one try tells that the store takes nothing";
    EXPECT_EQ(centre.counts().waiting, 2);
    EXPECT_LT(cost.time_s(), kLongest_s);
    EXPECT_LT(cost.memory_bytes(), kMaxMemory_bytes);
  }
  centre.waitLong();
  EXPECT_EQ(centre.deliver().delivered, 2);
}

TEST(HostileStore, NoOtherProtocolIsSpoken) {
  for (const char* address : {"file:///etc", "ftp://127.0.0.1", "gopher://127.0.0.1", "smtp://127.0.0.1"}) {
    LrsClient client(address, {"station", "secret"}, kPatience);
    EXPECT_EQ(client.get("passwd").status, 0) << address;
  }
}

}  // namespace
}  // namespace torsio
