// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QLocale>
#include <QString>

class QDate;
class QDateEdit;

namespace torsio::gui {

// Dates and times as on all screens, in this computer's time zone, in the form of dayFormat(). Thread-safe;
// fields in the GUI thread.

[[nodiscard]] QString dateText(const QDate& day, const QLocale& locale = QLocale());
/// `utc_us`: microseconds since 1970; 0: a dash.
[[nodiscard]] QString dayText(std::int64_t utc_us, const QLocale& locale = QLocale());
/// Formats date, hour and minute.
[[nodiscard]] QString shownTime(std::int64_t utc_us, const QLocale& locale = QLocale());

/// Sets the same format for a date field.
void showAsDate(QDateEdit* field);

}  // namespace torsio::gui
