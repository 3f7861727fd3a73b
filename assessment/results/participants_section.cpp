// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "assessment/results/aggregated_inputs.h"
#include "assessment/results/number_format.h"
#include "assessment/results/record_sentences.h"
#include "assessment/results/report_sections.h"

namespace torsio {

namespace {

/// Returns a group's mean before the training; `all`: including what is not shown.
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

/// Counts who was scored over the whole record, whether shown or not.
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
    std::vector<ReportCell> row = {in.groups[g].name, std::to_string(allocated), std::to_string(withdrew),
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

ReportSection participantsSection(const CohortInputs& in, const CohortInputs& all) {
  ReportSection section{"participants", Text::tr("Participants and allocation")};
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

}  // namespace torsio
