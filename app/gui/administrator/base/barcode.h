// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsio::gui {

/// A bar or a gap of a barcode.
struct BarcodeStripe {
  double left = 0.0;  ///< in widths of the narrowest bar
  double width = 1.0;
};

/// The dark bars of digits as Code 39 (ISO/IEC 16388) with its start and stop sign, which every hand scanner
/// reads; wide bars are 2.5 narrow ones. Throws ContractError for anything but digits.
[[nodiscard]] std::vector<BarcodeStripe> code39(const std::string& digits);
/// Width of all of it without the quiet zones of ten on either side, in narrow bars.
[[nodiscard]] double code39Width(std::size_t digits) noexcept;

}  // namespace torsio::gui
