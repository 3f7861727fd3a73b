// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <QByteArray>
#include <QHostAddress>
#include <QTcpServer>
#include <QTcpSocket>

namespace torsio::testing {

/// A mail server on this computer that takes one conversation, refuses one recipient, and keeps what it
/// heard.
class FakeMailServer {
 public:
  struct Taken {
    std::string to{};
    std::string text{};  ///< head and body as they came, lines ended by "\n"
  };

  explicit FakeMailServer(std::string refused = "nobody@example.org", std::string password = "a good one")
      : refused_(std::move(refused)), password_(std::move(password)) {
    std::promise<quint16> listening;
    std::future<quint16> port = listening.get_future();
    thread_ = std::thread([this, &listening] {
      QTcpServer server;
      server.listen(QHostAddress::LocalHost);
      listening.set_value(server.serverPort());
      if (server.waitForNewConnection(kPatience_ms)) {
        talk(*server.nextPendingConnection());
      }
    });
    port_ = port.get();
  }
  ~FakeMailServer() { finish(); }
  FakeMailServer(const FakeMailServer&) = delete;
  FakeMailServer& operator=(const FakeMailServer&) = delete;

  [[nodiscard]] quint16 port() const { return port_; }
  /// What was taken, once the conversation is over.
  const std::vector<Taken>& taken() {
    finish();
    return taken_;
  }

 private:
  static constexpr int kPatience_ms = 20'000;

  void finish() {
    if (thread_.joinable()) {
      thread_.join();
    }
  }
  static std::string line(QTcpSocket& socket) {
    while (!socket.canReadLine()) {
      if (!socket.waitForReadyRead(kPatience_ms)) {
        return "QUIT";
      }
    }
    return socket.readLine().trimmed().toStdString();
  }
  static void say(QTcpSocket& socket, const char* words) {
    socket.write(words);
    socket.flush();
  }
  void talk(QTcpSocket& socket) {
    say(socket, "220 fake\r\n");
    Taken message;
    for (std::string heard = line(socket); heard != "QUIT"; heard = line(socket)) {
      if (heard.starts_with("EHLO")) {
        say(socket, "250-fake\r\n250-AUTH PLAIN LOGIN\r\n250 8BITMIME\r\n");
      } else if (heard.starts_with("AUTH PLAIN ")) {
        const QByteArray secret = QByteArray::fromBase64(QByteArray::fromStdString(heard.substr(11)));
        say(socket,
            secret.endsWith(QByteArray::fromStdString(password_)) ? "235 welcome\r\n" : "535 wrong\r\n");
      } else if (heard.starts_with("RCPT TO:<" + refused_)) {
        say(socket, "550 nobody of this name\r\n");
      } else if (heard.starts_with("RCPT TO:<")) {
        message = {heard.substr(9, heard.size() - 10), {}};
        say(socket, "250 ok\r\n");
      } else if (heard == "DATA") {
        say(socket, "354 go on\r\n");
        for (heard = line(socket); heard != "."; heard = line(socket)) {
          message.text += heard + "\n";
        }
        taken_.push_back(message);
        say(socket, "250 taken\r\n");
      } else {
        say(socket, "250 ok\r\n");
      }
    }
    say(socket, "221 bye\r\n");
    socket.waitForBytesWritten(kPatience_ms);
  }

  std::string refused_;
  std::string password_;
  quint16 port_ = 0;
  std::vector<Taken> taken_;
  std::thread thread_;
};

}  // namespace torsio::testing
