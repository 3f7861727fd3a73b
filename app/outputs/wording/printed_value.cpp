// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/outputs/wording/printed_value.h"

#include <QDate>
#include <QRegularExpression>

namespace torsio {

QString dayFormat(const QLocale& locale) {
  return locale.language() == QLocale::Chinese ? locale.dateFormat(QLocale::ShortFormat)
                                               : QStringLiteral("d MMM yyyy");
}

QString printedTime(QString text, const QLocale& locale) {
  constexpr qsizetype kDay = 10;
  static const QRegularExpression kUtc(QStringLiteral("^\\d{4}-\\d{2}-\\d{2} \\d{2}:\\d{2} UTC$"));
  if (!kUtc.match(text).hasMatch()) {
    return text;
  }
  const QDate day = QDate::fromString(text.left(kDay), Qt::ISODate);
  return day.isValid() ? locale.toString(day, dayFormat(locale)) + text.mid(kDay) : text;
}

QString printedCount(QString text, const QLocale& locale) {
  constexpr qsizetype kMaxDigits = 18;
  static const QRegularExpression kWhole(QStringLiteral("^[1-9]\\d*$"));
  return text.size() <= kMaxDigits && kWhole.match(text).hasMatch() ? locale.toString(text.toLongLong())
                                                                    : text;
}

}  // namespace torsio
