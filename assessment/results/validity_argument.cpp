// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/validity_argument.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>
#include <variant>

#include "assessment/results/cohort_csv.h"
#include "assessment/results/validity_claims.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

constexpr std::string_view kPlannedMargin = "margin planned with the cohort";

/// Returns how far a value is on the right side of the threshold; negative: on the wrong side.
double roomFor(const ValidityThreshold& threshold, double value) noexcept {
  switch (threshold.side) {
    case ThresholdSide::kAtLeast:
      return value - threshold.value;
    case ThresholdSide::kAtMost:
      return threshold.value - value;
    case ThresholdSide::kWithin:
      return threshold.value - std::abs(value);
  }
  return 0.0;
}

/// Returns the threshold of a claim, for a cohort.
std::optional<ValidityThreshold> thresholdOf(const ValidityClaim& claim, const CohortInputs& in) {
  std::optional<ValidityThreshold> threshold = claim.threshold;
  if (claim.byMargin && threshold && in.hasAnalysisPlan()) {
    threshold->value = *in.equivalenceMargin;
    threshold->source = kPlannedMargin;
    threshold->sealed = true;
  }
  return threshold;
}

/// Writes what one result says into `line`.
void weigh(const ValidityEvidence& one, EvidenceKind kind, ValidityLine& line) {
  line.counted = kind != EvidenceKind::kEstimate;
  line.n = one.number->n;
  line.cell = keyAddress(one.number->key);
  line.number = numberIn(one.number->value);
  if (line.number && kind == EvidenceKind::kShare) {
    *line.number /= static_cast<double>(one.number->n);
  }
  if (const auto* undefined = std::get_if<Undefined>(&one.number->value)) {
    line.note = undefined->reason.str();
  }
  if (one.interval != nullptr) {
    if (const auto* interval = std::get_if<Interval>(&one.interval->value)) {
      line.interval = *interval;
    }
  }
  line.verdict = !line.number || !line.threshold ? ValidityVerdict::kNotShown
                 : line.counted                  ? verdictOfCount(*line.threshold, *line.number)
                                                 : verdictOf(*line.threshold, line.interval);
}

/// Orders verdicts by how much they speak against a claim.
int weightOf(ValidityVerdict verdict) noexcept {
  return verdict == ValidityVerdict::kNotSupported ? 2 : verdict == ValidityVerdict::kNotShown ? 1 : 0;
}

/// Returns whether `one` speaks more against the claim than `other`, which has the same threshold.
bool isWorse(const ValidityLine& one, const ValidityLine& other) noexcept {
  if (one.verdict != other.verdict) {
    return weightOf(one.verdict) > weightOf(other.verdict);
  }
  return one.number && other.number && one.threshold &&
         roomFor(*one.threshold, *one.number) < roomFor(*other.threshold, *other.number);
}

/// Returns whether there are marks that may not be shown yet.
bool marksAreWithheld(const AnalysedCohort& analysed) {
  const Result* present =
      analysed.ledger.find({.section = ResultSection::kTraining, .statistic = "sheets_present"});
  return analysed.shown.trainingMarks.empty() && present != nullptr && numberIn(present->value) > 0.0;
}

ValidityLine lineOf(const ValidityClaim& claim, const AnalysedCohort& analysed) {
  ValidityLine line{claim.id, claim.inference, claim.source, claim.claim, thresholdOf(claim, analysed.shown)};
  const std::vector<ValidityEvidence> found =
      claim.find == nullptr ? std::vector<ValidityEvidence>{} : claim.find(analysed);
  if (found.empty()) {
    if (claim.find != nullptr && claim.fromMarks && marksAreWithheld(analysed)) {
      line.verdict = ValidityVerdict::kNotShown;
      line.note = "shown once every sheet is in, or the data set is frozen";
    } else {
      line.note = std::string(claim.toCollect);
    }
    return line;
  }
  std::optional<ValidityLine> worst;
  for (const ValidityEvidence& one : found) {
    ValidityLine candidate = line;
    weigh(one, claim.kind, candidate);
    if (!worst || isWorse(candidate, *worst)) {
      worst = std::move(candidate);
    }
  }
  worst->results = std::ssize(found);
  bool undecided = false;
  if (const std::string remark = claim.remark == nullptr ? "" : claim.remark(analysed, undecided);
      !remark.empty()) {
    worst->note += (worst->note.empty() ? "" : "; ") + remark;
  }
  if (undecided) {
    worst->verdict = ValidityVerdict::kNotShown;
  }
  return *worst;
}

}  // namespace

std::string_view nameOf(Inference inference) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"scoring", "generalisation", "extrapolation",
                                                   "implications"};
  return kNames[static_cast<std::size_t>(inference)];
}

std::string_view nameOf(EvidenceSource source) noexcept {
  constexpr std::array<std::string_view, 5> kNames{"content", "response process", "internal structure",
                                                   "relations to other variables", "consequences"};
  return kNames[static_cast<std::size_t>(source)];
}

std::string_view nameOf(ValidityVerdict verdict) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"supported", "not supported", "not shown",
                                                   "not collected"};
  return kNames[static_cast<std::size_t>(verdict)];
}

std::string thresholdText(const ValidityThreshold& threshold) {
  const std::string value = resultText(threshold.value);
  const std::string words = threshold.side == ThresholdSide::kAtLeast  ? "at least " + value
                            : threshold.side == ThresholdSide::kAtMost ? "at most " + value
                                                                       : "within -" + value + " to " + value;
  return threshold.unit.empty() ? words : words + " " + std::string(threshold.unit);
}

ValidityVerdict verdictOf(const ValidityThreshold& threshold,
                          const std::optional<Interval>& interval) noexcept {
  if (!interval) {
    return ValidityVerdict::kNotShown;
  }
  const bool lower = roomFor(threshold, interval->lower) >= 0.0;
  const bool upper = roomFor(threshold, interval->upper) >= 0.0;
  if (lower && upper) {
    return ValidityVerdict::kSupported;
  }
  const bool around =
      threshold.side == ThresholdSide::kWithin && interval->lower < 0.0 && interval->upper > 0.0;
  return lower || upper || around ? ValidityVerdict::kNotShown : ValidityVerdict::kNotSupported;
}

ValidityVerdict verdictOfCount(const ValidityThreshold& threshold, double number) noexcept {
  return roomFor(threshold, number) >= 0.0 ? ValidityVerdict::kSupported : ValidityVerdict::kNotSupported;
}

std::vector<ValidityLine> validityArgument(const AnalysedCohort& analysed) {
  std::vector<ValidityLine> lines;
  for (const ValidityClaim& claim : validityClaims()) {
    lines.push_back(lineOf(claim, analysed));
  }
  return lines;
}

std::string validityCsvText(const std::vector<ValidityLine>& lines) {
  std::string text;
  appendCsvLine(
      text, std::array<std::string, 15>{"id", "inference", "source", "claim", "threshold", "threshold_source",
                                        "threshold_sealed", "number", "lower_95", "upper_95", "n", "results",
                                        "cell", "verdict", "note"});
  for (const ValidityLine& line : lines) {
    const bool some = line.results > 0;
    appendCsvLine(text, std::array<std::string, 15>{std::string(line.id), std::string(nameOf(line.inference)),
                                                    std::string(nameOf(line.source)), std::string(line.claim),
                                                    line.threshold ? thresholdText(*line.threshold) : "",
                                                    line.threshold ? std::string(line.threshold->source) : "",
                                                    !line.threshold          ? ""
                                                    : line.threshold->sealed ? "yes"
                                                                             : "no",
                                                    line.number ? resultText(*line.number) : "",
                                                    line.interval ? resultText(line.interval->lower) : "",
                                                    line.interval ? resultText(line.interval->upper) : "",
                                                    some ? std::to_string(line.n) : "",
                                                    some ? std::to_string(line.results) : "", line.cell,
                                                    std::string(nameOf(line.verdict)), line.note});
  }
  return text;
}

}  // namespace torsio
