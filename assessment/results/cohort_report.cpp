// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/cohort_report.h"

#include <algorithm>
#include <array>
#include <future>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "assessment/results/aggregated_inputs.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/cohort_csv.h"
#include "assessment/results/number_format.h"
#include "assessment/results/record_sentences.h"
#include "assessment/results/report_sections.h"
#include "assessment/results/shown_inputs.h"
#include "assessment/results/study_analysis.h"
#include "sim/core/digest.h"
#include "sim/core/error.h"

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

}  // namespace

std::vector<Text> commonFlags(const CohortInputs& in) {
  std::vector<Text> flags;
  if (in.demonstration) {
    flags.push_back(Text::tr("demonstration data"));
  }
  if (in.freeze && in.freeze->interim()) {
    flags.push_back(Text::tr("interim"));
  }
  if (in.imported) {
    flags.push_back(Text::tr("imported data"));
  }
  return flags;
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
  if (in.imported) {
    report.facts.emplace_back(Text::tr("Imported"), importSentence(*in.imported));
  }
  if (!in.auditHead.empty()) {
    report.facts.emplace_back(Text::tr("Audit trail"), Text::tr("%1 {entry|entries} at %2", in.auditEntries,
                                                                formatUtc(in.createdUtc_us)));
    report.facts.emplace_back(Text::tr("Checkpoint of the audit trail"), in.auditHead);
  }
}

ReportModel reportOf(const CohortInputs& in, const std::optional<StudyAnalysis>& study,
                     const Ledger& ledger) {
  ReportModel report;
  addCover(in, report);
  if (study) {
    report.sections.push_back(boardSection(in, *study, ledger));
  }
  if (!in.simulated.empty()) {
    ReportSection section{"simulated", Text::tr("What was simulated")};
    section.annex = true;
    section.paragraphs.assign(in.simulated.begin(), in.simulated.end());
    report.sections.push_back(section);
  }
  if (!in.trainees.empty()) {
    report.sections.push_back(participantsSection(in, ledger));
  }
  if (!in.evaluations.empty() || in.unfinishedEvaluation) {
    report.sections.push_back(evaluationSection(in, ledger));
  }
  if (!in.scores.empty()) {
    report.sections.push_back(trainingSection(in, ledger));
  }
  if (!in.criterionMarks.empty()) {
    report.sections.push_back(criteriaSection(in, ledger));
  }
  if (study) {
    report.sections.push_back(analysisSection(in, *study, ledger));
    if (std::optional<ReportTable> within = withinGroupsTable(in, *study, ledger)) {
      report.sections.back().tables.push_back(std::move(*within));
    }
    report.sections.push_back(ratersSection(in, *study, ledger));
    for (ReportTable& table : reliabilityTables(in, *study, ledger)) {
      report.sections.back().tables.push_back(std::move(table));
    }
  }
  if (ReportSection learning = learningSection(in, ledger); !learning.tables.empty()) {
    report.sections.push_back(std::move(learning));
  }
  if (!in.competence.empty()) {
    report.sections.push_back(competenceSection(in, ledger));
  }
  if (!in.trials.empty()) {
    report.sections.push_back(trialsSection(in, ledger));
  }
  if (!in.trainees.empty()) {
    report.sections.push_back(deviationsSection(in, ledger));
  }
  if (!in.signatures.empty()) {
    report.sections.push_back(signaturesSection(in, ledger));
  }
  report.sections.push_back(methodsSection(in, study ? *study : StudyAnalysis{}, ledger));
  report.sections.push_back(provenanceSection(in, ledger));
  if (!in.trainees.empty()) {
    report.sections.push_back(statementsSection(in));
    report.sections.push_back(checklistSection(in, report));
  }
  for (ReportSection& section : report.sections) {
    for (ReportFigure& figure : section.figures) {
      figure.valuesStand = Text::tr("The program shows them under Results.");
    }
  }
  return report;
}

/// Moves what only a reviewer looks up behind the report, in the order of its sections.
void moveToAnnex(ReportModel& report) {
  std::vector<ReportSection> annex;
  for (ReportSection& section : report.sections) {
    ReportSection rest{"annex-" + section.id, Text::tr("Annex: %1", section.title)};
    rest.annex = true;
    rest.startsPage = section.startsPage;
    const auto move = [](auto& from, auto& to) {
      const auto kept =
          std::stable_partition(from.begin(), from.end(), [](const auto& item) { return !item.annex; });
      to.assign(std::make_move_iterator(kept), std::make_move_iterator(from.end()));
      from.erase(kept, from.end());
    };
    move(section.figures, rest.figures);
    move(section.tables, rest.tables);
    if (section.annex) {
      rest.paragraphs = std::exchange(section.paragraphs, {});
    }
    if (!rest.paragraphs.empty() || !rest.figures.empty() || !rest.tables.empty()) {
      annex.push_back(std::move(rest));
    }
  }
  std::erase_if(report.sections, [](const ReportSection& section) {
    return section.paragraphs.empty() && section.figures.empty() && section.tables.empty();
  });
  report.sections.insert(report.sections.end(), std::make_move_iterator(annex.begin()),
                         std::make_move_iterator(annex.end()));
}

std::string hashOf(const Ledger& ledger) {
  Digest digest;
  digest.update(cohortCsvText(ledger));
  return digest.hex();
}

/// Adds the reference printed on every page: length of the audit trail at that time, and hash of all numbers.
void addReference(const CohortInputs& inputs, std::string numbersHash, ReportModel& report) {
  report.numbersHash = std::move(numbersHash);
  report.auditHead = inputs.auditHead;
  report.number = "R-" + std::to_string(inputs.auditEntries) + "-" + report.numbersHash.substr(0, 8);
  report.facts.emplace_back(Text::tr("Report"), report.number);
  report.facts.emplace_back(Text::tr("Hash of the table of numbers"), report.numbersHash);
}

}  // namespace

ReportModel cohortReport(const CohortInputs& inputs) {
  checkInputs(inputs);
  return cohortReport(inputs, analysedCohort(inputs));
}

ReportModel cohortReport(const CohortInputs& inputs, const AnalysedCohort& analysed) {
  checkInputs(inputs);
  const CohortInputs& in = analysed.shown;
  std::future<std::string> numbersHash =
      std::async(std::launch::async, [&analysed] { return hashOf(analysed.ledger); });
  std::vector<Text> left = analysed.left;
  const bool aggregated = in.identity == ReportIdentity::kAggregated;
  ReportModel report = reportOf(in, analysed.study, analysed.ledger);
  if (aggregated) {
    removeIndividuals(report);
    left.push_back(
        Text::tr("This report is aggregated: it contains no line about a single person and no count of fewer "
                 "than %1 people beside others.",
                 kSmallestCell));
  }
  if (!left.empty()) {
    ReportSection section{"left-out", Text::tr("What is left out")};
    section.paragraphs.assign(left.begin(), left.end());
    const bool board = !report.sections.empty() && report.sections.front().onFirstPage;
    report.sections.insert(report.sections.begin() + (board ? 1 : 0), std::move(section));
  }
  moveToAnnex(report);
  addReference(inputs, numbersHash.get(), report);
  return report;
}

}  // namespace torsio
