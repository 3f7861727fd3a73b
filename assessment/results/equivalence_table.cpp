// SPDX-License-Identifier: GPL-3.0-or-later
// Whether groups are equal within the planned margin.
#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"

namespace torsio {

std::optional<ReportTable> equivalenceTable(const CohortInputs& in, const StudyAnalysis& study) {
  if (!in.equivalenceMargin) {
    return std::nullopt;
  }
  const std::string margin = formatFixed(*in.equivalenceMargin, 2);
  ReportTable table =
      itemOf<ReportTable>(in, "table-equivalence", Text::tr("Whether the groups are equal within the margin"),
                          study.mixed ? Text::tr("two one-sided tests, linear mixed model")
                                      : Text::tr("two one-sided tests, analysis of covariance"));
  table.columns = {Text::tr("Comparison"), Text::tr("Difference [90 %, not adjusted]"),
                   Text::tr("p (of equality)"), Text::tr("Equal within %1 points (5 %)", margin)};
  table.provenance.n = study.mixed ? static_cast<std::int64_t>(study.mixed->marks) : comparedTrainees(study);
  table.provenance.missing = study.endMissing;
  table.notes = {Text::tr(
      "Planned with the cohort: a difference of at most %1 points does not matter. Equal: the 90 % "
      "interval lies within -%1 to %1, which is where p is below 0.05. Not shown to be equal does not "
      "say that the groups differ.",
      margin)};
  for (const PrimaryDifference& pair : primaryDifferences(study)) {
    if (!(pair.error > 0.0)) {
      table.rows.push_back({pairName(in, pair.first, pair.second), Text::tr("not defined"), "", ""});
      continue;
    }
    const Equivalence test = equivalence(pair.value, pair.error, pair.df, *in.equivalenceMargin);
    table.rows.push_back({pairName(in, pair.first, pair.second), withInterval(pair.value, test.interval),
                          cellsOfPair(in, pair.first, pair.second)("equivalence_p", formatP(test.p)),
                          test.p < 1.0 - kDefaultConfidence ? Text::tr("yes") : Text::tr("not shown")});
  }
  if (table.rows.empty()) {
    table.rows.push_back({notDefined(study.ancova.reason()), "", "", ""});
  }
  return table;
}

}  // namespace torsio
