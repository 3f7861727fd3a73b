// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/results/aggregated_inputs.h"

#include <algorithm>
#include <set>

#include "sim/core/text.h"

namespace torsio {

namespace {

/// Removes the items for which `gone` is true and renumbers the groups of the others.
template <typename Item>
void keepGroups(std::vector<Item>& items, const std::vector<std::optional<std::size_t>>& newNumber) {
  std::vector<Item> kept;
  for (Item& item : items) {
    if (!newNumber[item.group]) {
      continue;
    }
    item.group = *newNumber[item.group];
    kept.push_back(std::move(item));
  }
  items = std::move(kept);
}

bool smallClasses(const CohortInputs& in) {
  std::vector<std::int64_t> raters(in.instrument.classes.size(), 0);
  for (const ModelRatings& model : in.ratings) {
    for (const RaterSheet& sheet : model.sheets) {
      if (&model == &in.ratings.front()) {
        ++raters[sheet.raterClass];
      }
    }
  }
  return std::any_of(raters.begin(), raters.end(), [](auto n) { return n > 0 && n < kSmallestCell; });
}

}  // namespace

CohortInputs withoutSmallGroups(const CohortInputs& inputs, std::vector<Text>& left) {
  CohortInputs out = inputs;
  std::vector<std::int64_t> members(out.groups.size(), 0);
  for (const CohortTrainee& trainee : out.trainees) {
    ++members[trainee.group];
  }
  std::vector<std::optional<std::size_t>> newNumber(out.groups.size());
  std::vector<CohortGroup> groups;
  for (std::size_t g = 0; g < out.groups.size(); ++g) {
    if (members[g] >= kSmallestCell) {
      newNumber[g] = groups.size();
      groups.push_back(out.groups[g]);
    } else {
      left.push_back(
          Text::tr("%1 is left out: it has fewer than %2 trainees.", out.groups[g].name, kSmallestCell));
    }
  }
  out.groups = std::move(groups);
  keepGroups(out.trainees, newNumber);
  keepGroups(out.trainingMarks, newNumber);
  keepGroups(out.criterionMarks, newNumber);
  keepGroups(out.scores, newNumber);
  keepGroups(out.summaries, newNumber);
  keepGroups(out.trials, newNumber);
  keepGroups(out.competence, newNumber);
  std::set<std::string> known;
  for (const CohortTrainee& trainee : out.trainees) {
    known.insert(trainee.code);
  }
  std::erase_if(out.doses, [&](const CohortDose& dose) { return !known.contains(dose.trainee); });
  if (smallClasses(out)) {
    left.push_back(Text::tr("The evaluation of the models is left out: a class has fewer than %1 raters.",
                            kSmallestCell));
    out.ratings.clear();
    out.evaluations.clear();
  }
  return out;
}

void removeIndividuals(ReportModel& report) {
  for (ReportSection& section : report.sections) {
    std::erase_if(section.figures, [](const ReportFigure& figure) { return figure.individual; });
    std::erase_if(section.tables, [](const ReportTable& table) { return table.individual; });
    for (ReportFigure& figure : section.figures) {
      for (FigureSeries& series : figure.series) {
        if (series.box) {
          series.box->outliers.clear();
        }
      }
    }
  }
  std::erase_if(report.sections, [](const ReportSection& section) {
    return section.figures.empty() && section.tables.empty() && section.paragraphs.empty();
  });
}

Text countsText(const std::vector<std::pair<Text, std::int64_t>>& counts, ReportIdentity identity) {
  const bool small = std::any_of(counts.begin(), counts.end(),
                                 [](const auto& count) { return count.second < kSmallestCell; });
  if (identity == ReportIdentity::kAggregated && small && counts.size() > 1) {
    return Text::tr("not shown (fewer than %1)", kSmallestCell);
  }
  std::vector<Text> parts;
  for (const auto& [name, count] : counts) {
    parts.push_back(Text::verbatim("%1 %2", name.empty() ? Text::tr("not known") : name, count));
  }
  return listed(parts);
}

}  // namespace torsio
