// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/number_text.h"

#include <cmath>

#include <QLocale>
#include <QRegularExpression>

namespace torsio::gui {

namespace {

constexpr QChar kMinus(0x2212);

}  // namespace

QString numberText(double value, int decimals) {
  const bool zero = std::abs(value) * std::pow(10.0, decimals) < 0.5;
  return QLocale().toString(zero ? 0.0 : value, 'f', decimals).replace(QLatin1Char('-'), kMinus);
}

QString numberText(const QString& plain) {
  static const QRegularExpression kNumber(QStringLiteral("^-?(0|[1-9][0-9]*)(?:\\.([0-9]+))?$"));
  const QRegularExpressionMatch number = kNumber.match(plain);
  return number.hasMatch() ? numberText(plain.toDouble(), static_cast<int>(number.capturedLength(2)))
                           : QString();
}

QString plainMinus(QString shown) {
  return shown.replace(kMinus, QLatin1Char('-'));
}

}  // namespace torsio::gui
