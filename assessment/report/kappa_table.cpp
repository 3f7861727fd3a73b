// SPDX-License-Identifier: GPL-3.0-or-later
// Agreement of pairs of raters in whole points.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "assessment/report/analysis_tables.h"
#include "assessment/report/number_format.h"
#include "assessment/report/report_labels.h"
#include "assessment/report/report_sections.h"
#include "assessment/statistics/descriptive.h"

namespace torsio {

namespace {

/// What two raters or more have in common at one occasion.
struct PointAgreement {
  std::size_t pairs = 0;
  std::vector<double> kappas;  ///< of the pairs for which it is defined
  double shared = 0.0;         ///< marks of the same trainee by two raters
  double same = 0.0;
  double withinOne = 0.0;
};

PointAgreement agreementInPoints(const OccasionMarks& at, std::size_t raters, const ScoreScale& scale) {
  const auto pointOf = [&](double mark) { return static_cast<std::int64_t>(std::lround(mark)); };
  const std::int64_t lowest = pointOf(pointsFromSteps(scale.lo, scale));
  const auto points = static_cast<std::size_t>(pointOf(pointsFromSteps(scale.hi, scale)) - lowest + 1);
  PointAgreement out;
  for (std::size_t a = 0; a < raters; ++a) {
    for (std::size_t b = a + 1; b < raters; ++b) {
      NumberTable counts(points, points);
      ++out.pairs;
      for (const std::vector<std::optional<double>>& marks : at.marks) {
        if (!marks[a] || !marks[b]) {
          continue;
        }
        const std::int64_t x = pointOf(*marks[a]) - lowest;
        const std::int64_t y = pointOf(*marks[b]) - lowest;
        counts.at(static_cast<std::size_t>(x), static_cast<std::size_t>(y)) += 1.0;
        out.shared += 1.0;
        out.same += x == y ? 1.0 : 0.0;
        out.withinOne += std::abs(x - y) <= 1 ? 1.0 : 0.0;
      }
      if (const Outcome<KappaResult> kappa = cohenKappa(counts, KappaWeights::kQuadratic)) {
        out.kappas.push_back(kappa->kappa);
      }
    }
  }
  return out;
}

}  // namespace

ReportTable kappaTable(const CohortInputs& in, const StudyAnalysis& study) {
  ReportTable table = itemOf<ReportTable>(
      in, "table-kappa", Text::tr("Agreement of the raters in whole points, pair by pair"),
      Text::tr("Cohen's kappa with quadratic weights; marks rounded to whole points"));
  table.columns = {Text::tr("Occasion"),       Text::tr("Pairs of raters"),
                   Text::tr("Marks compared"), Text::tr("Kappa, median (lowest to highest)"),
                   Text::tr("Same point"),     Text::tr("Within one point")};
  const auto share = [](double part, double of) {
    return of > 0.0 ? Text::verbatim("%1 %", formatFixed(100.0 * part / of, 0)) : Text::tr("not defined");
  };
  for (std::size_t t = 0; t < in.occasions.size(); ++t) {
    const OccasionMarks& at = study.occasions[t];
    const PointAgreement found = agreementInPoints(at, study.raters.size(), in.trainingScale);
    table.provenance.n += at.n;
    table.provenance.missing += at.missing;
    const Text kappa =
        found.kappas.empty()
            ? Text::tr("not defined")
            : Text::tr("%1 (%2 to %3)", formatFixed(medianOf(found.kappas), 3),
                       formatFixed(*std::min_element(found.kappas.begin(), found.kappas.end()), 3),
                       formatFixed(*std::max_element(found.kappas.begin(), found.kappas.end()), 3));
    table.rows.push_back({in.occasions[t], std::to_string(found.pairs), formatFixed(found.shared, 0), kappa,
                          share(found.same, found.shared), share(found.withinOne, found.shared)});
  }
  table.notes = {
      Text::tr("Kappa is agreement beyond what the raters' own habits would give; a distance counts by its "
               "square. One pair far below the others names raters who should talk: see their severity.")};
  return table;
}

}  // namespace torsio
