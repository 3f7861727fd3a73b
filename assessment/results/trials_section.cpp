// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/catalogue/quantity.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/foreign_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "assessment/statistics/descriptive.h"

namespace torsio {

namespace {

Text shownMean(Quantity quantity, const std::vector<double>& values) {
  return values.empty() ? Text::tr("not recorded") : Text(shownNumber(quantity, meanOf(values)));
}

ReportTable trialsByPhase(const CohortInputs& in) {
  struct Sums {
    Text phase;
    std::int64_t trials = 0;
    double minutes = 0.0;
    std::int64_t twists = 0;
    std::int64_t onTarget = 0;
    std::vector<double> errors;
    std::vector<double> torques;
    std::vector<double> forces;
  };
  std::int64_t n = 0;
  std::map<std::pair<std::size_t, std::string>, Sums> cells;
  for (const TrialSummaryRow& trial : in.trials) {
    if (!trial.detorsion.empty()) {
      continue;  // in a separate table, without twists
    }
    Sums& sums = cells[{trial.group, trial.phase.str()}];
    sums.phase = trial.phase;
    ++n;
    ++sums.trials;
    sums.minutes += trial.minutes;
    sums.twists += trial.twists;
    sums.onTarget += trial.twistsOnTarget;
    if (trial.meanAbsoluteError_deg) {
      sums.errors.push_back(*trial.meanAbsoluteError_deg);
    }
    if (trial.peakTorque_Nm) {
      sums.torques.push_back(*trial.peakTorque_Nm);
    }
    if (trial.peakForce_N) {
      sums.forces.push_back(*trial.peakForce_N);
    }
  }
  ReportTable table;
  table.id = "table-trials";
  table.title = Text::tr("Recorded runs by group and phase");
  table.columns = {Text::tr("Group"),
                   Text::tr("Phase"),
                   Text::tr("Runs"),
                   Text::tr("Minutes recorded"),
                   rowOf(Quantity::kCompletedTwists).name,
                   rowOf(Quantity::kTargetsReached).name,
                   Text::tr("Mean absolute angle error (deg)"),
                   meanTitle(Quantity::kPeakTorque),
                   meanTitle(Quantity::kPeakForce)};
  for (const auto& [key, sums] : cells) {
    table.rows.push_back(
        {in.groups[key.first].name, sums.phase, std::to_string(sums.trials), formatFixed(sums.minutes, 2),
         std::to_string(sums.twists), std::to_string(sums.onTarget),
         sums.errors.empty() ? Text::tr("not recorded") : Text(formatFixed(meanOf(sums.errors), 2)),
         shownMean(Quantity::kPeakTorque, sums.torques), shownMean(Quantity::kPeakForce, sums.forces)});
  }
  table.notes = {Text::tr(
      "Means are taken over runs. Measured by the simulator; the marks of the physicians are separate.")};
  table.provenance.formula = Text::tr("means over runs");
  table.provenance.n = n;
  table.provenance.flags = commonFlags(in);
  return table;
}

}  // namespace

ResultKey trialKey(const TrialSummaryRow& trial) {
  return {.section = ResultSection::kTrial,
          .of = trial.trainee,
          .group = trial.group,
          .model = trial.model,
          .when = trial.phase.str(),
          .record = trial.trialId.text()};
}

ReportSection trialsSection(const CohortInputs& in) {
  ReportSection section{"runs", Text::tr("Recorded runs")};
  double minutes = 0.0;
  std::int64_t refused = 0;
  std::int64_t late = 0;
  std::int64_t cuts = 0;
  std::int64_t busy = 0;
  std::int64_t samples = 0;
  for (const TrialSummaryRow& trial : in.trials) {
    minutes += trial.minutes;
    refused += trial.refusedSamples;
    late += trial.lateTicks;
    cuts += trial.forceCuts;
    busy += trial.forceCuts > 0 ? 1 : 0;
    samples += trial.samples;
  }
  section.paragraphs.push_back(
      Text::tr("%1 {run was|runs were} recorded, %2 {minute|minutes} and %3 {sample|samples} in all; samples "
               "not recorded: %4; late ticks: %5.",
               in.trials.size(), formatFixed(minutes, 1), samples, refused, late));
  if (cuts > 0) {
    section.paragraphs.push_back(
        Text::tr("The machine was too busy in runs: %1. Their force was cut for a moment, times in all: %2; "
                 "they are marked in the data.",
                 busy, cuts));
  }
  if (refused > 0) {
    section.paragraphs.push_back(
        Text::tr("Runs with samples that were not recorded are incomplete and marked in the data."));
  }
  if (ReportTable twists = trialsByPhase(in); !twists.rows.empty()) {
    section.tables.push_back(std::move(twists));
  }
  if (std::optional<ReportTable> untwistings = detorsionTable(in)) {
    section.tables.push_back(std::move(*untwistings));
  }
  for (ReportTable& table : foreignTables(in)) {
    section.tables.push_back(std::move(table));
  }
  return section;
}

}  // namespace torsio
