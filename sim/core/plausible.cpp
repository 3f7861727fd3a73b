// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/core/plausible.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <vector>

namespace torsio {

namespace {

constexpr StatedUnit kMillimetres{"mm", Text::tr("millimetres"), 1e-3};
constexpr StatedUnit kMetres{"m", Text::tr("metres"), 1.0};
constexpr StatedUnit kSeconds{"s", Text::tr("seconds"), 1.0};
constexpr StatedUnit kYears{"years", Text::tr("years"), 1.0};

// 190 units read as metres are millimetres, though centimetres would pass too.
constexpr std::array<StatedUnit, 4> kLengths{
    {kMillimetres, kMetres, {"cm", Text::tr("centimetres"), 1e-2}, {"um", Text::tr("micrometres"), 1e-6}}};
constexpr std::array<StatedUnit, 3> kTracked{{kMetres, {"cm", Text::tr("centimetres"), 1e-2}, kMillimetres}};
constexpr std::array<StatedUnit, 4> kTimes{{{"ms", Text::tr("milliseconds"), 1e-3},
                                            {"us", Text::tr("microseconds"), 1e-6},
                                            kSeconds,
                                            {"ns", Text::tr("nanoseconds"), 1e-9}}};
constexpr std::array<StatedUnit, 2> kAges{{kYears, {"months", Text::tr("months"), 1.0 / 12.0}}};

constexpr std::array kRows = std::to_array<PlausibleRow>({
    {Stated::kOrganSide, 0.03, 2.0, kMillimetres, kLengths},
    {Stated::kInstrumentSide, 0.03, 0.6, kMillimetres, kLengths},
    {Stated::kVoxelSide, 1e-5, 0.05, kMillimetres, kLengths},
    {Stated::kHandReach, 0.002, 3.0, kMetres, kTracked},
    {Stated::kHandSpeed, 0.0, 3.0, {"m/s", Text::tr("metres a second"), 1.0}, kTracked},
    {Stated::kPosePeriod, 1e-4, 2.0, kSeconds, kTimes},
    {Stated::kMarkerWay, 0.0005, 1.5, kMillimetres, kTracked},
    {Stated::kScaleUsed, 0.1, 1.0, {"%", Text::verbatim("%"), 0.01}, {}},
    {Stated::kAge, 14.0, 100.0, {"", Text::tr("years"), 1.0}, kAges},
});

constexpr bool areInOrder() {
  for (std::size_t i = 0; i < kRows.size(); ++i) {
    if (static_cast<std::size_t>(kRows[i].quantity) != i) {
      return false;
    }
  }
  return true;
}
static_assert(areInOrder());

std::string rounded(double value) {
  std::array<char, 40> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

bool fit(std::span<const StatedValue> values, double scale) {
  return std::all_of(values.begin(), values.end(), [scale](const StatedValue& one) {
    return isPlausible(one.quantity, scale * one.value);
  });
}

std::vector<StatedUnit> fitting(std::span<const StatedValue> values, double stated_si) {
  std::vector<StatedUnit> found;
  if (!values.empty() && stated_si > 0.0) {
    const std::span<const StatedUnit> units = plausible(values.front().quantity).units;
    std::copy_if(units.begin(), units.end(), std::back_inserter(found), [&](const StatedUnit& unit) {
      return unit.si != stated_si && fit(values, unit.si / stated_si);
    });
  }
  return found;
}

}  // namespace

const PlausibleRow& plausible(Stated quantity) noexcept {
  return kRows[static_cast<std::size_t>(quantity)];
}

bool isPlausible(Stated quantity, double value) noexcept {
  const PlausibleRow& row = plausible(quantity);
  return value >= row.least && value <= row.most;
}

Text plausibleRange(Stated quantity) {
  const PlausibleRow& row = plausible(quantity);
  return Text::tr("%1 to %2", rounded(row.least / row.shown.si), inPlausibleUnit(quantity, row.most));
}

std::string inPlausibleUnit(Stated quantity, double value) {
  const StatedUnit& unit = plausible(quantity).shown;
  std::string text = rounded(value / unit.si);
  if (!unit.word.empty()) {
    text.append(" ").append(unit.word);
  }
  return text;
}

std::optional<StatedUnit> statedUnit(Stated quantity, std::string_view word) noexcept {
  const std::span<const StatedUnit> units = plausible(quantity).units;
  const auto found =
      std::find_if(units.begin(), units.end(), [word](const StatedUnit& unit) { return unit.word == word; });
  return found == units.end() ? std::nullopt : std::optional(*found);
}

std::string unitWords(Stated quantity) {
  std::string words;
  for (const StatedUnit& unit : plausible(quantity).units) {
    words += (words.empty() ? "" : ", ") + std::string(unit.word);
  }
  return words;
}

std::optional<StatedUnit> unitThatFits(std::span<const StatedValue> values, double stated_si) {
  const std::vector<StatedUnit> found = fitting(values, stated_si);
  return found.empty() ? std::nullopt : std::optional(found.front());
}

Text unitsThatFit(std::span<const StatedValue> values, double stated_si) {
  std::vector<Text> words;
  for (const StatedUnit& unit : fitting(values, stated_si)) {
    words.emplace_back(Text::verbatim("\"%1\"", unit.word));
  }
  return listed(words);
}

}  // namespace torsio
