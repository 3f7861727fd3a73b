// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <utility>

#include "assessment/results/aggregated_inputs.h"
#include "assessment/results/analysed_cohort.h"
#include "assessment/results/number_format.h"
#include "assessment/results/report_labels.h"
#include "assessment/results/report_sections.h"
#include "sim/core/text.h"

namespace torsio {

namespace {

template <typename Item>
Item competenceItem(const CohortInputs& in, const std::string& id, const Text& title) {
  Item item = itemOf<Item>(in, id, title, Text::tr("LC-CUSUM, Biau and Porcher 2010"));
  for (const CohortCompetence& one : in.competence) {
    item.provenance.n += one.attempts;
  }
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
ReportFigure sumsFigure(const CohortInputs& in) {
  auto figure =
      competenceItem<ReportFigure>(in, "figure-lc-cusum", Text::tr("LC-CUSUM of every trainee and exercise"));
  figure.kind = FigureKind::kLines;
  figure.individual = true;
  figure.xLabel = Text::tr("number of the attempt");
  figure.yLabel = Text::tr("cumulative sum, share of the limit");
  figure.yMin = 0.0;
  for (const CohortCompetence& one : in.competence) {
    FigureSeries series;
    series.name = one.trainee;
    series.look = one.group;
    series.faint = true;
    const auto shown = one.ableAt ? static_cast<std::size_t>(*one.ableAt) : one.sums.size();
    for (std::size_t i = 0; i < std::min(shown, one.sums.size()); ++i) {
      series.x.push_back(static_cast<double>(i + 1));
      series.y.emplace_back(one.sums[i] / one.limit);
    }
    figure.series.push_back(std::move(series));
  }
  figure.references = {{1.0, Text::tr("competent")}};
  figure.notes = {
      Text::tr("A success raises the sum, a failure lowers it, never below zero. A line ends where it "
               "reaches the limit: "
               "the trainee counts as competent from there on, with the error rates stated above.")};
  return figure;
}

Text shareText(double share) {
  return Text::verbatim("%1 %", formatFixed(100.0 * share, 1));
}

ReportTable verdictsTable(const CohortInputs& in) {
  auto table = competenceItem<ReportTable>(in, "table-competence", Text::tr("Competence of every trainee"));
  table.individual = true;
  table.columns = {Text::tr("Group"),           Text::tr("Trainee"),    Text::tr("Exercise"),
                   Text::tr("Attempts"),        Text::tr("Failed"),     Text::tr("Level"),
                   Text::tr("False pass"),      Text::tr("False fail"), Text::tr("False alarm"),
                   Text::tr("Within attempts"), Text::tr("Design")};
  for (std::size_t i = 0; i < in.competence.size(); ++i) {
    const CohortCompetence& one = in.competence[i];
    const CellsAt cell(competenceKey(in, i));
    table.rows.push_back(
        {in.groups[one.group].name, one.trainee, one.exercise, cell("level", std::to_string(one.attempts)),
         cell("failed", std::to_string(one.failed)), cell("level", one.level),
         cell("false_pass", shareText(one.falsePass)), cell("false_fail", shareText(one.falseFail)),
         cell("false_alarm", shareText(one.falseAlarm)),
         cell("within_attempts", std::to_string(one.withinAttempts)),
         one.designVersion > 0 ? Text::tr("registered, version %1", one.designVersion)
                               : Text::tr("shipped with the exercise")});
  }
  return table;
}

ReportTable countsTable(const CohortInputs& in) {
  struct Counts {
    std::int64_t able = 0;
    std::int64_t notAble = 0;
  };
  std::map<std::pair<std::string, std::size_t>, Counts> cells;
  std::map<std::string, Text> titles;
  for (const CohortCompetence& one : in.competence) {
    Counts& counts = cells[{one.exercise.str(), one.group}];
    titles[one.exercise.str()] = one.exercise;
    ++(one.able ? counts.able : counts.notAble);
  }
  auto table = competenceItem<ReportTable>(in, "table-competence-groups", Text::tr("Competence by group"));
  table.columns = {Text::tr("Exercise"), Text::tr("Group"),
                   Text::tr("Competent and not yet competent, trainees")};
  for (const auto& [place, counts] : cells) {
    table.rows.push_back(
        {titles[place.first], in.groups[place.second].name,
         countsText({{Text::tr("competent"), counts.able}, {Text::tr("not competent"), counts.notAble}},
                    in.identity)});
  }
  return table;
}

}  // namespace

ResultKey competenceKey(const CohortInputs& in, std::size_t number) {
  const CohortCompetence& one = in.competence[number];
  return {.section = ResultSection::kCompetence,
          .of = one.trainee,
          .group = one.group,
          .index = one.exercise.str(),
          .record = std::to_string(number)};
}

ReportSection competenceSection(const CohortInputs& in) {
  ReportSection section{"competence", Text::tr("Competence")};
  section.paragraphs = designSentences(in);
  section.figures = {sumsFigure(in)};
  section.tables = {countsTable(in), verdictsTable(in)};
  return section;
}

}  // namespace torsio
