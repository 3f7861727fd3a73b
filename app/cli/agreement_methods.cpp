// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/agreement_methods.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "app/services/base/name_places.h"

namespace torsio::cli {

namespace {

void refuseSecondScore(const CsvTable& table, std::size_t row, std::size_t firstRow,
                       const std::string& where) {
  table.refuse(row,
               "rater \"" + table.text(row, "rater") + "\" rates target \"" + table.text(row, "target") +
                   "\" a second time" + where + ", first in " + table.where(firstRow),
               "Keep one score for each rater and target" + where);
}

Text nobodyComplete() {
  return Text::tr("no target has a score by every rater");
}

/// Stores the group of a row's target; throws for a second one.
void noteGroup(const CsvTable& table, std::size_t row, std::size_t target, NamePlaces& groups,
               std::vector<std::size_t>& groupOf) {
  const std::size_t group = groups(table.text(row, "group"));
  if (target == groupOf.size()) {
    groupOf.push_back(group);
  } else if (groupOf[target] != group) {
    table.refuse(row,
                 "target \"" + table.text(row, "target") + "\" is in group \"" + groups.names()[group] +
                     "\", but in another one above",
                 Text::verbatim("A target belongs to one group"));
  }
}

}  // namespace

RatingGrid readRatingGrid(const CsvTable& table) {
  RatingGrid grid;
  NamePlaces targets;
  NamePlaces raters;
  NamePlaces groups;
  std::set<std::string> byName;  // so that a pair is compared in the same direction in any order of the lines
  for (std::size_t row = 0; row < table.rows(); ++row) {
    byName.insert(table.text(row, "rater"));
  }
  for (const std::string& rater : byName) {
    (void)raters(rater);
  }
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> rowOf;  // rater, target
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& target = table.text(row, "target");
    const std::string& rater = table.text(row, "rater");
    const std::pair key{raters(rater), targets(target)};
    if (table.has("group")) {
      noteGroup(table, row, key.second, groups, grid.groupOf);
    }
    const auto [first, isNew] = rowOf.emplace(key, row);
    if (!isNew) {
      refuseSecondScore(table, row, first->second, "");
    }
  }
  grid.targets = targets.names();
  grid.raters = raters.names();
  grid.groups = groups.names();
  grid.ratersByTarget.assign(grid.raters.size(),
                             std::vector<std::optional<double>>(grid.targets.size(), std::nullopt));
  for (const auto& [key, row] : rowOf) {
    const std::optional<double> score = table.numberIfGiven(row, "score");
    grid.ratersByTarget[key.first][key.second] = score;
    grid.given += score ? 1 : 0;
  }
  return grid;
}

CompleteTargets completeTargets(const RatingGrid& grid, std::optional<std::size_t> group) {
  CompleteTargets out;
  std::vector<std::vector<double>> rows;
  for (std::size_t t = 0; t < grid.targets.size(); ++t) {
    if (group && grid.groupOf[t] != *group) {
      continue;
    }
    std::vector<double> row;
    for (const auto& rater : grid.ratersByTarget) {
      if (rater[t]) {
        row.push_back(*rater[t]);
      }
    }
    if (row.size() == grid.raters.size()) {
      rows.push_back(std::move(row));
    } else {
      out.leftOut.push_back(grid.targets[t]);
    }
  }
  out.table = rows.empty() ? Outcome<NumberTable>::undefined(nobodyComplete()) : Outcome(NumberTable(rows));
  return out;
}

std::vector<double> distinctScores(const RatingGrid& grid) {
  std::set<double> scores;
  for (const auto& rater : grid.ratersByTarget) {
    for (const std::optional<double>& score : rater) {
      if (score) {
        scores.insert(*score);
      }
    }
  }
  return {scores.begin(), scores.end()};
}

SharedScores sharedScores(const RatingGrid& grid, std::size_t first, std::size_t second) {
  SharedScores shared;
  for (std::size_t t = 0; t < grid.targets.size(); ++t) {
    const std::optional<double>& x = grid.ratersByTarget[first][t];
    const std::optional<double>& y = grid.ratersByTarget[second][t];
    if (x && y) {
      shared.first.push_back(*x);
      shared.second.push_back(*y);
    }
  }
  return shared;
}

FacetTables readFacetTables(const CsvTable& table, const std::string& levelColumn, bool crossed) {
  FacetTables out;
  NamePlaces levels;
  NamePlaces targets;
  std::vector<NamePlaces> raters;  // by level; if crossed, one list
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, std::size_t> rowOf;  // level, target, rater
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::size_t level = levels(table.text(row, levelColumn));
    const std::size_t list = crossed ? 0 : level;
    raters.resize(std::max(raters.size(), list + 1));
    const std::size_t target = targets(table.text(row, "target"));
    const std::size_t rater = raters[list](table.text(row, "rater"));
    const auto [first, isNew] = rowOf.emplace(std::tuple{level, target, rater}, row);
    if (!isNew) {
      refuseSecondScore(table, row, first->second,
                        " at " + levelColumn + " \"" + levels.names()[level] + "\"");
    }
  }
  out.levels = levels.names();
  out.raters = raters.front().names().size();
  if (std::any_of(raters.begin(), raters.end(),
                  [&](const NamePlaces& list) { return list.names().size() != out.raters; })) {
    out.tables =
        Outcome<std::vector<NumberTable>>::undefined(Text::tr("the tasks have different numbers of raters"));
    return out;
  }
  const std::size_t wanted = out.levels.size() * out.raters;
  std::vector<std::vector<std::vector<std::optional<double>>>> scores(  // target, level, rater
      targets.names().size(),
      std::vector<std::vector<std::optional<double>>>(
          out.levels.size(), std::vector<std::optional<double>>(out.raters, std::nullopt)));
  std::vector<std::size_t> given(targets.names().size(), 0);
  for (const auto& [key, row] : rowOf) {
    if (const std::optional<double> score = table.numberIfGiven(row, "score")) {
      const auto& [level, target, rater] = key;
      scores[target][level][rater] = *score;
      ++given[target];
    }
  }
  std::vector<std::vector<std::vector<double>>> rows(out.levels.size());
  for (std::size_t target = 0; target < scores.size(); ++target) {
    if (given[target] < wanted) {
      out.leftOut.push_back(targets.names()[target]);
      continue;
    }
    for (std::size_t level = 0; level < out.levels.size(); ++level) {
      rows[level].emplace_back();
      for (const std::optional<double>& score : scores[target][level]) {
        rows[level].back().push_back(*score);
      }
    }
  }
  if (rows.front().empty()) {
    out.tables = Outcome<std::vector<NumberTable>>::undefined(nobodyComplete());
  } else {
    out.tables = Outcome(std::vector<NumberTable>(rows.begin(), rows.end()));
  }
  return out;
}

}  // namespace torsio::cli
