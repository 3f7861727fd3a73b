// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/people/roster_text.h"

#include <algorithm>
#include <optional>

#include <QByteArray>
#include <QByteArrayView>
#include <QString>
#include <QStringDecoder>

#include "sim/core/error.h"

namespace torsio {

namespace {

/// Converts to UTF-8; empty if the text is not in this encoding, or the system does not know it.
std::optional<std::string> decoded(std::string_view bytes, const char* encoding) {
  QStringDecoder decoder(encoding,
                         QStringConverter::Flag::Stateless);  // an incomplete character at the end is an
                                                              // error
  if (!decoder.isValid()) {
    return std::nullopt;
  }
  const QString text = decoder(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())));
  // Undefined bytes become C1 control characters.
  const bool meaningless = std::any_of(text.begin(), text.end(), [](QChar letter) {
    return letter == QChar::ReplacementCharacter || (letter >= QChar(0x80) && letter <= QChar(0x9F));
  });
  if (decoder.hasError() || meaningless) {
    return std::nullopt;
  }
  return text.toStdString();
}

/// Simplified Chinese consists of pairs of bytes above A0; in a western text such bytes are single among
/// ASCII letters.
bool isPairedChinese(std::string_view bytes) {
  std::size_t pairs = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto byte = [&](std::size_t at) {
      return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0U;
    };
    if (byte(i) < 0x80) {
      continue;
    }
    if (byte(i) < 0xA1 || byte(i + 1) < 0xA1) {
      return false;
    }
    ++pairs;
    ++i;
  }
  return pairs > 0;
}

}  // namespace

RosterText decodeRosterText(std::string_view bytes, const std::string& name) {
  const bool little = bytes.starts_with("\xFF\xFE");
  if (little || bytes.starts_with("\xFE\xFF")) {
    if (auto text = decoded(bytes.substr(2), little ? "UTF-16LE" : "UTF-16BE")) {
      return {std::move(*text), "UTF-16"};
    }
    refuse(Text::tr("the text begins as UTF-16 and is broken"), name,
           Text::tr("Save the table as UTF-8 CSV"));
  }
  if (bytes.starts_with("\xEF\xBB\xBF")) {
    bytes.remove_prefix(3);
  }
  if (auto text = decoded(bytes, "UTF-8")) {
    return {std::move(*text), "UTF-8"};
  }
  for (const char* encoding : {"GB18030", "windows-1252"}) {
    if (encoding == std::string_view("GB18030") && !isPairedChinese(bytes)) {
      continue;
    }
    if (auto text = decoded(bytes, encoding)) {
      return {std::move(*text), encoding == std::string_view("GB18030") ? "GB18030" : "Windows-1252"};
    }
  }
  refuse(Text::tr("the text is in no encoding that a spreadsheet saves"), name,
         Text::tr("Save the table as UTF-8 CSV"));
}

}  // namespace torsio
