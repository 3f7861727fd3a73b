// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>

#include <QString>

namespace torsio::gui {

// Numbers as every screen shows them: grouped as QLocale() groups, with the minus of print and no minus
// before a zero. What is typed, copied or written to a file keeps the plain form (plainMinus()). Any thread.

[[nodiscard]] QString numberText(double value, int decimals);
template <std::integral Count>
[[nodiscard]] QString countText(Count value) {
  return numberText(static_cast<double>(value), 0);
}

/// A number that was written in the form of files ("-1808.50", "7666"), with its decimals; empty: it is none,
/// or it has an exponent.
[[nodiscard]] QString numberText(const QString& plain);

}  // namespace torsio::gui
