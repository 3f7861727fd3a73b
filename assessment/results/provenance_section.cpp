// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "assessment/results/analysed_cohort.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "sim/core/digest.h"

namespace torsio {

namespace {

constexpr std::size_t kPrintedDigits = 16;

ReportTable versionsTable(const CohortInputs& in) {
  ReportTable table;
  table.id = "table-provenance";
  table.annex = true;
  table.title = Text::tr("Where the numbers come from");
  const Text generator =
      in.allocation.version.empty() ? Text(Text::tr("generator not recorded")) : Text(in.allocation.version);
  table.columns = {Text::tr("Item"), Text::tr("Value")};
  table.rows = {
      {Text::tr("Software"), in.softwareVersion},
      {Text::tr("Evaluation formulas"), std::string(kEvaluationFormulaVersion)},
      {Text::tr("Training formulas"), std::string(kTrainingFormulaVersion)},
      {Text::tr("Allocation"), in.allocation.method.empty() ? Text::tr("not recorded")
                               : in.allocation.sealed
                                   ? Text::tr("%1, seed sealed", generator)
                                   : Text::tr("%1, seed %2", generator, in.allocation.seed)},
      {Text::tr("Allocation commitment"),
       in.allocation.commitment.empty() ? Text::tr("not recorded") : Text(in.allocation.commitment)}};
  if (!in.programHash.empty()) {
    table.rows.insert(table.rows.begin() + 1, {Text::tr("Program file (BLAKE2b)"), in.programHash});
  }
  for (const ReportedSheet& sheet : in.sheets) {
    table.rows.push_back(
        {Text::tr("Scoring sheet"), Text::tr("%1, revision %2", sheet.name, sheet.revision)});
  }
  if (in.freeze) {
    table.rows.push_back({Text::tr("Frozen data set"), in.freeze->name});
    table.rows.push_back({Text::tr("Frozen data set, content hash"), in.freeze->contentHash});
    table.rows.push_back({Text::tr("Record compared with it"),
                          in.freeze->unchanged ? Text::tr("unchanged") : Text::tr("changed since then")});
  }
  for (const auto& [label, value] : in.provenance) {
    table.rows.push_back({label, value});
  }
  return table;
}

/// Lists the marks and recordings behind the parts of the report.
ReportTable sourcesTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table;
  table.id = "table-sources";
  table.annex = true;
  table.title = Text::tr("What each part is computed from");
  table.columns = {Text::tr("Part of the report"), Text::tr("Source"), Text::tr("Count"),
                   Text::tr("Hash of the source")};
  const auto add = [&](const Text& part, const Text& source, const char* of) {
    const ResultsAt at(ledger, {.section = ResultSection::kRecord, .of = of});
    if (at.number("count")) {
      ReportCell hash = at("blake2b");
      static_cast<Text&>(hash) = hash.str().substr(0, kPrintedDigits);
      table.rows.push_back({part, source, at("count"), std::move(hash)});
    }
  };
  add(Text::tr("Evaluation of the models"), Text::tr("submitted marks of the campaign"), kEvaluationMarks);
  add(Text::tr("Training study; Agreement and comparisons; Raters"),
      Text::tr("submitted marks of the occasions"), kTrainingMarks);
  add(Text::tr("Learning; Recorded runs"), Text::tr("recordings, listed below"), kRecordings);
  if (!in.trials.empty()) {
    const ResultsAt at(ledger, wholeKey(kRecordings));
    const ReportCell open = at("runs_without_hash");
    if (at.number("runs_without_hash").value_or(0.0) > 0.0) {
      table.notes.push_back(
          {Text::tr("%1 {recording has|recordings have} no content hash: nothing shows that "
                    "{it is|they are} unchanged.",
                    open.words()),
           {open}});
    } else {
      table.notes.push_back(
          Text::tr("Every recording is sealed in the record by its content hash; it can be replayed and "
                   "compared bit for bit (torsio replay RUN --verify)."));
    }
  }
  if (in.notAssessable > 0) {
    const ReportCell refused = ResultsAt(ledger, wholeKey(kTrainingMarks))("not_assessable");
    table.notes.push_back(
        {Text::tr("%1 {mark could not be given and carries a reason; it counts|marks could not be given and "
                  "carry a reason; they count} as missing.",
                  refused.words()),
         {refused}});
  }
  table.provenance.flags = commonFlags(in);
  return table;
}

/// Lists the marks and recordings behind each trainee's score.
ReportTable chainTable(const CohortInputs& in, const Ledger& ledger) {
  std::map<std::string, std::string> chains;  // recordings by trainee
  for (const TrainingMark& mark : in.trainingMarks) {
    chains[mark.trainee];
  }
  for (const TrialSummaryRow& trial : in.trials) {
    std::string& trials = chains[trial.trainee];
    trials += (trials.empty() ? "" : ", ") + trial.trialId.text().substr(0, 8);
  }
  ReportTable table;
  table.id = "table-chain";
  table.annex = true;
  table.title = Text::tr("From every trainee's scores back to marks and recordings");
  table.individual = true;
  table.columns = {Text::tr("Trainee"), Text::tr("Marks behind the scores"),
                   Text::tr("Recordings (first eight digits of the run)")};
  for (const auto& [trainee, trials] : chains) {
    const ResultsAt at(ledger, {.of = trainee});
    table.rows.push_back({trainee, at("marks", {}, Text(std::to_string(0))),
                          trials.empty() ? Text::tr("none on the simulator") : Text(trials)});
  }
  table.provenance.flags = commonFlags(in);
  return table;
}

ReportTable trialsTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table;
  table.id = "table-trial-hashes";
  table.annex = true;
  table.title = Text::tr("Recorded runs");
  table.individual = true;
  table.columns = {Text::tr("Run"),     Text::tr("Trainee"), Text::tr("Phase"),       Text::tr("Model"),
                   Text::tr("Minutes"), Text::tr("Outcome"), Text::tr("Content hash")};
  for (const TrialSummaryRow& trial : in.trials) {
    const ResultsAt at(ledger, trialKey(ledger, trial));
    table.rows.push_back({{trial.trialId, at("trial").key},
                          trial.trainee,
                          trial.phase,
                          trial.model,
                          at("minutes", fixed(1)),
                          at("outcome"),
                          {trial.contentHash.substr(0, kPrintedDigits), at("content_hash").key}});
  }
  table.notes = {Text::tr(
      "The first 16 digits of each content hash; the whole hashes are in the table of numbers (CSV).")};
  table.provenance.n = ResultsAt(ledger, wholeKey(kRecordings)).count("minutes", kValues);
  table.provenance.flags = commonFlags(in);
  return table;
}

}  // namespace

MarksHash hashOfTrainingMarks(const CohortInputs& in) {
  Digest digest;
  for (const TrainingMark& mark : in.trainingMarks) {
    digest.update(mark.trainee);
    digest.update(mark.rater);
    digest.update(static_cast<std::int64_t>(mark.occasion));
    digest.update(mark.steps);
  }
  return {std::ssize(in.trainingMarks), digest.hex()};
}

MarksHash hashOfEvaluationMarks(const CohortInputs& in) {
  MarksHash out;
  Digest digest;
  for (const ModelRatings& model : in.ratings) {
    for (const RaterSheet& sheet : model.sheets) {
      digest.update(model.model);
      digest.update(sheet.rater);
      for (const std::optional<std::int64_t>& steps : sheet.steps) {
        digest.update(steps.value_or(-1));
        out.count += steps ? 1 : 0;
      }
    }
  }
  out.hash = digest.hex();
  return out;
}

MarksHash hashOfTrials(const CohortInputs& in) {
  Digest digest;
  for (const TrialSummaryRow& trial : in.trials) {
    digest.update(trial.trialId.text());
    digest.update(trial.contentHash);
  }
  return {std::ssize(in.trials), digest.hex()};
}

ReportSection provenanceSection(const CohortInputs& in, const Ledger& ledger) {
  ReportSection section{"provenance", Text::tr("Provenance")};
  section.tables = {versionsTable(in)};
  if (ReportTable sources = sourcesTable(in, ledger); !sources.rows.empty()) {
    section.tables.push_back(std::move(sources));
  }
  if (ReportTable chain = chainTable(in, ledger); !chain.rows.empty()) {
    section.tables.push_back(std::move(chain));
  }
  if (!in.trials.empty()) {
    section.tables.push_back(trialsTable(in, ledger));
  }
  return section;
}

}  // namespace torsio
