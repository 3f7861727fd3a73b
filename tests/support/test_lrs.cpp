// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_lrs.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <functional>

#include <QHostAddress>
#include <QRegularExpression>
#include <QTcpServer>
#include <nlohmann/json.hpp>

namespace torsio::testing {

namespace {

constexpr int kLook_ms = 20;
constexpr int kPatience_ms = 30'000;

QByteArray reply(int status, const QByteArray& body, const QByteArray& more = {}) {
  return "HTTP/1.1 " + QByteArray::number(status) +
         " Said\r\nContent-Length: " + QByteArray::number(body.size()) +
         "\r\nContent-Type: application/json\r\nX-Experience-API-Version: 1.0.3\r\nConnection: close\r\n" +
         more + "\r\n" + body;
}

QByteArray headerOf(const QByteArray& head, const QByteArray& name) {
  for (const QByteArray& line : head.split('\n')) {
    if (line.toLower().startsWith(name.toLower() + ":")) {
      return line.mid(name.size() + 1).trimmed();
    }
  }
  return {};
}

bool isIri(const nlohmann::json& value) {
  static const QRegularExpression kIri(QStringLiteral("^[a-zA-Z][a-zA-Z0-9+.-]*:[^\\s<>\"{}|\\\\^`]+$"));
  return value.is_string() && kIri.match(QString::fromStdString(value.get<std::string>())).hasMatch();
}

bool holdsNull(const nlohmann::json& value) {
  return value.is_null() || (value.is_structured() && std::any_of(value.begin(), value.end(), holdsNull));
}

/// Returns the error of a statement (xAPI-Data 2.4); empty: none that matters here.
std::string errorOf(const nlohmann::json& statement) {
  static const QRegularExpression kUuid(
      QStringLiteral("^[0-9a-f]{8}-[0-9a-f]{4}-[1-5][0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}$"));
  static const QRegularExpression kTime(
      QStringLiteral("^\\d{4}-\\d\\d-\\d\\dT\\d\\d:\\d\\d:\\d\\d(\\.\\d+)?(Z|[+]\\d\\d:\\d\\d)$"));
  static const QRegularExpression kSpan(QStringLiteral("^PT\\d+\\.\\d\\dS$"));
  const auto text = [](const nlohmann::json& value) {
    return value.is_string() ? QString::fromStdString(value.get<std::string>()) : QString();
  };
  if (!statement.is_object() || holdsNull(statement)) {
    return "no object, or a null in it";
  }
  for (const auto& [key, value] : statement.items()) {
    const std::vector<std::string> known{"id", "actor", "verb", "object", "timestamp", "result", "context"};
    if (std::find(known.begin(), known.end(), key) == known.end()) {
      return "not of a sender: " + key;
    }
  }
  if (!kUuid.match(text(statement.value("id", nlohmann::json()))).hasMatch()) {
    return "the id is no UUID";
  }
  const nlohmann::json actor = statement.value("actor", nlohmann::json::object());
  if (actor.contains("name") || actor.contains("mbox") || actor.contains("openid") ||
      !isIri(actor.value("/account/homePage"_json_pointer, nlohmann::json())) ||
      text(actor.value("/account/name"_json_pointer, nlohmann::json())).isEmpty()) {
    return "the actor is not one account";
  }
  if (!isIri(statement.value("/verb/id"_json_pointer, nlohmann::json())) ||
      !isIri(statement.value("/object/id"_json_pointer, nlohmann::json())) ||
      !isIri(statement.value("/object/definition/type"_json_pointer, nlohmann::json()))) {
    return "verb, object or its type is no IRI";
  }
  if (!kTime.match(text(statement.value("timestamp", nlohmann::json()))).hasMatch()) {
    return "the time has no zone";
  }
  const nlohmann::json result = statement.value("result", nlohmann::json::object());
  if (result.contains("duration") && !kSpan.match(text(result["duration"])).hasMatch()) {
    return "the duration is none";
  }
  if (result.contains("score")) {
    const nlohmann::json& score = result["score"];
    if (score["scaled"] < -1.0 || score["scaled"] > 1.0 || score["raw"] < score["min"] ||
        score["raw"] > score["max"]) {
      return "the score is out of its bounds";
    }
  }
  const nlohmann::json extensions = result.value("extensions", nlohmann::json::object());
  for (const auto& [key, value] : extensions.items()) {
    if (!isIri(key)) {
      return "an extension is no IRI";
    }
  }
  return {};
}

}  // namespace

TestLrs::TestLrs() {
  std::atomic<quint16> port{0};
  thread_ = std::thread([this, &port] { serve(port); });
  while (port == 0) {
    std::this_thread::yield();
  }
  port_ = port;
}

TestLrs::~TestLrs() {
  stop_ = true;
  thread_.join();
  if (const char* file = std::getenv("TORSIO_LRS_OUT")) {  // for an external validator
    std::ofstream out(file, std::ios::app);
    for (const Stored& one : stored_) {
      out << one.bytes << "\n";
    }
  }
}

std::string TestLrs::endpoint() const {
  return "http://127.0.0.1:" + std::to_string(port_) + "/xapi";
}

void TestLrs::refuse(const std::string& part) {
  const std::lock_guard lock(mutex_);
  refused_ = part;
}

void TestLrs::put(const std::string& id, const std::string& bytes) {
  const std::lock_guard lock(mutex_);
  stored_.push_back({id, bytes});
}

std::vector<TestLrs::Stored> TestLrs::stored() const {
  const std::lock_guard lock(mutex_);
  return stored_;
}

std::vector<std::string> TestLrs::posted() const {
  const std::lock_guard lock(mutex_);
  return posted_;
}

std::vector<std::string> TestLrs::complaints() const {
  const std::lock_guard lock(mutex_);
  return complaints_;
}

void TestLrs::serve(std::atomic<quint16>& port) {
  QTcpServer server;
  server.listen(QHostAddress::LocalHost);
  port = server.serverPort();
  while (!stop_) {
    if (server.waitForNewConnection(kLook_ms)) {
      const std::unique_ptr<QTcpSocket> socket(server.nextPendingConnection());
      talk(*socket);
    }
  }
}

void TestLrs::talk(QTcpSocket& socket) {
  QByteArray heard;
  const auto more = [&] {
    for (int waited = 0; waited < kPatience_ms && !stop_; waited += kLook_ms) {
      if (socket.waitForReadyRead(kLook_ms)) {
        heard += socket.readAll();
        return true;
      }
      if (socket.state() != QAbstractSocket::ConnectedState) {
        return false;
      }
    }
    return false;
  };
  while (!heard.contains("\r\n\r\n")) {
    if (!more()) {
      return;
    }
  }
  const qsizetype end = heard.indexOf("\r\n\r\n") + 4;
  const QByteArray head = heard.left(end);
  while (heard.size() - end < headerOf(head, "Content-Length").toLongLong()) {
    if (!more()) {
      return;
    }
  }
  if (fault_ == Fault::kDropsBefore) {
    socket.abort();
    return;
  }
  if (fault_ == Fault::kHangs) {
    while (!stop_ && fault_ == Fault::kHangs && socket.state() == QAbstractSocket::ConnectedState) {
      (void)socket.waitForReadyRead(kLook_ms);
    }
    socket.abort();
    return;
  }
  const QByteArray answer = answerTo(head, heard.mid(end));
  if (fault_ == Fault::kDropsAfter) {
    socket.abort();
    return;
  }
  socket.write(answer);
  socket.waitForBytesWritten(kPatience_ms);
  socket.disconnectFromHost();
  if (socket.state() != QAbstractSocket::UnconnectedState) {
    socket.waitForDisconnected(kPatience_ms);
  }
}

QByteArray TestLrs::answerTo(const QByteArray& head, const QByteArray& body) {
  const std::lock_guard lock(mutex_);
  const Fault fault = fault_;
  const QByteArray asked = head.left(head.indexOf("\r\n"));
  const bool two = fault == Fault::kVersionTwo;
  if (asked.startsWith("GET /xapi/about ")) {
    return reply(200, two ? R"({"version": ["2.0.0"]})" : R"({"version": ["1.0.2", "1.0.3"]})");
  }
  if (!headerOf(head, "X-Experience-API-Version").startsWith(two ? "2.0" : "1.0")) {
    if (!two) {
      complaints_.emplace_back("no version header");
    }
    return reply(400, "no version");
  }
  const QByteArray expected = "Basic " + (QByteArray(kUser) + ":" + kSecret).toBase64();
  if (headerOf(head, "Authorization") != expected) {
    return reply(401, "who are you?");
  }
  if (asked.startsWith("GET /xapi/statements?statementId=")) {
    return read(asked.split('=').at(1).split(' ').front().toStdString(), fault);
  }
  if (!asked.startsWith("POST /xapi/statements ")) {
    complaints_.push_back("asked for " + asked.toStdString());
    return reply(404, "no such place");
  }
  posted_.push_back(body.toStdString());
  switch (fault) {
    case Fault::kBusy:
      return reply(503, "busy");
    case Fault::kBroken:
      return reply(500, "broken");
    case Fault::kTooMany:
      return reply(429, "slow down", "Retry-After: 7200\r\n");
    case Fault::kPage:
      return reply(200, "<html>Please sign in</html>");
    case Fault::kRedirects:
      return reply(302, "", "Location: http://127.0.0.1:1/elsewhere\r\n");
    case Fault::kNowhere:
      return reply(404, "no such place");
    case Fault::kRefuses:
      return reply(400, "this statement does not please");
    case Fault::kAnswers:
      return reply(status_, "as it was set");
    default:
      return keep(body, fault);
  }
}

QByteArray TestLrs::keep(const QByteArray& body, Fault fault) {
  const nlohmann::json statement = nlohmann::json::parse(body.toStdString(), nullptr, false);
  if (const std::string wrong = errorOf(statement); !wrong.empty()) {
    complaints_.push_back(wrong + ": " + body.toStdString());
    return reply(400, QByteArray::fromStdString(wrong));
  }
  if (!refused_.empty() && body.toStdString().find(refused_) != std::string::npos) {
    return reply(400, "this statement does not please");
  }
  const std::string id = statement["id"];
  const auto known =
      std::find_if(stored_.begin(), stored_.end(), [&](const Stored& one) { return one.id == id; });
  const bool conflicts = fault == Fault::kAlwaysConflicts || fault == Fault::kNotReadable;
  if (known == stored_.end()) {
    stored_.push_back({id, body.toStdString()});
  } else if (conflicts || nlohmann::json::parse(known->bytes, nullptr, false) != statement) {
    return reply(409, "known");
  }
  return reply(200, QByteArray::fromStdString(nlohmann::json::array({id}).dump()));
}

/// Returns it like a store: with additions, keys in another order.
QByteArray TestLrs::read(const std::string& id, Fault fault) const {
  const auto known =
      std::find_if(stored_.begin(), stored_.end(), [&](const Stored& one) { return one.id == id; });
  if (known == stored_.end() || fault == Fault::kNotReadable) {
    return reply(404, "not here");
  }
  nlohmann::json shown = nlohmann::json::parse(known->bytes);
  shown["stored"] = "2026-01-01T00:00:00.000Z";
  shown["version"] = "1.0.0";
  shown["authority"] = {{"mbox", "mailto:store@example.org"}};
  return reply(200, QByteArray::fromStdString(shown.dump()));
}

}  // namespace torsio::testing
