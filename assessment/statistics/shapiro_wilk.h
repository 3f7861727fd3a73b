// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "assessment/statistics/values.h"

namespace torsio {

struct NormalityTest {
  double w = 0.0;
  double p = 0.0;
};
/// Tests 4 to 5000 values for normality by Shapiro-Wilk (Royston 1995). For examining residuals, not for
/// choosing tests.
[[nodiscard]] Outcome<NormalityTest> shapiroWilk(std::span<const double> values);

}  // namespace torsio
