// SPDX-License-Identifier: GPL-3.0-or-later

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "assessment/catalogue/quantity.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

namespace {

ReportTable trialsByPhase(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table;
  table.id = "table-trials";
  table.title = Text::tr("Recorded runs by group and phase");
  ResultTable rows(ledger, table,
                   {{Text::tr("Group")},
                    {Text::tr("Phase")},
                    {Text::tr("Runs"), "runs"},
                    {Text::tr("Minutes recorded"), "minutes", fixed(1)},
                    {rowOf(Quantity::kCompletedTwists).name, "twists"},
                    {rowOf(Quantity::kTargetsReached).name, "twists_on_target"},
                    {Text::tr("Mean absolute angle error (deg)"), "mean_absolute_error_deg", fixed(2),
                     Text::tr("not recorded")},
                    {meanTitle(Quantity::kPeakTorque), "mean_peak_torque_Nm", shownAs(Quantity::kPeakTorque),
                     Text::tr("not recorded")},
                    {meanTitle(Quantity::kPeakForce), "mean_peak_force_N", shownAs(Quantity::kPeakForce),
                     Text::tr("not recorded")}});
  for (const auto& [group, place, runs] : runsByPhase(in, ledger, RunKind::kTwists)) {
    rows.row({in.groups[group].name, runs.front()->phase}, place);
  }
  table.provenance.n = ResultsAt(ledger, runsKey(RunKind::kTwists)).count("runs");
  table.notes = {Text::tr(
      "Means are taken over runs. Measured by the simulator; the marks of the physicians are separate.")};
  table.provenance.formula = Text::tr("means over runs");
  table.provenance.flags = commonFlags(in);
  return table;
}

}  // namespace

ResultKey trialKey(const Ledger& ledger, const TrialSummaryRow& trial) {
  return {.section = ResultSection::kTrial,
          .of = trial.trainee,
          .group = ledger.group(trial.group),
          .model = trial.model,
          .when = trial.phase.str(),
          .record = trial.trialId.text()};
}

ReportSection trialsSection(const CohortInputs& in, const Ledger& ledger) {
  ReportSection section{"runs", Text::tr("Recorded runs")};
  const ResultsAt at(ledger, wholeKey(kRecordings));
  const ReportCell runs = at("minutes", kValues);
  const ReportCell minutes = at("minutes", fixed(1));
  const ReportCell samples = at("samples");
  const ReportCell refused = at("refused_samples");
  const ReportCell late = at("late_ticks");
  const ReportCell cuts = at("force_cuts");
  const ReportCell busy = at("runs_with_force_cuts");
  section.paragraphs.push_back(
      {Text::tr(
           "%1 {run was|runs were} recorded, %2 {minute|minutes} and %3 {sample|samples} in all; samples "
           "not recorded: %4; late ticks: %5.",
           runs.words(), minutes.words(), samples.words(), refused.words(), late.words()),
       {runs, minutes, samples, refused, late}});
  if (at.number("force_cuts").value_or(0.0) > 0.0) {
    section.paragraphs.push_back(
        {Text::tr("The machine was too busy in runs: %1. Their force was cut for a moment, times in all: %2; "
                  "they are marked in the data.",
                  busy.words(), cuts.words()),
         {busy, cuts}});
  }
  if (at.number("refused_samples").value_or(0.0) > 0.0) {
    section.paragraphs.push_back(
        Text::tr("Runs with samples that were not recorded are incomplete and marked in the data."));
  }
  if (ReportTable twists = trialsByPhase(in, ledger); !twists.rows.empty()) {
    section.tables.push_back(std::move(twists));
  }
  if (std::optional<ReportTable> untwistings = detorsionTable(in, ledger)) {
    section.tables.push_back(std::move(*untwistings));
  }
  for (ReportTable& table : foreignTables(in, ledger)) {
    section.tables.push_back(std::move(table));
  }
  return section;
}

namespace {

/// Formats in how many runs a quantity is above zero, of `n` or of those that have it.
ReportCell yes(const ResultsAt& at, Quantity quantity, const std::optional<ReportCell>& n = std::nullopt) {
  const std::string statistic = "above_zero_" + idOf(quantity);
  ReportCell cell = at(statistic, {}, Text::tr("not recorded"));
  if (cell.key != nullptr) {
    static_cast<Text&>(cell) = Text::tr("%1 of %2", cell.words(), (n ? *n : at(statistic, kValues)).words());
  }
  return cell;
}

ReportCell median(const ResultsAt& at, Quantity quantity) {
  return at("median_" + idOf(quantity), shownAs(quantity), Text::tr("not recorded"));
}

}  // namespace

std::optional<ReportTable> detorsionTable(const CohortInputs& in, const Ledger& ledger) {
  const std::vector<PhaseRuns> phases = runsByPhase(in, ledger, RunKind::kUntwisting);
  if (phases.empty()) {
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
  for (const PhaseRuns& phase : phases) {
    const ResultsAt at(ledger, phase.place);
    const ReportCell runs = at("measured_runs");
    ReportCell blood = yes(at, Quantity::kTimeToFlow, runs);
    if (blood.key == nullptr) {
      blood = {Text::tr("%1 of %2", 0, runs.words()), runs.key};
    }
    table.rows.push_back({in.groups[phase.group].name, phase.runs.front()->phase, runs,
                          yes(at, Quantity::kUntwisted), yes(at, Quantity::kRelapse),
                          yes(at, Quantity::kFirstDirection), yes(at, Quantity::kOverloadTime), blood,
                          median(at, Quantity::kTimeToFlow), median(at, Quantity::kDose),
                          at(std::string("median_") + kRegripsBeyondLeast, shownAs(Quantity::kRegrips, 1),
                             Text::tr("not recorded")),
                          median(at, Quantity::kSlipBack)});
  }
  table.notes = {
      Text::tr(
          "An organ that came twisted is untwisted; there are no targets and no angle errors. Time is that "
          "of "
          "the hand; where blood did not come back, it is censored and not in the median. From an ischaemic "
          "dose of 1 on the organ is lost."),
      Text::tr("Tissue hurt: the jaw or the pull exceeded what the tissue could bear at that moment.")};
  table.provenance.formula = Text::tr("medians over runs");
  table.provenance.n = ResultsAt(ledger, runsKey(RunKind::kUntwisting)).count("measured_runs");
  table.provenance.flags = commonFlags(in);
  return table;
}

namespace {

ReportTable mediansTable(const CohortInputs& in, const Ledger& ledger, const std::vector<PhaseRuns>& phases) {
  ReportTable table =
      itemOf<ReportTable>(in, "table-foreign", Text::tr("Recordings of other equipment by group and phase"),
                          Text::tr("medians over runs"));
  std::vector<ResultColumn> columns{
      {Text::tr("Group")}, {Text::tr("Phase")}, {Text::tr("Runs"), "measured_runs"}};
  for (const Quantity quantity : kForeignQuantities) {
    columns.push_back({medianTitle(quantity), "median_" + idOf(quantity), shownAs(quantity)});
  }
  columns.push_back(
      {Text::tr("Runs with the instrument out of view"), "above_zero_" + idOf(Quantity::kTimesUnseen)});
  columns.push_back({titleWithUnit(Quantity::kUnseen), kTimeOutOfView, shownAs(Quantity::kUnseen)});
  columns.push_back(
      {titleWithUnit(Quantity::kUnseenShare), kShareOutOfView, shownAs(Quantity::kUnseenShare)});
  ResultTable rows(ledger, table, std::move(columns));
  for (const auto& [group, place, runs] : phases) {
    rows.row({in.groups[group].name, runs.front()->phase}, place);
  }
  table.provenance.n = ResultsAt(ledger, runsKey(RunKind::kForeign)).count("measured_runs");
  table.notes = {
      Text::tr("Force, torque and twist do not apply: no organ answered, and nothing can be computed again."),
      Text::tr(
          "The time out of view is that of all runs. Path and idle time leave it out; a run that was out "
          "of view for more than 5 % of its time has neither.")};
  return table;
}

ReportTable foreignCourses(const CohortInputs& in, const Ledger& ledger,
                           const std::set<std::pair<std::size_t, std::string>>& trainees) {
  ReportTable table = itemOf<ReportTable>(in, "table-foreign-learning",
                                          Text::tr("Learning of every trainee on other equipment"),
                                          Text::tr("exponential learning curve"));
  table.annex = true;
  table.individual = true;
  table.columns = {Text::tr("Group"), Text::tr("Trainee"), Text::tr("Measure"),        Text::tr("Runs"),
                   Text::tr("First"), Text::tr("Last"),    Text::tr("Left in the end")};
  for (const auto& [group, trainee] : trainees) {
    for (const Quantity quantity : kForeignQuantities) {
      const ResultsAt at(ledger, foreignKey(ledger, trainee, group, idOf(quantity)));
      if (at.find("runs") == nullptr) {
        continue;
      }
      const Format format = shownAs(quantity);
      ReportCell left = at("left_in_the_end", format);
      if (const auto* none = std::get_if<Undefined>(&at.find("left_in_the_end")->value)) {
        static_cast<Text&>(left) = Text::tr("not fitted: %1", none->reason);
      }
      table.rows.push_back({in.groups[group].name, trainee, titleWithUnit(quantity), at("runs"),
                            at("first", format), at("last", format), std::move(left)});
    }
  }
  table.provenance.n = ResultsAt(ledger, runsKey(RunKind::kForeign)).count("measured_runs");
  table.notes = {
      Text::tr("Each trainee is fitted alone; eight runs are the fewest for a curve with three parameters.")};
  return table;
}

}  // namespace

std::vector<ReportTable> foreignTables(const CohortInputs& in, const Ledger& ledger) {
  const std::vector<PhaseRuns> phases = runsByPhase(in, ledger, RunKind::kForeign);
  std::set<std::pair<std::size_t, std::string>> trainees;
  for (const PhaseRuns& phase : phases) {
    for (const TrialSummaryRow* trial : phase.runs) {
      trainees.insert({phase.group, trial->trainee});
    }
  }
  if (phases.empty()) {
    return {};
  }
  return {mediansTable(in, ledger, phases), foreignCourses(in, ledger, trainees)};
}

}  // namespace torsio
