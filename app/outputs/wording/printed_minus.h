// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace torsio {

// Sources, the record and files write the minus as a hyphen for programs. Readers see U+2212. Any thread.

/// Replaces the hyphen by a minus before a number ("-1.4", "[-1.7; -1.2]") and in "n - 1", which then stays
/// on one line. Hyphens of words, dates, codes and powers of ten ("1e-05") stay.
[[nodiscard]] QString printedMinus(QString text);

/// Like printedMinus(), for a Text pattern with arguments: also replaces it between two of them ("%1 - %2").
[[nodiscard]] QString printedPattern(QString pattern);

/// Replaces the typographic minus by a hyphen, for files.
[[nodiscard]] QString plainMinus(QString shown);

}  // namespace torsio
