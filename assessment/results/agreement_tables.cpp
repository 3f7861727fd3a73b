// SPDX-License-Identifier: GPL-3.0-or-later
// Agreement of the raters: overall, within groups, with missing marks, and of pairs in whole points.
#include <algorithm>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"

namespace torsio {

namespace {

constexpr int kAgreementDecimals = 3;

/// States the marks of all occasions in a caption.
void setCounts(const Ledger& ledger, Provenance& caption) {
  const ResultsAt all(ledger, {.section = ResultSection::kAgreement});
  caption.n = all.count("marks");
  caption.missing = all.count("marks_missing");
}

}  // namespace

ReportTable agreementTable(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  ReportTable table = itemOf<ReportTable>(
      in, "table-agreement", Text::tr("Agreement of the raters within the groups, at each occasion"),
      Text::tr("G-study of trainees x raters within groups"));
  ResultTable rows(
      ledger, table,
      {{Text::tr("Occasion")},
       {Text::tr("Trainees"), "trainees_with_every_mark"},
       {Text::tr("Dependability of one rater [95 %]"), "dependability_of_one_rater", kWithInterval},
       {Text::tr("Dependability of the mean of all [95 %]"), "dependability_of_all_raters", kWithInterval},
       {Text::tr("SEM of one rater (points)"), "sem_agreement", fixed(kAgreementDecimals)},
       {Text::tr("SEM of the mean (points)"), "sem_of_mean", fixed(kAgreementDecimals)}});
  bool holes = false;
  setCounts(ledger, table.provenance);
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    const OccasionMarks& at = study.occasions[t];
    const ResultKey place{.section = ResultSection::kAgreement, .occasion = ledger.occasion(t)};
    rows.row({in.occasions[t]}, place);
    if (at.missing == 0) {
      continue;
    }
    holes = true;
    const ResultsAt cell(ledger, place);
    table.rows.push_back({Text::tr("%1, every mark", in.occasions[t]), cell("trainees_with_marks"),
                          cell("reml_one_rater", fixed(kAgreementDecimals)),
                          cell("reml_mean", fixed(kAgreementDecimals)),
                          cell("reml_sem_of_one_rater", fixed(kAgreementDecimals)),
                          cell("reml_sem_of_mean", fixed(kAgreementDecimals))});
  }
  table.notes = {
      Text::tr("Dependability: share of the variance of a mark, or of the mean over all raters, that is due "
               "to the trainee; in a single group the intraclass correlations for absolute agreement, "
               "ICC(2,1) and ICC(2,k). Raters count as a random sample. Differences between the groups do "
               "not count: an effect of the training would make raters look more alike."),
      Text::tr("A group that is much alike gives a low coefficient even when raters agree well: look at the "
               "standard error of measurement (SEM). The intervals assume normal scores. With strongly "
               "skewed scores they include the true coefficient in about four of five cases, not in 95 %.")};
  if (holes) {
    table.notes.push_back(Text::tr(
        "Marks are missing: the first line of an occasion is made from the trainees whom every rater "
        "scored, the second from every mark, with variances by restricted maximum likelihood and without "
        "an interval."));
  }
  return table;
}

ReportTable agreementWithinTable(const CohortInputs& in, const StudyAnalysis& study, const Ledger& ledger) {
  ReportTable table = itemOf<ReportTable>(in, "table-agreement-groups",
                                          Text::tr("Agreement of the raters in each group alone"),
                                          Text::tr("Shrout and Fleiss ICC(2,1), ICC(2,k), each group alone"));
  table.annex = true;
  ResultTable rows(ledger, table,
                   {{Text::tr("Occasion")},
                    {Text::tr("Group")},
                    {Text::tr("Trainees"), "trainees_with_every_mark"},
                    {Text::tr("ICC(2,1) [95 %]"), "icc_2_1", kWithInterval},
                    {Text::tr("ICC(2,k) [95 %]"), "icc_2_k", kWithInterval},
                    {Text::tr("SEM of the mean (points)"), "sem_of_mean", fixed(kAgreementDecimals)}});
  setCounts(ledger, table.provenance);
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    for (const GroupAgreement& of : study.occasions[t].groups) {
      rows.row({in.occasions[t], in.groups[of.group].name}, {.section = ResultSection::kAgreement,
                                                             .group = ledger.group(of.group),
                                                             .occasion = ledger.occasion(t)});
    }
  }
  return table;
}

ReportTable kappaTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table = itemOf<ReportTable>(
      in, "table-kappa", Text::tr("Agreement of the raters in whole points, pair by pair"),
      Text::tr("Cohen's kappa with quadratic weights, each group alone; marks rounded to whole points"));
  table.annex = true;
  ResultTable rows(ledger, table,
                   {{Text::tr("Occasion")},
                    {Text::tr("Group")},
                    {Text::tr("Pairs of raters"), "rater_pairs"},
                    {Text::tr("Marks compared"), "rater_pairs", kValues},
                    {Text::tr("Kappa, median (lowest to highest)")},
                    {Text::tr("Same point"), "share_same_point", percent(0)},
                    {Text::tr("Within one point"), "share_within_one_point", percent(0)}});
  setCounts(ledger, table.provenance);
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    for (std::size_t g = 0; g < in.groups.size(); ++g) {
      const ResultKey place{
          .section = ResultSection::kAgreement, .group = ledger.group(g), .occasion = ledger.occasion(t)};
      const ResultsAt cell(ledger, place);
      ReportCell kappa = cell("kappa_quadratic_median", fixed(kAgreementDecimals));
      if (cell.number("kappa_quadratic_median")) {
        static_cast<Text&>(kappa) = Text::tr(
            "%1 (%2 to %3)", kappa.words(), cell("kappa_quadratic_lowest", fixed(kAgreementDecimals)).words(),
            cell("kappa_quadratic_highest", fixed(kAgreementDecimals)).words());
      }
      rows.row({in.occasions[t], in.groups[g].name, kappa}, place);
    }
  }
  table.notes = {
      Text::tr("Kappa is agreement beyond chance; distances count by their square. If one pair is far below "
               "the others, these raters should compare how they mark: see their severity.")};
  return table;
}

std::optional<ReportFigure> agreementFigure(const CohortInputs& in, const Ledger& ledger) {
  ReportFigure figure = itemOf<ReportFigure>(
      in, "figure-agreement", Text::tr("Agreement of the raters within the groups, with 95 % intervals"),
      Text::tr("G-study of trainees x raters within groups"));
  figure.kind = FigureKind::kForest;
  figure.yLabel = Text::tr("dependability");
  FigureSeries one{.name = Text::tr("one rater")};
  FigureSeries mean{.name = Text::tr("mean of all raters")};
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    const ResultsAt at(ledger, {.section = ResultSection::kAgreement, .occasion = ledger.occasion(t)});
    if (at.find("dependability_of_one_rater_95") == nullptr ||
        at.find("dependability_of_all_raters_95") == nullptr) {
      continue;
    }
    figure.categories.push_back(in.occasions[t]);
    addPoint(one, at, "dependability_of_one_rater", true);
    addPoint(mean, at, "dependability_of_all_raters", true);
  }
  if (figure.categories.empty()) {
    return std::nullopt;
  }
  if (figure.categories.size() == in.occasions.size()) {
    setCounts(ledger, figure.provenance);
  }
  figure.series = {one, mean};
  figure.yMin = std::min(0.0, *std::min_element(one.low.begin(), one.low.end()));
  figure.yMax = 1.0;
  figure.notes = {Text::tr("1 is perfect agreement; 0 is what marks by chance would give.")};
  return figure;
}

}  // namespace torsio
