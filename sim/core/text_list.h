// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "sim/core/text.h"

namespace torsio {

/// Joins texts to "a, b, c"; empty for none. `two` is the pattern that joins two of them.
[[nodiscard]] inline Text listed(std::span<const Text> items, Phrase two = Text::tr("%1, %2")) {
  Text all;
  for (const Text& item : items) {
    all = all.empty() ? item : Text(two, all, item);
  }
  return all;
}

}  // namespace torsio
