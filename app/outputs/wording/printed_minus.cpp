// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/wording/printed_minus.h"

#include <utility>

#include <QRegularExpression>

namespace torsio {

namespace {

constexpr QChar kHyphen(u'-');
constexpr QChar kMinus(0x2212);

}  // namespace

QString printedMinus(QString text) {
  if (!text.contains(kHyphen)) {
    return text;
  }
  static const QRegularExpression kOfNumber(QStringLiteral(R"((?<![A-Za-z0-9_.)\]%/\\-])-(?=%?\.?[0-9]))"));
  static const QRegularExpression kOfLetter(QStringLiteral("(?<![A-Za-z])([a-z]) - (?=[0-9])"));
  return text.replace(kOfLetter, QStringLiteral("\\1\u00A0\u2212\u00A0")).replace(kOfNumber, kMinus);
}

QString printedPattern(QString pattern) {
  return printedMinus(std::move(pattern)).replace(QStringLiteral(" - "), QStringLiteral(" \u2212 "));
}

QString plainMinus(QString shown) {
  return shown.replace(kMinus, kHyphen);
}

}  // namespace torsio
