// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "assessment/statistics/values.h"

namespace torsio {

struct IccForm {
  double estimate = 0.0;             ///< may be negative; reported as is
  std::optional<Interval> interval;  ///< empty if the error variance is zero, or nothing bounds it
};

/// Intraclass correlations of Shrout and Fleiss (1979), with the mean squares they come from.
struct IccResult {
  std::size_t targets = 0;
  std::size_t raters = 0;
  double bms = 0.0;               ///< between targets
  double wms = 0.0;               ///< within targets
  double jms = 0.0;               ///< between raters
  double ems = 0.0;               ///< residual
  IccForm oneWaySingle;           ///< ICC(1,1): other raters for every target
  IccForm agreementSingle;        ///< ICC(2,1): same raters, absolute agreement
  IccForm consistencySingle;      ///< ICC(3,1): same raters, order only
  IccForm oneWayMean;             ///< ICC(1,k)
  IccForm agreementMean;          ///< ICC(2,k): reported, as scores are means over the same raters
  IccForm consistencyMean;        ///< ICC(3,k)
  double agreementDf = 0.0;       ///< Satterthwaite degrees of freedom of the ICC(2,1) interval
  std::optional<double> fOneWay;  ///< these six are empty if their error term is zero
  std::optional<double> pOneWay;
  std::optional<double> fTwoWay;
  std::optional<double>
      pTwoWay;  ///< of ICC(2,.) and ICC(3,.) = 0, degrees of freedom n - 1 and (n - 1)(k - 1)
  std::optional<double> fRaters;
  std::optional<double> pRaters;
  double varianceTargets = 0.0;
  double varianceRaters = 0.0;
  double varianceResidual = 0.0;
  double semConsistency = 0.0;  ///< sqrt(EMS), in score points
  double semAgreement = 0.0;    ///< sqrt(rater variance + EMS); negative rater variance counts as 0
  double semMean = 0.0;         ///< semAgreement / sqrt(k): of the mean over the raters
};

/// Mean squares of targets x raters, pooled over strata if there are several.
struct RatedSquares {
  double raters = 0.0;           ///< in each stratum
  double targetsPerRater = 0.0;  ///< mean over the strata
  double targets_ms = 0.0, targets_df = 0.0;
  double raters_ms = 0.0, raters_df = 0.0;
  double error_ms = 0.0, error_df = 0.0;
};
/// Returns the interval of the absolute agreement of a single rater, ICC(2,1), and its degrees of freedom
/// (McGraw and Wong 1996; Satterthwaite). Empty if nothing bounds it.
[[nodiscard]] std::optional<std::pair<Interval, double>> agreementInterval(
    const RatedSquares& squares, double confidence = kDefaultConfidence);
/// Returns the reliability of the mean of k raters from that of one (Spearman and Brown).
[[nodiscard]] constexpr double spearmanBrown(double single, double k) noexcept {
  return k * single / (1.0 + (k - 1.0) * single);
}

/// Computes the six intraclass correlations. `ratings`: targets x raters, complete. Raters that differ by
/// constants only leave no residual: consistency is 1, and ratios to the residual are empty. Undefined with
/// fewer than two of either, no variation between targets, or if squares overflow.
[[nodiscard]] Outcome<IccResult> intraclassCorrelation(const NumberTable& ratings,
                                                       double confidence = kDefaultConfidence);

struct CronbachResult {
  double alpha = 0.0;
  Interval interval;                                ///< Feldt
  std::vector<std::optional<double>> alphaWithout;  ///< one per item
  std::optional<double> standardized;               ///< from the mean correlation between items
};

/// Computes Cronbach's alpha. `answers`: persons x items. Undefined with fewer than two of either or if the
/// sums do not vary.
[[nodiscard]] Outcome<CronbachResult> cronbachAlpha(const NumberTable& answers,
                                                    double confidence = kDefaultConfidence);

struct KendallResult {
  double w = 0.0;             ///< with tie correction
  double wUncorrected = 0.0;  ///< shown only to explain differences from other programs
  double s = 0.0;
  double tieTerm = 0.0;  ///< sum of t^3 - t over all raters
  double chiSquared = 0.0;
  double df = 0.0;
  double p = 0.0;
};

/// Computes Kendall's W. `ratings`: targets x raters. Undefined if every rater ties all targets.
[[nodiscard]] Outcome<KendallResult> kendallW(const NumberTable& ratings);

struct BlandAltmanResult {
  std::size_t n = 0;
  double meanDifference = 0.0;
  double deviation = 0.0;
  Interval limits;  ///< mean +- multiplier x deviation
  Interval meanInterval;
  double limitError = 0.0;       ///< sqrt(3/n) x deviation
  double limitErrorExact = 0.0;  ///< sqrt(1/n + z^2 / (2 (n - 1))) x deviation
  Interval lowerLimitInterval;
  Interval upperLimitInterval;
  std::optional<double>
      slope;  ///< of the difference on the pair mean; away from 0: a proportional difference
};

inline constexpr double kAgreementLimit = 1.96;

/// Analyses differences x - y against pair means (Bland-Altman). Undefined for fewer than two pairs.
[[nodiscard]] Outcome<BlandAltmanResult> blandAltman(std::span<const double> x, std::span<const double> y,
                                                     double multiplier = kAgreementLimit,
                                                     double confidence = kDefaultConfidence);

/// Compares every rater with the mean of the others; a mean including the rater would agree by construction.
/// `ratings`: targets x raters, at least two raters.
[[nodiscard]] std::vector<Outcome<BlandAltmanResult>> blandAltmanAgainstPanel(const NumberTable& ratings);

}  // namespace torsio
