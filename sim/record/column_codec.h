// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace torsio {

/// Appends one column of integers to `packed` so that smooth columns become mostly zero bytes: differences of
/// the order (0 to 4) that leaves the least, folded to unsigned, one plane a byte (shuffle). Any value of 64
/// bits survives.
void packColumn(std::span<const std::int64_t> column, std::vector<std::uint8_t>& packed);

/// Fills `column` from the front of `packed` and returns what follows. Throws Error{kBadData} when the bytes
/// cannot be a column of that length.
[[nodiscard]] std::span<const std::uint8_t> unpackColumn(std::span<const std::uint8_t> packed,
                                                         std::span<std::int64_t> column);

/// Returns the most bytes that packColumn appends for a column of this length.
[[nodiscard]] std::size_t largestPackedColumn(std::size_t length) noexcept;

}  // namespace torsio
