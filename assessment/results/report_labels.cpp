// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/report_labels.h"

#include "assessment/results/number_format.h"

namespace torsio {

namespace {

constexpr int kLabelDecimals = 3;

}  // namespace

std::string withInterval(double value, const std::optional<Interval>& interval) {
  if (!interval) {
    return formatFixed(value, kLabelDecimals);
  }
  return filledIn("%1 %2", {formatFixed(value, kLabelDecimals), intervalText(*interval)});
}

std::string intervalText(const Interval& interval) {
  return filledIn("[%1, %2]",
                  {formatFixed(interval.lower, kLabelDecimals), formatFixed(interval.upper, kLabelDecimals)});
}

Text notDefined(const Text& reason) {
  return Text::tr("not defined: %1", reason);
}

Text meanTitle(Quantity quantity) {
  return Text::tr("Mean: %1", titleWithUnit(quantity));
}

Text medianTitle(Quantity quantity) {
  return Text::tr("Median: %1", titleWithUnit(quantity));
}

std::string equalsP(double p) {
  return filledIn(p < 0.001 ? "p %1" : "p = %1", {formatP(p)});
}

}  // namespace torsio
