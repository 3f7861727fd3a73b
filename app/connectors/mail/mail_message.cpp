// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/connectors/mail/mail_message.h"

#include <algorithm>

#include <QByteArray>
#include <QDateTime>

#include "sim/core/error.h"

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
    refuseParameter(Text::tr("this is no mail address"), address, Text::tr("Write it like li@example.org"));
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

}  // namespace torsio
