// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "assessment/results/analysed_cohort.h"
#include "assessment/statistics/values.h"

namespace torsio {

/// Kane's inferences, from a performance to the decision that rests on it.
enum class Inference : std::uint8_t { kScoring, kGeneralisation, kExtrapolation, kImplications };
/// Messick's sources of evidence.
enum class EvidenceSource : std::uint8_t {
  kContent,
  kResponseProcess,
  kInternalStructure,
  kOtherVariables,
  kConsequences,
};
enum class ValidityVerdict : std::uint8_t {
  kSupported,
  kNotSupported,
  kNotShown,      ///< the interval spans the threshold, or there is no number although there are data
  kNotCollected,  ///< the record holds no data for it
};

/// Return "scoring", "response process", "not shown" ...
[[nodiscard]] std::string_view nameOf(Inference inference) noexcept;
[[nodiscard]] std::string_view nameOf(EvidenceSource source) noexcept;
[[nodiscard]] std::string_view nameOf(ValidityVerdict verdict) noexcept;

/// On which side of its threshold a number must lie.
enum class ThresholdSide : std::uint8_t {
  kAtLeast,
  kAtMost,
  kWithin
};  ///< kWithin: from minus to plus the threshold

/// What decides about a claim.
struct ValidityThreshold {
  ThresholdSide side = ThresholdSide::kAtLeast;
  double value = 0.0;       ///< in the unit of the number
  std::string_view unit{};  ///< "points"; empty: a coefficient or a share
  std::string_view source{};
  bool sealed = false;  ///< planned with the cohort, before its data
};

/// Returns "at least 0.8", "within -0.5 to 0.5 points" ...
[[nodiscard]] std::string thresholdText(const ValidityThreshold& threshold);

/// Judges an estimate by its interval, not by itself: without an interval nothing is shown.
[[nodiscard]] ValidityVerdict verdictOf(const ValidityThreshold& threshold,
                                        const std::optional<Interval>& interval) noexcept;
/// Judges a number that is counted or follows from the plan, so that it has no interval.
[[nodiscard]] ValidityVerdict verdictOfCount(const ValidityThreshold& threshold, double number) noexcept;

/// A claim with what the record says about it.
struct ValidityLine {
  std::string_view id;  ///< "generalisation.raters"
  Inference inference = Inference::kScoring;
  EvidenceSource source = EvidenceSource::kContent;
  std::string_view claim;                      ///< a sentence
  std::optional<ValidityThreshold> threshold;  ///< empty: none is agreed on
  std::optional<double> number{};              ///< of the result that speaks most against the claim
  std::optional<Interval> interval{};          ///< 95 %
  bool counted = false;                        ///< a count or a rate of the plan: it has no interval
  std::int64_t n = 0;                          ///< values used
  std::int64_t results = 0;                    ///< that the claim is about: each must keep to the threshold
  std::string cell{};                          ///< keyAddress() of the number; empty: none
  ValidityVerdict verdict = ValidityVerdict::kNotCollected;
  std::string note{};  ///< what would have to be collected, why a number is missing; may be empty
};

/// Weighs the results of a cohort, by Kane's inferences in order. Computes no statistic: each number is one
/// of `analysed.ledger`, or a count of it divided by its n.
[[nodiscard]] std::vector<ValidityLine> validityArgument(const AnalysedCohort& analysed);

/// Formats the lines as CSV with a header, like cohortCsvText().
[[nodiscard]] std::string validityCsvText(const std::vector<ValidityLine>& lines);

}  // namespace torsio
