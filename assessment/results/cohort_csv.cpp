// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/cohort_csv.h"

#include <array>

#include "assessment/results/analysed_cohort.h"
#include "assessment/results/number_format.h"
#include "sim/core/csv_cell.h"

namespace torsio {

void appendCsvLine(std::string& text, std::span<const std::string> cells) {
  for (const std::string& cell : cells) {
    if (&cell != &cells.front()) {
      text += ',';
    }
    appendCsvCell(text, cell);
  }
  text += "\r\n";
}

std::string resultText(const ResultValue& value) {
  if (const auto* word = std::get_if<Text>(&value)) {
    return word->str();
  }
  if (const auto* interval = std::get_if<Interval>(&value)) {
    return "[" + formatExact(interval->lower) + ", " + formatExact(interval->upper) + "]";
  }
  const std::optional<double> number = numberIn(value);
  return number ? formatExact(*number) : std::string();
}

std::vector<CohortCsvRow> cohortCsvRows(const Ledger& ledger) {
  std::vector<CohortCsvRow> rows;
  rows.reserve(ledger.every().size());
  ledger.eachLine([&](const Result& result) {
    auto [section, item, group, model, index, occasion, statistic] = keyCells(result.key);
    rows.push_back({std::move(section), std::move(item), std::move(group), std::move(model), std::move(index),
                    std::move(occasion), std::move(statistic), resultText(result.value),
                    std::to_string(result.n), result.flags});
  });
  return rows;
}

std::string cohortCsvText(const std::vector<CohortCsvRow>& rows) {
  std::string text;
  appendCsvLine(text, std::array<std::string, 10>{"section", "item", "group", "model", "index", "occasion",
                                                  "statistic", "value", "n", "flags"});
  for (const CohortCsvRow& row : rows) {
    appendCsvLine(text, std::array{row.section, row.item, row.group, row.model, row.index, row.occasion,
                                   row.statistic, row.value, row.n, row.flags});
  }
  return text;
}

std::string cohortCsvText(const Ledger& ledger) {
  return cohortCsvText(cohortCsvRows(ledger));
}

}  // namespace torsio
