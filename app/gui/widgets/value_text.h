// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <cstdint>

#include <QLocale>
#include <QString>

class QDate;
class QDateEdit;

namespace torsio::gui {

// Numbers as on all screens: grouped by QLocale(), with a typographic minus, and none before zero. Input,
// clipboard and files use the plain form (plainMinus()). Thread-safe.

[[nodiscard]] QString numberText(double value, int decimals);
template <std::integral Count>
[[nodiscard]] QString countText(Count value) {
  return numberText(static_cast<double>(value), 0);
}

/// Formats a number from a file's notation ("-1808.50", "7666"), keeping its decimals; empty if it is not a
/// number, or has an exponent.
[[nodiscard]] QString numberText(const QString& plain);

// Dates and times as on all screens, in this computer's time zone, in the form of dayFormat(). Thread-safe;
// fields in the GUI thread.

[[nodiscard]] QString dateText(const QDate& day, const QLocale& locale = QLocale());
/// `utc_us`: microseconds since 1970; 0: a dash.
[[nodiscard]] QString dayText(std::int64_t utc_us, const QLocale& locale = QLocale());
/// Formats date, hour and minute.
[[nodiscard]] QString shownTime(std::int64_t utc_us, const QLocale& locale = QLocale());

/// Sets the same format for a date field.
void showAsDate(QDateEdit* field);

// Like sim/core/clock.h, for screens: moments and durations of a recording are shown in tenths, so that
// people can refer to the same moment; running clocks and plans in whole seconds. Thread-safe.

/// Rounds down to whole seconds: "2:05".
[[nodiscard]] QString clockTime(std::int64_t time_us);
/// Rounds up to whole seconds: "2:05"; "0:00" when nothing is left.
[[nodiscard]] QString clockTimeLeft(std::int64_t left_us);
/// Rounds to tenths: "2:05.4".
[[nodiscard]] QString clockTenths(double time_s);
[[nodiscard]] QString clockTenthsOf(std::int64_t time_us);

}  // namespace torsio::gui
