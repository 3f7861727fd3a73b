// SPDX-License-Identifier: GPL-3.0-or-later
// A pooled record: the comparison within centres, how it differs between them, and who took part at each.
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/result_writer.h"
#include "assessment/results/shown_inputs.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

using enum ResultSection;

/// Returns what most of a trainee's runs have, by trainee; somebody without a run has none.
std::map<std::string, std::string> mostUsed(const CohortInputs& in, std::string TrialSummaryRow::*what) {
  std::map<std::string, std::map<std::string, int>> counts;
  for (const TrialSummaryRow& run : in.trials) {
    ++counts[run.trainee][run.*what];
  }
  std::map<std::string, std::string> out;
  for (const auto& [trainee, used] : counts) {
    out[trainee] = std::max_element(used.begin(), used.end(), [](const auto& a, const auto& b) {
                     return a.second < b.second;
                   })->first;
  }
  return out;
}

/// Repeats the comparison with a further factor: what most of a trainee's runs have.
Outcome<SiteComparison> compareWith(const CohortInputs& in, const SiteAnalysis& of,
                                    std::string TrialSummaryRow::*what) {
  const std::map<std::string, std::string> used = mostUsed(in, what);
  std::set<std::string> levels;
  std::vector<SiteTrainee> trainees;
  std::vector<std::string> level;
  for (std::size_t i = 0; i < of.trainees.size(); ++i) {
    const auto found = used.find(of.traineeCodes[i]);
    if (found != used.end()) {  // others had nothing to do with it
      trainees.push_back(of.trainees[i]);
      level.push_back(found->second);
      levels.insert(found->second);
    }
  }
  if (levels.size() < 2) {
    return Outcome<SiteComparison>::undefined(Text::tr("all runs have the same"));
  }
  for (std::size_t i = 0; i < trainees.size(); ++i) {
    trainees[i].level = static_cast<std::size_t>(std::distance(levels.begin(), levels.find(level[i])));
  }
  return compareWithinSites(trainees, of.term, true);
}

/// Returns whether differences at one centre may be shown.
bool showsCentres(const CohortInputs& in) {
  return in.identity != ReportIdentity::kAggregated;
}

ResultKey pairAt(const Ledger& ledger, std::size_t first, std::size_t second, const std::string& site) {
  ResultKey key = pairKey(ledger, first, second);
  key.index = site;
  return key;
}

ResultKey flowKey(const Ledger& ledger, std::size_t group, const std::string& site) {
  return {.section = kParticipants, .group = ledger.group(group), .index = site};
}

/// Returns the scores of the trainees compared.
ResultParts scoresOfAll(const SiteAnalysis& of, const Ledger& ledger) {
  std::vector<ResultPart> parts{RecordRef{RecordKind::kEnrolments}};
  for (const std::string& code : of.traineeCodes) {
    for (const std::string& at : {ledger.occasion(0), ledger.lastOccasion()}) {
      parts.emplace_back(ResultPattern{.statistic = "score", .of = code, .occasion = at});
    }
  }
  return partsOf(std::move(parts));
}

void addPairs(const SiteComparison& found, const std::string& name, ResultWriter& rows) {
  const auto n = static_cast<std::int64_t>(found.trainees);
  for (const AdjustedDifference& pair : found.pairs) {
    rows.place.group = rows.group(pair.first);
    rows.place.against = rows.group(pair.second);
    rows.addInterval(name, pair.difference, pair.interval, n);
    rows.put(name + "_holm_95", pair.asHolm, n);
    rows.add(name + "_error", pair.error, n);
    rows.add(name + "_df", pair.df, n);
    rows.add(name + "_t", pair.t, n);
    rows.add(name + "_p", pair.p, n);
    rows.add(name + "_p_holm", pair.pHolm, n);
  }
  rows.place.group.clear();
  rows.place.against.clear();
}

void addFlow(const CohortInputs& in, Ledger& ledger) {
  ResultWriter rows(ledger, {.section = kParticipants}, commonFlags(in));
  rows.madeOf = partsOf({RecordRef{RecordKind::kEnrolments}});
  std::map<std::string, std::set<std::size_t>> scoredAt;  // occasions, by trainee
  for (const TraineeScore& score : in.scores) {
    scoredAt[score.trainee].insert(score.occasion);
  }
  for (const std::string& site : in.sites) {
    for (std::size_t g = 0; g < in.groups.size(); ++g) {
      std::int64_t allocated = 0;
      std::int64_t withdrew = 0;
      std::int64_t before = 0;
      std::int64_t end = 0;
      std::set<std::string> codes;
      for (const CohortTrainee& trainee : in.trainees) {
        if (trainee.group == g && trainee.site == site) {
          ++allocated;
          withdrew += trainee.withdrew ? 1 : 0;
          codes.insert(trainee.code);
          before += scoredAt[trainee.code].contains(0) ? 1 : 0;
          end += scoredAt[trainee.code].contains(in.occasions.size() - 1) ? 1 : 0;
        }
      }
      rows.place = flowKey(ledger, g, site);
      rows.addCount("centre_allocated", allocated, allocated);
      rows.addCount("centre_withdrew", withdrew, allocated);
      rows.addCount("centre_runs",
                    std::count_if(in.trials.begin(), in.trials.end(),
                                  [&](const auto& run) { return codes.contains(run.trainee); }),
                    allocated);
      rows.addCount("centre_scored_before", before, allocated);
      rows.addCount("centre_scored_at_the_end", end, allocated);
    }
  }
}

Text termOf(SiteTerm term) {
  return term == SiteTerm::kRandom ? Text::tr("random, as there are five or more")
                                   : Text::tr("fixed, as there are fewer than five");
}

}  // namespace

std::optional<SiteAnalysis> analyseSites(const CohortInputs& in, const CompleteCases& ends,
                                         const std::vector<std::vector<std::string>>& codes) {
  if (in.sites.size() < 2) {
    return std::nullopt;
  }
  std::map<std::string, std::string> siteOf;
  for (const CohortTrainee& trainee : in.trainees) {
    siteOf[trainee.code] = trainee.site;
  }
  SiteAnalysis out;
  for (std::size_t g = 0; g < codes.size(); ++g) {
    for (std::size_t i = 0; i < codes[g].size(); ++i) {
      const auto place = std::find(in.sites.begin(), in.sites.end(), siteOf[codes[g][i]]);
      if (place != in.sites.end()) {
        const auto site = static_cast<std::size_t>(place - in.sites.begin());
        out.trainees.push_back({g, site, ends.before[g][i], ends.after[g][i]});
        out.traineeCodes.push_back(codes[g][i]);
      }
    }
  }
  std::set<std::size_t> present;
  for (const SiteTrainee& trainee : out.trainees) {
    present.insert(trainee.site);
  }
  out.sites.assign(present.begin(), present.end());
  out.term = siteTermFor(present.size());
  out.together = compareWithinSites(out.trainees, out.term);
  out.heterogeneity = heterogeneityOfSites(out.trainees);
  for (const std::size_t site : out.sites) {
    std::vector<SiteTrainee> others = out.trainees;
    std::erase_if(others, [&](const SiteTrainee& trainee) { return trainee.site == site; });
    out.without.push_back(compareWithinSites(others, out.term));
  }
  out.withDevice = compareWith(in, out, &TrialSummaryRow::device);
  out.withStation = compareWith(in, out, &TrialSummaryRow::station);
  return out;
}

void addSiteResults(const CohortInputs& in, const StudyAnalysis& study, Ledger& ledger) {
  if (!study.sites) {
    return;
  }
  if (showsCentres(in)) {
    addFlow(in, ledger);
  }
  const SiteAnalysis& of = *study.sites;
  ResultWriter rows(ledger, {.section = kComparison, .occasion = ledger.lastOccasion()}, commonFlags(in),
                    flagIf(!study.asPlanned(), "complete cases"));
  rows.madeOf = scoresOfAll(of, ledger);
  const std::int64_t n = std::ssize(of.trainees);
  rows.addCount("centres_compared", std::ssize(of.sites), n);
  rows.put("centre_term", termOf(of.term), n);
  if (of.together) {
    rows.add("centre_variance_of_rest", of.together->residualVariance, n);
    if (of.term == SiteTerm::kRandom) {
      rows.add("centre_variance_of_centres", of.together->siteVariance, n);
    }
    addPairs(*of.together, "centre_difference", rows);
  }
  if (of.heterogeneity) {
    for (const Heterogeneity& pair : *of.heterogeneity) {
      rows.place.group = rows.group(pair.first);
      rows.place.against = rows.group(pair.second);
      const std::int64_t centres = std::ssize(pair.sites);
      rows.add("heterogeneity_q", pair.q, centres);
      rows.add("heterogeneity_p", pair.p, centres);
      rows.add("heterogeneity_i_squared", pair.iSquared, centres);
      rows.addInterval("heterogeneity_tau_squared", pair.tauSquared, pair.tauInterval, centres);
      rows.addInterval("average_over_centres", pair.average, pair.averageInterval, centres);
      for (const SiteDifference& one : pair.sites) {
        const auto fewest = static_cast<std::int64_t>(std::min(one.first, one.second));
        if (showsCentres(in) && (in.singleMarks || fewest >= kMinMarks)) {
          rows.place.index = in.sites[one.site];
          rows.addInterval("difference_at_centre", one.difference, one.interval,
                           static_cast<std::int64_t>(one.first + one.second));
        }
      }
      rows.place.index.clear();
    }
  }
  for (std::size_t i = 0; i < of.sites.size(); ++i) {
    if (!of.without[i] || !showsCentres(in)) {
      continue;
    }
    for (const AdjustedDifference& pair : of.without[i]->pairs) {
      rows.place = pairAt(ledger, pair.first, pair.second, in.sites[of.sites[i]]);
      rows.addInterval("difference_without_centre", pair.difference, pair.interval,
                       static_cast<std::int64_t>(of.without[i]->trainees));
    }
  }
  rows.place = {.section = kComparison, .occasion = ledger.lastOccasion()};
  std::vector<ResultPart> parts = *rows.madeOf;
  parts.emplace_back(ResultPattern{.section = kTrial, .statistic = "content_hash", .of = kEach});
  rows.madeOf = partsOf(std::move(parts));
  for (const auto& [name, found] :
       {std::pair{"device_difference", &of.withDevice}, std::pair{"station_difference", &of.withStation}}) {
    if (*found) {
      addPairs(**found, name, rows);
    }
  }
}

std::optional<ReportTable> sitesTable(const CohortInputs& in, const StudyAnalysis& study,
                                      const Ledger& ledger) {
  if (!study.sites) {
    return std::nullopt;
  }
  const SiteAnalysis& of = *study.sites;
  ReportTable table = itemOf<ReportTable>(
      in, "table-centres", Text::tr("Differences within the centres"),
      of.term == SiteTerm::kRandom
          ? Text::tr("linear mixed model, centre random, restricted maximum likelihood, Satterthwaite")
          : Text::tr("analysis of covariance, centre fixed, HC3"));
  table.provenance.n = resultsAtEnd(ledger).count("centres_compared", kValues);
  table.provenance.missing = resultsAtEnd(ledger).count("marks_missing");
  ResultTable rows(ledger, table,
                   {{Text::tr("Comparison")},
                    {Text::tr("Difference [95 %, not adjusted]"), "centre_difference", kWithInterval},
                    {Text::tr("[95 %, after Holm]"), "centre_difference_holm_95"},
                    {Text::verbatim("t"), "centre_difference_t", fixed(2)},
                    {Text::tr("Degrees of freedom"), "centre_difference_df", fixed(1)},
                    {Text::verbatim("p"), "centre_difference_p", kAsP},
                    {Text::tr("p (Holm)"), "centre_difference_p_holm", kAsP}});
  if (!of.together) {
    table.rows.push_back({notDefined(of.together.reason()), "", "", "", "", "", ""});
    return table;
  }
  for (const AdjustedDifference& pair : of.together->pairs) {
    rows.row({pairName(in, pair.first, pair.second)}, pairKey(ledger, pair.first, pair.second));
  }
  const ResultsAt at = resultsAtEnd(ledger);
  const ReportCell centres = at("centres_compared");
  const ReportCell term = at("centre_term");
  const ReportCell rest = at("centre_variance_of_rest", fixed(3));
  table.notes = {{Text::tr("Score at the end on score before, group and centre, one slope; centres (%1): %2.",
                           centres.words(), term.words()),
                  {centres, term}}};
  if (of.term == SiteTerm::kRandom) {
    const ReportCell between = at("centre_variance_of_centres", fixed(3));
    table.notes.push_back(
        {Text::tr("Variances: centres %1, rest %2 (points squared).", between.words(), rest.words()),
         {between, rest}});
  }
  return table;
}

std::optional<ReportTable> heterogeneityTable(const CohortInputs& in, const StudyAnalysis& study,
                                              const Ledger& ledger) {
  if (!study.sites) {
    return std::nullopt;
  }
  const SiteAnalysis& of = *study.sites;
  ReportTable table = itemOf<ReportTable>(
      in, "table-heterogeneity", Text::tr("How far the differences vary from centre to centre"),
      Text::tr(
          "Cochran; Higgins and Thompson; Paule and Mandel, interval by profiling Q; Hartung and Knapp"));
  table.provenance.n = resultsAtEnd(ledger).count("centres_compared", kValues);
  ResultTable rows(
      ledger, table,
      {{Text::tr("Comparison")},
       {Text::tr("Centres"), "heterogeneity_q", kValues},
       {Text::verbatim("Q"), "heterogeneity_q", fixed(2)},
       {Text::verbatim("p"), "heterogeneity_p", kAsP},
       {Text::tr("I squared"), "heterogeneity_i_squared", percent(0)},
       {Text::tr("Variance between centres [95 %] (points squared)"), "heterogeneity_tau_squared",
        kWithInterval},
       {Text::tr("Average of centres like these [95 %]"), "average_over_centres", kWithInterval}});
  if (!of.heterogeneity) {
    table.rows.push_back({notDefined(of.heterogeneity.reason()), "", "", "", "", "", ""});
    return table;
  }
  for (const Heterogeneity& pair : *of.heterogeneity) {
    rows.row({pairName(in, pair.first, pair.second)}, pairKey(ledger, pair.first, pair.second));
  }
  table.notes = {Text::tr(
      "Differences at each centre, adjusted with the slope and the residual variance of all. A large p does "
      "not show that the centres agree: look at the upper end of the variance.")};
  return table;
}

std::optional<ReportTable> siteDifferencesTable(const CohortInputs& in, const StudyAnalysis& study,
                                                const Ledger& ledger) {
  if (!study.sites || !study.sites->heterogeneity || !showsCentres(in)) {
    return std::nullopt;
  }
  ReportTable table = itemOf<ReportTable>(
      in, "table-centre-by-centre", Text::tr("Differences at each centre, and without it"),
      Text::tr("analysis of covariance of all centres, one slope and one variance; then the comparison "
               "within the other centres"));
  table.annex = true;
  table.provenance.n = resultsAtEnd(ledger).count("centres_compared", kValues);
  ResultTable rows(
      ledger, table,
      {{Text::tr("Comparison")},
       {Text::tr("Centre")},
       {Text::tr("Trainees"), "difference_at_centre", kValues, Text::tr("not shown")},
       {Text::tr("At this centre [95 %]"), "difference_at_centre", kWithInterval, Text::tr("not shown")},
       {Text::tr("Without this centre [95 %]"), "difference_without_centre", kWithInterval}});
  for (const Heterogeneity& pair : *study.sites->heterogeneity) {
    for (const SiteDifference& one : pair.sites) {
      rows.row({pairName(in, pair.first, pair.second), in.sites[one.site]},
               pairAt(ledger, pair.first, pair.second, in.sites[one.site]));
    }
  }
  table.notes = {Text::tr("Intervals are not adjusted for their number.")};
  return table;
}

std::optional<ReportTable> equipmentTable(const CohortInputs& in, const StudyAnalysis& study,
                                          const Ledger& ledger) {
  if (!study.sites || (!study.sites->withDevice && !study.sites->withStation)) {
    return std::nullopt;
  }
  ReportTable table = itemOf<ReportTable>(
      in, "table-equipment", Text::tr("Differences within the centres with device or station in the model"),
      Text::tr("the comparison within the centres with a further fixed factor"));
  table.annex = true;
  table.provenance.n = resultsAtEnd(ledger).count("centres_compared", kValues);
  ResultTable rows(
      ledger, table,
      {{Text::tr("Comparison")},
       {Text::tr("With the device [95 %]"), "device_difference", kWithInterval, Text::tr("does not apply")},
       {Text::tr("With the station [95 %]"), "station_difference", kWithInterval,
        Text::tr("does not apply")}});
  const Outcome<SiteComparison>& any =
      study.sites->withDevice ? study.sites->withDevice : study.sites->withStation;
  for (const AdjustedDifference& pair : any->pairs) {
    rows.row({pairName(in, pair.first, pair.second)}, pairKey(ledger, pair.first, pair.second));
  }
  table.notes = {Text::tr(
      "Of trainees with a recorded run, by what most of their runs used. Where all runs have the same, or "
      "device or station cannot be told apart from group and centre, it does not apply.")};
  return table;
}

std::optional<ReportTable> siteFlowTable(const CohortInputs& in, const Ledger& ledger) {
  if (in.sites.size() < 2 || !showsCentres(in)) {
    return std::nullopt;
  }
  ReportTable table;
  table.id = "table-flow-centres";
  table.title = Text::tr("Flow of participants by centre");
  ResultTable rows(ledger, table,
                   {{Text::tr("Centre")},
                    {Text::tr("Group")},
                    {Text::tr("Allocated"), "centre_allocated"},
                    {Text::tr("Withdrew"), "centre_withdrew"},
                    {Text::tr("Recorded runs"), "centre_runs"},
                    {Text::tr("Scored before"), "centre_scored_before"},
                    {Text::tr("Scored at the end"), "centre_scored_at_the_end"}});
  for (const std::string& site : in.sites) {
    for (std::size_t g = 0; g < in.groups.size(); ++g) {
      rows.row({site, in.groups[g].name}, flowKey(ledger, g, site));
    }
  }
  table.provenance.formula = Text::tr("counts");
  table.provenance.n = ResultsAt(ledger, {.section = kParticipants}).count("trainees");
  table.provenance.flags = commonFlags(in);
  return table;
}

ReportParagraph sitesSentence(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  const Text pooled = Text::tr("The data of %1 centres were pooled (%2).", in.sites.size(),
                               listed(std::vector<Text>(in.sites.begin(), in.sites.end())));
  if (!study.sites || !study.sites->together) {
    return Text::tr("%1 No analysis takes account of the centre: %2.", pooled,
                    study.sites ? study.sites->together.reason() : Text::tr("nothing is compared"));
  }
  ReportParagraph out;
  const bool answered = study.primaryMethod() == PrimaryMethod::kCentres;
  std::vector<Text> pairs;
  for (const AdjustedDifference& pair :
       answered ? std::vector<AdjustedDifference>() : study.sites->together->pairs) {
    const ResultsAt at = resultsOfPair(ledger, pair.first, pair.second);
    const ReportCell value = at("centre_difference", fixed(1));
    const ReportCell interval = at("centre_difference_holm_95", intervalWith(1));
    pairs.push_back(
        Text::tr("%1: %2 %3", pairName(in, pair.first, pair.second), value.words(), interval.words()));
    out.keys.insert(out.keys.end(), {value.key, interval.key});
  }
  std::vector<Text> vary;
  if (study.sites->heterogeneity) {
    for (const Heterogeneity& pair : *study.sites->heterogeneity) {
      const ResultsAt at = resultsOfPair(ledger, pair.first, pair.second);
      out.keys.push_back(at("heterogeneity_p").key);
      if (at.number("heterogeneity_p").value_or(1.0) < 1.0 - kDefaultConfidence) {
        const ReportCell share = at("heterogeneity_i_squared", percent(0));
        vary.push_back(Text::verbatim("%1 (%2)", pairName(in, pair.first, pair.second), share.words()));
        out.keys.push_back(share.key);
      }
    }
  }
  static_cast<Text&>(out) = Text::verbatim(
      "%1 %2 %3", pooled,
      answered ? Text::tr("The answer has the centre in its model (%1).", termOf(study.sites->term))
               : Text::tr("With the centre in the model (%1), in points with 95 % intervals after Holm: %2.",
                          termOf(study.sites->term), listed(pairs, Text::tr("%1; %2"))),
      vary.empty()
          ? Text::tr("That the differences vary from centre to centre was not shown; few centres can "
                     "hardly show it.")
          : Text::tr("The differences vary from centre to centre (share that is not chance, I "
                     "squared): %1. One answer for all centres does not describe each of them.",
                     listed(vary, Text::tr("%1; %2"))));
  return out;
}

}  // namespace torsio
