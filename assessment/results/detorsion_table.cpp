// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/results/number_format.h"
#include "assessment/results/report_sections.h"
#include "assessment/statistics/quantiles.h"
#include "sim/core/angle.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

/// Untwistings of one group in one phase.
struct Untwistings {
  Text phase;
  std::int64_t trials = 0;
  std::int64_t bloodBack = 0;
  std::map<std::string, std::vector<double>> values;  // by metric id, for trials in which it is defined

  void add(const TrialSummaryRow& trial) {
    phase = trial.phase;
    ++trials;
    for (const auto& [id, value] : trial.detorsion) {
      values[id].push_back(value);
    }
    bloodBack += trial.detorsion.contains("detorse.time_to_flow") ? 1 : 0;
    const auto regrips = trial.detorsion.find("detorse.regrips");
    const auto least = trial.detorsion.find("detorse.least_regrips");
    if (regrips != trial.detorsion.end() && least != trial.detorsion.end()) {
      values["beyond the least"].push_back(regrips->second - least->second);
    }
  }
  /// Formats in how many trials a yes/no metric was yes, of those that have it.
  [[nodiscard]] Text yes(const std::string& id) const {
    const auto found = values.find(id);
    if (found == values.end()) {
      return Text::tr("not recorded");
    }
    std::int64_t count = 0;
    for (const double value : found->second) {
      count += value > 0.0 ? 1 : 0;
    }
    return Text::tr("%1 of %2", count, found->second.size());
  }
  [[nodiscard]] Text median(const std::string& id, double scale, int decimals) const {
    const auto found = values.find(id);
    return found == values.end() ? Text::tr("not recorded")
                                 : Text(formatFixed(scale * *quantile(found->second, 0.5), decimals));
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
                   Text::tr("Untwisted"),
                   Text::tr("Relapsed"),
                   Text::tr("First turn the right way"),
                   Text::tr("Tissue hurt"),
                   Text::tr("Blood came back"),
                   Text::tr("Median time until then (s)"),
                   Text::tr("Median ischaemic dose"),
                   Text::tr("Median re-grips beyond the least number"),
                   Text::tr("Median slip back (deg)")};
  for (const auto& [key, cell] : cells) {
    table.rows.push_back(
        {in.groups[key.first].name, cell.phase, std::to_string(cell.trials), cell.yes("detorse.done"),
         cell.yes("detorse.relapse"), cell.yes("detorse.first_direction"), cell.yes("detorse.overload_time"),
         Text::tr("%1 of %2", cell.bloodBack, cell.trials), cell.median("detorse.time_to_flow", 1.0, 1),
         cell.median("detorse.dose", 1.0, 2), cell.median("beyond the least", 1.0, 1),
         cell.median("detorse.slip_back", kDegreesPerRadian, 1)});
  }
  table.notes = {
      Text::tr(
          "An organ that came twisted is untwisted; there are no targets and no angle errors. Time is that "
          "of "
          "the hand; where blood did not come back, it is censored and not in the median. From an ischaemic "
          "dose of 1 on the organ is lost."),
      Text::tr("Tissue was hurt where jaw or pull went beyond what it then bore.")};
  table.provenance.formula = Text::tr("medians over runs");
  table.provenance.n = trials;
  table.provenance.flags = commonFlags(in);
  return table;
}

}  // namespace torsio
