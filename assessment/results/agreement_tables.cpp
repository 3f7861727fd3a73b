// SPDX-License-Identifier: GPL-3.0-or-later
// Agreement of the raters: overall, within groups, and with missing marks.
#include <algorithm>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"

namespace torsio {

namespace {

constexpr int kAgreementDecimals = 3;

Text coefficientText(const Outcome<IccResult>& icc, IccForm IccResult::*form) {
  return icc ? Text(withInterval(((*icc).*form).estimate, ((*icc).*form).interval))
             : notDefined(icc.reason());
}

Text errorText(const Outcome<IccResult>& icc, double IccResult::*error) {
  return icc ? Text(formatFixed((*icc).*error, kAgreementDecimals)) : Text::tr("not defined");
}

}  // namespace

ReportTable agreementTable(const CohortInputs& in, const StudyAnalysis& study) {
  ReportTable table =
      itemOf<ReportTable>(in, "table-agreement", Text::tr("Agreement of the raters at each occasion"),
                          Text::tr("Shrout and Fleiss ICC(2,1), ICC(2,k); Krippendorff alpha"));
  table.columns = {Text::tr("Occasion"),
                   Text::tr("Trainees"),
                   Text::tr("ICC(2,1) [95 %]"),
                   Text::tr("ICC(2,k) [95 %]"),
                   Text::tr("SEM of one rater (points)"),
                   Text::tr("SEM of the mean (points)"),
                   Text::tr("Krippendorff alpha")};
  bool holes = false;
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    const OccasionMarks& at = study.occasions[t];
    table.provenance.n += at.n;
    table.provenance.missing += at.missing;
    const CellsAt cell({.section = ResultSection::kAgreement, .occasion = t});
    table.rows.push_back(
        {in.occasions[t], std::to_string(at.completeTrainees),
         cell("icc_2_1", coefficientText(at.icc, &IccResult::agreementSingle)),
         cell("icc_2_k", coefficientText(at.icc, &IccResult::agreementMean)),
         cell("sem_agreement", errorText(at.icc, &IccResult::semAgreement)),
         cell("sem_of_mean", errorText(at.icc, &IccResult::semMean)),
         cell("krippendorff_alpha_interval", at.alpha ? Text(formatFixed(at.alpha->alpha, kAgreementDecimals))
                                                      : notDefined(at.alpha.reason()))});
    if (at.missing == 0) {
      continue;
    }
    holes = true;
    const auto shown = [&](double IncompleteReliability::*value) {
      return at.reliability ? Text(formatFixed((*at.reliability).*value, kAgreementDecimals))
                            : notDefined(at.reliability.reason());
    };
    table.rows.push_back({Text::tr("%1, every mark", in.occasions[t]), std::to_string(at.marks.size()),
                          cell("reml_one_rater", shown(&IncompleteReliability::single)),
                          cell("reml_mean", shown(&IncompleteReliability::mean)),
                          cell("reml_sem_of_one_rater", shown(&IncompleteReliability::semSingle)),
                          cell("reml_sem_of_mean", shown(&IncompleteReliability::semMean)), ""});
  }
  table.notes = {
      holes
          ? Text::tr("ICC: absolute agreement, raters as a random sample; (2,1) for one rater, (2,k) for the "
                     "mean over all, which is the reported score of who has a mark of each.")
          : Text::tr("ICC: absolute agreement, raters as a random sample; (2,1) for one rater, (2,k) for the "
                     "mean over all, which is the reported score."),
      Text::tr("Alpha with the interval metric. A group that is much alike gives a low coefficient even when "
               "raters agree well: look at the standard error of measurement (SEM)."),
      Text::tr("The intervals assume normal scores. With strongly skewed scores they include the true "
               "coefficient in about four of five cases, not in 95 %.")};
  if (holes) {
    table.notes.push_back(Text::tr(
        "Marks are missing: the first line of an occasion is made from the trainees whom every rater "
        "scored, the second from every mark, with variances by restricted maximum likelihood."));
  }
  return table;
}

ReportTable agreementWithinTable(const CohortInputs& in, const StudyAnalysis& study) {
  ReportTable table =
      itemOf<ReportTable>(in, "table-agreement-groups", Text::tr("Agreement of the raters within each group"),
                          Text::tr("Shrout and Fleiss ICC(2,1), ICC(2,k), each group alone"));
  table.columns = {Text::tr("Occasion"),        Text::tr("Group"),
                   Text::tr("Trainees"),        Text::tr("ICC(2,1) [95 %]"),
                   Text::tr("ICC(2,k) [95 %]"), Text::tr("SEM of the mean (points)")};
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    table.provenance.n += study.occasions[t].n;
    table.provenance.missing += study.occasions[t].missing;
    for (const GroupAgreement& of : study.occasions[t].groups) {
      const CellsAt cell({.section = ResultSection::kAgreement, .group = of.group, .occasion = t});
      table.rows.push_back({in.occasions[t], in.groups[of.group].name, std::to_string(of.trainees),
                            cell("icc_2_1", coefficientText(of.icc, &IccResult::agreementSingle)),
                            cell("icc_2_k", coefficientText(of.icc, &IccResult::agreementMean)),
                            cell("sem_of_mean", errorText(of.icc, &IccResult::semMean))});
    }
  }
  table.notes = {
      Text::tr("Differences between the groups make raters agree in the table above. This table shows what "
               "counts for comparing trainees of one group.")};
  return table;
}

std::optional<ReportFigure> agreementFigure(const CohortInputs& in, const StudyAnalysis& study) {
  ReportFigure figure =
      itemOf<ReportFigure>(in, "figure-agreement", Text::tr("Agreement of the raters with 95 % intervals"),
                           Text::tr("Shrout and Fleiss ICC(2,1), ICC(2,k)"));
  figure.kind = FigureKind::kForest;
  figure.yLabel = Text::tr("intraclass correlation");
  FigureSeries one;
  FigureSeries mean;
  one.name = Text::tr("ICC(2,1), one rater");
  mean.name = Text::tr("ICC(2,k), mean of all raters");
  const auto add = [](FigureSeries& series, const IccForm& form) {
    series.y.emplace_back(form.estimate);
    series.low.push_back(form.interval->lower);
    series.high.push_back(form.interval->upper);
  };
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    const OccasionMarks& at = study.occasions[t];
    if (!at.icc || !at.icc->agreementSingle.interval || !at.icc->agreementMean.interval) {
      continue;
    }
    figure.categories.push_back(in.occasions[t]);
    add(one, at.icc->agreementSingle);
    add(mean, at.icc->agreementMean);
    figure.provenance.n += at.n;
    figure.provenance.missing += at.missing;
  }
  if (figure.categories.empty()) {
    return std::nullopt;
  }
  figure.series = {one, mean};
  figure.yMin = std::min(0.0, *std::min_element(one.low.begin(), one.low.end()));
  figure.yMax = 1.0;
  figure.notes = {Text::tr("1 is perfect agreement; 0 is what marks by chance would give.")};
  return figure;
}

}  // namespace torsio
