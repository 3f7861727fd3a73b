// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "assessment/statistics/values.h"

namespace torsio {

/// Adjusts p values by Bonferroni, in the given order; the family must be fixed before the data are seen.
[[nodiscard]] std::vector<double> adjustBonferroni(std::span<const double> p);
[[nodiscard]] std::vector<double> adjustHolm(std::span<const double> p);  ///< family-wise error rate
/// Returns for each p value the number by which Holm's method multiplies it, at least its step's. An interval
/// with the confidence 1 - alpha / factor excludes 0 exactly if the adjusted p value is below alpha (Ludbrook
/// 2000).
[[nodiscard]] std::vector<double> holmFactors(std::span<const double> p);
/// Returns that interval of a difference with Student's t; `factor`: its holmFactors().
[[nodiscard]] Interval holmInterval(double difference, double error, double df, double factor,
                                    double confidence);
[[nodiscard]] std::vector<double> adjustHochberg(
    std::span<const double> p);  ///< family-wise error rate, independent tests
[[nodiscard]] std::vector<double> adjustBenjaminiHochberg(
    std::span<const double> p);  ///< false discovery rate

}  // namespace torsio
