// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/validity_claims.h"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "assessment/results/cohort_csv.h"

namespace torsio {

namespace {

using enum ResultSection;
using Evidences = std::vector<ValidityEvidence>;

/// Returns the results of a pattern, each with its interval: the result `interval` of the same place.
Evidences resultsWith(const Ledger& ledger, const ResultPattern& pattern, const std::string& interval) {
  Evidences found;
  for (const Result* number : ledger.select(pattern)) {
    ResultKey at = number->key;
    at.statistic = interval;
    found.push_back({number, ledger.find(at)});
  }
  return found;
}

/// The same, where the interval has the number's own name with its level.
Evidences estimatesOf(const Ledger& ledger, const ResultPattern& pattern) {
  return resultsWith(ledger, pattern, pattern.statistic + "_95");
}

/// Returns a single result; none for a count of nothing.
Evidences singleCount(const Ledger& ledger, const ResultKey& key) {
  const Result* found = ledger.find(key);
  return found == nullptr || found->n == 0 ? Evidences{} : Evidences{{found, nullptr}};
}

ResultPattern atTheEnd(const Ledger& ledger, ResultSection section, std::string statistic) {
  return {.section = section, .statistic = std::move(statistic), .occasion = ledger.lastOccasion()};
}

Evidences waysOfMarks(const AnalysedCohort& of, const char* way) {
  return singleCount(of.ledger, {.section = kRecord, .statistic = way, .of = "training_marks"});
}

Evidences samplesRefused(const AnalysedCohort& of) {
  const Result* refused =
      of.ledger.find({.section = kRecord, .statistic = "refused_samples", .of = "recordings"});
  return refused == nullptr || of.shown.trials.empty() ? Evidences{} : Evidences{{refused, nullptr}};
}

Evidences competenceOfAll(const AnalysedCohort& of, const char* statistic) {
  return singleCount(of.ledger, {.section = kCompetence, .statistic = statistic});
}

bool onlyOn(const std::optional<double>& trained_min, const std::optional<double>& other_min) {
  return trained_min.value_or(0.0) > 0.0 && other_min && *other_min == 0.0;
}

/// Returns the differences at the end between groups planned on the simulator alone and on the real arm
/// alone.
Evidences simulatorAgainstRealArm(const AnalysedCohort& of) {
  Evidences found;
  if (!of.study) {
    return found;
  }
  const PrimaryStatistics names = primaryStatistics(of.study->primaryMethod());
  const std::vector<CohortGroup>& groups = of.shown.groups;
  for (std::size_t a = 0; a < groups.size(); ++a) {
    for (std::size_t b = a + 1; b < groups.size(); ++b) {
      const auto apart = [](const CohortGroup& virtualOne, const CohortGroup& realOne) {
        return onlyOn(virtualOne.plannedVirtual_min, virtualOne.plannedReal_min) &&
               onlyOn(realOne.plannedReal_min, realOne.plannedVirtual_min);
      };
      if (!apart(groups[a], groups[b]) && !apart(groups[b], groups[a])) {
        continue;
      }
      ResultPattern pair = atTheEnd(of.ledger, kComparison, names.difference);
      pair.group = of.ledger.group(a);
      pair.against = of.ledger.group(b);
      for (const ValidityEvidence& one : resultsWith(of.ledger, pair, names.interval)) {
        found.push_back(one);
      }
    }
  }
  return found;
}

std::string valueAt(const Ledger& ledger, const ResultKey& key) {
  const Result* found = ledger.find(key);
  return found == nullptr ? std::string() : resultText(found->value);
}

std::string remarkOnRaters(const AnalysedCohort& of, bool& /*undecided*/) {
  const auto needed = [&](const char* statistic) {
    return valueAt(of.ledger, atTheEnd(of.ledger, kAgreement, statistic));
  };
  const std::string byLimit = needed("raters_needed");
  const std::string byEstimate = needed("raters_needed_by_estimate");
  return (byLimit.empty() ? "No number of raters tried is enough for the lower limit"
                          : "Raters needed for the lower limit: " + byLimit) +
         (byEstimate.empty() ? "" : "; for the estimate alone: " + byEstimate);
}

/// A verdict that nobody could pass is never wrong in passing somebody.
std::string verdictsOnTooFewRuns(const AnalysedCohort& of, bool& undecided) {
  const Result* tooFew = of.ledger.find({.section = kCompetence, .statistic = "verdicts_on_too_few_runs"});
  if (tooFew == nullptr) {
    return {};
  }
  undecided = numberIn(tooFew->value) == static_cast<double>(tooFew->n);
  return "Verdicts on too few runs: " + resultText(tooFew->value) + " of " + std::to_string(tooFew->n);
}

constexpr std::string_view kKooLi = "Koo & Li 2016";
constexpr std::string_view kDowning = "Downing 2004";
constexpr std::string_view kCohen = "Cohen 1988";
constexpr std::string_view kHalfPoint = "half a point by convention; no published value";

constexpr ValidityThreshold kByMargin{ThresholdSide::kWithin, 0.5, "points", kHalfPoint};

constexpr auto kClaims = std::to_array<ValidityClaim>({
    // Scoring: from the performance to the mark.
    {.id = "scoring.sheet",
     .inference = Inference::kScoring,
     .source = EvidenceSource::kContent,
     .claim = "Every mark of the training study was given on a scoring sheet.",
     .threshold = ValidityThreshold{ThresholdSide::kAtMost, 0.0, "of the marks without a sheet", "Downing 2003"},
     .toCollect = "marks on the scoring sheets of the review desk or of the real arm",
     .kind = EvidenceKind::kShare,
     .find = [](const AnalysedCohort& of) { return waysOfMarks(of, "entered_without_sheet"); }},
    {.id = "scoring.relevance",
     .inference = Inference::kScoring,
     .source = EvidenceSource::kContent,
     .claim = "Physicians who had no part in writing the scoring sheet find its criteria relevant.",
     .threshold = ValidityThreshold{ThresholdSide::kAtLeast, 0.78, "", "Polit, Beck & Owen 2007"},
     .toCollect = "judgements of relevance, criterion by criterion, by at least six physicians"},
    {.id = "scoring.blinding",
     .inference = Inference::kScoring,
     .source = EvidenceSource::kResponseProcess,
     .claim = "Every mark was given on a recording under a case label, blind to trainee and group.",
     .threshold = ValidityThreshold{ThresholdSide::kAtLeast, 1.0, "of the marks", "Wood et al. 2008"},
     .toCollect = "marks on recordings under case labels",
     .kind = EvidenceKind::kShare,
     .find = [](const AnalysedCohort& of) { return waysOfMarks(of, "given_blinded"); }},
    {.id = "scoring.missing",
     .inference = Inference::kScoring,
     .source = EvidenceSource::kResponseProcess,
     .claim = "Too few marks are missing to matter.",
     .threshold = ValidityThreshold{ThresholdSide::kAtMost, 0.05, "of the marks", "Schafer 1999"},
     .toCollect = "marks of the trainees by physicians",
     .kind = EvidenceKind::kShare,
     .find =
         [](const AnalysedCohort& of) {
           return singleCount(of.ledger, {.section = kAgreement, .statistic = "marks_missing"});
         }},
    {.id = "scoring.recordings",
     .inference = Inference::kScoring,
     .source = EvidenceSource::kResponseProcess,
     .claim = "The recordings of the simulator are complete.",
     .threshold = ValidityThreshold{ThresholdSide::kAtMost, 0.0, "samples refused", "Downing 2003"},
     .toCollect = "recordings of runs on the simulator",
     .kind = EvidenceKind::kCount,
     .fromMarks = false,
     .find = samplesRefused},
    {.id = "scoring.use",
     .inference = Inference::kScoring,
     .source = EvidenceSource::kResponseProcess,
     .claim = "Physicians use the criteria as they are meant.",
     .toCollect = "what physicians think while they mark (thinking aloud, or reasons for single marks)"},
    {.id = "scoring.severity",
     .inference = Inference::kScoring,
     .source = EvidenceSource::kInternalStructure,
     .claim = "No physician is more severe or more lenient than the others by a difference that matters.",
     .threshold = kByMargin,
     .byMargin = true,
     .toCollect = "marks of the same trainees by at least two physicians",
     .find =
         [](const AnalysedCohort& of) {
           return estimatesOf(of.ledger,
                              {.section = kAgreement, .statistic = "severity_offset", .of = kEach});
         }},
    // Generalisation: from the mark to all marks that might have been given.
    {.id = "generalisation.raters",
     .inference = Inference::kGeneralisation,
     .source = EvidenceSource::kInternalStructure,
     .claim = "The mean mark at the end depends on the trainee, not on which physicians gave it.",
     .threshold = ValidityThreshold{ThresholdSide::kAtLeast, kWantedDependability, "", kDowning},
     .toCollect = "marks of the same trainees by at least two physicians",
     .find =
         [](const AnalysedCohort& of) {
           return estimatesOf(of.ledger, atTheEnd(of.ledger, kAgreement, "dependability_of_all_raters"));
         },
     .remark = remarkOnRaters},
    {.id = "generalisation.one_rater",
     .inference = Inference::kGeneralisation,
     .source = EvidenceSource::kInternalStructure,
     .claim = "The mark of a single physician would do, in each group.",
     .threshold = ValidityThreshold{ThresholdSide::kAtLeast, 0.75, "", kKooLi},
     .toCollect = "marks of the same trainees by at least two physicians",
     .find =
         [](const AnalysedCohort& of) {
           return estimatesOf(of.ledger, atTheEnd(of.ledger, kAgreement, "icc_2_1"));
         }},
    {.id = "generalisation.repetition",
     .inference = Inference::kGeneralisation,
     .source = EvidenceSource::kInternalStructure,
     .claim = "A trainee would get the same score on another day.",
     .threshold = ValidityThreshold{ThresholdSide::kAtLeast, 0.75, "", kKooLi},
     .toCollect = "two occasions without training between them"},
    {.id = "generalisation.exercises",
     .inference = Inference::kGeneralisation,
     .source = EvidenceSource::kInternalStructure,
     .claim = "A trainee would get the same score at another exercise.",
     .threshold = ValidityThreshold{ThresholdSide::kAtLeast, kWantedDependability, "", kDowning},
     .toCollect = "marks of each trainee at several exercises"},
    {.id = "generalisation.centres",
     .inference = Inference::kGeneralisation,
     .source = EvidenceSource::kOtherVariables,
     .claim = "The groups differ by as much at other centres.",
     .toCollect = "how far the differences may vary between centres, planned before the data; data of "
                  "several centres in one record"},
    // Extrapolation: from these marks to other performances.
    {.id = "extrapolation.experts",
     .inference = Inference::kExtrapolation,
     .source = EvidenceSource::kOtherVariables,
     .claim = "Experts get better marks than novices.",
     .threshold = ValidityThreshold{ThresholdSide::kAtLeast, 0.8, "(Hedges' g)", kCohen},
     .toCollect = "a group of experts, marked by the same physicians under case labels"},
    {.id = "extrapolation.simulator",
     .inference = Inference::kExtrapolation,
     .source = EvidenceSource::kOtherVariables,
     .claim = "In each group, trainees with smaller errors on the simulator get better marks at the end.",
     .threshold = ValidityThreshold{ThresholdSide::kAtMost, -0.5, "(Pearson's r)", kCohen},
     .toCollect = "recorded twists and marks of the same trainees",
     .find =
         [](const AnalysedCohort& of) {
           return estimatesOf(of.ledger, {.section = kPractice, .statistic = "error_score_correlation"});
         }},
    {.id = "extrapolation.real_arm",
     .inference = Inference::kExtrapolation,
     .source = EvidenceSource::kOtherVariables,
     .claim = "Training on the simulator alone ends where training on the real arm alone does.",
     .threshold = kByMargin,
     .byMargin = true,
     .toCollect = "one group trained on the simulator alone and one on the real arm alone",
     .find = simulatorAgainstRealArm},
    {.id = "extrapolation.retention",
     .inference = Inference::kExtrapolation,
     .source = EvidenceSource::kOtherVariables,
     .claim = "What was learned is still there months later.",
     .threshold = kByMargin,
     .byMargin = true,
     .toCollect = "marks at an occasion some months after the last training"},
    {.id = "extrapolation.patients",
     .inference = Inference::kExtrapolation,
     .source = EvidenceSource::kOtherVariables,
     .claim = "Trainees with better scores do better with patients.",
     .threshold = ValidityThreshold{ThresholdSide::kAtLeast, 0.5, "(Pearson's r)", kCohen},
     .toCollect = "marks of the same trainees with patients"},
    // Implications: from the performance to what is decided.
    {.id = "implications.learning",
     .inference = Inference::kImplications,
     .source = EvidenceSource::kConsequences,
     .claim = "In each group, the median trainee gains at least a difference that matters.",
     .threshold = ValidityThreshold{ThresholdSide::kAtLeast, 0.5, "points", kHalfPoint},
     .byMargin = true,
     .toCollect = "marks of the same trainees before and after training",
     .find =
         [](const AnalysedCohort& of) {
           return estimatesOf(of.ledger, atTheEnd(of.ledger, kComparison, "median_gain"));
         }},
    {.id = "implications.false_pass",
     .inference = Inference::kImplications,
     .source = EvidenceSource::kConsequences,
     .claim = "The rule of competence seldom passes who is not competent.",
     .threshold = ValidityThreshold{ThresholdSide::kAtMost, 0.05, "of those who should fail", kCohen},
     .toCollect = "runs at an exercise with a rule of competence",
     .kind = EvidenceKind::kCount,
     .fromMarks = false,
     .find = [](const AnalysedCohort& of) { return competenceOfAll(of, "false_pass_at_most"); },
     .remark = verdictsOnTooFewRuns},
    {.id = "implications.false_fail",
     .inference = Inference::kImplications,
     .source = EvidenceSource::kConsequences,
     .claim = "The rule of competence seldom fails who is competent.",
     .threshold = ValidityThreshold{ThresholdSide::kAtMost, 0.2, "of those who should pass", kCohen},
     .toCollect = "runs at an exercise with a rule of competence",
     .kind = EvidenceKind::kCount,
     .fromMarks = false,
     .find = [](const AnalysedCohort& of) { return competenceOfAll(of, "false_fail_at_most"); }},
    {.id = "implications.cut_score",
     .inference = Inference::kImplications,
     .source = EvidenceSource::kConsequences,
     .claim = "Judges agree where the pass mark lies.",
     .toCollect = "a table of judgements (torsio standard-setting); the record keeps no pass mark"},
    {.id = "implications.harms",
     .inference = Inference::kImplications,
     .source = EvidenceSource::kConsequences,
     .claim = "Nobody came to harm.",
     .threshold = ValidityThreshold{ThresholdSide::kAtMost, 0.0, "harms", "CONSORT 2025, item 27"},
     .toCollect = "harms counted in each group; the record keeps them in words (torsio report statement "
                  "harms)"},
    {.id = "implications.decisions",
     .inference = Inference::kImplications,
     .source = EvidenceSource::kConsequences,
     .claim = "Those who passed do as well afterwards as was expected of them.",
     .toCollect = "what became of those who passed and of those who did not"},
});

}  // namespace

std::span<const ValidityClaim> validityClaims() noexcept {
  return kClaims;
}

}  // namespace torsio
