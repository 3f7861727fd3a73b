// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsio::gui {

/// A bar or a gap of a barcode.
struct BarcodeStripe {
  double left = 0.0;  ///< in units of the narrowest bar
  double width = 1.0;
};

/// Returns the dark bars of digits as Code 39 (ISO/IEC 16388) with start and stop character, which every hand
/// scanner reads; wide bars are 2.5 narrow ones. Throws ContractError for anything but digits.
[[nodiscard]] std::vector<BarcodeStripe> code39(const std::string& digits);
/// Returns the total width without the quiet zones of ten on either side, in narrow bars.
[[nodiscard]] double code39Width(std::size_t digits) noexcept;

}  // namespace torsio::gui
