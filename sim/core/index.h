// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace torsio {

/// Converts a count or position that is known not to be negative into the index of a container.
[[nodiscard]] constexpr std::size_t at(int i) noexcept {
  return static_cast<std::size_t>(i);
}

}  // namespace torsio
