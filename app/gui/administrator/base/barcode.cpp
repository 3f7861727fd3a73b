// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/gui/administrator/base/barcode.h"

#include <array>
#include <string_view>

#include "sim/core/contracts.h"

namespace torsio::gui {

namespace {

constexpr double kWide = 2.5;
constexpr std::string_view kBorder = "nwnnwnwnn";  // the character *
// Five bars and four gaps, bar first; w: wide.
constexpr std::array<std::string_view, 10> kDigits{"nnnwwnwnn", "wnnwnnnnw", "nnwwnnnnw", "wnwwnnnnn",
                                                   "nnnwwnnnw", "wnnwwnnnn", "nnwwwnnnn", "nnnwnnwnw",
                                                   "wnnwnnwnn", "nnwwnnwnn"};

void addSign(std::string_view pattern, double& at, std::vector<BarcodeStripe>& bars) {
  bool dark = true;
  for (const char width : pattern) {
    const double wide = width == 'w' ? kWide : 1.0;
    if (dark) {
      bars.push_back({at, wide});
    }
    at += wide;
    dark = !dark;
  }
  at += 1.0;  // gap between characters
}

}  // namespace

std::vector<BarcodeStripe> code39(const std::string& digits) {
  std::vector<BarcodeStripe> bars;
  double at = 0.0;
  addSign(kBorder, at, bars);
  for (const char digit : digits) {
    TORSIO_EXPECTS(digit >= '0' && digit <= '9');
    addSign(kDigits[static_cast<std::size_t>(digit - '0')], at, bars);
  }
  addSign(kBorder, at, bars);
  return bars;
}

double code39Width(std::size_t digits) noexcept {
  constexpr double kSign = 6.0 + 3.0 * kWide;  // three of nine stripes are wide
  return static_cast<double>(digits + 2) * (kSign + 1.0) - 1.0;
}

}  // namespace torsio::gui
