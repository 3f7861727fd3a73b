// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "sim/core/text.h"

namespace torsio {

/// Quantities that files, rosters and senders state about the world. What lies outside their plausible range
/// was most likely stated in another unit.
enum class Stated : std::uint8_t {
  kOrganSide,       ///< largest side of an organ's surface, m
  kInstrumentSide,  ///< largest side of an instrument's surface, m
  kVoxelSide,       ///< side of a scan's voxel, m
  kHandReach,       ///< farthest that a hand's instrument comes from its first position, m
  kHandSpeed,       ///< mean speed of an instrument, m/s
  kPosePeriod,      ///< from one pose of an instrument or marker to the next, s
  kMarkerWay,       ///< farthest that any marker on a limb moves from rest, m
  kScaleUsed,       ///< highest of many marks, share of its scale
  kAge,             ///< of a person, years
};

/// A unit in which people or programs write a quantity.
struct StatedUnit {
  std::string_view word{};  ///< in files and options: "mm"
  Phrase name{};            ///< in sentences: "millimetres"
  double si = 1.0;          ///< stored value of one such unit
};

/// A row of the table: the values that are believed.
struct PlausibleRow {
  Stated quantity{};
  double least = 0.0;  ///< SI (kAge: years)
  double most = 0.0;
  StatedUnit shown{};                   ///< in which the range is told
  std::span<const StatedUnit> units{};  ///< that may have been meant, the likeliest first; empty: none
};

/// Returns the row of a quantity.
[[nodiscard]] const PlausibleRow& plausible(Stated quantity) noexcept;
/// Whether a value, SI, is believed. NaN is not.
[[nodiscard]] bool isPlausible(Stated quantity, double value) noexcept;
/// Returns the range as people read it: "30 to 2000 mm"; without "years" for an age.
[[nodiscard]] Text plausibleRange(Stated quantity);
/// Formats a value, SI, in the unit of the range: "1400 mm".
[[nodiscard]] std::string inPlausibleUnit(Stated quantity, double value);

/// Returns the unit of a quantity that is written so in files; empty: there is none.
[[nodiscard]] std::optional<StatedUnit> statedUnit(Stated quantity, std::string_view word) noexcept;
/// Lists the words of its units: "m, cm, mm".
[[nodiscard]] std::string unitWords(Stated quantity);

/// A value that was read from what a file states.
struct StatedValue {
  Stated quantity{};
  double value = 0.0;  ///< SI, by the unit that the file states
};

/// Returns the likeliest unit in which all values would be plausible, if they grow with the unit and were
/// read in one of `stated_si`; empty where none is, or nothing is stated (0). The values' quantities share
/// their units.
[[nodiscard]] std::optional<StatedUnit> unitThatFits(std::span<const StatedValue> values, double stated_si);
/// Returns all such units, listed: "cm, mm"; empty where there is none.
[[nodiscard]] Text unitsThatFit(std::span<const StatedValue> values, double stated_si);

}  // namespace torsio
