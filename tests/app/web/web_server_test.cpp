// SPDX-License-Identifier: GPL-3.0-or-later
// HTTP: limits, contradictory requests, noise, and shutdown with pending requests.
#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/web/http_server.h"
#include "sim/core/error.h"
#include "sim/core/random.h"
#include "tests/app/web/web_client.h"

namespace torsio::web {
namespace {

using torsio::testing::WebAnswer;
using torsio::testing::WebClient;

/// Echoes the request.
void echo(HttpRequest request, const HttpServer::Reply& reply) {
  reply({.body = request.method + " " + request.path + " " + request.body});
}

HttpAddress anyPort() {
  return {"127.0.0.1", 0};
}

TEST(HttpServer, PassesRequestsAndAnswers) {
  const HttpServer server(anyPort(), {}, {}, echo);
  WebClient client(server.port());

  EXPECT_EQ(client.get("/a%20b?c=d").body, "GET /a b ");
  EXPECT_EQ(client.send("PUT", "/x", {{"n", 1}}).body, "PUT /x {\"n\":1}");
}

TEST(HttpServer, RejectsLargeAndContradictoryRequests) {
  const HttpServer server(anyPort(), {}, {.body_bytes = 1000}, echo);
  const WebClient client(server.port());
  const std::string host = "Host: x\r\n";

  EXPECT_EQ(client
                .raw("POST / HTTP/1.1\r\nConnection: close\r\n" + host + "Content-Length: 1001\r\n\r\n" +
                     std::string(1001, 'a'))
                .status,
            413);
  EXPECT_EQ(client
                .raw("POST / HTTP/1.1\r\nConnection: close\r\n" + host +
                     "Content-Length: 3\r\nContent-Length: 4\r\n\r\nabc")
                .status,
            400);
  const WebAnswer both = client.raw("POST / HTTP/1.1\r\nConnection: close\r\n" + host +
                                    "Content-Length: 3\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n");
  EXPECT_TRUE(both.status == 400 || both.status == 0) << both.status;
  std::string chunks;
  for (int i = 0; i < 10; ++i) {
    chunks += "100\r\n" + std::string(0x100, 'a') + "\r\n";
  }
  const WebAnswer chunked = client.raw("POST / HTTP/1.1\r\nConnection: close\r\n" + host +
                                       "Transfer-Encoding: chunked\r\n\r\n" + chunks + "0\r\n\r\n");
  EXPECT_EQ(chunked.status, 0) << "a body beyond the limit is not read to its end";
  std::string headers;
  for (int i = 0; i < 2000; ++i) {
    headers += "X-" + std::to_string(i) + ": " + std::string(100, 'a') + "\r\n";
  }
  const WebAnswer many = client.raw("GET / HTTP/1.1\r\nConnection: close\r\n" + host + headers + "\r\n");
  EXPECT_NE(many.status, 200);
}

TEST(HttpServer, SurvivesNoise) {
  const HttpServer server(anyPort(), {}, {}, echo);
  WebClient client(server.port());
  Random random(17);
  const std::vector<std::string> pieces = {
      "GET ",     "POST ", "/",        " HTTP/1.1",           "\r\n",
      "Host: a",  ":",     "\0",       "Content-Length: -5",  "Transfer-Encoding: chunked",
      "%00",      "..",    "Cookie: ", std::string(300, 'A'), "\xff\xfe",
      "0\r\n\r\n"};
  for (int i = 0; i < 300; ++i) {
    std::string noise;
    for (std::uint64_t k = 0; k < 1 + random.bounded(20); ++k) {
      noise += pieces[random.bounded(pieces.size())];
    }
    WebClient noisy(server.port());
    noisy.patience_ms = 5;  // nobody answers half a request
    EXPECT_NE(noisy.raw(noise).status, 500);
  }
  EXPECT_EQ(client.get("/alive").status, 200);
}

TEST(HttpServer, StopsWithAPendingRequest) {
  HttpServer::Reply kept;
  std::mutex mutex;
  auto server = std::make_unique<HttpServer>(anyPort(), TlsMaterial{}, HttpLimits{},
                                             [&](const HttpRequest&, HttpServer::Reply reply) {
                                               const std::lock_guard lock(mutex);
                                               kept = std::move(reply);
                                             });
  WebAnswer answer;
  std::thread waiting([&, port = server->port()] { answer = WebClient(port).get("/slow"); });
  for (bool asked = false; !asked;) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    const std::lock_guard lock(mutex);
    asked = kept != nullptr;
  }

  server.reset();
  waiting.join();

  EXPECT_TRUE(answer.status == 503 || answer.status == 0) << answer.status;
  kept({.body = "too late"});  // the connection has gone; the reply is dropped
}

TEST(HttpServer, ParsesAddresses) {
  EXPECT_EQ(addressOf("127.0.0.1:80").port, 80);
  EXPECT_EQ(addressOf("[::1]:8443").host, "::1");
  EXPECT_TRUE(addressOf("[::1]:8443").isLoopback());
  EXPECT_FALSE(addressOf("0.0.0.0:8443").isLoopback());
  for (const char* wrong : {"", "8443", "localhost:8443", "127.0.0.1:", "127.0.0.1:70000", "127.0.0.1:8x"}) {
    EXPECT_THROW((void)addressOf(wrong), Error) << wrong;
  }
}

TEST(HttpServer, ReportsAnAddressInUse) {
  const HttpServer first(anyPort(), {}, {}, echo);

  EXPECT_THROW(HttpServer({"127.0.0.1", first.port()}, {}, {}, echo), Error);
  EXPECT_THROW(HttpServer(anyPort(), {"no certificate", "no key"}, {}, echo), Error);
}

}  // namespace
}  // namespace torsio::web
