// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/outputs/tables/export_table.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_report.h"

namespace torsio {

/// The tables of a cohort, by what a row is.
struct ExportSet {
  ExportTable groups;        ///< a group of the cohort
  ExportTable participants;  ///< a trainee
  ExportTable scores;        ///< a trainee and occasion
  ExportTable marks;         ///< a mark of a rater, or one that is missing
  ExportTable trials;        ///< a recorded trial
  ExportTable twists;        ///< a twist of a trial
  ExportTable competence;    ///< a trainee and exercise
  ExportTable evaluation;    ///< a number of the evaluation of models
  ExportTable agreement;     ///< a number about raters
  ExportTable comparison;    ///< a number about groups
  ExportTable deviations;    ///< something that did not go by the protocol
  ExportTable numbers;       ///< a line of cohort.csv, its value also as the text that stands there
};

/// Sorts the results of a cohort into tables: what its ledger leaves out is left out here, and no number is
/// computed. `startedUtc_us`: when runs began, as far as that may be told.
[[nodiscard]] ExportSet exportSet(const AnalysedCohort& cohort,
                                  const std::map<TrialId, std::int64_t>& startedUtc_us);

/// The tables in the order in which people look at them.
[[nodiscard]] std::vector<const ExportTable*> tablesOf(const ExportSet& set);

}  // namespace torsio
