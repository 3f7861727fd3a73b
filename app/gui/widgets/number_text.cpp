// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/number_text.h"

#include <cmath>

#include <QLocale>
#include <QRegularExpression>

#include "app/outputs/wording/printed_minus.h"

namespace torsio::gui {

QString numberText(double value, int decimals) {
  const bool zero = std::abs(value) * std::pow(10.0, decimals) < 0.5;
  return printedMinus(QLocale().toString(zero ? 0.0 : value, 'f', decimals));
}

QString numberText(const QString& plain) {
  static const QRegularExpression kNumber(QStringLiteral("^-?(0|[1-9][0-9]*)(?:\\.([0-9]+))?$"));
  const QRegularExpressionMatch number = kNumber.match(plain);
  return number.hasMatch() ? numberText(plain.toDouble(), static_cast<int>(number.capturedLength(2)))
                           : QString();
}

}  // namespace torsio::gui
