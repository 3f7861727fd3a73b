// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include <QLocale>
#include <QString>

class QDate;
class QDateEdit;

namespace torsio::gui {

// Days and times as every screen shows them, by this computer's clock, in the form of dayFormat(). Any
// thread; fields on the GUI thread.

[[nodiscard]] QString dateText(const QDate& day, const QLocale& locale = QLocale());
/// `utc_us`: microseconds since 1970; 0: a dash.
[[nodiscard]] QString dayText(std::int64_t utc_us, const QLocale& locale = QLocale());
/// Day, hour and minute.
[[nodiscard]] QString shownTime(std::int64_t utc_us, const QLocale& locale = QLocale());

/// Gives a field for a day the same form.
void showAsDate(QDateEdit* field);

}  // namespace torsio::gui
