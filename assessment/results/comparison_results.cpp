// SPDX-License-Identifier: GPL-3.0-or-later
// Results about the groups of the training study: their scores before, on the way and at the end.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/result_writer.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/power.h"
#include "assessment/statistics/shapiro_wilk.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

using enum ResultSection;

/// Returns the scores before and at the end, for trainees with both; `only`: of one group.
std::vector<ResultPart> endScores(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger,
                                  std::optional<std::size_t> only = std::nullopt) {
  std::vector<ResultPart> parts;
  for (std::size_t g = 0; g < study.endCodes.size(); ++g) {
    for (const std::string& code : only.value_or(g) == g ? study.endCodes[g] : std::vector<std::string>{}) {
      for (const std::size_t t : {std::size_t{0}, lastOf(in)}) {
        parts.emplace_back(ResultPattern{
            .statistic = "score", .of = code, .group = ledger.group(g), .occasion = ledger.occasion(t)});
      }
    }
  }
  return parts;
}

/// Returns the marks before and at the end, and who should be marked.
ResultParts endMarks(const Ledger& ledger) {
  return partsOf(
      {marksAt(ledger.occasion(0)), marksAt(ledger.lastOccasion()), RecordRef{RecordKind::kEnrolments}});
}

/// Returns the scores at every occasion, for trainees with a score at each.
ResultParts courseScores(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger,
                         std::optional<std::size_t> only = std::nullopt) {
  std::vector<ResultPart> parts{RecordRef{RecordKind::kEnrolments}};
  for (const TraineeScore& score : in.scores) {
    const auto& left = study.leftOutOfCourse;
    if (only.value_or(score.group) == score.group &&
        std::find(left.begin(), left.end(), score.trainee) == left.end()) {
      parts.emplace_back(ResultPattern{.statistic = "score",
                                       .of = score.trainee,
                                       .group = ledger.group(score.group),
                                       .occasion = ledger.occasion(score.occasion)});
    }
  }
  return partsOf(std::move(parts));
}

/// Returns a writer for the comparison of groups.
ResultWriter comparison(const CohortInputs& in, const ResultFlags& flags, ResultParts parts, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kComparison, .occasion = ledger.lastOccasion()}, commonFlags(in),
                    flags);
  rows.madeOf = std::move(parts);
  return rows;
}

void placeAtPair(ResultWriter& rows, std::size_t first, std::size_t second) {
  rows.place.group = rows.group(first);
  rows.place.against = rows.group(second);
}

void placeAtAll(ResultWriter& rows) {
  rows.place.group.clear();
  rows.place.against.clear();
}

void addEffect(ResultWriter& rows, const std::string& name, const AnovaEffect& effect, std::int64_t n) {
  rows.add(name + "_f", effect.f, n);
  rows.add(name + "_df", effect.df, n);
  rows.add(name + "_df_error", effect.dfError, n);
  rows.add(name + "_p", effect.p, n);
  if (effect.pGreenhouseGeisser) {
    rows.add(name + "_p_greenhouse_geisser", *effect.pGreenhouseGeisser, n);
  }
  rows.add(name + "_generalised_eta_squared", effect.generalizedEtaSquared, n);
}

/// Adds the groups' course over the occasions, for trainees with a score at each.
void addCourse(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  if (!study.course) {
    return;
  }
  std::int64_t n = 0;
  for (const NumberTable& group : study.courses) {
    n += static_cast<std::int64_t>(group.rows());
  }
  ResultWriter rows = comparison(in, flagIf(!study.leftOutOfCourse.empty(), "complete cases"),
                                 courseScores(in, study, ledger), ledger);
  if (study.course->interaction) {
    addEffect(rows, "mixed_interaction", *study.course->interaction, n);
  }
  if (study.course->group) {
    addEffect(rows, "mixed_group", *study.course->group, n);
  }
  addEffect(rows, "mixed_time", study.course->time, n);
  rows.addCount("trainees_without_every_score", std::ssize(study.leftOutOfCourse), n);
  rows.add("greenhouse_geisser_epsilon", study.course->sphericity.greenhouseGeisser, n);
}

/// Adds the groups' gains: each group separately, and compared by ranks.
void addGainResults(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  if (!study.gains) {
    return;
  }
  ResultWriter rows = comparison(in, {}, {}, ledger);
  for (std::size_t g = 0; g < study.gains->within.size(); ++g) {
    const GroupGain& gain = study.gains->within[g];
    rows.place.group = rows.group(g);
    std::vector<ResultPart> own = endScores(in, study, ledger, g);
    own.emplace_back(RecordRef{RecordKind::kEnrolments});
    rows.madeOf = partsOf(std::move(own));
    rows.add("median_gain", gain.median, &Bootstrap::estimate, gain.n);
    if (gain.median) {
      rows.put("median_gain_95", gain.median->bca, gain.n);
    }
    rows.add("gain_signed_rank_v", gain.ranks, &SignedRank::v, gain.n);
    rows.add("gain_signed_rank_p", gain.ranks, &SignedRank::pTwoSided, gain.n);
    rows.madeOf = courseScores(in, study, ledger, g);
    rows.add("occasions_friedman_p", gain.occasions, &Friedman::p,
             static_cast<std::int64_t>(study.courses[g].rows()));
  }
  placeAtAll(rows);
  rows.madeOf = partsOf(endScores(in, study, ledger));
  const Outcome<KruskalWallis>& between = study.gains->between;
  if (!between) {
    return;
  }
  std::int64_t n = 0;
  for (const std::vector<double>& group : study.gains->gains) {
    n += std::ssize(group);
  }
  rows.add("gain_kruskal_wallis_h", between->h, n);
  rows.add("gain_kruskal_wallis_p", between->p, n);
  rows.add("gain_epsilon_squared", between->epsilonSquared, n);
  for (std::size_t i = 0; i < between->pairs.size(); ++i) {
    const DunnPair& pair = between->pairs[i];
    const Outcome<MannWhitney>& ranks = study.gains->pairs[i];
    const std::int64_t two =
        std::ssize(study.gains->gains[pair.first]) + std::ssize(study.gains->gains[pair.second]);
    placeAtPair(rows, pair.first, pair.second);
    rows.add("gain_difference_of_mean_ranks", -pair.difference, two);
    rows.add("gain_dunn_z", -pair.z, two);
    rows.add("gain_dunn_p_holm", pair.pHolm, two);
    rows.add("gain_superiority", ranks, &MannWhitney::superiority, two);
    rows.add("gain_mann_whitney_p_exact", ranks, &MannWhitney::pExact, two);
  }
}

/// Describes the scores before in which two groups differ, of those that the scale has. `scale`: in points.
Text regionText(const SignificantRegion& region, const Interval& scale) {
  const auto below = [](double bound) {
    return Text(Text::tr("for a score before below %1", formatFixed(bound, 2)));
  };
  const auto above = [](double bound) {
    return Text(Text::tr("for a score before above %1", formatFixed(bound, 2)));
  };
  const Text everywhere = Text::tr("for every score before");
  const Text nowhere = Text::tr("for no score before");
  // Of five texts the one that fits where the two bounds lie on the scale.
  const auto onScale = [&scale](const Interval& bounds, const Text& beside, const Text& around,
                                const Text& upperOnly, const Text& lowerOnly, const Text& within) {
    const auto [lower, upper] = bounds;
    return lower >= scale.upper || upper <= scale.lower   ? beside
           : lower <= scale.lower && upper >= scale.upper ? around
           : lower <= scale.lower                         ? upperOnly
           : upper >= scale.upper                         ? lowerOnly
                                                          : within;
  };
  if (region.inside) {
    const auto [lower, upper] = *region.inside;
    return onScale(
        *region.inside, nowhere, everywhere, below(upper), above(lower),
        Text::tr("for a score before between %1 and %2", formatFixed(lower, 2), formatFixed(upper, 2)));
  }
  if (region.outside) {
    const auto [lower, upper] = *region.outside;
    return onScale(
        *region.outside, everywhere, nowhere, above(upper), below(lower),
        Text::tr("for a score before below %1 or above %2", formatFixed(lower, 2), formatFixed(upper, 2)));
  }
  return region.everywhere ? everywhere : nowhere;
}

void addSlopes(const CohortInputs& in, const StudyAnalysis& study, std::int64_t n, ResultWriter& rows) {
  if (!study.slopes) {
    return;
  }
  for (std::size_t g = 0; g < study.slopes->slopes.size(); ++g) {
    rows.place.group = rows.group(study.slopes->groups[g]);
    rows.add("separate_slope", study.slopes->slopes[g], n);
  }
  const Interval scale{pointsFromSteps(in.trainingScale.lo, in.trainingScale),
                       pointsFromSteps(in.trainingScale.hi, in.trainingScale)};
  for (const SlopesPair& pair : study.slopes->pairs) {
    placeAtPair(rows, pair.first, pair.second);
    for (std::size_t b = 0; b < pair.at.size(); ++b) {
      const ResultKey key = slopesKey(study, b);
      rows.place.index = key.index;
      rows.place.record = key.record;
      rows.add("separate_slopes_score_before", study.slopes->baselines[b], n);
      rows.addInterval("separate_slopes_difference", pair.at[b].difference, pair.at[b].interval, n);
      rows.add("separate_slopes_p", pair.at[b].p, n);
      rows.add("separate_slopes_p_holm", pair.at[b].pHolm, n);
    }
    rows.place.index.clear();
    rows.place.record.clear();
    rows.put("separate_slopes_differ", regionText(pair.region, scale), n);
  }
  placeAtAll(rows);
}

void addEquivalence(const CohortInputs& in, const StudyAnalysis& study, std::int64_t n, ResultWriter& rows) {
  if (!in.equivalenceMargin) {
    return;
  }
  rows.origin = Origin::kPlanned;
  const ResultParts compared = rows.madeOf;
  rows.madeOf = partsOf({RecordRef{RecordKind::kCohortPlan}});
  rows.add("equivalence_margin", *in.equivalenceMargin, n);
  rows.madeOf = compared;
  for (const PrimaryDifference& pair : primaryDifferences(study)) {
    if (!(pair.error > 0.0)) {
      continue;
    }
    const Equivalence test = equivalence(pair.value, pair.error, pair.df, *in.equivalenceMargin);
    placeAtPair(rows, pair.first, pair.second);
    rows.add("equivalence_p", test.p, n);
    rows.put("equivalence_90", test.interval, n);
  }
  placeAtAll(rows);
}

/// Adds the difference of each pair that the primary comparison detects with a power of kWantedPower,
/// whatever the other pairs are: at the level of Holm's first step.
void addDetectable(const StudyAnalysis& study, std::int64_t n, ResultWriter& rows) {
  const std::vector<PrimaryDifference> pairs = primaryDifferences(study);
  const double alpha =
      (1.0 - kDefaultConfidence) / static_cast<double>(std::max<std::size_t>(1, pairs.size()));
  for (const PrimaryDifference& pair : pairs) {
    if (pair.error > 0.0 && pair.df > 0.0) {
      placeAtPair(rows, pair.first, pair.second);
      rows.add("detectable_difference", pair.error * detectableStandardErrors(pair.df, kWantedPower, alpha),
               n);
    }
  }
  placeAtAll(rows);
}

/// Adds how the residuals of the groups spread, and the comparison that allows for unequal spreads.
void addSpread(const StudyAnalysis& study, std::int64_t n, ResultWriter& rows) {
  const UnequalSpread& spread = study.ancova->spread;
  rows.add("largest_spread", spread.largest, n);
  rows.add("smallest_spread", spread.smallest, n);
  rows.add("equal_spread_p", spread.test, &FTest::p, n);
  for (const AdjustedDifference& pair : spread.pairs) {
    placeAtPair(rows, pair.first, pair.second);
    rows.addInterval("robust_difference", pair.difference, pair.interval, n);
    rows.put("robust_difference_holm_95", pair.asHolm, n);
    rows.add("robust_error", pair.error, n);
    rows.add("robust_df", pair.df, n);
    rows.add("robust_t", pair.t, n);
    rows.add("robust_p", pair.p, n);
    rows.add("robust_p_holm", pair.pHolm, n);
  }
  placeAtAll(rows);
}

/// Adds how the groups differed before, in standard deviations within groups.
void addBaseline(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  const Groups& before = study.ends.before;
  const Outcome<OneWayAnova> within = oneWayAnova(before);
  if (!within) {
    return;
  }
  const std::int64_t n = comparedTrainees(study);
  ResultWriter rows = comparison(in, {}, partsOf(endScores(in, study, ledger)), ledger);
  for (std::size_t g = 0; g < before.size(); ++g) {
    for (std::size_t h = g + 1; h < before.size(); ++h) {
      if (!before[g].empty() && !before[h].empty()) {
        placeAtPair(rows, g, h);
        rows.add("difference_before_in_sd",
                 (meanOf(before[g]) - meanOf(before[h])) / std::sqrt(within->msWithin), n);
      }
    }
  }
}

/// Adds the comparison of those who were trained as planned.
void addPerProtocol(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  if (!study.perProtocol) {
    return;
  }
  std::vector<ResultPart> parts{RecordRef{RecordKind::kTrainingTimes}, RecordRef{RecordKind::kCohortPlan}};
  for (const std::string& code : study.perProtocolCodes) {
    for (const std::size_t t : {std::size_t{0}, lastOf(in)}) {
      parts.emplace_back(ResultPattern{.statistic = "score", .of = code, .occasion = ledger.occasion(t)});
    }
  }
  ResultWriter rows = comparison(in, {"per protocol"}, partsOf(std::move(parts)), ledger);
  const Ancova& treated = *study.perProtocol;
  for (const AdjustedDifference& pair : concludedPairs(treated)) {
    placeAtPair(rows, pair.first, pair.second);
    const std::int64_t n = std::ssize(study.perProtocolCodes);
    rows.add("per_protocol_difference", pair.difference, n);
    rows.put("per_protocol_difference_holm_95", pair.asHolm, n);
    rows.add("per_protocol_p_holm", pair.pHolm, n);
  }
}

/// Adds whether the residuals look normal, and the data of their plots, one row per trainee.
void addResiduals(const CohortInputs& in, const StudyAnalysis& study, ResultWriter& rows) {
  std::vector<double> all;
  for (const std::vector<double>& group : study.ancova->residuals) {
    all.insert(all.end(), group.begin(), group.end());
  }
  if (const Outcome<NormalityTest> shape = shapiroWilk(all)) {
    rows.add("residuals_shapiro_wilk_w", shape->w, std::ssize(all));
    rows.add("residuals_shapiro_wilk_p", shape->p, std::ssize(all));
  }
  for (std::size_t g = 0; g < study.ancova->residuals.size(); ++g) {
    rows.place.group = rows.group(g);
    for (std::size_t i = 0; i < study.ancova->residuals[g].size(); ++i) {
      rows.place.of = study.endCodes[g][i];
      const auto score = [&](std::size_t t) {
        return ResultPattern{.statistic = "score",
                             .of = rows.place.of,
                             .group = rows.place.group,
                             .occasion = rows.occasion(t)};
      };
      rows.madeOf = partsOf(
          {score(0), score(lastOf(in)), ResultPattern{.section = kComparison, .statistic = "ancova_slope"}});
      rows.add("ancova_fitted", study.ancova->fitted[g][i], 1);
      rows.add("ancova_residual", study.ancova->residuals[g][i], 1);
      rows.add("ancova_normal_quantile", study.ancova->quantiles[g][i], 1);
    }
  }
}

void addComparison(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  const std::int64_t n = comparedTrainees(study);
  if (!primaryDifferences(study).empty()) {
    ResultWriter rows = comparison(in, flagIf(!study.asPlanned(), "marks missing"), endMarks(ledger), ledger);
    const Text covariance = Text::verbatim("analysis of covariance");
    rows.put("planned_analysis",
             in.hasAnalysisPlan() ? covariance : Text(Text::verbatim("none in the record")), n);
    rows.put("primary_analysis",
             study.primaryMethod() == PrimaryMethod::kMixed    ? Text(Text::verbatim("linear mixed model"))
             : study.primaryMethod() == PrimaryMethod::kRobust ? Text::verbatim("%1, HC3", covariance)
             : study.primaryMethod() == PrimaryMethod::kCentres
                 ? Text::verbatim("%1 within centres", covariance)
                 : covariance,
             n);
    addDetectable(study, n, rows);
    rows.addCount("marks_missing", study.endMissing, study.endMarks + study.endMissing);
    rows.addCount("marks_at_both_ends", study.endMarks, study.endMarks + study.endMissing);
    rows.addCount("trainees_compared", n, n);
    rows.addCount("trainees_left_out", std::ssize(leftOutTrainees(study)), n);
    addEquivalence(in, study, n, rows);
  }
  if (!study.ancova) {
    return;
  }
  ResultWriter rows = comparison(in, flagIf(!study.asPlanned(), "complete cases"),
                                 partsOf(endScores(in, study, ledger)), ledger);
  rows.origin = in.hasAnalysisPlan() ? Origin::kPlanned : Origin::kUnplanned;
  rows.add("ancova_df", study.ancova->group.df1, n);
  rows.add("ancova_df_error", study.ancova->group.df2, n);
  rows.add("ancova_f", study.ancova->group.f, n);
  rows.add("ancova_p", study.ancova->group.p, n);
  rows.add("ancova_slope", study.ancova->slope, n);
  if (study.ancova->equalSlopes) {
    rows.add("ancova_equal_slopes_p", study.ancova->equalSlopes->p, n);
  }
  for (std::size_t g = 0; g < study.ancova->adjusted.size(); ++g) {
    rows.place.group = rows.group(study.ancova->groups[g]);
    rows.addInterval("adjusted_mean", study.ancova->adjusted[g].mean, study.ancova->adjusted[g].interval, n);
  }
  const Groups& after = study.ends.after;
  for (const AdjustedDifference& pair : study.ancova->pairs) {
    placeAtPair(rows, pair.first, pair.second);
    rows.addInterval("adjusted_difference", pair.difference, pair.interval, n);
    rows.put("adjusted_difference_holm_95", pair.asHolm, n);
    rows.put("adjusted_difference_simultaneous_95", pair.simultaneous, n);
    rows.add("t", pair.t, n);
    rows.add("p", pair.p, n);
    rows.add("p_holm", pair.pHolm, n);
    if (const Outcome<HedgesG> g = hedgesG(after[pair.first], after[pair.second])) {
      rows.addInterval("hedges_g", g->g, g->interval, n);
    } else {
      rows.put("hedges_g", Undefined{g.reason()}, n);
    }
  }
  placeAtAll(rows);
  rows.origin = Origin::kUnplanned;
  addSpread(study, n, rows);
  addSlopes(in, study, n, rows);
  addResiduals(in, study, rows);
}

/// Adds whose marks are missing.
void addMissingTrainees(const StudyAnalysis& study, ResultWriter& rows) {
  placeAtAll(rows);
  for (const MissingTrainee& trainee : study.missing) {
    rows.place.of = trainee.trainee;
    rows.place.group = rows.group(trainee.group);
    rows.addCount("marks_missing_before", static_cast<std::int64_t>(trainee.marks.before), 1);
    rows.addCount("marks_missing_at_the_end", static_cast<std::int64_t>(trainee.marks.after), 1);
    rows.put("compared", !trainee.leftOut, 1);
  }
}

/// Adds the fixed effects and variances of the mixed model.
void addModel(const MixedComparison& model, ResultWriter& rows) {
  const auto n = static_cast<std::int64_t>(model.marks);
  rows.addCount("mixed_model_marks", n, n);
  rows.addCount("mixed_model_trainees", static_cast<std::int64_t>(model.trainees), n);
  if (model.group) {
    rows.add("mixed_model_group_df", model.group->df1, n);
    rows.add("mixed_model_group_df_error", model.group->df2, n);
    rows.add("mixed_model_group_f", model.group->f, n);
    rows.add("mixed_model_group_p", model.group->p, n);
  }
  rows.add("mixed_model_variance_of_trainees", model.varianceTrainees, n);
  rows.add("mixed_model_variance_of_raters", model.varianceRaters, n);
  rows.add("mixed_model_variance_of_rest", model.varianceResidual, n);
  rows.addInterval("mixed_model_slope", model.slope.value, model.slope.interval, n);
  for (std::size_t g = 0; g < model.adjusted.size(); ++g) {
    rows.place.group = rows.group(model.groups[g]);
    rows.addInterval("mixed_model_adjusted_mean", model.adjusted[g].value, model.adjusted[g].interval, n);
  }
  placeAtAll(rows);
}

/// Adds the comparison with missing marks: the mixed model, and how far missing marks could change it.
void addMixedModel(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  ResultWriter rows = comparison(in, {"marks missing"}, endMarks(ledger), ledger);
  const std::int64_t n = comparedTrainees(study);
  if (study.mixed) {
    addModel(*study.mixed, rows);
    for (const MixedComparison::Pair& pair : study.mixed->pairs) {
      placeAtPair(rows, pair.first, pair.second);
      rows.addInterval("mixed_model_difference", pair.difference.value, pair.difference.interval, n);
      rows.put("mixed_model_difference_holm_95", pair.asHolm, n);
      rows.put("mixed_model_difference_simultaneous_95", pair.simultaneous, n);
      rows.add("mixed_model_t", pair.difference.t, n);
      rows.add("mixed_model_df", pair.difference.df, n);
      rows.add("mixed_model_p", pair.difference.p, n);
      rows.add("mixed_model_p_holm", pair.pHolm, n);
    }
  }
  for (const MissingBounds& pair : study.bounds) {
    placeAtPair(rows, pair.first, pair.second);
    for (const auto& [name, bound] : {std::pair("bound_worst", &pair.worst), {"bound_best", &pair.best}}) {
      if (*bound) {
        rows.addInterval(name, (*bound)->difference, (*bound)->interval, n);
      } else {
        rows.put(name, Undefined{bound->reason()}, n);
      }
    }
  }
  placeAtAll(rows);
  if (!study.bounds.empty()) {
    const std::vector<PrimaryDifference> made = primaryDifferences(study);
    rows.addCount(
        "pairs_left_open",
        std::count_if(
            study.bounds.begin(), study.bounds.end(),
            [&](const MissingBounds& pair) {
              const bool compared = std::any_of(made.begin(), made.end(), [&](const PrimaryDifference& one) {
                return one.first == pair.first && one.second == pair.second;
              });
              return compared && (!pair.worst || !pair.best ||
                                  (pair.worst->interval.lower <= 0.0 && pair.best->interval.upper >= 0.0));
            }),
        std::ssize(made));
  }
  addMissingTrainees(study, rows);
}

}  // namespace

std::vector<std::string> leftOutTrainees(const StudyAnalysis& study) {
  std::vector<std::string> codes;
  for (const MissingTrainee& trainee : study.missing) {
    if (trainee.leftOut) {
      codes.push_back(trainee.trainee);
    }
  }
  return codes;
}

ResultKey slopesKey(const StudyAnalysis& study, std::size_t baseline) {
  return {.section = kComparison,
          .index = "score before " + formatExact(study.slopes->baselines[baseline]),
          .record = std::to_string(baseline)};
}

void addComparisonResults(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  if (study.occasions.size() >= 2) {
    addComparison(in, study, ledger);
    addBaseline(in, study, ledger);
    addPerProtocol(in, study, ledger);
    addCourse(in, study, ledger);
    addMixedModel(in, study, ledger);
    addGainResults(in, study, ledger);
    addSiteResults(in, study, ledger);
  }
}

}  // namespace torsio
