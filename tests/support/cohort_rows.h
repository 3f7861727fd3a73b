// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_csv.h"
#include "sim/core/csv_cell.h"

namespace torsio {

/// Returns the rows of cohort.csv of a cohort.
inline std::vector<CohortCsvRow> cohortCsvRows(const CohortInputs& inputs) {
  return cohortCsvRows(analysedCohort(inputs).ledger);
}

/// Identifies a row by its first seven cells as in the file: keyAddress() of its result.
inline std::string numberAddress(const CohortCsvRow& row) {
  std::string address;
  for (const std::string* field :
       {&row.section, &row.item, &row.group, &row.model, &row.index, &row.occasion, &row.statistic}) {
    address += (field == &row.section ? "" : ",") + csvCell(*field);
  }
  return address;
}

}  // namespace torsio
