// SPDX-License-Identifier: GPL-3.0-or-later

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/results/aggregated_inputs.h"
#include "assessment/results/analysis_tables.h"
#include "assessment/results/number_format.h"
#include "assessment/results/record_sentences.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"

namespace torsio {

namespace {

ReportTable groupsTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table;
  table.id = "table-participants";
  table.title = Text::tr("Participants by group");
  ResultTable rows(ledger, table,
                   {{Text::tr("Group")},
                    {Text::tr("Protocol")},
                    {Text::tr("Trainees"), "allocated"},
                    {Text::tr("By sex"), "by_sex", {}, ""},
                    {Text::tr("By level"), "by_level", {}, ""},
                    {Text::tr("Mean score before")}});
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const bool scored = ResultsAt(ledger, {.section = ResultSection::kParticipants,
                                           .group = ledger.group(g),
                                           .occasion = ledger.occasion(0)})
                            .number("scored")
                            .value_or(0.0) > 0.0;
    const ResultsAt before(ledger, {.group = ledger.group(g), .occasion = ledger.occasion(0)});
    rows.row({in.groups[g].name, in.groups[g].protocol,
              before("mean", fixed(2), scored ? Text::tr("not shown") : Text::tr("not recorded"))},
             {.section = ResultSection::kParticipants, .group = ledger.group(g)});
  }
  if (in.allocation.method.empty()) {
    table.notes = {
        Text::tr("How the groups were made is not in the record: they may differ from the start.")};
  } else if (in.allocation.movedByHand > 0) {
    const ReportCell moved = ResultsAt(ledger, {.section = ResultSection::kParticipants})("moved_by_hand");
    table.notes = {
        {Text::tr("No test of baseline differences is shown. %1 {trainee was|trainees were} moved by hand "
                  "after the draw: a difference need not be due to chance.",
                  moved.words()),
         {moved}}};
  } else if (in.allocation.replayDiffers) {
    table.notes = {
        Text::tr("No test of baseline differences is shown. The draw could not be repeated from its seed: a "
                 "difference need not be due to chance.")};
  } else if (!in.allocation.replayed) {
    table.notes = {
        Text::tr("No test of baseline differences is shown. The draw has not been repeated from its seed: "
                 "nothing here shows that a difference is due to chance.")};
  } else {
    table.notes = {Text::tr(
        "No test of baseline differences is shown: allocation was drawn, so any difference is due to "
        "chance.")};
  }
  table.provenance.formula = Text::tr("counts");
  table.provenance.n = ResultsAt(ledger, {.section = ResultSection::kParticipants}).count("trainees");
  table.provenance.flags = commonFlags(in);
  return table;
}

/// Counts who was scored over the whole record, whether shown or not.
ReportTable flowTable(const CohortInputs& in, const Ledger& ledger) {
  ReportTable table;
  table.id = "table-flow";
  table.title = Text::tr("Flow of participants");
  std::vector<ResultColumn> columns{{Text::tr("Group")},
                                    {Text::tr("Allocated"), "allocated"},
                                    {Text::tr("Withdrew"), "withdrew"},
                                    {Text::tr("Recorded runs"), "runs"},
                                    {Text::tr("Interrupted runs"), "runs_interrupted"}};
  for (const Text& occasion : in.occasions) {
    columns.push_back({Text::tr("Scored %1", occasion)});
  }
  ResultTable rows(ledger, table, std::move(columns));
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    std::vector<ReportCell> labels{in.groups[g].name};
    for (std::size_t t = 0; t < in.occasions.size(); ++t) {
      labels.push_back(ResultsAt(ledger, {.section = ResultSection::kParticipants,
                                          .group = ledger.group(g),
                                          .occasion = ledger.occasion(t)})("scored"));
    }
    rows.row(labels, {.section = ResultSection::kParticipants, .group = ledger.group(g)});
  }
  table.provenance.formula = Text::tr("counts");
  table.provenance.n = ResultsAt(ledger, {.section = ResultSection::kParticipants}).count("trainees");
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

ReportSection participantsSection(const CohortInputs& in, const Ledger& ledger) {
  ReportSection section{"participants", Text::tr("Participants and allocation")};
  const CohortAllocation& drawn = in.allocation;
  const ResultsAt at(ledger, {.section = ResultSection::kParticipants});
  const ReportCell trainees = at("trainees");
  const ReportCell groups = at("groups");
  const ReportCell more = at("not_allocated");
  const Text enrolled = in.notAllocated > 0
                            ? Text::tr(
                                  "%1 {trainee was|trainees were} allocated to %2 {group|groups}; %3 more "
                                  "{was enrolled and is|were enrolled and are} in no group",
                                  trainees.words(), groups.words(), more.words())
                            : Text::tr("%1 {trainee was|trainees were} allocated to %2 {group|groups}",
                                       trainees.words(), groups.words());
  const ReportCell seed = at("seed");
  section.paragraphs.push_back({Text::tr("%1. Method: %2; generator: %3; seed: %4.", enrolled,
                                         drawn.method.empty() ? Text::tr("not recorded") : drawn.method,
                                         drawn.generator.empty() ? Text::tr("not recorded") : drawn.generator,
                                         drawn.sealed           ? Text::tr("sealed until the study ends")
                                         : drawn.method.empty() ? Text::tr("not recorded")
                                                                : seed.words()),
                                {trainees, groups, more, seed}});
  ReportParagraph commitment = commitmentSentence(drawn, ledger);
  static_cast<Text&>(commitment) = Text::verbatim("%1 %2", commitment.words(), replaySentence(drawn));
  section.paragraphs.push_back(std::move(commitment));
  section.tables = {groupsTable(in, ledger), flowTable(in, ledger)};
  if (std::optional<ReportTable> centres = siteFlowTable(in, ledger)) {
    section.tables.push_back(std::move(*centres));
  }
  if (!in.allocation.design.empty()) {
    section.tables.push_back(
        pairsTable("table-allocation", Text::tr("Design of the allocation"), in.allocation.design));
    section.tables.back().annex = true;
  }
  return section;
}

ResultKey deviationKey(const CohortInputs& in, std::size_t number) {
  const CohortDeviation& deviation = in.deviations[number];
  return {.section = ResultSection::kDeviation,
          .statistic = deviation.kind,
          .of = deviation.trainee,
          .when = formatUtc(deviation.happenedUtc_us),
          .record = std::to_string(number)};
}

ReportSection deviationsSection(const CohortInputs& in, const Ledger& ledger) {
  ReportSection section{"deviations", Text::tr("Deviations")};
  if (in.deviations.empty()) {
    section.paragraphs.push_back(Text::tr("No deviation from the protocol was reported."));
    return section;
  }
  const ResultsAt at(ledger, {.section = ResultSection::kParticipants});
  const ReportCell reported = at("deviations");
  const ReportCell kinds = at("deviations_by_kind");
  section.paragraphs.push_back(
      {Text::tr("%1 {deviation from the protocol was|deviations from the protocol were} reported: %2.",
                reported.words(), kinds.words()),
       {reported, kinds}});
  ReportTable table;
  table.id = "table-deviations";
  table.annex = true;
  table.title = Text::tr("Deviations from the protocol");
  table.individual = true;
  table.columns = {Text::tr("When"), Text::tr("Trainee"), Text::tr("Kind"), Text::tr("What happened")};
  for (std::size_t i = 0; i < in.deviations.size(); ++i) {
    const CohortDeviation& deviation = in.deviations[i];
    const ResultKey key = deviationKey(in, i);
    table.rows.push_back({{formatUtc(deviation.happenedUtc_us), key},
                          deviation.trainee.empty() ? Text::tr("whole cohort") : Text(deviation.trainee),
                          deviation.kind,
                          {deviation.description, key}});
  }
  table.provenance.n = reported;
  table.provenance.flags = commonFlags(in);
  section.tables.push_back(table);
  return section;
}

/// Name, meaning and time with the signed object, as required by 21 CFR 11.50.
ReportSection signaturesSection(const CohortInputs& in, const Ledger& ledger) {
  ReportSection section{"signatures", Text::tr("Signatures of the marks")};
  const ResultsAt at(ledger, wholeKey(kTrainingMarks));
  const ReportCell with = at("signed");
  const ReportCell without = at("not_signed");
  section.paragraphs.push_back(
      {Text::tr("%1 {mark was|marks were} signed with the password of their rater, %2 {was|were} not.",
                with.words(), without.words()),
       {with, without}});
  ReportTable table;
  table.id = "table-mark-signatures";
  table.annex = true;
  table.title = Text::tr("Who signed which mark");
  table.individual = true;
  table.columns = {Text::tr("Signed by"), Text::tr("Trainee"), Text::tr("Occasion"), Text::tr("Version"),
                   Text::tr("Meaning"),   Text::tr("When"),    Text::tr("Why")};
  for (const CohortSignature& one : in.signatures) {
    table.rows.push_back({one.signer, one.trainee, one.occasion, std::to_string(one.version), one.meaning,
                          formatUtc(one.signedUtc_us),
                          in.singleMarks ? Text(one.reason) : Text()});  // a reason may reveal the mark
  }
  table.provenance.n = with;
  table.provenance.flags = commonFlags(in);
  section.tables.push_back(table);
  return section;
}

}  // namespace torsio
