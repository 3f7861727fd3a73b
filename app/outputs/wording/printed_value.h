// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

namespace torsio {

// Sources, the record and files write times as ISO 8601 has them and whole numbers without groups, so that
// programs read them. What people read instead. Any thread.

/// The form of a day, as QLocale::toString and QDateEdit take it. In English the month is in letters: 03/12
/// is March to some and December to others.
[[nodiscard]] QString dayFormat(const QLocale& locale);

/// A text that is a time as formatUtc() writes it ("2026-01-05 08:00 UTC"), with its day in the form of the
/// locale ("5 Jan 2026 08:00 UTC"); any other as it stands.
[[nodiscard]] QString printedTime(QString text, const QLocale& locale);

/// A text that is a whole number, with its digits in groups; any other as it stands.
[[nodiscard]] QString printedCount(QString text, const QLocale& locale);

}  // namespace torsio
