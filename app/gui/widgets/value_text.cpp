// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/value_text.h"

#include <cmath>

#include <QDateEdit>
#include <QDateTime>
#include <QLocale>
#include <QRegularExpression>

#include "app/outputs/wording/printed_minus.h"
#include "app/outputs/wording/printed_value.h"
#include "sim/core/clock.h"

namespace torsio::gui {

namespace {

constexpr QChar kDash(0x2013);

QDateTime timeOf(std::int64_t utc_us) {
  return QDateTime::fromMSecsSinceEpoch(utc_us / 1000);
}

}  // namespace

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

QString dateText(const QDate& day, const QLocale& locale) {
  return locale.toString(day, dayFormat(locale));
}

QString dayText(std::int64_t utc_us, const QLocale& locale) {
  return utc_us == 0 ? QString(kDash) : dateText(timeOf(utc_us).date(), locale);
}

QString shownTime(std::int64_t utc_us, const QLocale& locale) {
  return utc_us == 0
             ? QString(kDash)
             : QStringLiteral("%1 %2").arg(dayText(utc_us, locale),
                                           locale.toString(timeOf(utc_us).time(), QLocale::ShortFormat));
}

void showAsDate(QDateEdit* field) {
  field->setDisplayFormat(dayFormat(field->locale()));
}

QString clockTime(std::int64_t time_us) {
  return QString::fromStdString(clockText(time_us));
}

QString clockTimeLeft(std::int64_t left_us) {
  return QString::fromStdString(clockLeftText(left_us));
}

QString clockTenths(double time_s) {
  return QString::fromStdString(clockTenthsText(time_s));
}

QString clockTenthsOf(std::int64_t time_us) {
  return clockTenths(1e-6 * static_cast<double>(time_us));
}

}  // namespace torsio::gui
