// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/people/person_text.h"

#include <QString>

namespace torsio {

namespace {

QString unicodeOf(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

/// The two joiners belong to names in Persian and Indic scripts.
bool isJoiner(char32_t character) {
  return character == 0x200C || character == 0x200D;
}

bool cannotBeSeen(char32_t character) {
  switch (QChar::category(character)) {
    case QChar::Other_Control:
    case QChar::Other_Format:  // direction marks, blanks without width
    case QChar::Other_Surrogate:
    case QChar::Separator_Line:
    case QChar::Separator_Paragraph:
      return true;
    default:
      return character == QChar::ReplacementCharacter;
  }
}

/// Letters of other scripts beside the Latin one, or the digit, that they look like.
char16_t latinFor(char16_t letter) {
  constexpr std::u16string_view kOthers =
      u"\u0410\u0412\u0415\u041A\u041C\u041D\u041E\u0420\u0421\u0422\u0423\u0425\u0406\u0408\u0405"
      u"\u0391\u0392\u0395\u0396\u0397\u0399\u039A\u039C\u039D\u039F\u03A1\u03A4\u03A5\u03A7";
  constexpr std::u16string_view kLatin =
      u"ABEKMHOPCTYXIJS"
      u"ABEZHIKMNOPTYX";
  const std::size_t at = kOthers.find(letter);
  return at == std::u16string_view::npos ? letter : kLatin[at];
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
          "holds the character U+%1, which nobody can see",
          QString::number(character, 16).rightJustified(4, QLatin1Char('0')).toUpper().toStdString());
    }
  }
  return {};
}

std::string likenessOf(std::string_view number) {
  QString likeness;
  for (const QChar character : unicodeOf(number).normalized(QString::NormalizationForm_KD).toUpper()) {
    if (character.isMark() || character.isSpace() || cannotBeSeen(character.unicode())) {
      continue;
    }
    const bool dash = character.category() == QChar::Punctuation_Dash || character == QChar(0x2212);
    likeness += dash ? QChar('-') : QChar(latinFor(character.unicode()));
  }
  return likeness.toStdString();
}

}  // namespace torsio
