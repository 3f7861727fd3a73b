// SPDX-License-Identifier: GPL-3.0-or-later
// Effect of more raters, severity on one scale, and gains within groups.
#include <algorithm>
#include <cmath>

#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"

namespace torsio {

namespace {

constexpr int kReliabilityDecimals = 3;

/// Returns how many raters it takes, by the lower end of the interval; otherwise why that is not known.
ReportParagraph neededSentence(const Ledger& ledger, const StudyAnalysis& study) {
  const RatersNeeded& found = study.needed;
  const GStudy& components = *study.occasions.back().within;
  const ResultsAt at(ledger, {.section = ResultSection::kAgreement, .occasion = ledger.lastOccasion()});
  const ReportCell fewest = at("raters_needed", fixed(0));
  const ReportCell byEstimate = at("raters_needed_by_estimate", fixed(0));
  const std::string wanted = formatFixed(kWantedDependability, 2);
  if (components.at("pr").variance == 0.0 && components.at("r").variance == 0.0) {
    return Text(
        Text::tr("All raters gave the same marks: that says nothing about how many are needed, as raters who "
                 "score by themselves differ."));
  }
  if (found.fewest) {
    return {
        Text::tr("%1 {rater is|raters are} the fewest whose mean has a dependability of %2 or more with 95 % "
                 "confidence (lower end of the interval); by the estimate alone it would be %3.",
                 fewest.words(), wanted, byEstimate.words()),
        {fewest, byEstimate}};
  }
  return {
      found.fewestByEstimate
          ? Text::tr("These trainees are too few to say how many raters are needed: even %1 {rater "
                     "does|raters do} not "
                     "have a dependability of %2 with 95 % confidence. By the estimate alone it would be %3.",
                     kMaxRaters, wanted, byEstimate.words())
          : Text::tr("Not even %1 raters would give a dependability of %2.", kMaxRaters, wanted),
      {byEstimate}};
}

ReportTable ratersNeededTable(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  auto table =
      itemOf<ReportTable>(in, "table-raters-needed", Text::tr("How many raters are needed"),
                          Text::tr("G-study of trainees x raters within groups, last occasion; D-study"));
  ResultTable rows(
      ledger, table,
      {{Text::tr("Raters")},
       {Text::tr("Dependability (level) [95 %]"), "dependability", kWithInterval},
       {Text::tr("Generalizability (order)"), "generalizability", fixed(kReliabilityDecimals), ""},
       {Text::tr("Standard error of the mean mark (points)"), "standard_error_of_mean_mark",
        fixed(kReliabilityDecimals), ""}});
  const RatersNeeded& found = study.needed;
  const ResultsAt at(ledger, {.section = ResultSection::kAgreement, .occasion = ledger.lastOccasion()});
  table.provenance.n = at.count("variance_of_trainees", kValues);
  table.provenance.missing = at.count("marks_missing");
  const Outcome<GStudy>& components = study.occasions.back().within;
  if (!components) {
    table.rows.push_back({notDefined(components.reason()), "", "", ""});
    return table;
  }
  for (const RatersNeeded::Planned& planned : found.planned) {
    rows.row({std::to_string(planned.raters)}, {.section = ResultSection::kAgreement,
                                                .index = ratersIndex(planned.raters),
                                                .occasion = ledger.lastOccasion()});
  }
  if (std::any_of(found.planned.begin(), found.planned.end(),
                  [](const auto& planned) { return static_cast<bool>(planned.study); })) {
    table.notes = {neededSentence(ledger, study)};
  }
  const ReportCell trainees = at("variance_of_trainees", fixed(kReliabilityDecimals));
  const ReportCell raters = at("variance_of_raters", fixed(kReliabilityDecimals));
  const ReportCell rest = at("variance_of_rest", fixed(kReliabilityDecimals));
  table.notes.push_back(
      {Text::tr("Components of variance within groups: trainees %1, raters %2, rest %3. Differences between "
                "the groups do not count: an effect of the training would make raters look more alike.",
                trainees.words(), raters.words(), rest.words()),
       {trainees, raters, rest}});
  if (components->negativeComponent) {
    table.notes.push_back(Text::tr("A negative component counts as 0 in the rows above."));
  }
  return table;
}

ReportTable raschTable(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  auto table = itemOf<ReportTable>(in, "table-rasch", Text::tr("Raters on one scale, last occasion"),
                                   Text::tr("many-facet Rasch model, joint maximum likelihood"));
  table.annex = true;
  table.individual = true;
  table.columns = {Text::tr("Rater"), Text::tr("Severity, corrected (logits) [95 %]"),
                   Text::tr("Joint estimate"), Text::tr("Infit"), Text::tr("Outfit")};
  const ResultsAt last(ledger, {.section = ResultSection::kAgreement, .occasion = ledger.lastOccasion()});
  table.provenance.n = last.count("marks");
  table.provenance.missing = last.count("marks_missing");
  const Outcome<RaschResult>& found = study.rasch;
  if (!found) {
    table.rows.push_back({notDefined(found.reason()), "", "", "", ""});
    return table;
  }
  for (std::size_t r = 0; r < study.raters.size(); ++r) {
    const RaschRater& rater = found->raters[r];
    const Text none =
        rater.status == RaschStatus::kNoRatings ? Text::tr("no mark here") : Text::tr("only extreme marks");
    const ResultsAt cell(
        ledger,
        {.section = ResultSection::kAgreement, .of = study.raters[r], .occasion = ledger.lastOccasion()});
    table.rows.push_back({study.raters[r], cell("rasch_severity_corrected", kWithInterval, none),
                          cell("rasch_severity", fixed(2), none), cell("rasch_infit", fixed(2), none),
                          cell("rasch_outfit", fixed(2), none)});
  }
  table.notes = {Text::tr(
      "Positive: stricter. Severities sum to zero. Infit and outfit are about 1 where a rater's marks follow "
      "the "
      "model; the marks that occur, in their order, are its categories. Joint estimates lie too far apart; "
      "the "
      "corrected ones allow for it, and their intervals come from leaving out trainees.")};
  return table;
}

}  // namespace

std::vector<ReportTable> reliabilityTables(const CohortInputs& in, const StudyAnalysis& study,
                                           const Ledger& ledger) {
  if (study.occasions.empty() || study.raters.size() < 2) {
    return {};
  }
  return {ratersNeededTable(in, study, ledger), raschTable(in, study, ledger)};
}

std::optional<ReportTable> withinGroupsTable(const CohortInputs& in, const StudyAnalysis& study,
                                             const Ledger& ledger) {
  if (!study.gains) {
    return std::nullopt;
  }
  auto table = itemOf<ReportTable>(in, "table-within-groups", Text::tr("What each group gained by itself"),
                                   Text::tr("exact signed ranks; Friedman; bootstrap of the median, BCa"));
  ResultTable rows(ledger, table,
                   {{Text::tr("Group")},
                    {Text::tr("Trainees"), "median_gain", kValues},
                    {Text::tr("Median gain [95 %] (points)"), "median_gain", kWithInterval},
                    {Text::tr("Signed ranks V"), "gain_signed_rank_v", fixed(1)},
                    {Text::tr("p (exact)")},
                    {Text::tr("p (Friedman, all occasions)"), "occasions_friedman_p", kAsP}});
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const GroupGain& gain = study.gains->within[g];
    const ResultKey place{
        .section = ResultSection::kComparison, .group = ledger.group(g), .occasion = ledger.lastOccasion()};
    ReportCell p = ResultsAt(ledger, place)("gain_signed_rank_p", kAsP);
    if (gain.ranks && !gain.ranks->exact) {  // random sign changes
      static_cast<Text&>(p) = Text::tr("%1, random changes of sign, standard error %2", p.words(),
                                       formatFixed(gain.ranks->error, 4));
    }
    rows.row({in.groups[g].name, gain.ranks ? p : ReportCell()}, place);
  }
  table.provenance.n = resultsAtEnd(ledger).count("trainees_compared");
  table.notes = {
      Text::tr("A gain within a group shows no effect of its training: repetition alone may give it. Compare "
               "the groups. p values and intervals of this table are not adjusted for the number of "
               "groups.")};
  return table;
}

}  // namespace torsio
