// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

namespace torsio {

// Sources, the record and files have times in ISO 8601 and whole numbers without grouping, for programs.
// These functions format them for readers. Any thread.

/// Returns the date format for QLocale::toString and QDateEdit. In English the month is a word: 03/12 is
/// March to some and December to others.
[[nodiscard]] QString dayFormat(const QLocale& locale);

/// Reformats a time written by formatUtc() ("2026-01-05 08:00 UTC") with the date in the locale's format ("5
/// Jan 2026 08:00 UTC"); other texts are unchanged.
[[nodiscard]] QString printedTime(QString text, const QLocale& locale);

/// Groups the digits of a whole number; other texts are unchanged.
[[nodiscard]] QString printedCount(QString text, const QLocale& locale);

}  // namespace torsio
