// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/base/web_answer.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

#include <QDeadlineTimer>
#include <QSslSocket>
#include <QUrl>

namespace torsio {

namespace {

constexpr int kHttpPort = 80;
constexpr int kHttpsPort = 443;

/// Splits status and body; empty if this is no whole answer.
std::optional<WebAnswer> answerIn(const QByteArray& heard) {
  const qsizetype end = heard.indexOf("\r\n\r\n");
  const bool http = heard.startsWith("HTTP/1.") && heard.size() > 12 && heard[8] == ' ';
  if (end < 0 || !http) {
    return std::nullopt;
  }
  WebAnswer answer{heard.mid(9, 3).toInt(), heard.mid(end + 4).toStdString()};
  for (const QByteArray& line : heard.left(end).split('\n')) {
    const qsizetype colon = line.indexOf(':');
    if (colon < 0 || line.left(colon).trimmed().toLower() != "content-length") {
      continue;
    }
    bool number = false;
    const qulonglong length = line.mid(colon + 1).trimmed().toULongLong(&number);
    if (!number || answer.body.size() < length) {
      return std::nullopt;
    }
    answer.body.resize(length);
  }
  return answer;
}

}  // namespace

// Not QNetworkAccessManager: its thread reads a header that never ends for as long as somebody sends it.
WebAnswer postedTo(const std::string& address, const std::string& contentType, const std::string& body,
                   std::chrono::milliseconds patience, std::size_t most_bytes) {
  const QUrl url(QString::fromStdString(address), QUrl::StrictMode);
  const bool secure = url.scheme() == QLatin1String("https");
  const QDeadlineTimer deadline(patience);
  const auto left_ms = [&deadline] { return static_cast<int>(std::max<qint64>(1, deadline.remainingTime())); };
  QSslSocket socket;
  const auto none = [&socket] { return WebAnswer{0, socket.errorString().toStdString()}; };
  const auto port = static_cast<quint16>(url.port(secure ? kHttpsPort : kHttpPort));
  if (secure) {
    socket.connectToHostEncrypted(url.host(), port);
  } else {
    socket.connectToHost(url.host(), port);
  }
  if (!(secure ? socket.waitForEncrypted(left_ms()) : socket.waitForConnected(left_ms()))) {
    return none();
  }
  // 1.0: the server ends the connection after an answer in one piece.
  QByteArray request = "POST " + url.toEncoded(QUrl::RemoveScheme | QUrl::RemoveAuthority | QUrl::RemoveFragment);
  if (url.path().isEmpty()) {
    request += '/';
  }
  request += " HTTP/1.0\r\nHost: " + url.authority(QUrl::FullyEncoded).toLatin1() +
             "\r\nContent-Type: " + QByteArray::fromStdString(contentType) +
             "\r\nContent-Length: " + QByteArray::number(static_cast<qulonglong>(body.size())) +
             "\r\nConnection: close\r\n\r\n" + QByteArray::fromStdString(body);
  socket.setReadBufferSize(static_cast<qint64>(most_bytes));
  socket.write(request);
  QByteArray heard;
  while (socket.bytesAvailable() > 0 || socket.waitForReadyRead(left_ms())) {
    heard += socket.read(static_cast<qint64>(most_bytes));
    if (static_cast<std::size_t>(heard.size()) > most_bytes || deadline.hasExpired()) {
      socket.abort();
      return {0, deadline.hasExpired() ? "it took too long" : "it is too long"};
    }
  }
  return answerIn(heard).value_or(none());
}

}  // namespace torsio
