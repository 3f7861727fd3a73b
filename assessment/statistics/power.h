// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace torsio {

inline constexpr double kDefaultAlpha = 0.05;

// Sizes are real numbers; round up. Contract: arguments are in range.

/// Returns the power of the two-sided two-sample t test, both tails, for standardised difference d and n
/// trainees per group.
[[nodiscard]] double powerTwoSampleT(double n, double d, double alpha = kDefaultAlpha);
[[nodiscard]] double sizeTwoSampleT(double d, double power, double alpha = kDefaultAlpha);
/// Returns the standardised difference that n per group detect with the given power.
[[nodiscard]] double detectableTwoSampleT(double n, double power, double alpha = kDefaultAlpha);
/// Returns the difference, in standard errors, that a two-sided t test with `df` detects with this power.
[[nodiscard]] double detectableStandardErrors(double df, double power, double alpha = kDefaultAlpha);
[[nodiscard]] double powerPairedT(double pairs, double d, double alpha = kDefaultAlpha);
[[nodiscard]] double detectablePairedT(double pairs, double power, double alpha = kDefaultAlpha);
/// Returns the number of pairs that detects standardised mean difference d with the given power.
[[nodiscard]] double sizePairedT(double d, double power, double alpha = kDefaultAlpha);
/// Returns the power of a one-way analysis of variance of k groups of n for Cohen's f.
[[nodiscard]] double powerAnova(int groups, double n, double f, double alpha = kDefaultAlpha);
[[nodiscard]] double sizeAnova(int groups, double f, double power, double alpha = kDefaultAlpha);
/// Returns Cohen's f that k groups of n detect with the given power.
[[nodiscard]] double detectableAnova(int groups, double n, double power, double alpha = kDefaultAlpha);
/// Returns the size for analysis of covariance: `sizeWithout` times 1 - rho^2 (correlation before and after).
[[nodiscard]] double sizeWithCovariate(double sizeWithout, double rho);
/// Returns the number of targets for an intraclass correlation interval of the given width (Bonett 2002).
[[nodiscard]] double sizeIccWidth(double icc, int raters, double width, double confidence = 0.95);

}  // namespace torsio
