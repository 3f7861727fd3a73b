// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <future>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <QByteArray>
#include <QFile>
#include <QHostAddress>
#include <QSslCertificate>
#include <QSslKey>
#include <QSslSocket>
#include <QTcpServer>

namespace torsio::testing {

/// Behaviour of a mail server.
struct MailManner {
  enum class Way { kClear, kTls, kStartTls };

  Way way = Way::kClear;
  std::string certificate = "server.pem";  ///< of tests/data/mail
  std::string refused = "nobody@example.org";
  std::string password = "a good one";
  std::string signIn = "AUTH PLAIN LOGIN";  ///< offered authentication; empty: none
  /// Replies to lines with this beginning ("." ends a message): empty: none, "drop": hangs up.
  std::map<std::string, std::string> instead{};
  std::string behindStartTls{};  ///< injected after the answer to STARTTLS
};

/// A local mail server that refuses one recipient and stores what it receives, one conversation after
/// another. With encryption it is a separate TLS peer using OpenSSL.
class FakeMailServer {
 public:
  struct Taken {
    std::string to{};
    std::string text{};  ///< head and body as received, lines ended by "\n"
  };

  explicit FakeMailServer(MailManner manner = {}) : manner_(std::move(manner)) {
    std::promise<quint16> listening;
    std::future<quint16> port = listening.get_future();
    thread_ = std::thread([this, &listening] {
      Door door;
      door.listen(QHostAddress::LocalHost);
      listening.set_value(door.serverPort());
      while (!closing_ || door.hasPendingConnections()) {
        if (door.waitForNewConnection(kLook_ms)) {
          receive(*qobject_cast<QSslSocket*>(door.nextPendingConnection()));
        }
      }
    });
    port_ = port.get();
  }
  ~FakeMailServer() { finish(); }
  FakeMailServer(const FakeMailServer&) = delete;
  FakeMailServer& operator=(const FakeMailServer&) = delete;

  [[nodiscard]] quint16 port() const { return port_; }
  /// Returns the accepted messages after the last conversation.
  const std::vector<Taken>& taken() {
    finish();
    return taken_;
  }
  /// Return the lines received unencrypted and encrypted, after the last conversation.
  const std::vector<std::string>& inTheClear() {
    finish();
    return inTheClear_;
  }
  const std::vector<std::string>& encrypted() {
    finish();
    return encrypted_;
  }

 private:
  static constexpr int kPatience_ms = 20'000;
  static constexpr int kLook_ms = 20;

  class Door : public QTcpServer {
   protected:
    void incomingConnection(qintptr descriptor) override {
      auto* socket = new QSslSocket(this);
      socket->setSocketDescriptor(descriptor);
      addPendingConnection(socket);
    }
  };

  static QByteArray pem(const std::string& name) {
    QFile file(QStringLiteral(TORSIO_TEST_DATA "/mail/") + QString::fromStdString(name));
    (void)file.open(QIODevice::ReadOnly);
    return file.readAll();
  }
  void finish() {
    closing_ = true;
    if (thread_.joinable()) {
      thread_.join();
    }
  }
  [[nodiscard]] bool encrypt(QSslSocket& socket) const {
    socket.setLocalCertificate(QSslCertificate(pem(manner_.certificate)));
    socket.setPrivateKey(QSslKey(pem("server.key"), QSsl::Ec));
    socket.startServerEncryption();
    return socket.waitForEncrypted(kPatience_ms);
  }
  std::string line(QSslSocket& socket) {
    while (!socket.canReadLine()) {
      if (!socket.waitForReadyRead(kPatience_ms)) {
        return "QUIT";
      }
    }
    const std::string heard = socket.readLine().trimmed().toStdString();
    (socket.isEncrypted() ? encrypted_ : inTheClear_).push_back(heard);
    return heard;
  }
  static void say(QSslSocket& socket, const std::string& words) {
    socket.write(QByteArray::fromStdString(words) + "\r\n");
    socket.flush();
  }
  /// Answers; returns whether the conversation continues.
  bool answer(QSslSocket& socket, const std::string& heard, const std::string& usual) {
    for (const auto& [beginning, words] : manner_.instead) {
      if (heard.starts_with(beginning)) {
        if (words == "drop") {
          return false;
        }
        if (!words.empty()) {
          say(socket, words);
        }
        return true;
      }
    }
    say(socket, usual);
    return true;
  }
  void receive(QSslSocket& socket) {
    if ((manner_.way != MailManner::Way::kTls || encrypt(socket)) && answer(socket, "GREETING", "220 fake")) {
      talk(socket);
    }
    socket.flush();
    socket.disconnectFromHost();
    if (socket.state() != QAbstractSocket::UnconnectedState) {
      socket.waitForDisconnected(kPatience_ms);
    }
  }
  [[nodiscard]] std::string greeting(const QSslSocket& socket) const {
    const bool more = manner_.way == MailManner::Way::kStartTls && !socket.isEncrypted();
    return std::string("250-fake\r\n") + (more ? "250-STARTTLS\r\n" : "") +
           (manner_.signIn.empty() ? "" : "250-" + manner_.signIn + "\r\n") + "250 8BITMIME";
  }
  [[nodiscard]] std::string verdict(const QByteArray& secret) const {
    return secret.endsWith(QByteArray::fromStdString(manner_.password)) ? "235 welcome" : "535 wrong";
  }
  static QByteArray unpacked(const std::string& text) {
    return QByteArray::fromBase64(QByteArray::fromStdString(text));
  }
  /// Returns the normal answer.
  std::string reply(QSslSocket& socket, const std::string& heard, Taken& message) {
    if (heard.starts_with("EHLO ")) {
      return greeting(socket);
    }
    if (heard.starts_with("AUTH PLAIN ")) {
      return verdict(unpacked(heard.substr(11)));
    }
    if (heard.starts_with("AUTH LOGIN ")) {  // the name follows immediately
      say(socket, "334 UGFzc3dvcmQ6");
      return verdict(unpacked(line(socket)));
    }
    if (heard.starts_with("RCPT TO:<" + manner_.refused)) {
      return "550 nobody of this name";
    }
    if (heard.starts_with("RCPT TO:<")) {
      message = {heard.substr(9, heard.size() - 10), {}};
    }
    if (heard == "STARTTLS") {
      return "220 go on" + (manner_.behindStartTls.empty() ? "" : "\r\n" + manner_.behindStartTls);
    }
    return heard == "DATA" ? "354 go on" : heard == "QUIT" ? "221 bye" : "250 ok";
  }
  void talk(QSslSocket& socket) {
    Taken message;
    for (bool open = true; open;) {
      std::string heard = line(socket);
      if (!answer(socket, heard, reply(socket, heard, message)) || heard == "QUIT") {
        return;
      }
      if (heard == "STARTTLS" && !manner_.instead.contains(heard)) {
        open = encrypt(socket);
      } else if (heard == "DATA" && !manner_.instead.contains(heard)) {
        for (heard = line(socket); heard != "." && heard != "QUIT"; heard = line(socket)) {
          message.text += heard + "\n";
        }
        open = heard == "." && answer(socket, heard, "250 taken");
        if (open && !manner_.instead.contains(heard)) {
          taken_.push_back(message);
        }
      }
    }
  }

  MailManner manner_;
  quint16 port_ = 0;
  std::vector<Taken> taken_;
  std::vector<std::string> inTheClear_;
  std::vector<std::string> encrypted_;
  std::atomic<bool> closing_{false};
  std::thread thread_;
};

}  // namespace torsio::testing
