// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/base/identifiers.h"

#include <QString>

#include "sim/core/error.h"

namespace torsio {

namespace {

QString unicodeOf(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// Returns whether this is one of the two joiners used in Persian and Indic names.
bool isJoiner(char32_t character) {
  return character == 0x200C || character == 0x200D;
}

/// Returns whether the character is drawn as nothing.
bool isFiller(char32_t character) {
  constexpr std::u32string_view kFillers = U"\u115F\u1160\u17B4\u17B5\u2800\u3164\uFFA0";
  return kFillers.find(character) != std::u32string_view::npos;
}

bool cannotBeSeen(char32_t character) {
  switch (QChar::category(character)) {
    case QChar::Other_Control:
    case QChar::Other_Format:  // direction marks, zero-width spaces
    case QChar::Other_Surrogate:
    case QChar::Separator_Line:
    case QChar::Separator_Paragraph:
      return true;
    default:
      return character == QChar::ReplacementCharacter || isFiller(character);
  }
}

/// Maps a capital of another script to the Latin letter that it, or its lower-case form, resembles.
char32_t latinFor(char32_t letter) {
  constexpr std::u32string_view kOthers =
      U"\u0410\u0412\u0415\u041A\u041C\u041D\u041E\u0420\u0421\u0422\u0423\u0425\u0406\u0408\u0405"
      U"\u04AE\u04BA\u04C0\u0500\u051A\u051C"
      U"\u0391\u0392\u0395\u0396\u0397\u0399\u039A\u039C\u039D\u039F\u03A1\u03A4\u03A5\u03A7"
      U"\u0540\u0548\u054D\u0555"
      U"\u2C6D\uA7AC\uA7AE";
  constexpr std::u32string_view kLatin =
      U"ABEKMHOPCTYXIJS"
      U"YHIDQW"
      U"ABEZHIKMNOPTYX"
      U"HNUO"
      U"AGI";
  static_assert(kOthers.size() == kLatin.size());
  const std::size_t at = kOthers.find(letter);
  return at == std::u32string_view::npos ? letter : kLatin[at];
}

char32_t looksLike(char32_t character) {
  if (QChar::category(character) == QChar::Punctuation_Dash || character == 0x2212) {
    return U'-';
  }
  const int digit = QChar::digitValue(character);
  const char32_t letter = digit < 0 ? latinFor(character) : U'0' + static_cast<char32_t>(digit);
  return letter == U'0' ? U'O' : letter;
}

}  // namespace

Text flawOf(std::string_view text, std::size_t longest) {
  const std::u32string characters = unicodeOf(text.substr(0, longest * 4 + 4)).toStdU32String();
  if (characters.size() > longest) {
    return Text::tr("is longer than %1 characters", longest);
  }
  for (const char32_t character : characters) {
    if (cannotBeSeen(character) && !isJoiner(character)) {
      return Text::tr(
          "contains the invisible character U+%1",
          QString::number(character, 16).rightJustified(4, QLatin1Char('0')).toUpper().toStdString());
    }
  }
  return {};
}

std::string likenessOf(std::string_view number) {
  const QString folded = unicodeOf(number).normalized(QString::NormalizationForm_KD).toUpper();
  std::u32string likeness;
  for (const char32_t character : folded.toStdU32String()) {
    if (!QChar::isMark(character) && !QChar::isSpace(character) && !cannotBeSeen(character)) {
      likeness += looksLike(character);
    }
  }
  return QString::fromStdU32String(likeness).toStdString();
}

bool isSpreadsheetNumber(std::string_view text) {
  static constexpr std::string_view kDigits = "0123456789";
  const std::size_t exponent = text.find("E+");
  if (exponent == std::string_view::npos) {
    return false;
  }
  const std::string_view mantissa = text.substr(0, exponent);
  const std::string_view power = text.substr(exponent + 2);
  const auto areDigits = [](std::string_view part) {
    return !part.empty() && part.find_first_not_of(kDigits) == std::string_view::npos;
  };
  const bool pointed = mantissa.size() > 2 && (mantissa[1] == '.' || mantissa[1] == ',');
  return power.size() >= 2 && areDigits(power) && areDigits(mantissa.substr(0, 1)) &&
         (mantissa.size() == 1 || (pointed && areDigits(mantissa.substr(2))));
}

void requireReadable(std::string_view text, const Text& where, std::size_t longest) {
  if (const Text flaw = flawOf(text, longest); !flaw.empty()) {
    refuse(Text::tr("this text %1", flaw), where, Text::tr("Type it again"));
  }
}

void Identifiers::take(const std::string& name, const std::string& where) {
  std::string likeness = likenessOf(name);
  const auto known = byLikeness_.find(likeness);
  if (known != byLikeness_.end() && known->second.name == name) {
    return;
  }
  if (const Text flaw = flawOf(name, kLongestField); !flaw.empty()) {
    refuse(Text::tr("a %1 %2", kind_, flaw), where, Text::tr("Type it again"));
  }
  if (likeness.empty()) {
    refuse(Text::tr("a %1 consists of blanks", kind_), where, Text::tr("Type it again"));
  }
  if (known != byLikeness_.end()) {
    refuse(Text::tr("%1 \"%2\" looks like \"%3\" in %4, but is another", kind_, name, known->second.name,
                    known->second.where),
           where, Text::tr("Write both in the same way, or change one of the two"));
  }
  byLikeness_.emplace(std::move(likeness), First{name, where});
}

}  // namespace torsio
