// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/report/report_labels.h"

#include "assessment/report/number_format.h"

namespace torsio {

namespace {

constexpr int kDecimals = 3;

}  // namespace

std::string withInterval(double value, const std::optional<Interval>& interval) {
  if (!interval) {
    return formatFixed(value, kDecimals);
  }
  return filledIn("%1 [%2, %3]", {formatFixed(value, kDecimals), formatFixed(interval->lower, kDecimals),
                                  formatFixed(interval->upper, kDecimals)});
}

Text notDefined(const std::string& reason) {
  return Text("not defined: %1", Text(reason));
}

std::string equalsP(double p) {
  return filledIn(p < 0.001 ? "p %1" : "p = %1", {formatP(p)});
}

}  // namespace torsio
