// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/mail/smtp_client.h"

#include <algorithm>
#include <cstdlib>
#include <curl/curl.h>
#include <memory>

#include <QByteArray>
#include <QDateTime>
#include <QUrl>
#include <QUuid>

#include "app/services/base/this_computer.h"
#include "sim/core/error.h"
#include "sim/core/plain_text.h"

namespace torsio {

namespace {

constexpr qsizetype kBodyLine = 76;             // base64 characters per line
constexpr std::size_t kMaxAddress_bytes = 254;  // RFC 5321
constexpr qsizetype kSubjectPart = 42;          // bytes per encoded word, so that a line stays below 78

/// Encodes a header's text as encoded words of whole characters; control characters become spaces.
QByteArray headerText(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](unsigned char letter) { return letter < ' ' || letter == '\x7f'; }, ' ');
  QByteArray header;
  QByteArray part;
  const auto flush = [&] {
    if (!part.isEmpty()) {
      header += (header.isEmpty() ? "" : "\r\n ") + QByteArray("=?UTF-8?B?") + part.toBase64() + "?=";
      part.clear();
    }
  };
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
      ++end;
    }
    const QByteArray letter(text.data() + at, static_cast<qsizetype>(end - at));
    if (part.size() + letter.size() > kSubjectPart) {
      flush();
    }
    part += letter;
    at = end;
  }
  flush();
  return header;
}

}  // namespace

void checkAddress(const std::string& address) {
  const std::size_t at = address.find('@');
  const bool plain = std::all_of(address.begin(), address.end(), [](char letter) {
    return letter > ' ' && letter < '\x7f' && std::string("<>()[],;:\\\"").find(letter) == std::string::npos;
  });
  if (!plain || address.size() > kMaxAddress_bytes || at == 0 || at == std::string::npos ||
      at + 1 == address.size() || address.rfind('@') != at) {
    refuseParameter(Text::tr("not a mail address"), address, Text::tr("Write it like li@example.org"));
  }
}

std::string written(const MailMessage& message, const std::string& id, std::int64_t utc_us) {
  checkAddress(message.from);
  checkAddress(message.to);
  const std::string home = message.from.substr(message.from.find('@') + 1);
  QByteArray text =
      "From: <" + QByteArray::fromStdString(message.from) + ">\r\nTo: <" +
      QByteArray::fromStdString(message.to) + ">\r\nSubject: " + headerText(message.subject) + "\r\nDate: " +
      QDateTime::fromMSecsSinceEpoch(utc_us / 1000, Qt::UTC).toString(Qt::RFC2822Date).toLatin1() +
      "\r\nMessage-ID: <" + QByteArray::fromStdString(id + "@" + home) +
      ">\r\nMIME-Version: 1.0\r\nContent-Type: text/plain; charset=UTF-8\r\n"
      "Content-Transfer-Encoding: base64\r\nAuto-Submitted: auto-generated\r\n\r\n";
  const QByteArray body =
      QByteArray::fromStdString(message.body).replace("\r\n", "\n").replace('\n', "\r\n").toBase64();
  for (qsizetype at = 0; at < body.size(); at += kBodyLine) {
    text += body.mid(at, kBodyLine) + "\r\n";
  }
  return text.toStdString();
}

namespace {

constexpr std::size_t kMaxAnswers_bytes = 64 * 1024;  // to all commands of one message
constexpr std::size_t kAnswerShown = 300;             // characters
constexpr long kMessagePatience = 4;                  // times that for one answer
constexpr int kFirstRefusal = 300;                    // reply codes from here on

/// A conversation with a mail server: libcurl keeps the connection between messages.
class MailTalk {
 public:
  explicit MailTalk(const MailServer& server) : server_(server), curl_(curl_easy_init(), &curl_easy_cleanup) {
    QUrl url;
    url.setScheme(server.encryption == MailEncryption::kTls ? "smtps" : "smtp");
    url.setHost(QString::fromStdString(server.host));
    url.setPort(server.port);
    url.setPath("/[127.0.0.1]");  // EHLO argument: keeps the name of this computer private
    set(CURLOPT_URL, url.toEncoded().constData());
    set(CURLOPT_PROTOCOLS_STR, "smtp,smtps");
    set(CURLOPT_USE_SSL, server.encryption == MailEncryption::kNone ? CURLUSESSL_NONE : CURLUSESSL_ALL);
    set(CURLOPT_NOPROXY, "*");
    set(CURLOPT_NOSIGNAL, 1L);
    set(CURLOPT_CONNECTTIMEOUT, long{server.patience_s});
    set(CURLOPT_TIMEOUT, kMessagePatience * server.patience_s);
    set(CURLOPT_SERVER_RESPONSE_TIMEOUT, long{server.patience_s});
    set(CURLOPT_LOW_SPEED_LIMIT, 1L);
    set(CURLOPT_LOW_SPEED_TIME, long{server.patience_s});
    if (!server.authorities.empty()) {
      set(CURLOPT_CAINFO, server.authorities.string().c_str());
    }
    if (!server.user.empty()) {
      set(CURLOPT_USERNAME, server.user.c_str());
      set(CURLOPT_PASSWORD, server.password.c_str());
      set(CURLOPT_LOGIN_OPTIONS, "AUTH=PLAIN;AUTH=LOGIN");
      set(CURLOPT_SASL_IR, 1L);
    }
    set(CURLOPT_ERRORBUFFER, failure_);
    set(CURLOPT_HEADERFUNCTION, &MailTalk::hear);
    set(CURLOPT_HEADERDATA, this);
    set(CURLOPT_READFUNCTION, &MailTalk::give);
    set(CURLOPT_READDATA, this);
  }

  /// Connects, encrypts and signs in.
  void open() {
    set(CURLOPT_CUSTOMREQUEST, "NOOP");
    set(CURLOPT_NOBODY, 1L);
    perform();
    if (!server_.user.empty() && !signedIn_) {  // libcurl sends anyway if the server offers no sign-in
      refuseSignIn();
    }
  }

  /// Empty: taken. Throws Error when the connection is lost.
  Text send(const MailMessage& message, const std::string& text) {
    const std::unique_ptr<curl_slist, decltype(&curl_slist_free_all)> recipients(
        curl_slist_append(nullptr, message.to.c_str()), &curl_slist_free_all);
    unsent_ = text;
    set(CURLOPT_UPLOAD, 1L);
    set(CURLOPT_MAIL_FROM, message.from.c_str());
    set(CURLOPT_MAIL_RCPT, recipients.get());
    return perform(true) ? Text() : Text(said());
  }

  /// Whether a whole message was sent and has not been answered.
  [[nodiscard]] bool handedOver() const noexcept { return handedOver_; }

 private:
  template <typename Value>
  void set(CURLoption option, Value value) {
    curl_easy_setopt(curl_.get(), option, value);
  }

  /// A line of the server ("250-STARTTLS"). Lines of one answer are joined under one number.
  static std::size_t hear(char* bytes, std::size_t size, std::size_t count, void* self) {
    auto& talk = *static_cast<MailTalk*>(self);
    if (size * count > talk.left_bytes_) {
      return 0;
    }
    talk.left_bytes_ -= size * count;
    const std::string line = QByteArray(bytes, static_cast<qsizetype>(size * count)).trimmed().toStdString();
    if (line.starts_with("221")) {  // answer to QUIT, which libcurl sends after a refusal
      return size * count;
    }
    const std::string words = line.substr(std::min<std::size_t>(line.size(), 4));
    if (!talk.moreToHear_) {
      talk.answer_ = line.substr(0, 3);
    }
    talk.answer_ += " " + words;
    talk.moreToHear_ = line.size() > 3 && line[3] == '-';
    talk.signedIn_ = talk.signedIn_ || line.starts_with("235");
    talk.handedOver_ = false;
    return size * count;
  }
  static std::size_t give(char* bytes, std::size_t size, std::size_t count, void* self) {
    auto& talk = *static_cast<MailTalk*>(self);
    const std::size_t given = talk.unsent_.copy(bytes, size * count);
    talk.unsent_.erase(0, given);
    talk.handedOver_ = talk.unsent_.empty();
    return given;
  }

  /// False: the server refuses the message. Throws Error for whatever else goes wrong.
  bool perform(bool ofMessage = false) {
    failure_[0] = '\0';
    left_bytes_ = kMaxAnswers_bytes;
    const CURLcode code = curl_easy_perform(curl_.get());
    const std::string why = failure_;
    const bool refused = std::atoi(answer_.c_str()) >= kFirstRefusal && !handedOver_;
    switch (code) {
      case CURLE_OK:
        return true;
      case CURLE_PEER_FAILED_VERIFICATION:
      case CURLE_SSL_CACERT_BADFILE:
        refuseServer(
            Text::tr("the mail server cannot be trusted: %1", why),
            Text::tr("Check its name; the authority of its certificate must be known to this computer"));
      case CURLE_LOGIN_DENIED:
        refuseSignIn();
      case CURLE_USE_SSL_FAILED:
      case CURLE_WEIRD_SERVER_REPLY:
        if (!refused) {  // not offered, or text was injected after the answer
          refuseServer(Text::tr("the mail server offers no safe encryption: %1", why),
                       Text::tr("Choose TLS from the start, or ask the server's administrator"));
        }
        [[fallthrough]];
      case CURLE_REMOTE_ACCESS_DENIED:
      case CURLE_SEND_ERROR:
      case CURLE_RECV_ERROR:
        if (refused && ofMessage) {
          return false;
        }
        if (refused) {
          refuseServer(Text::tr("the mail server refuses: %1", said()), Text::tr("Check its settings"));
        }
        [[fallthrough]];
      default:
        refuseServer(Text::tr("the mail server does not answer: %1", why),
                     Text::tr("Check its name, port and encryption, and the network"));
    }
  }

  /// The last answer, as one line for people.
  [[nodiscard]] std::string said() const { return plainLine(answer_, kAnswerShown); }
  [[noreturn]] void refuseSignIn() const {
    refuseServer(Text::tr("the mail server refuses the sign-in: %1", said()),
                 Text::tr("Check the sign-in name and the password, or leave both out"));
  }
  [[noreturn]] void refuseServer(const Text& what, const Text& remedy) const {
    throw Error(ErrorCode::kFileUnreadable, what, server_.host, remedy);
  }

  const MailServer& server_;
  char failure_[CURL_ERROR_SIZE] = {};
  std::string answer_;  // the last one of the server
  std::string unsent_;
  std::size_t left_bytes_ = 0;
  bool moreToHear_ = false;
  bool handedOver_ = false;
  bool signedIn_ = false;
  std::unique_ptr<CURL, decltype(&curl_easy_cleanup)> curl_;  // ends first: it writes into the others
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
  for (const MailMessage& message : messages) {  // check all before sending anything
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
        refusals.push_back(
            Text::tr("it is not known whether the server accepted it: %1", error.happenedText()));
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
  return refusals;
}

}  // namespace torsio
