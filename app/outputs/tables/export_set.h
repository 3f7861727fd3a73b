// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/outputs/tables/export_table.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_report.h"

namespace torsio {

/// The tables of a cohort, named by what a row is.
struct ExportSet {
  ExportTable groups;        ///< per group of the cohort
  ExportTable participants;  ///< per trainee
  ExportTable scores;        ///< per trainee and occasion
  ExportTable marks;         ///< per mark of a rater, given or missing
  ExportTable trials;        ///< per recorded trial
  ExportTable twists;        ///< per twist of a trial
  ExportTable competence;    ///< per trainee and exercise
  ExportTable evaluation;    ///< per number of the evaluation of models
  ExportTable agreement;     ///< per number about raters
  ExportTable comparison;    ///< per number about groups
  ExportTable deviations;    ///< per protocol deviation
  ExportTable numbers;       ///< per row of cohort.csv, with the value also as its text
};

/// Sorts the results of a cohort into tables; computes none, and omits what its ledger omits.
/// `startedUtc_us`: start times of runs, as far as they may be shown.
[[nodiscard]] ExportSet exportSet(const AnalysedCohort& cohort,
                                  const std::map<TrialId, std::int64_t>& startedUtc_us);

/// Returns the tables in reading order.
[[nodiscard]] std::vector<const ExportTable*> tablesOf(const ExportSet& set);

}  // namespace torsio
