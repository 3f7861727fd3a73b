// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>

#include <QString>

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

}  // namespace torsio::gui
