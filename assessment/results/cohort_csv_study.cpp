// SPDX-License-Identifier: GPL-3.0-or-later
// Rows of cohort.csv about raters and about groups: what the report's tables and figures of the training
// study show.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/csv_rows.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_sections.h"
#include "assessment/statistics/descriptive.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

std::vector<std::string> missingFlag(bool missing) {
  return missing ? std::vector<std::string>{"marks missing"} : std::vector<std::string>{};
}

void addCoefficients(CsvRows& rows, const Outcome<IccResult>& icc, std::int64_t n) {
  if (!icc) {
    return;
  }
  rows.addInterval("icc_2_1", icc->agreementSingle.estimate, icc->agreementSingle.interval, n);
  rows.addInterval("icc_2_k", icc->agreementMean.estimate, icc->agreementMean.interval, n);
  rows.add("sem_agreement", icc->semAgreement, n);
  rows.add("sem_of_mean", icc->semMean, n);
}

/// Agreement of the pairs of raters in whole points.
void addPoints(CsvRows& rows, const PointAgreement& points) {
  const std::vector<double>& kappas = points.kappas;
  const bool known = !kappas.empty();
  rows.add("rater_pairs", static_cast<double>(points.pairs), points.shared);
  rows.add("kappa_quadratic_median", known ? std::optional(medianOf(kappas)) : std::nullopt, points.shared);
  rows.add("kappa_quadratic_lowest",
           known ? std::optional(*std::min_element(kappas.begin(), kappas.end())) : std::nullopt,
           points.shared);
  rows.add("kappa_quadratic_highest",
           known ? std::optional(*std::max_element(kappas.begin(), kappas.end())) : std::nullopt,
           points.shared);
  const auto share = [&](std::int64_t part) {
    return points.shared > 0 ? std::optional(static_cast<double>(part) / static_cast<double>(points.shared))
                             : std::nullopt;
  };
  rows.add("share_same_point", share(points.same), points.shared);
  rows.add("share_within_one_point", share(points.withinOne), points.shared);
}

/// How many raters are needed: components of variance, and what each number of raters would give.
void addRatersNeeded(const CohortInputs& in, const StudyAnalysis& study, std::vector<CohortCsvRow>& out) {
  const RatersNeeded& needed = study.needed;
  if (!needed.components) {
    return;
  }
  CsvRows rows(out);
  rows.place.section = "agreement";
  rows.place.item = "all";
  rows.place.occasion = in.occasions.back().str();
  rows.place.flags = csvFlags(commonFlags(in), {"complete cases"});
  rows.add("variance_of_trainees", needed.components->at("p").variance, needed.marks);
  rows.add("variance_of_raters", needed.components->at("r").variance, needed.marks);
  rows.add("variance_of_rest", needed.components->at("pr").variance, needed.marks);
  rows.add("raters_needed", needed.fewest ? std::optional(static_cast<double>(*needed.fewest)) : std::nullopt,
           needed.marks);
  for (const auto& [raters, planned] : needed.planned) {
    rows.place.index = "raters " + std::to_string(raters);
    rows.add("dependability", planned ? std::optional(planned->dependability) : std::nullopt, needed.marks);
    rows.add("generalizability", planned ? std::optional(planned->generalizability) : std::nullopt,
             needed.marks);
    rows.add("standard_error_of_mean_mark",
             planned ? std::optional(std::sqrt(planned->absoluteError)) : std::nullopt, needed.marks);
  }
}

/// The raters on one scale.
void addRasch(const CohortInputs& in, const StudyAnalysis& study, std::vector<CohortCsvRow>& out) {
  if (!study.rasch) {
    return;
  }
  CsvRows rows(out);
  rows.place.section = "agreement";
  rows.place.occasion = in.occasions.back().str();
  rows.place.flags = csvFlags(commonFlags(in), {});
  for (std::size_t r = 0; r < study.raters.size(); ++r) {
    const RaschRater& rater = study.rasch->raters[r];
    rows.place.item = study.raters[r];
    const auto& marks = study.occasions.back().marks;
    const std::int64_t n =
        std::count_if(marks.begin(), marks.end(), [r](const auto& row) { return row[r].has_value(); });
    rows.add("rasch_severity", rater.severity, n);
    rows.add("rasch_error", rater.error, n);
    rows.add("rasch_infit", rater.infit, n);
    rows.add("rasch_outfit", rater.outfit, n);
  }
}

/// Agreement at each occasion: of everybody, of every mark where some are missing, and within each group.
void addAgreement(const CohortInputs& in, const StudyAnalysis& study, std::vector<CohortCsvRow>& out) {
  CsvRows rows(out);
  rows.place.section = "agreement";
  rows.place.item = "all";
  for (std::size_t t = 0; t < study.occasions.size(); ++t) {
    const OccasionMarks& at = study.occasions[t];
    rows.place.occasion = in.occasions[t].str();
    rows.place.flags = csvFlags(commonFlags(in), missingFlag(at.missing > 0));
    addCoefficients(rows, at.icc, at.n);
    addPoints(rows, at.points);
    rows.add("krippendorff_alpha_interval", at.alpha ? std::optional<double>(at.alpha->alpha) : std::nullopt,
             at.n);
    if (at.missing > 0 && at.reliability) {
      const IncompleteReliability& every = *at.reliability;
      rows.add("reml_one_rater", every.single, at.n);
      rows.add("reml_mean", every.mean, at.n);
      rows.add("reml_sem_of_one_rater", every.semSingle, at.n);
      rows.add("reml_sem_of_mean", every.semMean, at.n);
    }
    for (const GroupAgreement& of : at.groups) {
      rows.place.group = in.groups[of.group].name.str();
      addCoefficients(rows, of.icc, of.trainees);
    }
    rows.place.group.clear();
  }
}

/// Each rater against the others: one value a trainee, so that the differences are independent.
void addRaters(const CohortInputs& in, const StudyAnalysis& study, std::vector<CohortCsvRow>& out) {
  CsvRows rows(out);
  rows.place.section = "agreement";
  rows.place.flags = csvFlags(commonFlags(in), {});
  for (const RaterSeverity& rater : study.severity) {
    rows.place.item = rater.rater;
    rows.addInterval("severity_offset", rater.offset, rater.interval, rater.n);
  }
  for (std::size_t r = 0; r < study.againstPanel.size(); ++r) {
    const Outcome<BlandAltmanResult>& against = study.againstPanel[r];
    if (!against) {
      continue;
    }
    rows.place.item = study.raters[r];
    rows.place.occasion = in.occasions.back().str();
    const auto n = static_cast<std::int64_t>(against->n);
    rows.add("mean_difference_from_others", against->meanDifference, n);
    rows.add("limit_of_agreement_lower", against->limits.lower, n);
    rows.add("limit_of_agreement_upper", against->limits.upper, n);
  }
}

/// Where the comparison of groups stands in the table.
CsvRows comparisonRows(const CohortInputs& in, const std::vector<std::string>& flags,
                       std::vector<CohortCsvRow>& out) {
  CsvRows rows(out);
  rows.place.section = "comparison";
  rows.place.item = "all";
  rows.place.occasion = in.occasions.back().str();
  rows.place.flags = csvFlags(commonFlags(in), flags);
  return rows;
}

void addEffect(CsvRows& rows, const std::string& name, const AnovaEffect& effect, std::int64_t n) {
  rows.add(name + "_f", effect.f, n);
  rows.add(name + "_p", effect.p, n);
  if (effect.pGreenhouseGeisser) {
    rows.add(name + "_p_greenhouse_geisser", *effect.pGreenhouseGeisser, n);
  }
  rows.add(name + "_generalised_eta_squared", effect.generalizedEtaSquared, n);
}

/// The course of the groups over the occasions, of the trainees with a score at each.
void addCourse(const CohortInputs& in, const StudyAnalysis& study, std::vector<CohortCsvRow>& out) {
  if (!study.course) {
    return;
  }
  std::int64_t n = 0;
  for (const NumberTable& group : study.courses) {
    n += static_cast<std::int64_t>(group.rows());
  }
  CsvRows rows = comparisonRows(
      in,
      study.leftOutOfCourse.empty() ? std::vector<std::string>{} : std::vector<std::string>{"complete cases"},
      out);
  if (study.course->interaction) {
    addEffect(rows, "mixed_interaction", *study.course->interaction, n);
  }
  if (study.course->group) {
    addEffect(rows, "mixed_group", *study.course->group, n);
  }
  addEffect(rows, "mixed_time", study.course->time, n);
  rows.add("greenhouse_geisser_epsilon", study.course->sphericity.greenhouseGeisser, n);
}

/// What the groups gained: each by itself, and one against the other by ranks.
void addGainRows(const CohortInputs& in, const StudyAnalysis& study, std::vector<CohortCsvRow>& out) {
  if (!study.gains) {
    return;
  }
  CsvRows rows = comparisonRows(in, {}, out);
  for (std::size_t g = 0; g < study.gains->within.size(); ++g) {
    const GroupGain& gain = study.gains->within[g];
    rows.place.group = in.groups[g].name.str();
    rows.add("median_gain", gain.median ? std::optional(gain.median->estimate) : std::nullopt, gain.n);
    if (gain.median) {
      rows.addBounds("median_gain", gain.median->bca, gain.n);
    }
    rows.add("gain_signed_rank_v", gain.ranks ? std::optional(gain.ranks->v) : std::nullopt, gain.n);
    rows.add("gain_signed_rank_p", gain.ranks ? std::optional(gain.ranks->pTwoSided) : std::nullopt, gain.n);
    rows.add("occasions_friedman_p", gain.occasions ? std::optional(gain.occasions->p) : std::nullopt,
             static_cast<std::int64_t>(study.courses[g].rows()));
  }
  rows.place.group.clear();
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
    rows.place.group = pairName(in, pair.first, pair.second).str();
    rows.add("gain_difference_of_mean_ranks", -pair.difference, two);
    rows.add("gain_dunn_z", -pair.z, two);
    rows.add("gain_dunn_p_holm", pair.pHolm, two);
    rows.add("gain_superiority", ranks ? std::optional(ranks->superiority) : std::nullopt, two);
    rows.add("gain_mann_whitney_p_exact", ranks ? ranks->pExact : std::nullopt, two);
  }
}

void addSlopes(const CohortInputs& in, const StudyAnalysis& study, std::int64_t n, CsvRows& rows) {
  if (!study.slopes) {
    return;
  }
  for (std::size_t g = 0; g < study.slopes->slopes.size(); ++g) {
    rows.place.group = in.groups[study.slopes->groups[g]].name.str();
    rows.add("separate_slope", study.slopes->slopes[g], n);
  }
  for (const SlopesPair& pair : study.slopes->pairs) {
    rows.place.group = pairName(in, pair.first, pair.second).str();
    for (std::size_t b = 0; b < pair.at.size(); ++b) {
      rows.place.index = "score before " + formatExact(study.slopes->baselines[b]);
      rows.addInterval("separate_slopes_difference", pair.at[b].difference, pair.at[b].interval, n);
      rows.add("separate_slopes_p", pair.at[b].p, n);
      rows.add("separate_slopes_p_holm", pair.at[b].pHolm, n);
    }
    rows.place.index.clear();
  }
  rows.place.group.clear();
}

void addEquivalence(const CohortInputs& in, const StudyAnalysis& study, std::int64_t n, CsvRows& rows) {
  if (!in.equivalenceMargin) {
    return;
  }
  rows.add("equivalence_margin", *in.equivalenceMargin, n);
  for (const PrimaryDifference& pair : primaryDifferences(study)) {
    if (!(pair.error > 0.0)) {
      continue;
    }
    const Equivalence test = equivalence(pair.value, pair.error, pair.df, *in.equivalenceMargin);
    rows.place.group = pairName(in, pair.first, pair.second).str();
    rows.add("equivalence_p", test.p, n);
    rows.add("equivalence_lower_90", test.interval.lower, n);
    rows.add("equivalence_upper_90", test.interval.upper, n);
  }
  rows.place.group.clear();
}

/// What the residual plots show, a trainee a row.
void addResiduals(const CohortInputs& in, const StudyAnalysis& study, CsvRows& rows) {
  for (std::size_t g = 0; g < study.ancova->residuals.size(); ++g) {
    rows.place.group = in.groups[g].name.str();
    for (std::size_t i = 0; i < study.ancova->residuals[g].size(); ++i) {
      rows.place.item = study.endCodes[g][i];
      rows.add("ancova_fitted", study.ancova->fitted[g][i], 1);
      rows.add("ancova_residual", study.ancova->residuals[g][i], 1);
      rows.add("ancova_normal_quantile", study.ancova->quantiles[g][i], 1);
    }
  }
  rows.place.group.clear();
  rows.place.item = "all";
}

void addComparison(const CohortInputs& in, const StudyAnalysis& study, std::vector<CohortCsvRow>& out) {
  const std::int64_t n = comparedTrainees(study);
  if (!primaryDifferences(study).empty()) {
    CsvRows rows = comparisonRows(in, missingFlag(!study.asPlanned()), out);
    rows.addText("planned_analysis", "analysis of covariance", n);
    rows.addText("primary_analysis", study.mixed ? "linear mixed model" : "analysis of covariance", n);
    rows.add("marks_missing", static_cast<double>(study.endMissing), study.endMarks + study.endMissing);
    addEquivalence(in, study, n, rows);
  }
  if (!study.ancova) {
    return;
  }
  CsvRows rows = comparisonRows(
      in, study.asPlanned() ? std::vector<std::string>{} : std::vector<std::string>{"complete cases"}, out);
  rows.add("ancova_f", study.ancova->group.f, n);
  rows.add("ancova_p", study.ancova->group.p, n);
  rows.add("ancova_slope", study.ancova->slope, n);
  if (study.ancova->equalSlopes) {
    rows.add("ancova_equal_slopes_p", study.ancova->equalSlopes->p, n);
  }
  for (std::size_t g = 0; g < study.ancova->adjusted.size(); ++g) {
    rows.place.group = in.groups[study.ancova->groups[g]].name.str();
    rows.addInterval("adjusted_mean", study.ancova->adjusted[g].mean, study.ancova->adjusted[g].interval, n);
  }
  const Groups& after = study.ends.after;
  for (const AdjustedDifference& pair : study.ancova->pairs) {
    rows.place.group = pairName(in, pair.first, pair.second).str();
    rows.addInterval("adjusted_difference", pair.difference, pair.interval, n);
    rows.addBounds("adjusted_difference_simultaneous", pair.simultaneous, n);
    rows.add("t", pair.t, n);
    rows.add("p", pair.p, n);
    rows.add("p_holm", pair.pHolm, n);
    if (const Outcome<HedgesG> g = hedgesG(after[pair.first], after[pair.second])) {
      rows.addInterval("hedges_g", g->g, g->interval, n);
    }
  }
  rows.place.group.clear();
  addSlopes(in, study, n, rows);
  addResiduals(in, study, rows);
}

/// The comparison where marks are missing: the mixed model, and how far the missing ones could move it.
void addMixedModel(const CohortInputs& in, const StudyAnalysis& study, std::vector<CohortCsvRow>& out) {
  CsvRows rows = comparisonRows(in, missingFlag(true), out);
  const std::int64_t n = comparedTrainees(study);
  if (study.mixed) {
    for (const MixedComparison::Pair& pair : study.mixed->pairs) {
      rows.place.group = pairName(in, pair.first, pair.second).str();
      rows.addInterval("mixed_model_difference", pair.difference.value, pair.difference.interval, n);
      rows.addBounds("mixed_model_difference_simultaneous", pair.simultaneous, n);
      rows.add("mixed_model_df", pair.difference.df, n);
      rows.add("mixed_model_p", pair.difference.p, n);
      rows.add("mixed_model_p_holm", pair.pHolm, n);
    }
  }
  for (const MissingBounds& pair : study.bounds) {
    rows.place.group = pairName(in, pair.first, pair.second).str();
    if (pair.worst && pair.best) {
      rows.addInterval("bound_worst", pair.worst->difference, pair.worst->interval, n);
      rows.addInterval("bound_best", pair.best->difference, pair.best->interval, n);
    }
  }
}

}  // namespace

std::string csvFlags(const std::vector<Text>& common, const std::vector<std::string>& own) {
  std::vector<Text> all = common;
  all.insert(all.end(), own.begin(), own.end());
  return listed(all, Text::tr("%1; %2")).str();
}

void CsvRows::addText(const std::string& statistic, const std::string& value, std::int64_t n) {
  CohortCsvRow row = place;
  row.statistic = statistic;
  row.value = value;
  row.n = std::to_string(n);
  out_.push_back(row);
}

void CsvRows::addInterval(const std::string& statistic, double value, const std::optional<Interval>& interval,
                          std::int64_t n) {
  add(statistic, value, n);
  if (interval) {
    addBounds(statistic, *interval, n);
  }
}

void CsvRows::addBounds(const std::string& statistic, const Interval& interval, std::int64_t n) {
  add(statistic + "_lower_95", interval.lower, n);
  add(statistic + "_upper_95", interval.upper, n);
}

void CsvRows::add(const std::string& statistic, const std::optional<double>& value, std::int64_t n) {
  CohortCsvRow row = place;
  row.statistic = statistic;
  if (value) {
    row.value = formatExact(*value);
  }
  row.n = std::to_string(n);
  if (!value) {
    row.flags += row.flags.empty() ? "undefined" : "; undefined";
  }
  out_.push_back(row);
}

void addStudyRows(const CohortInputs& in, const StudyAnalysis& study, std::vector<CohortCsvRow>& out) {
  addAgreement(in, study, out);
  addRaters(in, study, out);
  if (study.raters.size() >= 2) {
    addRatersNeeded(in, study, out);
    addRasch(in, study, out);
  }
  if (study.occasions.size() >= 2) {
    addComparison(in, study, out);
    addCourse(in, study, out);
    addMixedModel(in, study, out);
    addGainRows(in, study, out);
  }
}

}  // namespace torsio
