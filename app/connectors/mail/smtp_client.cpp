// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/mail/smtp_client.h"

#include <utility>

#include <QByteArrayList>
#include <QDeadlineTimer>
#include <QHostAddress>
#include <QSslSocket>
#include <QUuid>

#include "app/services/base/this_computer.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr qsizetype kLongestAnswer_bytes = 64 * 1024;
constexpr int kReady = 220;
constexpr int kDone = 250;
constexpr int kSignedIn = 235;
constexpr int kSignInGoesOn = 334;
constexpr int kBodyFollows = 354;

/// What a server says: a number of three digits, and lines.
struct MailAnswer {
  int code = 0;
  QByteArrayList lines{};

  [[nodiscard]] bool done() const noexcept { return code >= 200 && code < 300; }
  /// "550 nobody of this name"
  [[nodiscard]] std::string text() const {
    return QByteArray::number(code).append(' ').append(lines.join(' ')).toStdString();
  }
};

/// One conversation with a mail server.
class MailTalk {
 public:
  explicit MailTalk(const MailServer& server) : server_(server) {}

  void open() {
    const QString host = QString::fromStdString(server_.host);
    if (server_.encryption == MailEncryption::kTls) {
      socket_.connectToHostEncrypted(host, server_.port);
      requireTrust();
    } else {
      socket_.connectToHost(host, server_.port);
      require(socket_.waitForConnected(server_.patience_ms));
    }
    require(hear(), kReady);
    greet();
    if (server_.encryption == MailEncryption::kStartTls) {
      encrypt();
    }
    if (!server_.user.empty()) {
      signIn();
    }
  }

  /// Empty: taken.
  Text send(const MailMessage& message, const std::string& text) {
    for (const std::string& line : {"MAIL FROM:<" + message.from + ">", "RCPT TO:<" + message.to + ">"}) {
      if (const MailAnswer answer = ask(line); !answer.done()) {
        (void)ask("RSET");
        return answer.text();
      }
    }
    if (const MailAnswer answer = ask("DATA"); answer.code != kBodyFollows) {
      (void)ask("RSET");
      return answer.text();
    }
    handedOver_ = true;
    const MailAnswer answer = ask(text + ".");  // no line of it begins with a dot
    handedOver_ = false;
    return answer.done() ? Text() : Text(answer.text());
  }

  /// Whether a whole message went out that nothing was said about.
  [[nodiscard]] bool handedOver() const noexcept { return handedOver_; }

  void close() {
    say("QUIT");
    if (socket_.bytesToWrite() > 0) {
      socket_.waitForBytesWritten(server_.patience_ms);
    }
  }

 private:
  void greet() {
    const QHostAddress here = socket_.localAddress();
    const QString literal = here.protocol() == QAbstractSocket::IPv6Protocol
                                ? QStringLiteral("IPv6:") + QHostAddress(here.toIPv6Address()).toString()
                                : here.toString();
    MailAnswer answer = ask("EHLO [" + literal.toStdString() + "]");
    require(answer, kDone);
    offers_ = std::move(answer.lines);
  }

  /// Whatever stands between here and the server can leave the offer out, or put words behind the answer.
  void encrypt() {
    if (!offered("STARTTLS")) {
      refuseServer(Text::tr("the mail server offers no encryption: nothing was sent"),
                   Text::tr("Choose TLS from the beginning, or ask who runs it"));
    }
    require(ask("STARTTLS"), kReady);
    if (socket_.bytesAvailable() > 0) {
      refuseServer(Text::tr("somebody else speaks before the encryption of the mail server begins"),
                   Text::tr("Choose TLS from the beginning, or ask who runs the network"));
    }
    socket_.startClientEncryption();
    requireTrust();
    greet();
  }

  void signIn() {
    const auto packed = [](const std::string& text) {
      return QByteArray::fromStdString(text).toBase64().toStdString();
    };
    MailAnswer answer;
    if (offered("AUTH", "PLAIN")) {
      answer = ask("AUTH PLAIN " + packed(std::string(1, '\0') + server_.user + '\0' + server_.password));
    } else if (offered("AUTH", "LOGIN")) {
      require(ask("AUTH LOGIN"), kSignInGoesOn);
      require(ask(packed(server_.user)), kSignInGoesOn);
      answer = ask(packed(server_.password));
    } else {
      refuseServer(Text::tr("the mail server takes no sign-in with a password"),
                   Text::tr("Take the sign-in name out of its settings, or ask who runs it"));
    }
    if (answer.code != kSignedIn) {
      refuseServer(Text::tr("the mail server refuses the sign-in: %1", answer.text()),
                   Text::tr("Check the sign-in name and the password"));
    }
  }

  /// Whether a line of the greeting begins with `word`, and names `way` behind it.
  [[nodiscard]] bool offered(const char* word, const char* way = nullptr) const {
    for (const QByteArray& line : offers_) {
      const QByteArrayList words = line.toUpper().replace('=', ' ').split(' ');
      if (words.first() == word && (way == nullptr || words.contains(way))) {
        return true;
      }
    }
    return false;
  }

  void say(const std::string& line) { socket_.write(QByteArray::fromStdString(line) + "\r\n"); }

  MailAnswer ask(const std::string& line) {
    say(line);
    return hear();
  }

  MailAnswer hear() {
    MailAnswer answer;
    QDeadlineTimer deadline(server_.patience_ms);
    for (qsizetype heard = 0; heard < kLongestAnswer_bytes;) {
      while (!socket_.canReadLine()) {
        require(!deadline.hasExpired() &&
                socket_.waitForReadyRead(static_cast<int>(deadline.remainingTime())) &&
                socket_.bytesAvailable() < kLongestAnswer_bytes);
      }
      const QByteArray line = socket_.readLine().trimmed();
      heard += line.size() + 1;
      answer.code = line.left(3).toInt();
      answer.lines << line.mid(4);
      if (line.size() < 4 || line[3] != '-') {
        return answer;
      }
    }
    require(false);
    return answer;
  }

  void require(const MailAnswer& answer, int code) const {
    if (answer.code != code) {
      refuseServer(Text::tr("the mail server refuses: %1", answer.text()), Text::tr("Check its settings"));
    }
  }
  void require(bool answers) const {
    if (!answers) {
      refuseServer(Text::tr("the mail server does not answer: %1", socket_.errorString().toStdString()),
                   Text::tr("Check its name, port and encryption, and the network"));
    }
  }
  void requireTrust() {
    if (socket_.waitForEncrypted(server_.patience_ms)) {
      return;
    }
    if (!socket_.sslHandshakeErrors().isEmpty()) {
      refuseServer(
          Text::tr("the mail server cannot be trusted: %1",
                   socket_.sslHandshakeErrors().first().errorString().toStdString()),
          Text::tr("Check its name; the authority of its certificate must be known to this computer"));
    }
    require(false);
  }
  [[noreturn]] void refuseServer(const Text& what, const Text& remedy) const {
    throw Error(ErrorCode::kFileUnreadable, what, server_.host, remedy);
  }

  const MailServer& server_;
  QSslSocket socket_;
  QByteArrayList offers_;
  bool handedOver_ = false;
};

}  // namespace

void requireProtectedWay(const MailServer& server) {
  if (server.encryption == MailEncryption::kNone && !isThisComputer(server.host)) {
    refuseParameter(Text::tr("without encryption messages go to a server on this computer only"), server.host,
                    Text::tr("Choose an encryption"));
  }
}

std::vector<Text> sendMail(const MailServer& server, std::span<const MailMessage> messages,
                           std::int64_t utc_us, const ProgressCallback& progress, const MailTaken& taken) {
  requireProtectedWay(server);
  std::vector<std::string> texts;
  for (const MailMessage& message : messages) {  // before anything is sent
    texts.push_back(
        written(message, QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString(), utc_us));
  }
  MailTalk talk(server);
  talk.open();
  std::vector<Text> refusals;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    try {
      refusals.push_back(talk.send(messages[i], texts[i]));
    } catch (const Error& error) {
      if (talk.handedOver()) {
        refusals.push_back(Text::tr("it is not known whether it was taken: %1", error.happenedText()));
      }
      refusals.resize(messages.size(), Text::tr("not sent: %1", error.happenedText()));
      return refusals;
    }
    if (taken && refusals.back().empty()) {
      taken(i);
    }
    tellProgress(progress, Text::tr("Message to %1", messages[i].to),
                 static_cast<double>(i + 1) / static_cast<double>(messages.size()));
  }
  talk.close();
  return refusals;
}

}  // namespace torsio
