// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mail/smtp_client.h"

#include <utility>

#include <QSslSocket>
#include <QUuid>

#include "app/base/this_computer.h"
#include "sim/base/error.h"
#include "sim/base/refusal.h"

namespace torsio {

namespace {

constexpr int kAnswer_ms = 30'000;
constexpr qsizetype kLongestAnswer_bytes = 64 * 1024;

/// What a server says: a number of three digits, and words.
struct MailAnswer {
  int code = 0;
  std::string text{};

  [[nodiscard]] bool good() const noexcept { return code >= 200 && code < 400; }
};

/// One conversation with a mail server.
class MailTalk {
 public:
  explicit MailTalk(const MailServer& server) : server_(server) {}

  void open() {
    const QString host = QString::fromStdString(server_.host);
    if (server_.encryption == MailEncryption::kTls) {
      socket_.connectToHostEncrypted(host, server_.port);
      require(socket_.waitForEncrypted(kAnswer_ms));
    } else {
      socket_.connectToHost(host, server_.port);
      require(socket_.waitForConnected(kAnswer_ms));
    }
    require(hear());
    greet();
    if (server_.encryption == MailEncryption::kStartTls) {
      require(ask("STARTTLS"));
      socket_.startClientEncryption();
      require(socket_.waitForEncrypted(kAnswer_ms));
      greet();
    }
    if (!server_.user.empty()) {
      signIn();
    }
  }

  /// Empty: taken.
  std::string send(const MailMessage& message, const std::string& text) {
    for (const std::string& line : {"MAIL FROM:<" + message.from + ">", "RCPT TO:<" + message.to + ">"}) {
      if (const MailAnswer answer = ask(line); !answer.good()) {
        (void)ask("RSET");
        return answer.text;
      }
    }
    if (const MailAnswer answer = ask("DATA"); !answer.good()) {
      return answer.text;
    }
    const MailAnswer answer = ask(text + ".");  // no line of it begins with a dot
    return answer.good() ? std::string() : answer.text;
  }

  void close() {
    say("QUIT");
    if (socket_.bytesToWrite() > 0) {
      socket_.waitForBytesWritten(kAnswer_ms);
    }
  }

 private:
  void greet() {
    const MailAnswer answer = ask("EHLO torsio");
    require(answer);
    offers_ = answer.text;
  }

  void signIn() {
    const auto packed = [](const std::string& text) {
      return QByteArray::fromStdString(text).toBase64().toStdString();
    };
    const bool plain =
        offers_.find("PLAIN") != std::string::npos || offers_.find("LOGIN") == std::string::npos;
    MailAnswer answer;
    if (plain) {
      answer = ask("AUTH PLAIN " + packed(std::string(1, '\0') + server_.user + '\0' + server_.password));
    } else {
      require(ask("AUTH LOGIN"));
      require(ask(packed(server_.user)));
      answer = ask(packed(server_.password));
    }
    if (!answer.good()) {
      throw Error(ErrorCode::kFileUnreadable,
                  Text::tr("the mail server refuses the sign-in: %1", answer.text), server_.host,
                  Text::tr("Check the sign-in name and the password"));
    }
  }

  void say(const std::string& line) { socket_.write(QByteArray::fromStdString(line) + "\r\n"); }

  MailAnswer ask(const std::string& line) {
    say(line);
    return hear();
  }

  MailAnswer hear() {
    MailAnswer answer;
    for (qsizetype heard = 0; heard < kLongestAnswer_bytes;) {
      while (!socket_.canReadLine()) {
        require(socket_.waitForReadyRead(kAnswer_ms));
        require(socket_.bytesAvailable() < kLongestAnswer_bytes);
      }
      const QByteArray line = socket_.readLine().trimmed();
      heard += line.size() + 1;
      answer.code = line.left(3).toInt();
      answer.text += (answer.text.empty() ? "" : " ") + line.mid(4).toStdString();
      if (line.size() < 4 || line[3] != '-') {
        return answer;
      }
    }
    require(false);
    return answer;
  }

  void require(const MailAnswer& answer) const {
    if (!answer.good()) {
      throw Error(ErrorCode::kFileUnreadable, Text::tr("the mail server refuses: %1", answer.text),
                  server_.host, Text::tr("Check its settings"));
    }
  }
  void require(bool answers) const {
    if (!answers) {
      throw Error(ErrorCode::kFileUnreadable,
                  Text::tr("the mail server does not answer: %1", socket_.errorString().toStdString()),
                  server_.host, Text::tr("Check its name, port and encryption, and the network"));
    }
  }

  const MailServer& server_;
  QSslSocket socket_;
  std::string offers_;
};

}  // namespace

void requireProtectedWay(const MailServer& server) {
  if (server.encryption == MailEncryption::kNone && !isThisComputer(server.host)) {
    refuseParameter(Text::tr("without encryption messages go to a server on this computer only"), server.host,
                    Text::tr("Choose an encryption"));
  }
}

std::vector<std::string> sendMail(const MailServer& server, std::span<const MailMessage> messages,
                                  std::int64_t utc_us, const ProgressCallback& progress) {
  requireProtectedWay(server);
  std::vector<std::string> texts;
  for (const MailMessage& message : messages) {  // before anything is sent
    texts.push_back(
        written(message, QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString(), utc_us));
  }
  MailTalk talk(server);
  talk.open();
  std::vector<std::string> refusals;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    refusals.push_back(talk.send(messages[i], texts[i]));
    tellProgress(progress, Text::tr("Message to %1", messages[i].to),
                 static_cast<double>(i + 1) / static_cast<double>(messages.size()));
  }
  talk.close();
  return refusals;
}

}  // namespace torsio
