// SPDX-License-Identifier: GPL-3.0-or-later
// HTTP: limits, contradictory requests, noise, and shutdown with pending requests.
#include <chrono>
#include <cstdint>
#include <cstdlib>
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
#include "tests/app/web/served_desk.h"
#include "tests/app/web/web_client.h"

namespace torsio::web {

namespace {

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
  const DeskAnswer both = client.raw("POST / HTTP/1.1\r\nConnection: close\r\n" + host +
                                     "Content-Length: 3\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n");
  EXPECT_TRUE(both.status == 400 || both.status == 0) << both.status;
  std::string chunks;
  for (int i = 0; i < 10; ++i) {
    chunks += "100\r\n" + std::string(0x100, 'a') + "\r\n";
  }
  const DeskAnswer chunked = client.raw("POST / HTTP/1.1\r\nConnection: close\r\n" + host +
                                        "Transfer-Encoding: chunked\r\n\r\n" + chunks + "0\r\n\r\n");
  EXPECT_EQ(chunked.status, 0) << "a body beyond the limit is not read to its end";
  std::string headers;
  for (int i = 0; i < 2000; ++i) {
    headers += "X-" + std::to_string(i) + ": " + std::string(100, 'a') + "\r\n";
  }
  const DeskAnswer many = client.raw("GET / HTTP/1.1\r\nConnection: close\r\n" + host + headers + "\r\n");
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

/// A server with one request that nobody has answered yet.
class PendingRequest {
 public:
  explicit PendingRequest(const HttpLimits& limits)
      : server_(std::make_unique<HttpServer>(anyPort(), TlsMaterial{}, limits,
                                             [this](const HttpRequest&, HttpServer::Reply reply) {
                                               const std::lock_guard lock(mutex_);
                                               reply_ = std::move(reply);
                                             })),
        client_([this, port = server_->port()] { answer_ = WebClient(port).get("/slow"); }) {
    for (bool asked = false; !asked;) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      const std::lock_guard lock(mutex_);
      asked = reply_ != nullptr;
    }
  }
  void reply(const std::string& body) { reply_({.body = body}); }
  /// Stops the server and returns what its client got.
  DeskAnswer stop() {
    server_.reset();
    client_.join();
    return answer_;
  }

 private:
  std::mutex mutex_;
  HttpServer::Reply reply_;
  DeskAnswer answer_;
  std::unique_ptr<HttpServer> server_;
  std::thread client_;
};

TEST(HttpServer, StopsWithAPendingRequest) {
  PendingRequest pending({.drain_s = 0});

  const DeskAnswer answer = pending.stop();

  EXPECT_TRUE(answer.status == 503 || answer.status == 0) << answer.status;
  pending.reply("too late");  // the connection has gone; the reply is dropped
}

TEST(HttpServer, AnswersWhatItReceivedBeforeItStops) {
  PendingRequest pending({});
  std::thread late([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    pending.reply("done");
  });

  const DeskAnswer answer = pending.stop();
  late.join();

  EXPECT_EQ(answer.status, 200);
  EXPECT_EQ(answer.body, "done");
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

// Attacks on web servers: each is refused, none crashes the program or causes an internal error. Includes a
// random run (TORSIO_SOAK=1: 10,000 requests).

std::string headOf(const WebClient& client, const std::string& line) {
  return line +
         " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nOrigin: http://localhost\r\nContent-Type: "
         "application/json\r\n" +
         "Cookie: " + client.cookie + "\r\nX-Torsio-Token: " + client.token + "\r\n";
}

DeskAnswer posted(const WebClient& client, const std::string& path, const std::string& body) {
  return client.raw(headOf(client, "POST " + path) + "Content-Length: " + std::to_string(body.size()) +
                    "\r\n\r\n" + body);
}

std::string nested(const std::string& open, const std::string& close, std::size_t depth) {
  std::string text;
  for (std::size_t i = 0; i < depth; ++i) {
    text += open;
  }
  text += "1";
  for (std::size_t i = 0; i < depth; ++i) {
    text += close;
  }
  return text;
}

TEST(WebAttacks, PathTraversalIsRefused) {
  const ServedDesk served;
  const WebClient client = served.physician(0);
  for (const char* path : {"/../../etc/passwd",
                           "/..%2f..%2fetc%2fpasswd",
                           "/%2e%2e/%2e%2e/etc/passwd",
                           "/....//....//etc/passwd",
                           "/app.js%00.html",
                           "/app.js/",
                           "//etc/passwd",
                           "/\\..\\..\\windows\\win.ini",
                           "/.git/config",
                           "/.env",
                           "/api/../app.js",
                           "/api/cases/../../queue",
                           "/api/cases/%2e%2e/sheet",
                           "/api/cases//sheet",
                           "/%",
                           "/%zz",
                           "/%u002e%u002e/",
                           "/api/queue?x=' OR '1'='1",
                           "/api/cases/' OR '1'='1",
                           "/api/cases/1;DROP TABLE person",
                           "/api/cases/${jndi:ldap://x}",
                           "/cgi-bin/test.cgi",
                           "/wp-login.php",
                           "/server-status",
                           "http://evil.example/",
                           "*",
                           "/api/cases/<script>alert(1)</script>"}) {
    const DeskAnswer answer = client.raw(headOf(client, std::string("GET ") + path) + "\r\n");
    const bool query = std::string(path).find('?') != std::string::npos;
    EXPECT_TRUE(query || answer.status != 200) << path;
    EXPECT_LT(answer.status, 500) << path;
    EXPECT_EQ(answer.body.find("root:"), std::string::npos) << path;
    EXPECT_EQ(answer.body.find("<script>"), std::string::npos) << path;
  }
}

TEST(WebAttacks, ContradictoryRequestsAreRefused) {
  const ServedDesk served;
  const WebClient client = served.physician(0);
  const std::string host = "Host: localhost\r\nConnection: close\r\n";
  const std::vector<std::string> requests = {
      "GET / HTTP/0.9\r\n" + host + "\r\n",
      "GET / HTTP/9.9\r\n" + host + "\r\n",
      "TRACE / HTTP/1.1\r\n" + host + "\r\n",
      "CONNECT evil.example:443 HTTP/1.1\r\n" + host + "\r\n",
      "PROPFIND / HTTP/1.1\r\n" + host + "\r\n",
      "POST /api/sign-in HTTP/1.1\r\n" + host + "Transfer-Encoding: chunked, chunked\r\n\r\n0\r\n\r\n",
      "POST /api/sign-in HTTP/1.1\r\n" + host +
          "Transfer-Encoding: xchunked\r\nContent-Length: 4\r\n\r\nabcd",
      "POST /api/sign-in HTTP/1.1\r\n" + host + "Content-Length: 0x10\r\n\r\nabcdabcdabcdabcd",
      "POST /api/sign-in HTTP/1.1\r\n" + host + "Content-Length: 99999999999999999999\r\n\r\n",
      "POST /api/sign-in HTTP/1.1\r\n" + host + "Content-Length: -1\r\n\r\n",
      "GET / HTTP/1.1\r\nHost: a\r\nHost: b\r\nConnection: close\r\n\r\n",
      "GET / HTTP/1.1\r\n" + host + "X: a\r\n b\r\n\tc\r\n\r\n",
      "GET / HTTP/1.1\r\n" + host + "Cookie: " + std::string(20'000, ';') + "\r\n\r\n",
      "GET / HTTP/1.1\r\n" + host + "Range: bytes=0-0,1-1,2-2,0-18446744073709551615\r\n\r\n",
      "GET /api/me HTTP/1.1\r\n" + host + "Cookie: __Host-torsio=" + std::string(9'000, 'a') + "\r\n\r\n",
      "GET /api/me HTTP/1.1\r\n" + host + "X-Forwarded-For: 127.0.0.1\r\nREMOTE_ADDR: 127.0.0.1\r\n\r\n",
      "GET / HTTP/1.1\r\n" + host + "Accept-Language: " + std::string(8'000, 'z') + "\r\n\r\n",
      "GET / HTTP/1.1\r\n" + host + "X-Torsio-Language: ../../zh_CN\r\n\r\n"};
  for (const std::string& request : requests) {
    WebClient noisy(served.server->port());
    noisy.patience_ms = 200;  // nobody answers half a request
    const DeskAnswer answer = noisy.raw(request);
    EXPECT_NE(answer.status, 500) << request.substr(0, 120);
    EXPECT_EQ(answer.headers.count("set-cookie"), 0U) << request.substr(0, 120);
  }
  WebClient alive(served.server->port());
  EXPECT_EQ(alive.get("/").status, 200);
}

TEST(WebAttacks, MaliciousBodiesAreRefused) {
  const ServedDesk served;
  WebClient client = served.physician(0);
  const std::string path = "/api/cases/" + firstCase(client) + "/submit";
  constexpr std::size_t kDeep = 40'000;  // the depth that fits 256 KB, and more than a thread's stack allows
  const std::vector<std::string> bodies = {
      "{\"sheet\":" + nested("[", "]", kDeep) + "}",
      nested("{\"sheet\":", "}", 20'000),
      "{\"sheet\":" + nested("[", "", kDeep),
      "{\"sheet\":{\"rows\":" + nested("[", "]", 5) + "}}",
      "{\"__proto__\":{\"sheet\":1},\"constructor\":{\"prototype\":1}}",
      "{\"sheet\":1,\"sheet\":{\"rows\":[]},\"sheet\":null}",
      "{\"sheet\":{\"rows\":1e999}}",
      "{\"sheet\":{\"rows\":[],\"revision\":1e308,\"comment\":\"\\u0000\\ud800\"}}",
      "\xEF\xBB\xBF{}",
      "{\"sheet\":\"\xff\xfe\"}",
      "<?xml version=\"1.0\"?><!DOCTYPE x [<!ENTITY y SYSTEM \"file:///etc/passwd\">]><x>&y;</x>",
      "a=b&c=d",
      "",
      "null",
      std::string(250'000, ' '),
      std::string(1, '\0')};
  for (const std::string& body : bodies) {
    const DeskAnswer answer = posted(client, path, body);
    EXPECT_EQ(answer.status, 400) << body.substr(0, 60);
  }
  EXPECT_EQ(client.get("/api/me").status, 200);
}

/// Changes some bytes of a valid request.
std::string spoiled(std::string request, Random& random) {
  const std::uint64_t times = 1 + random.bounded(8);
  for (std::uint64_t i = 0; i < times && !request.empty(); ++i) {
    const std::size_t at = random.bounded(request.size());
    switch (random.bounded(4)) {
      case 0:
        request[at] = static_cast<char>(random.bounded(256));
        break;
      case 1:
        request.erase(at, 1 + random.bounded(12));
        break;
      case 2:
        request.insert(at, request.substr(random.bounded(request.size()), 1 + random.bounded(40)));
        break;
      default:
        request.insert(at, std::string(1 + random.bounded(30), static_cast<char>(random.bounded(256))));
    }
  }
  return request;
}

TEST(WebAttacks, CorruptedRequestsAreRefusedOrUnderstood) {
  const ServedDesk served;
  WebClient client = served.physician(0);
  const std::string handle = firstCase(client);
  std::vector<std::string> right;
  for (const Route& route : served.desk->router().routes()) {
    if (route.path == "/api/sign-out") {
      continue;
    }
    const std::string body = sheetBody(0, 70, 80, 75).dump();
    const std::string line = headOf(client, route.method + " " + pathOf(route, handle));
    right.push_back(route.method == "GET"
                        ? line + "\r\n"
                        : line + "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body);
  }
  const bool soak = std::getenv("TORSIO_SOAK") != nullptr;
  const int times = soak ? 10'000 : 150;
  int answered = 0;
  Random random(29);
  for (int i = 0; i < times; ++i) {
    const std::string request = spoiled(right[random.bounded(right.size())], random);
    WebClient noisy(served.server->port());
    noisy.patience_ms = 20;  // nobody answers half a request
    const int status = noisy.raw(request).status;
    EXPECT_NE(status, 500) << i << ": " << request;
    answered += status == 0 ? 0 : 1;
  }
  EXPECT_GT(answered, 0);
  RecordProperty("answered", answered);
  EXPECT_EQ(client.get("/api/texts").status, 200);
}

}  // namespace

}  // namespace torsio::web
