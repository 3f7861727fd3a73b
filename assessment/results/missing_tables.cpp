// SPDX-License-Identifier: GPL-3.0-or-later
// Effect of missing marks on the comparison of groups: who is excluded, the mixed model, and bounds.
#include <algorithm>
#include <string>
#include <utility>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

/// Returns codes, or in a report without single people their number.
Text whoText(const CohortInputs& in, const std::vector<std::string>& codes, const Text& number) {
  return in.identity == ReportIdentity::kAggregated ? number
                                                    : listed(std::vector<Text>(codes.begin(), codes.end()));
}

/// Names raters without any marks at one of the two ends: no trainee lacks a mark that others have, but the
/// two scores are by different raters.
std::vector<ReportParagraph> otherRaters(const CohortInputs& in, const StudyAnalysis& study,
                                         const Ledger& ledger) {
  std::vector<ReportParagraph> out;
  for (const std::size_t t : {lastOf(in), std::size_t{0}}) {
    const std::vector<std::string> codes = absentRaters(study, t);
    if (!codes.empty() && !study.occasions[t].present.empty()) {
      const ReportCell count = ResultsAt(
          ledger, {.section = ResultSection::kAgreement, .occasion = ledger.occasion(t)})("raters_absent");
      out.push_back(
          {Text::tr(
               "Raters with marks at the other end of the study but none %1: %2. The scores before and "
               "at the end are then not means over the same raters, which shifts the gains of all groups "
               "alike and not the differences between them.",
               in.occasions[t], whoText(in, codes, count.words())),
           {count}});
    }
  }
  return out;
}

/// Says which raters scored only some groups; empty: none.
std::vector<ReportParagraph> raterGroupSentences(const CohortInputs& in, const StudyAnalysis& study,
                                                 const Ledger& ledger) {
  const std::vector<std::string> codes = ratersOfSomeGroups(in);
  if (codes.empty()) {
    return {};
  }
  ReportParagraph told = ratersOfSomeGroupsSentence(in, codes, ledger);
  if (study.mixed) {
    static_cast<Text&>(told) = Text::verbatim(
        "%1 %2", told.words(),
        Text::tr("The linear mixed model corrects for the severity of a rater only as far as the same rater "
                 "scored several groups."));
  }
  return {told};
}

/// Describes what the record states about the planned comparison of groups.
Text planText(const CohortInputs& in) {
  return in.hasAnalysisPlan()
             ? Text::tr("Planned: the analysis of covariance of the score at the end on the score before.")
             : Text::tr(
                   "No plan of the analysis is in the record; the usual one is the analysis of covariance "
                   "of the score at the end on the score before.");
}

/// Says how the centre enters the comparison of several centres.
Text withCentre(const StudyAnalysis& study) {
  return study.sites->term == SiteTerm::kFixed
             ? Text::tr(
                   "Used: the same with the centre as a fixed factor, as the data are those of %1 centres "
                   "(fewer than %2).",
                   study.sites->sites.size(), kMinRandomSites)
             : Text::tr(
                   "Used: the same with the centre as a random effect, as the data are those of %1 "
                   "centres (%2 or more).",
                   study.sites->sites.size(), kMinRandomSites);
}

/// Names the analysis of complete data, and what its standard errors assume.
Text usedAsPlanned(const CohortInputs& in, const StudyAnalysis& study) {
  const bool centres = study.primaryMethod() == PrimaryMethod::kCentres;
  const Text errors =
      study.allowsForSpreads()
          ? Text::tr(
                "Its standard errors and degrees of freedom hold for unequal spreads, too (HC3, Bell "
                "and McCaffrey).")
      : centres
          ? Text::tr(
                "Its standard errors are those of the model, with degrees of freedom after Satterthwaite.")
          : Text::tr(
                "Its standard errors assume that all groups spread alike: somebody is alone in a group.");
  return centres ? Text::verbatim("%1 %2 %3", planText(in), withCentre(study), errors)
         : in.hasAnalysisPlan()
             ? Text::tr(
                   "Planned and used: the analysis of covariance of the score at the end on the score "
                   "before. %1",
                   errors)
             : Text::tr(
                   "Used: the analysis of covariance of the score at the end on the score before. %1 No "
                   "plan of the analysis is in the record.",
                   errors);
}

}  // namespace

ReportParagraph ratersOfSomeGroupsSentence(const CohortInputs& in, const std::vector<std::string>& codes,
                                           const Ledger& ledger) {
  const ReportCell count = ResultsAt(ledger, {.section = ResultSection::kAgreement,
                                              .occasion = ledger.lastOccasion()})("raters_of_some_groups");
  return {
      Text::tr("Raters who scored trainees of some groups only %1: %2. How severe such a rater is cannot be "
               "told from what the training did: a difference between groups may be one between raters.",
               in.occasions.back(), whoText(in, codes, count.words())),
      {count}};
}

std::vector<Text> groupsNotCompared(const CohortInputs& in, const StudyAnalysis& study) {
  std::vector<Text> out;
  for (const std::size_t g : groupsWithoutEnds(study)) {
    out.push_back(in.groups[g].name);
  }
  return out;
}

std::vector<ReportParagraph> plannedAndUsed(const CohortInputs& in, const StudyAnalysis& study,
                                            const Ledger& ledger) {
  if (study.occasions.size() < 2) {
    return {};
  }
  std::vector<ReportParagraph> out = otherRaters(in, study, ledger);
  for (ReportParagraph& sentence : raterGroupSentences(in, study, ledger)) {
    out.push_back(std::move(sentence));
  }
  if (const std::vector<Text> groups = groupsNotCompared(in, study); !groups.empty()) {
    out.push_back(Text::tr("Not compared, as nobody has a score at both occasions: %1.", listed(groups)));
  }
  if (!study.ancova && !study.mixed) {
    out.push_back(Text::tr("%1 It is not defined (%2): the groups are not compared.", planText(in),
                           study.ancova.reason()));
    return out;
  }
  const bool centres = study.primaryMethod() == PrimaryMethod::kCentres;
  if (study.asPlanned()) {
    const Text marks =
        out.empty()
            ? Text::tr("No mark of the first and the last occasion is missing.")
            : Text::tr("Every trainee has the marks that most have at the first and the last occasion.");
    out.insert(out.begin(), Text::verbatim("%1 %2", usedAsPlanned(in, study), marks));
    return out;
  }
  const ResultsAt at = resultsAtEnd(ledger);
  const ReportCell lost = at("marks_missing");
  const ReportCell all = at("marks_missing", kValues);
  const ReportCell compared = at("trainees_compared");
  const Text missing =
      study.endMissing > 0
          ? Text::tr("Of %2 {mark|marks} of the first and the last occasion %1 {is|are} missing",
                     lost.words(), all.words())
          : Text::tr("Not every trainee was marked by the same raters at the end");
  out.push_back(
      {study.mixed
           ? Text::tr("%1 %2, so the linear mixed model is the primary comparison here: it uses every mark "
                      "at the end of everybody who also has one before. The analysis of covariance is shown "
                      "beside it, for the %3 "
                      "{trainee|trainees} with a score at both occasions.",
                      planText(in), missing, compared.words())
           : Text::tr("%1 %2. The linear mixed model that would take every mark is not defined (%3), so the "
                      "analysis of covariance is used, of the %4 {trainee|trainees} with a score at both "
                      "occasions.",
                      planText(in), missing, study.mixed.reason(), compared.words()),
       {lost, all, compared}});
  if (centres) {
    out.push_back(withCentre(study));
  } else if (study.sites) {
    out.push_back(
        Text::tr("The linear mixed model has no term for the centre: the comparison with the centre "
                 "stands beside it."));
  }
  if (const std::vector<std::string> codes = leftOutTrainees(study); !codes.empty()) {
    const ReportCell count = at("trainees_left_out");
    out.push_back({Text::tr("Left out of both, without any mark at one of the two: %1.",
                            whoText(in, codes, Text::tr("%1 trainees", count.words()))),
                   {count}});
  }
  if (study.endMissing == 0) {
    return out;
  }
  out.push_back(
      Text::tr("Both assume that whether a mark is missing does not depend on its value, given the group and "
               "the score before. The table of bounds shows the worst that the missing marks could do."));
  return out;
}

std::optional<ReportTable> missingTable(const CohortInputs& in, const StudyAnalysis& study,
                                        const Ledger& ledger) {
  if (study.missing.empty()) {
    return std::nullopt;
  }
  ReportTable table = itemOf<ReportTable>(in, "table-missing", Text::tr("Trainees of whom marks are missing"),
                                          Text::tr("counts"));
  table.annex = true;
  table.individual = true;
  ResultTable rows(ledger, table,
                   {{Text::tr("Trainee")},
                    {Text::tr("Group")},
                    {Text::tr("Marks missing before"), "marks_missing_before"},
                    {Text::tr("Marks missing at the end"), "marks_missing_at_the_end"},
                    {Text::tr("Compared"), "compared"}});
  for (const MissingTrainee& trainee : study.missing) {
    rows.row({trainee.trainee, in.groups[trainee.group].name}, {.section = ResultSection::kComparison,
                                                                .of = trainee.trainee,
                                                                .group = ledger.group(trainee.group),
                                                                .occasion = ledger.lastOccasion()});
  }
  table.provenance.n = resultsAtEnd(ledger).count("marks_at_both_ends");
  table.provenance.missing = resultsAtEnd(ledger).count("marks_missing");
  table.notes = {Text::tr("Missing: short of the number of marks that most trainees have at that occasion.")};
  return table;
}

std::optional<ReportTable> mixedModelTable(const CohortInputs& in, const StudyAnalysis& study,
                                           const Ledger& ledger) {
  if (study.asPlanned()) {
    return std::nullopt;
  }
  ReportTable table = itemOf<ReportTable>(
      in, "table-mixed-model", Text::tr("Marks at the end, adjusted for the score before: every mark given"),
      Text::tr("linear mixed model, restricted maximum likelihood"));
  ResultTable rows(ledger, table,
                   {{Text::tr("Comparison")},
                    {Text::tr("Difference [95 %, not adjusted]"), "mixed_model_difference", kWithInterval},
                    {Text::tr("[95 %, all pairs together]"), "mixed_model_difference_simultaneous_95"},
                    {Text::verbatim("t"), "mixed_model_t", fixed(2)},
                    {Text::tr("Degrees of freedom"), "mixed_model_df", fixed(1)},
                    {Text::verbatim("p"), "mixed_model_p", kAsP},
                    {Text::tr("p (Holm)"), "mixed_model_p_holm", kAsP}});
  if (!study.mixed) {
    table.rows.push_back({notDefined(study.mixed.reason()), "", "", "", "", "", ""});
    return table;
  }
  const MixedComparison& model = *study.mixed;
  for (const MixedComparison::Pair& pair : model.pairs) {
    rows.row({pairName(in, pair.first, pair.second)}, pairKey(ledger, pair.first, pair.second));
  }
  const ResultsAt at = resultsAtEnd(ledger);
  const ReportCell marks = at("mixed_model_marks");
  const ReportCell trainees = at("mixed_model_trainees");
  const ReportCell ofTrainees = at("mixed_model_variance_of_trainees", fixed(3));
  const ReportCell ofRaters = at("mixed_model_variance_of_raters", fixed(3));
  const ReportCell residual = at("mixed_model_variance_of_rest", fixed(3));
  const ReportCell slope = at("mixed_model_slope", kWithInterval);
  const ReportParagraph means =
      valuesOfGroups(in, ledger, model.groups, "mixed_model_adjusted_mean", kWithInterval);
  if (model.group) {
    const ReportCell df1 = at("mixed_model_group_df", fixed(0));
    const ReportCell df2 = at("mixed_model_group_df_error", fixed(1));
    const ReportCell f = at("mixed_model_group_f", fixed(2));
    const ReportCell p = at("mixed_model_group_p", kEqualsP);
    table.notes.push_back(
        {Text::tr("Effect of the group: F(%1, %2) = %3, %4.", df1.words(), df2.words(), f.words(), p.words()),
         {df1, df2, f, p}});
  }
  table.notes.push_back(
      {Text::tr("Mark at the end on group and mean mark before (fixed), trainee and rater (random, crossed); "
                "%1 {mark|marks} of %2 {trainee|trainees}. Degrees of freedom after Satterthwaite.",
                marks.words(), trainees.words()),
       {marks, trainees}});
  table.notes.push_back({Text::tr("Adjusted means [95 %]: %1.", means.words()), {}, means.keys});
  table.notes.push_back(
      {Text::tr("Variances: trainees %1, raters %2, residual %3 (points squared). Slope on the score before "
                "[95 %]: %4.",
                ofTrainees.words(), ofRaters.words(), residual.words(), slope.words()),
       {ofTrainees, ofRaters, residual, slope}});
  table.provenance.n = marks;
  table.provenance.missing = resultsAtEnd(ledger).count("marks_missing");
  return table;
}

std::optional<ReportTable> boundsTable(const CohortInputs& in, const StudyAnalysis& study,
                                       const Ledger& ledger) {
  if (study.bounds.empty()) {
    return std::nullopt;
  }
  ReportTable table =
      itemOf<ReportTable>(in, "table-bounds", Text::tr("What the missing marks could do at worst"),
                          Text::tr("analysis of covariance, missing marks at the ends of the scale"));
  ResultTable rows(
      ledger, table,
      {{Text::tr("Comparison")},
       {Text::tr("Worst for the first group [95 %, not adjusted]"), "bound_worst", kWithInterval},
       {Text::tr("Best for the first group [95 %, not adjusted]"), "bound_best", kWithInterval},
       {Text::tr("Direction")}});
  for (const MissingBounds& pair : study.bounds) {
    Text direction = Text::tr("not known");
    if (pair.worst && pair.best) {
      direction = pair.worst->interval.lower > 0.0  ? Text::tr("first is better whatever is missing")
                  : pair.best->interval.upper < 0.0 ? Text::tr("second is better whatever is missing")
                                                    : Text::tr("not decided");
    }
    rows.row({pairName(in, pair.first, pair.second), direction}, pairKey(ledger, pair.first, pair.second));
  }
  table.notes = {
      Text::tr("Every missing mark at the end is taken as the lowest of the scale in one group and as the "
               "highest in the other. Trainees without a score before get the mean of the others.")};
  table.provenance.n = resultsAtEnd(ledger).count("marks_at_both_ends");
  table.provenance.missing = resultsAtEnd(ledger).count("marks_missing");
  return table;
}

}  // namespace torsio
