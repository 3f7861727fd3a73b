// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/report/cohort_report.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "assessment/report/aggregated_inputs.h"
#include "assessment/report/cohort_csv.h"
#include "assessment/report/csv_rows.h"
#include "assessment/report/foreign_tables.h"
#include "assessment/report/number_format.h"
#include "assessment/report/record_sentences.h"
#include "assessment/report/report_sections.h"
#include "assessment/report/shown_inputs.h"
#include "assessment/report/study_analysis.h"
#include "sim/base/digest.h"
#include "sim/base/error.h"

namespace torsio {

namespace {

void checkInputs(const CohortInputs& in) {
  const auto refuse = [](Phrase what) {
    throw Error(ErrorCode::kBadData, what, Text::tr("cohort report"),
                Text::tr("Check the data that the report is made from."));
  };
  if (in.ratings.size() != in.evaluations.size() && !(in.unfinishedEvaluation && in.evaluations.empty())) {
    refuse(Text::tr("ratings and evaluations name different models"));
  }
  for (const ModelEvaluation& model : in.evaluations) {
    if (model.indices.size() != in.instrument.indices.size()) {
      refuse(Text::tr("an evaluation lacks an index"));
    }
  }
  if (!in.evaluations.empty() && in.chiefClass >= in.instrument.classes.size()) {
    refuse(Text::tr("the class of chief physicians does not exist"));
  }
  for (const CohortTrainee& trainee : in.trainees) {
    if (trainee.group >= in.groups.size()) {
      refuse(Text::tr("a trainee is in a group that does not exist"));
    }
  }
  for (const TraineeScore& score : in.scores) {
    if (score.group >= in.groups.size() || score.occasion >= in.occasions.size() || score.number == 0) {
      refuse(Text::tr("a score belongs to a group or an occasion that does not exist"));
    }
  }
  for (const GroupSummary& summary : in.summaries) {
    if (summary.group >= in.groups.size() || summary.occasion >= in.occasions.size()) {
      refuse(Text::tr("a summary belongs to a group or an occasion that does not exist"));
    }
  }
  for (const TrainingMark& mark : in.trainingMarks) {
    if (mark.group >= in.groups.size() || mark.occasion >= in.occasions.size()) {
      refuse(Text::tr("a mark belongs to a group or an occasion that does not exist"));
    }
  }
  for (const CriterionMark& mark : in.criterionMarks) {
    if (mark.group >= in.groups.size() || mark.occasion >= in.occasions.size() ||
        mark.sheet >= in.sheets.size() || mark.criterion >= in.sheets[mark.sheet].criteria.size()) {
      refuse(Text::tr("a mark of a criterion belongs to no group, occasion or scoring sheet"));
    }
  }
  for (const TrialSummaryRow& trial : in.trials) {
    if (trial.group >= in.groups.size()) {
      refuse(Text::tr("a run is in a group that does not exist"));
    }
  }
  for (const CohortCompetence& one : in.competence) {
    if (one.group >= in.groups.size() || !(one.limit > 0.0)) {
      refuse(Text::tr("a competence verdict is in a group that does not exist, or has no limit"));
    }
  }
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

Text meanOrDash(const std::vector<double>& values, int decimals) {
  return values.empty() ? Text::tr("not recorded") : Text(formatFixed(mean(values), decimals));
}

/// The mean of a group before the training; `all`: as it stands in the record.
Text meanBefore(const CohortInputs& in, const CohortInputs& all, std::size_t group) {
  const auto ofGroup = [&](const GroupSummary& summary) {
    return summary.group == group && summary.occasion == 0;
  };
  if (const auto shown = std::find_if(in.summaries.begin(), in.summaries.end(), ofGroup);
      shown != in.summaries.end()) {
    return formatFixed(shown->mean, 2);
  }
  return std::any_of(all.summaries.begin(), all.summaries.end(), ofGroup) ? Text::tr("not shown")
                                                                          : Text::tr("not recorded");
}

ReportTable groupsTable(const CohortInputs& in, const CohortInputs& all) {
  ReportTable table;
  table.id = "table-participants";
  table.title = Text::tr("Participants by group");
  table.columns = {Text::tr("Group"),  Text::tr("Protocol"), Text::tr("Trainees"),
                   Text::tr("By sex"), Text::tr("By level"), Text::tr("Mean score before")};
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    std::map<std::string, std::int64_t> sexes;
    std::map<std::string, std::int64_t> levels;
    std::int64_t n = 0;
    for (const CohortTrainee& trainee : in.trainees) {
      if (trainee.group != g) {
        continue;
      }
      ++n;
      ++sexes[trainee.sex];
      ++levels[trainee.level];
    }
    const auto counted = [&](const std::map<std::string, std::int64_t>& counts) {
      return countsText({counts.begin(), counts.end()}, in.identity);
    };
    table.rows.push_back({in.groups[g].name, in.groups[g].protocol, std::to_string(n), counted(sexes),
                          counted(levels), meanBefore(in, all, g)});
  }
  if (in.allocation.method.empty()) {
    table.notes = {
        Text::tr("How the groups were made is not in the record: they may differ from the start.")};
  } else if (in.allocation.movedByHand > 0) {
    table.notes = {
        Text::tr("No test of baseline differences is shown. %1 {trainee was|trainees were} moved by hand "
                 "after the draw: a difference need not be due to chance.",
                 in.allocation.movedByHand)};
  } else if (in.allocation.replayDiffers) {
    table.notes = {
        Text::tr("No test of baseline differences is shown. The draw could not be repeated from its seed: a "
                 "difference need not be due to chance.")};
  } else {
    table.notes = {Text::tr(
        "No test of baseline differences is shown: allocation was drawn, so any difference is due to "
        "chance.")};
  }
  table.provenance.formula = Text::tr("counts");
  table.provenance.n = std::ssize(in.trainees);
  table.provenance.flags = commonFlags(in);
  return table;
}

/// Who was scored is counted from all that is in the record, shown or not.
ReportTable flowTable(const CohortInputs& in, const CohortInputs& all) {
  ReportTable table;
  table.id = "table-flow";
  table.title = Text::tr("Flow of participants");
  table.columns = {Text::tr("Group"), Text::tr("Allocated"), Text::tr("Withdrew"), Text::tr("Recorded runs"),
                   Text::tr("Interrupted runs")};
  for (const Text& occasion : in.occasions) {
    table.columns.push_back(Text::tr("Scored %1", occasion));
  }
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    std::int64_t allocated = 0;
    std::int64_t withdrew = 0;
    std::int64_t trials = 0;
    std::int64_t interrupted = 0;
    for (const CohortTrainee& trainee : in.trainees) {
      allocated += trainee.group == g ? 1 : 0;
      withdrew += trainee.group == g && trainee.withdrew ? 1 : 0;
    }
    for (const TrialSummaryRow& trial : in.trials) {
      trials += trial.group == g ? 1 : 0;
      interrupted += trial.group == g && trial.interrupted ? 1 : 0;
    }
    std::vector<Text> row = {in.groups[g].name, std::to_string(allocated), std::to_string(withdrew),
                             std::to_string(trials), std::to_string(interrupted)};
    for (std::size_t t = 0; t < in.occasions.size(); ++t) {
      row.push_back(
          std::to_string(std::count_if(all.scores.begin(), all.scores.end(), [&](const TraineeScore& score) {
            return score.group == g && score.occasion == t;
          })));
    }
    table.rows.push_back(row);
  }
  table.provenance.formula = Text::tr("counts");
  table.provenance.n = std::ssize(in.trainees);
  table.provenance.flags = commonFlags(in);
  return table;
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
      continue;  // a table of their own: there are no twists
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
                   Text::tr("Twists"),
                   Text::tr("On target"),
                   Text::tr("Mean absolute angle error (deg)"),
                   Text::tr("Mean peak torque (N m)"),
                   Text::tr("Mean peak force (N)")};
  for (const auto& [key, sums] : cells) {
    table.rows.push_back({in.groups[key.first].name, sums.phase, std::to_string(sums.trials),
                          formatFixed(sums.minutes, 2), std::to_string(sums.twists),
                          std::to_string(sums.onTarget), meanOrDash(sums.errors, 2),
                          meanOrDash(sums.torques, 3), meanOrDash(sums.forces, 2)});
  }
  table.notes = {Text::tr(
      "Means are taken over runs. Measured by the simulator; the marks of the physicians are separate.")};
  table.provenance.formula = Text::tr("means over runs");
  table.provenance.n = n;
  table.provenance.flags = commonFlags(in);
  return table;
}

ReportTable pairsTable(const std::string& id, const Text& title, const Facts& pairs) {
  ReportTable table;
  table.id = id;
  table.title = title;
  table.columns = {Text::tr("Item"), Text::tr("Value")};
  for (const auto& [label, value] : pairs) {
    table.rows.push_back({label, value});
  }
  return table;
}

}  // namespace

std::vector<Text> commonFlags(const CohortInputs& in) {
  if (in.demonstration) {
    return {Text::tr("demonstration data")};
  }
  return {};
}

ReportSection participantsSection(const CohortInputs& in, const CohortInputs& all) {
  ReportSection section;
  section.title = Text::tr("Participants and allocation");
  const CohortAllocation& drawn = in.allocation;
  const Text enrolled = in.notAllocated > 0
                            ? Text::tr(
                                  "%1 {trainee was|trainees were} allocated to %2 {group|groups}; %3 more "
                                  "{was enrolled and is|were enrolled and are} in no group",
                                  in.trainees.size(), in.groups.size(), in.notAllocated)
                            : Text::tr("%1 {trainee was|trainees were} allocated to %2 {group|groups}",
                                       in.trainees.size(), in.groups.size());
  section.paragraphs.push_back(Text::tr("%1. Method: %2; generator: %3; seed: %4.", enrolled,
                                        drawn.method.empty() ? Text::tr("not recorded") : drawn.method,
                                        drawn.generator.empty() ? Text::tr("not recorded") : drawn.generator,
                                        drawn.sealed           ? Text::tr("sealed until the study ends")
                                        : drawn.method.empty() ? Text::tr("not recorded")
                                                               : Text(std::to_string(drawn.seed))));
  section.paragraphs.push_back(Text::verbatim("%1 %2", commitmentSentence(drawn), replaySentence(drawn)));
  section.tables = {groupsTable(in, all), flowTable(in, all)};
  if (!in.allocation.design.empty()) {
    section.tables.push_back(
        pairsTable("table-allocation", Text::tr("Design of the allocation"), in.allocation.design));
  }
  return section;
}

ReportSection deviationsSection(const CohortInputs& in) {
  ReportSection section;
  section.title = Text::tr("Deviations");
  if (in.deviations.empty()) {
    section.paragraphs.push_back(Text::tr("No deviation from the protocol was reported."));
    return section;
  }
  std::map<std::string, std::int64_t> kinds;
  for (const CohortDeviation& deviation : in.deviations) {
    ++kinds[deviation.kind];
  }
  section.paragraphs.push_back(
      Text::tr("%1 {deviation from the protocol was|deviations from the protocol were} reported: %2.",
               in.deviations.size(), countsText({kinds.begin(), kinds.end()}, in.identity)));
  ReportTable table;
  table.id = "table-deviations";
  table.title = Text::tr("Deviations from the protocol");
  table.individual = true;
  table.columns = {Text::tr("When"), Text::tr("Trainee"), Text::tr("Kind"), Text::tr("What happened")};
  for (const CohortDeviation& deviation : in.deviations) {
    table.rows.push_back({formatUtc(deviation.happenedUtc_us),
                          deviation.trainee.empty() ? Text::tr("whole cohort") : Text(deviation.trainee),
                          deviation.kind, deviation.description});
  }
  table.provenance.n = std::ssize(in.deviations);
  table.provenance.flags = commonFlags(in);
  section.tables.push_back(table);
  return section;
}

/// Name, meaning and time beside what was signed: 21 CFR 11.50.
ReportSection signaturesSection(const CohortInputs& in) {
  ReportSection section;
  section.title = Text::tr("Signatures of the marks");
  section.paragraphs.push_back(Text::tr("%1 marks were signed with the password of their rater, %2 were not.",
                                        in.signatures.size(), in.unsignedMarks));
  ReportTable table;
  table.id = "table-mark-signatures";
  table.title = Text::tr("Who signed which mark");
  table.individual = true;
  table.columns = {Text::tr("Signed by"), Text::tr("Trainee"), Text::tr("Occasion"), Text::tr("Version"),
                   Text::tr("Meaning"),   Text::tr("When"),    Text::tr("Why")};
  for (const CohortSignature& one : in.signatures) {
    table.rows.push_back({one.signer, one.trainee, one.occasion, std::to_string(one.version), one.meaning,
                          formatUtc(one.signedUtc_us),
                          in.singleMarks ? Text(one.reason) : Text()});  // a reason may tell the mark
  }
  table.provenance.n = std::ssize(in.signatures);
  table.provenance.flags = commonFlags(in);
  section.tables.push_back(table);
  return section;
}

ReportSection trialsSection(const CohortInputs& in) {
  ReportSection section;
  section.title = Text::tr("Recorded runs");
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

namespace {

void addCover(const CohortInputs& in, ReportModel& report) {
  report.title = in.title;
  report.subtitle = in.demonstration ? Text::tr("Demonstration with simulated people and marks")
                                     : Text::tr("Surgical twist skills");
  report.centre = in.centre;
  report.softwareVersion = in.softwareVersion;
  report.createdUtc_us = in.createdUtc_us;
  report.demonstration = in.demonstration;
  if (in.freeze) {
    report.facts = {
        {Text::tr("Frozen data set"), in.freeze->name},
        {Text::tr("Frozen"), Text::tr("%1 by %2", formatUtc(in.freeze->frozenUtc_us), in.freeze->frozenBy)},
        {Text::tr("Content hash"), in.freeze->contentHash.substr(0, 32)},
        {Text::tr("Since then"),
         in.freeze->unchanged ? Text::tr("unchanged")
                              : Text::tr("the record has changed, and the numbers are those of today; see "
                                         "Provenance")}};
  } else {
    report.facts = {{Text::tr("Data"), Text::tr("as they were when this report was made; not frozen")}};
  }
  const Text identity = in.identity == ReportIdentity::kNamed ? Text::tr("named trainees")
                        : in.identity == ReportIdentity::kCoded
                            ? Text::tr("coded")
                            : Text::tr("aggregated, no line about a single person");
  report.facts.insert(report.facts.end(),
                      {{Text::tr("People are shown"), identity},
                       {Text::tr("Trainees"), std::to_string(in.trainees.size())},
                       {Text::tr("Groups"), std::to_string(in.groups.size())},
                       {Text::tr("Recorded runs"), std::to_string(in.trials.size())},
                       {Text::tr("Evaluated models"), std::to_string(in.evaluations.size())}});
  report.facts.insert(report.facts.end(), in.facts.begin(), in.facts.end());
  if (!in.auditHead.empty()) {
    report.facts.emplace_back(Text::tr("Audit trail"), Text::tr("%1 {entry|entries} at %2", in.auditEntries,
                                                                formatUtc(in.createdUtc_us)));
    report.facts.emplace_back(Text::tr("Head of the audit trail"), in.auditHead);
  }
}

ReportModel reportOf(const CohortInputs& in, const CohortInputs& all,
                     const std::optional<StudyAnalysis>& study) {
  ReportModel report;
  addCover(in, report);
  if (study) {
    report.sections.push_back(boardSection(in, *study));
  }
  if (!in.simulated.empty()) {
    ReportSection section;
    section.title = Text::tr("What was simulated");
    section.paragraphs = in.simulated;
    report.sections.push_back(section);
  }
  if (!in.trainees.empty()) {
    report.sections.push_back(participantsSection(in, all));
  }
  if (!in.evaluations.empty() || in.unfinishedEvaluation) {
    report.sections.push_back(evaluationSection(in));
  }
  if (!in.scores.empty()) {
    report.sections.push_back(trainingSection(in));
  }
  if (!in.criterionMarks.empty()) {
    report.sections.push_back(criteriaSection(in));
  }
  if (study) {
    report.sections.push_back(analysisSection(in, *study));
    if (std::optional<ReportTable> within = withinGroupsTable(in, *study)) {
      report.sections.back().tables.push_back(std::move(*within));
    }
    report.sections.push_back(ratersSection(in, *study));
    for (ReportTable& table : reliabilityTables(in, *study)) {
      report.sections.back().tables.push_back(std::move(table));
    }
  }
  if (ReportSection learning = learningSection(in); !learning.tables.empty()) {
    report.sections.push_back(std::move(learning));
  }
  if (!in.competence.empty()) {
    report.sections.push_back(competenceSection(in));
  }
  if (!in.trials.empty()) {
    report.sections.push_back(trialsSection(in));
  }
  if (!in.trainees.empty()) {
    report.sections.push_back(deviationsSection(in));
  }
  if (!in.signatures.empty()) {
    report.sections.push_back(signaturesSection(in));
  }
  report.sections.push_back(methodsSection(in, study ? *study : StudyAnalysis{}));
  report.sections.push_back(provenanceSection(in));
  for (ReportSection& section : report.sections) {
    for (ReportFigure& figure : section.figures) {
      figure.valuesStand = Text::tr("The program shows them under Results.");
    }
  }
  return report;
}

/// What every page is known by: the length of the trail when it was made, and the hash of all its numbers.
void addReference(const CohortInputs& inputs, const std::vector<CohortCsvRow>& rows, ReportModel& report) {
  Digest digest;
  digest.update(cohortCsvText(rows));
  report.numbersHash = digest.hex();
  report.auditHead = inputs.auditHead;
  report.number = "R-" + std::to_string(inputs.auditEntries) + "-" + report.numbersHash.substr(0, 8);
  report.facts.emplace_back(Text::tr("Report"), report.number);
  report.facts.emplace_back(Text::tr("Hash of the table of numbers"), report.numbersHash);
}

}  // namespace

ReportModel cohortReport(const CohortInputs& inputs) {
  checkInputs(inputs);
  std::vector<Text> left;
  CohortInputs in = shownInputs(inputs, left);
  const bool aggregated = in.identity == ReportIdentity::kAggregated;
  if (aggregated) {
    in = withoutSmallGroups(in, left);
  }
  std::optional<StudyAnalysis> study;
  if (!in.trainingMarks.empty()) {
    study = analyseStudy(in);
  }
  std::vector<Text> unsaid;
  ReportModel report = reportOf(in, aggregated ? withoutSmallGroups(inputs, unsaid) : inputs, study);
  if (aggregated) {
    removeIndividuals(report);
    left.push_back(Text::tr(
        "This report is aggregated: it holds no line about a single person and no count of fewer than %1 "
        "people beside others.",
        kSmallestCell));
  }
  if (!left.empty()) {
    ReportSection section;
    section.title = Text::tr("What is left out");
    section.paragraphs = std::move(left);
    const bool board = !report.sections.empty() && report.sections.front().onFirstPage;
    report.sections.insert(report.sections.begin() + (board ? 1 : 0), std::move(section));
  }
  addReference(inputs, csvRowsOf(inputs, in, study), report);
  return report;
}

}  // namespace torsio
