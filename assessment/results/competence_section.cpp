// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "assessment/results/analysed_cohort.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

template <typename Item>
Item competenceItem(const CohortInputs& in, const Ledger& ledger, const std::string& id, const Text& title) {
  Item item = itemOf<Item>(in, id, title, Text::tr("LC-CUSUM, Biau and Porcher 2010"));
  item.provenance.n = ResultsAt(ledger, {.section = ResultSection::kCompetence}).count("runs_judged");
  return item;
}

/// Describes each design in use with its error rates, once for all exercises and numbers of attempts it
/// applies to.
std::vector<Text> designSentences(const CohortInputs& in) {
  struct Said {
    Text design;
    Text errors;
    std::vector<Text> exercises;
  };
  std::vector<Said> all;
  for (const CohortCompetence& one : in.competence) {
    auto said = std::find_if(all.begin(), all.end(), [&one](const Said& known) {
      return known.design == one.design && known.errors == one.errors;
    });
    if (said == all.end()) {
      said = all.insert(all.end(), {one.design, one.errors, {}});
    }
    if (std::find(said->exercises.begin(), said->exercises.end(), one.exercise) == said->exercises.end()) {
      said->exercises.push_back(one.exercise);
    }
  }
  std::vector<Text> sentences;
  for (const Said& said : all) {
    sentences.push_back(
        Text::tr("%1. %2 %3", listed(said.exercises, Text::tr("%1; %2")), said.design, said.errors));
  }
  return sentences;
}

/// Shows the sums relative to the limit, up to the attempt that proved competence.
ReportFigure sumsFigure(const CohortInputs& in, const Ledger& ledger) {
  auto figure = competenceItem<ReportFigure>(in, ledger, "figure-lc-cusum",
                                             Text::tr("LC-CUSUM of every trainee and exercise"));
  figure.kind = FigureKind::kLines;
  figure.individual = true;
  figure.xLabel = Text::tr("number of the run");
  figure.yLabel = Text::tr("cumulative sum, share of the limit");
  figure.yMin = 0.0;
  for (std::size_t i = 0; i < in.competence.size(); ++i) {
    const CohortCompetence& one = in.competence[i];
    FigureSeries series{.name = one.trainee, .look = one.group, .faint = true};
    ResultKey key = competenceKey(ledger, in, i);
    const auto shown = one.ableAt ? static_cast<std::size_t>(*one.ableAt) : one.sums.size();
    while (series.x.size() < std::min(shown, one.sums.size())) {
      ++key.number;
      series.x.push_back(static_cast<double>(key.number));
      addPoint(series, ResultsAt(ledger, key), "cumulative_sum_of_limit");
    }
    figure.series.push_back(std::move(series));
  }
  figure.references = {{1.0, Text::tr("competent")}};
  figure.notes = {
      Text::tr("A success raises the sum, a failure lowers it, never below zero. A line ends where it "
               "reaches the limit: "
               "the trainee counts as competent from there on, with the probabilities stated above.")};
  return figure;
}

Text whichDesign(const CohortCompetence& one) {
  return one.designVersion > 0 ? Text::tr("registered, version %1", one.designVersion)
                               : Text::tr("shipped with the exercise");
}

/// What all verdicts have in common stands below the table in place of a column.
ReportTable verdictsTable(const CohortInputs& in, const Ledger& ledger) {
  auto table =
      competenceItem<ReportTable>(in, ledger, "table-competence", Text::tr("Competence of every trainee"));
  table.annex = true;
  table.individual = true;
  const auto varies = [&in](const auto& property) {
    return std::any_of(in.competence.begin(), in.competence.end(), [&](const CohortCompetence& one) {
      return property(one) != property(in.competence.front());
    });
  };
  const bool exercises = varies([](const CohortCompetence& one) { return one.exercise; });
  const bool designs = varies([](const CohortCompetence& one) { return whichDesign(one); });
  std::vector<ResultColumn> columns{{Text::tr("Group")}, {Text::tr("Trainee")}};
  if (exercises) {
    columns.push_back({Text::tr("Exercise")});
  }
  columns.insert(columns.end(), {{Text::tr("Runs"), "level", kValues},
                                 {Text::tr("Failed"), "failed"},
                                 {Text::tr("Excused"), "excused_runs"},
                                 {Text::tr("Level"), "level"},
                                 {Text::tr("False pass so far"), "false_pass", percent(1)},
                                 {Text::tr("False fail so far"), "false_fail", percent(1)},
                                 {Text::tr("Runs needed at least"), "fewest_attempts"}});
  if (designs) {
    columns.push_back({Text::tr("Design")});
  }
  ResultTable rows(ledger, table, std::move(columns));
  for (std::size_t i = 0; i < in.competence.size(); ++i) {
    const CohortCompetence& one = in.competence[i];
    std::vector<ReportCell> labels{in.groups[one.group].name, one.trainee};
    if (exercises) {
      labels.emplace_back(one.exercise);
    }
    if (designs) {
      labels.emplace_back(whichDesign(one));
    }
    rows.row(labels, competenceKey(ledger, in, i));
  }
  if (!exercises) {
    table.notes.emplace_back(Text(Text::tr("Exercise: %1.", in.competence.front().exercise)));
  }
  if (!designs) {
    table.notes.emplace_back(Text(Text::tr("Design: %1.", whichDesign(in.competence.front()))));
  }
  return table;
}

/// Shows how probable it is to be declared competent, for each number of runs that somebody made.
ReportTable oddsTable(const CohortInputs& in, const Ledger& ledger) {
  auto table = competenceItem<ReportTable>(in, ledger, "table-competence-odds",
                                           Text::tr("Probability of being declared competent within the runs "
                                                    "made, by the share of runs that a trainee truly fails"));
  std::vector<ResultColumn> columns{{Text::tr("Exercises")}, {Text::tr("Runs made"), "false_pass", kValues}};
  for (std::size_t rate = 0; rate < kStatedFailureRates.size(); ++rate) {
    columns.push_back({Text::verbatim("%1\u00A0%", formatFixed(100.0 * kStatedFailureRates[rate], 0)),
                       declaredStatistic(rate, false), percent(1)});
  }
  ResultTable rows(ledger, table, std::move(columns));
  std::map<std::pair<std::int64_t, std::string>, std::pair<std::size_t, std::vector<Text>>> made;
  for (std::size_t i = 0; i < in.competence.size(); ++i) {
    const CohortCompetence& one = in.competence[i];
    if (one.attempts == 0) {
      continue;
    }
    std::vector<Text>& exercises =
        made.try_emplace({one.attempts, one.errors.str()}, i, std::vector<Text>{}).first->second.second;
    if (std::find(exercises.begin(), exercises.end(), one.exercise) == exercises.end()) {
      exercises.push_back(one.exercise);
    }
  }
  for (const auto& [number, found] : made) {
    rows.row({listed(found.second, Text::tr("%1; %2"))}, competenceKey(ledger, in, found.first));
  }
  table.notes = {Text::tr("Within the runs that were planned: see the sentences above.")};
  return table;
}

ReportTable countsTable(const CohortInputs& in, const Ledger& ledger) {
  std::map<std::pair<std::string, std::size_t>, Text> exercises;
  for (const CohortCompetence& one : in.competence) {
    exercises[{one.exercise.str(), one.group}] = one.exercise;
  }
  auto table =
      competenceItem<ReportTable>(in, ledger, "table-competence-groups", Text::tr("Competence by group"));
  ResultTable rows(ledger, table,
                   {{Text::tr("Exercise")},
                    {Text::tr("Group")},
                    {Text::tr("Competent, not competent, not shown yet: trainees"), "competent_and_not"}});
  for (const auto& [place, exercise] : exercises) {
    rows.row(
        {exercise, in.groups[place.second].name},
        {.section = ResultSection::kCompetence, .group = ledger.group(place.second), .index = place.first});
  }
  return table;
}

}  // namespace

std::string declaredStatistic(std::size_t rate, bool planned) {
  return "declared_if_failing_" + formatFixed(100.0 * kStatedFailureRates[rate], 0) +
         (planned ? "_planned" : "_so_far");
}

ResultKey competenceKey(const Ledger& ledger, const CohortInputs& in, std::size_t number) {
  const CohortCompetence& one = in.competence[number];
  return {.section = ResultSection::kCompetence,
          .of = one.trainee,
          .group = ledger.group(one.group),
          .index = one.exercise.str(),
          .record = std::to_string(number)};
}

ReportSection competenceSection(const CohortInputs& in, const Ledger& ledger) {
  ReportSection section{"competence", Text::tr("Competence")};
  const std::vector<Text> designs = designSentences(in);
  section.paragraphs.assign(designs.begin(), designs.end());
  const ResultsAt at(ledger, {.section = ResultSection::kCompetence});
  if (at.number("excused_runs").value_or(0.0) > 0.0) {
    const ReportCell excused = at("excused_runs");
    section.paragraphs.push_back(
        {Text::tr("%1 {interrupted run was|interrupted runs were} excused with a reason and {counts|count} "
                  "neither as passed nor as failed; the table of every trainee has how many of whom.",
                  excused.words()),
         {excused}});
  }
  section.tables = {countsTable(in, ledger), verdictsTable(in, ledger)};
  if (std::any_of(in.competence.begin(), in.competence.end(),
                  [](const CohortCompetence& one) { return one.attempts > 0; })) {
    section.figures = {sumsFigure(in, ledger)};
    section.tables.insert(section.tables.begin() + 1, oddsTable(in, ledger));
  }
  return section;
}

}  // namespace torsio
