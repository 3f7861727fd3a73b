// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/catalogue/quantity.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "assessment/statistics/quantiles.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

/// Untwistings of one group in one phase.
struct Untwistings {
  Text phase;
  std::int64_t trials = 0;
  std::map<std::string, std::vector<double>> values;  // by id, for trials in which it is defined
  std::vector<double> beyondLeast;                    // re-grips

  void add(const TrialSummaryRow& trial) {
    phase = trial.phase;
    ++trials;
    for (const auto& [id, value] : trial.detorsion) {
      values[id].push_back(value);
    }
    const auto regrips = trial.detorsion.find(idOf(Quantity::kRegrips));
    const auto least = trial.detorsion.find(idOf(Quantity::kLeastRegrips));
    if (regrips != trial.detorsion.end() && least != trial.detorsion.end()) {
      beyondLeast.push_back(regrips->second - least->second);
    }
  }
  /// Formats in how many trials a quantity was yes or above 0, of those that have it.
  [[nodiscard]] Text yes(Quantity quantity) const {
    const auto found = values.find(idOf(quantity));
    if (found == values.end()) {
      return Text::tr("not recorded");
    }
    std::int64_t count = 0;
    for (const double value : found->second) {
      count += value > 0.0 ? 1 : 0;
    }
    return Text::tr("%1 of %2", count, found->second.size());
  }
  [[nodiscard]] std::size_t timesDefined(Quantity quantity) const {
    const auto found = values.find(idOf(quantity));
    return found == values.end() ? 0 : found->second.size();
  }
  [[nodiscard]] Text median(Quantity quantity) const {
    const auto found = values.find(idOf(quantity));
    return found == values.end() ? Text::tr("not recorded")
                                 : Text(shownNumber(quantity, *quantile(found->second, 0.5)));
  }
};

}  // namespace

std::optional<ReportTable> detorsionTable(const CohortInputs& in) {
  std::map<std::pair<std::size_t, std::string>, Untwistings> cells;
  std::int64_t trials = 0;
  for (const TrialSummaryRow& trial : in.trials) {
    if (!trial.detorsion.empty() && trial.model != kForeignModel) {
      cells[{trial.group, trial.phase.str()}].add(trial);
      ++trials;
    }
  }
  if (cells.empty()) {
    return std::nullopt;
  }
  ReportTable table;
  table.id = "table-untwistings";
  table.title = Text::tr("Untwistings by group and phase");
  table.columns = {Text::tr("Group"),
                   Text::tr("Phase"),
                   Text::tr("Runs"),
                   rowOf(Quantity::kUntwisted).name,
                   rowOf(Quantity::kRelapse).name,
                   rowOf(Quantity::kFirstDirection).name,
                   Text::tr("Tissue hurt"),
                   Text::tr("Blood came back"),
                   medianTitle(Quantity::kTimeToFlow),
                   medianTitle(Quantity::kDose),
                   Text::tr("Median re-grips beyond the least number"),
                   medianTitle(Quantity::kSlipBack)};
  for (const auto& [key, cell] : cells) {
    table.rows.push_back({in.groups[key.first].name, cell.phase, std::to_string(cell.trials),
                          cell.yes(Quantity::kUntwisted), cell.yes(Quantity::kRelapse),
                          cell.yes(Quantity::kFirstDirection), cell.yes(Quantity::kOverloadTime),
                          Text::tr("%1 of %2", cell.timesDefined(Quantity::kTimeToFlow), cell.trials),
                          cell.median(Quantity::kTimeToFlow), cell.median(Quantity::kDose),
                          cell.beyondLeast.empty()
                              ? Text::tr("not recorded")
                              : Text(shownNumber(Quantity::kRegrips, *quantile(cell.beyondLeast, 0.5), 1)),
                          cell.median(Quantity::kSlipBack)});
  }
  table.notes = {
      Text::tr(
          "An organ that came twisted is untwisted; there are no targets and no angle errors. Time is that "
          "of "
          "the hand; where blood did not come back, it is censored and not in the median. From an ischaemic "
          "dose of 1 on the organ is lost."),
      Text::tr("Tissue was injured because the jaw or the pull exceeded what it could bear at that moment.")};
  table.provenance.formula = Text::tr("medians over runs");
  table.provenance.n = trials;
  table.provenance.flags = commonFlags(in);
  return table;
}

}  // namespace torsio
