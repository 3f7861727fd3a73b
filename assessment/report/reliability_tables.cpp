// SPDX-License-Identifier: GPL-3.0-or-later
// What more raters would give, how strict each one is on one scale, and what each group gained by itself.
#include <algorithm>
#include <cmath>
#include <set>

#include "assessment/report/number_format.h"
#include "assessment/report/report_labels.h"
#include "assessment/report/report_sections.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/generalizability.h"
#include "assessment/statistics/quantiles.h"
#include "assessment/statistics/rank_tests.h"
#include "assessment/statistics/rasch.h"
#include "assessment/statistics/resampling.h"

namespace torsio {

namespace {

constexpr int kReliabilityDecimals = 3;
constexpr double kWantedDependability = 0.8;
constexpr int kMostRaters = 100;

/// The fewest raters whose mean is dependable enough; empty: more than kMostRaters.
std::optional<int> ratersNeeded(const GStudy& found) {
  for (int raters = 1; raters <= kMostRaters; ++raters) {
    const Outcome<DStudy> study = dStudyPR(found, raters);
    if (study && study->dependability >= kWantedDependability) {
      return raters;
    }
  }
  return std::nullopt;
}

Text neededSentence(const GStudy& found) {
  const std::optional<int> needed = ratersNeeded(found);
  return needed
             ? Text::tr("%1 {rater is|raters are} the fewest whose mean has a dependability of 0.80 or more.",
                        *needed)
             : Text::tr("Not even %1 raters would give a dependability of 0.80.", kMostRaters);
}

ReportTable ratersNeededTable(const CohortInputs& in, const StudyAnalysis& study) {
  auto table = itemOf<ReportTable>(in, "table-raters-needed", Text::tr("How many raters are needed"),
                                   Text::tr("G-study of trainees x raters, last occasion; D-study"));
  table.columns = {Text::tr("Raters"), Text::tr("Dependability (level)"),
                   Text::tr("Generalizability (order)"),
                   Text::tr("Standard error of the mean mark (points)")};
  const OccasionMarks& last = study.occasions.back();
  const NumberTable marks = completeMarks(last);
  const Outcome<GStudy> found = gStudyPR(marks);
  table.provenance.n = static_cast<std::int64_t>(marks.rows() * marks.columns());
  table.provenance.missing = last.missing;
  if (!found) {
    table.rows.push_back({notDefined(found.reason()), "", "", ""});
    return table;
  }
  std::set<std::size_t> sizes{1, 2, 3, 5, 10, last.present.size()};
  for (const std::size_t raters : sizes) {
    const Outcome<DStudy> planned = dStudyPR(*found, static_cast<double>(raters));
    if (!planned) {
      table.rows.push_back({std::to_string(raters), notDefined(planned.reason()), "", ""});
      continue;
    }
    table.rows.push_back({std::to_string(raters), formatFixed(planned->dependability, kReliabilityDecimals),
                          formatFixed(planned->generalizability, kReliabilityDecimals),
                          formatFixed(std::sqrt(planned->absoluteError), kReliabilityDecimals)});
  }
  table.notes = {neededSentence(*found),
                 Text::tr("Components of variance: trainees %1, raters %2, rest %3.",
                          formatFixed(found->at("p").variance, kReliabilityDecimals),
                          formatFixed(found->at("r").variance, kReliabilityDecimals),
                          formatFixed(found->at("pr").variance, kReliabilityDecimals))};
  return table;
}

/// Marks of the last occasion as categories without gaps: the marks that occur, in their order.
CategoryRatings categoriesOf(const StudyAnalysis& study, int& highest) {
  std::set<double> used;
  for (const auto& row : study.occasions.back().marks) {
    for (const std::optional<double>& mark : row) {
      if (mark) {
        used.insert(*mark);
      }
    }
  }
  highest = static_cast<int>(used.size()) - 1;
  CategoryRatings ratings;
  for (const auto& row : study.occasions.back().marks) {
    ratings.emplace_back();
    for (const std::optional<double>& mark : row) {
      ratings.back().push_back(
          mark ? std::optional(static_cast<int>(std::distance(used.begin(), used.find(*mark))))
               : std::nullopt);
    }
  }
  return ratings;
}

ReportTable raschTable(const CohortInputs& in, const StudyAnalysis& study) {
  auto table = itemOf<ReportTable>(in, "table-rasch", Text::tr("Raters on one scale, last occasion"),
                                   Text::tr("many-facet Rasch model, joint maximum likelihood"));
  table.individual = true;
  table.columns = {Text::tr("Rater"), Text::tr("Severity (logits)"), Text::tr("Standard error"),
                   Text::tr("Infit"), Text::tr("Outfit")};
  table.provenance.n = study.occasions.back().n;
  table.provenance.missing = study.occasions.back().missing;
  int highest = 0;
  const CategoryRatings ratings = categoriesOf(study, highest);
  if (highest < 1) {
    const Text reason = Text::tr("every rating is the same");
    table.rows.push_back({notDefined(reason), "", "", "", ""});
    return table;
  }
  const Outcome<RaschResult> found = manyFacetRasch(ratings, highest);
  if (!found) {
    table.rows.push_back({notDefined(found.reason()), "", "", "", ""});
    return table;
  }
  const auto shown = [](const std::optional<double>& value) {
    return value ? Text(formatFixed(*value, 2)) : Text::tr("only extreme marks");
  };
  for (std::size_t r = 0; r < study.raters.size(); ++r) {
    const RaschRater& rater = found->raters[r];
    table.rows.push_back({study.raters[r], shown(rater.severity), shown(rater.error), shown(rater.infit),
                          shown(rater.outfit)});
  }
  table.notes = {Text::tr(
      "Positive: stricter. Severities sum to zero. Infit and outfit are about 1 where a rater's marks follow "
      "the "
      "model; the marks that occur, in their order, are its categories. Joint estimates lie somewhat too far "
      "apart.")};
  return table;
}

/// The median with its interval by resampling trainees.
Text medianText(const std::vector<double>& gains) {
  const auto median = [&](std::span<const std::size_t> chosen) {
    std::vector<double> values;
    for (const std::size_t i : chosen) {
      values.push_back(gains[i]);
    }
    return medianOf(values);
  };
  const Outcome<Bootstrap> found = bootstrap(gains.size(), median);
  return found ? Text(withInterval(found->estimate, found->bca)) : notDefined(found.reason());
}

Text friedmanText(const StudyAnalysis& study, std::size_t group) {
  const Outcome<Friedman> found = friedman(study.courses[group]);
  return found ? Text(formatP(found->p)) : notDefined(found.reason());
}

}  // namespace

std::vector<ReportTable> reliabilityTables(const CohortInputs& in, const StudyAnalysis& study) {
  if (study.occasions.empty() || study.raters.size() < 2) {
    return {};
  }
  return {ratersNeededTable(in, study), raschTable(in, study)};
}

std::optional<ReportTable> withinGroupsTable(const CohortInputs& in, const StudyAnalysis& study) {
  if (study.wholeGains.empty()) {
    return std::nullopt;
  }
  auto table = itemOf<ReportTable>(in, "table-within-groups", Text::tr("What each group gained by itself"),
                                   Text::tr("exact signed ranks; Friedman; bootstrap of the median, BCa"));
  table.columns = {
      Text::tr("Group"),          Text::tr("Trainees"),  Text::tr("Median gain [95 %] (points)"),
      Text::tr("Signed ranks V"), Text::tr("p (exact)"), Text::tr("p (Friedman, all occasions)")};
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const std::vector<double>& before = study.ends.before[g];
    const std::vector<double>& after = study.ends.after[g];
    std::vector<double> gains;
    for (std::size_t i = 0; i < before.size(); ++i) {
      gains.push_back(after[i] - before[i]);
    }
    const Outcome<SignedRank> ranks = signedRank(study.wholeGains.front()[g]);
    table.rows.push_back({in.groups[g].name, std::to_string(gains.size()), medianText(gains),
                          ranks ? Text(formatFixed(ranks->v, 1)) : notDefined(ranks.reason()),
                          ranks ? Text(formatP(ranks->pTwoSided)) : Text(""), friedmanText(study, g)});
    table.provenance.n += std::ssize(gains);
  }
  table.notes = {
      Text::tr("A gain within a group shows no effect of its training: repetition alone may give it. Compare "
               "the groups.")};
  return table;
}

}  // namespace torsio
