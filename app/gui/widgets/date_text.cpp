// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/widgets/date_text.h"

#include <QDateEdit>
#include <QDateTime>

#include "app/outputs/wording/printed_value.h"

namespace torsio::gui {

namespace {

constexpr QChar kDash(0x2013);

QDateTime timeOf(std::int64_t utc_us) {
  return QDateTime::fromMSecsSinceEpoch(utc_us / 1000);
}

}  // namespace

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

}  // namespace torsio::gui
