// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace torsio {

// Sources, the record and files write the minus as a hyphen, so that programs read it. People read U+2212.
// Any thread.

/// What people read: the minus before a number ("-1.4", "[-1.7; -1.2]") and the one in "n - 1", which then
/// stays on one line. The hyphens of words, dates, codes and powers of ten ("1e-05") stay.
[[nodiscard]] QString printedMinus(QString text);

/// As printedMinus(), for a pattern of Text that has arguments: also what stands between two of them
/// ("%1 - %2").
[[nodiscard]] QString printedPattern(QString pattern);

/// As files have it: the minus of print becomes a hyphen.
[[nodiscard]] QString plainMinus(QString shown);

}  // namespace torsio
