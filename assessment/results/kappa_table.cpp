// SPDX-License-Identifier: GPL-3.0-or-later
// Agreement of pairs of raters in whole points.
#include <algorithm>
#include <cstdint>

#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "assessment/statistics/descriptive.h"

namespace torsio {

ReportTable kappaTable(const CohortInputs& in, const StudyAnalysis& study) {
  ReportTable table = itemOf<ReportTable>(
      in, "table-kappa", Text::tr("Agreement of the raters in whole points, pair by pair"),
      Text::tr("Cohen's kappa with quadratic weights; marks rounded to whole points"));
  table.columns = {Text::tr("Occasion"),       Text::tr("Pairs of raters"),
                   Text::tr("Marks compared"), Text::tr("Kappa, median (lowest to highest)"),
                   Text::tr("Same point"),     Text::tr("Within one point")};
  const auto share = [](std::int64_t part, std::int64_t of) {
    return of > 0 ? Text::verbatim(
                        "%1 %", formatFixed(100.0 * static_cast<double>(part) / static_cast<double>(of), 0))
                  : Text::tr("not defined");
  };
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    const OccasionMarks& at = study.occasions[t];
    const PointAgreement& found = at.points;
    table.provenance.n += at.n;
    table.provenance.missing += at.missing;
    const Text kappa =
        found.kappas.empty()
            ? Text::tr("not defined")
            : Text::tr("%1 (%2 to %3)", formatFixed(medianOf(found.kappas), 3),
                       formatFixed(*std::min_element(found.kappas.begin(), found.kappas.end()), 3),
                       formatFixed(*std::max_element(found.kappas.begin(), found.kappas.end()), 3));
    const CellsAt cell({.section = ResultSection::kAgreement, .occasion = t});
    table.rows.push_back({in.occasions[t], cell("rater_pairs", std::to_string(found.pairs)),
                          std::to_string(found.shared), cell("kappa_quadratic_median", kappa),
                          cell("share_same_point", share(found.same, found.shared)),
                          cell("share_within_one_point", share(found.withinOne, found.shared))});
  }
  table.notes = {
      Text::tr("Kappa is agreement beyond chance; distances count by their square. If one pair is far below "
               "the others, these raters should compare how they mark: see their severity.")};
  return table;
}

}  // namespace torsio
