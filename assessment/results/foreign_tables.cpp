// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/foreign_tables.h"

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "assessment/catalogue/quantity.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "assessment/statistics/curve_fit.h"
#include "assessment/statistics/quantiles.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

/// Quantities that apply to foreign recordings.
constexpr std::array kForeignQuantities{Quantity::kTime, Quantity::kTipPath, Quantity::kIdleTime};

using Values = std::map<Quantity, std::vector<double>>;

void addValues(const TrialSummaryRow& trial, Values& values) {
  for (const Quantity quantity : kForeignQuantities) {
    const auto found = trial.detorsion.find(idOf(quantity));
    if (found != trial.detorsion.end()) {
      values[quantity].push_back(found->second);
    }
  }
}

ReportTable mediansTable(const CohortInputs& in, const std::vector<const TrialSummaryRow*>& trials) {
  struct Cell {
    Text phase;
    std::size_t trials = 0;
    Values values;
  };
  std::map<std::pair<std::size_t, std::string>, Cell> cells;
  for (const TrialSummaryRow* trial : trials) {
    Cell& cell = cells[{trial->group, trial->phase.str()}];
    cell.phase = trial->phase;
    ++cell.trials;
    addValues(*trial, cell.values);
  }
  ReportTable table =
      itemOf<ReportTable>(in, "table-foreign", Text::tr("Recordings of other equipment by group and phase"),
                          Text::tr("medians over runs"));
  table.columns = {Text::tr("Group"), Text::tr("Phase"), Text::tr("Runs")};
  for (const Quantity quantity : kForeignQuantities) {
    table.columns.push_back(medianTitle(quantity));
  }
  for (auto& [key, cell] : cells) {
    std::vector<ReportCell> row{in.groups[key.first].name, cell.phase, std::to_string(cell.trials)};
    for (const Quantity quantity : kForeignQuantities) {
      const std::vector<double>& values = cell.values[quantity];
      row.push_back(values.empty() ? Text(Text::tr("not defined"))
                                   : Text(shownNumber(quantity, *quantile(values, 0.5))));
    }
    table.rows.push_back(std::move(row));
  }
  table.notes = {Text::tr(
      "Force, torque and twist do not apply: no organ answered, and nothing can be computed again.")};
  table.provenance.n = std::ssize(trials);
  return table;
}

ReportTable foreignCourses(const CohortInputs& in, const std::vector<const TrialSummaryRow*>& trials) {
  std::map<std::pair<std::size_t, std::string>, Values> courses;  // by group and trainee
  for (const TrialSummaryRow* trial : trials) {
    addValues(*trial, courses[{trial->group, trial->trainee}]);
  }
  ReportTable table = itemOf<ReportTable>(in, "table-foreign-learning",
                                          Text::tr("Learning of every trainee on other equipment"),
                                          Text::tr("exponential learning curve"));
  table.individual = true;
  table.columns = {Text::tr("Group"), Text::tr("Trainee"), Text::tr("Measure"),        Text::tr("Runs"),
                   Text::tr("First"), Text::tr("Last"),    Text::tr("Left in the end")};
  for (auto& [key, values] : courses) {
    for (const Quantity quantity : kForeignQuantities) {
      const std::vector<double>& course = values[quantity];
      if (course.empty()) {
        continue;
      }
      std::vector<double> number;
      for (std::size_t i = 0; i < course.size(); ++i) {
        number.push_back(static_cast<double>(i + 1));
      }
      const Outcome<LearningCurve> fit = fitLearningCurve(LearningFamily::kExponential, number, course);
      table.rows.push_back({in.groups[key.first].name, key.second, titleWithUnit(quantity),
                            std::to_string(course.size()), shownNumber(quantity, course.front()),
                            shownNumber(quantity, course.back()),
                            fit ? Text(shownNumber(quantity, fit->asymptote))
                                : Text::tr("not fitted: %1", Text(fit.reason()))});
      table.provenance.n += std::ssize(course);
    }
  }
  table.notes = {
      Text::tr("Each trainee is fitted alone; eight runs are the fewest for a curve with three parameters.")};
  return table;
}

}  // namespace

std::vector<ReportTable> foreignTables(const CohortInputs& in) {
  std::vector<const TrialSummaryRow*> trials;
  for (const TrialSummaryRow& trial : in.trials) {
    if (trial.model == kForeignModel) {
      trials.push_back(&trial);
    }
  }
  if (trials.empty()) {
    return {};
  }
  return {mediansTable(in, trials), foreignCourses(in, trials)};
}

}  // namespace torsio
