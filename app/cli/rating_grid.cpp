// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/rating_grid.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "app/base/name_places.h"

namespace torsio::cli {

namespace {

void refuseSecondScore(const CsvTable& table, std::size_t row, std::size_t firstRow,
                       const std::string& where) {
  table.refuse(row,
               "rater \"" + table.text(row, "rater") + "\" rates target \"" + table.text(row, "target") +
                   "\" a second time" + where + ", first in " + table.where(firstRow),
               "Keep one score for each rater and target" + where);
}

Outcome<std::vector<NumberTable>> incomplete(std::size_t missing, std::size_t wanted) {
  return Outcome<std::vector<NumberTable>>::undefined(
      std::to_string(missing) + " of " + std::to_string(wanted) +
      " ratings are missing, and this needs a complete table");
}

}  // namespace

RatingGrid readRatingGrid(const CsvTable& table) {
  RatingGrid grid;
  NamePlaces targets;
  NamePlaces raters;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> rowOf;  // rater, target
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& target = table.text(row, "target");
    const std::string& rater = table.text(row, "rater");
    const std::pair key{raters(rater), targets(target)};
    const auto [first, isNew] = rowOf.emplace(key, row);
    if (!isNew) {
      refuseSecondScore(table, row, first->second, "");
    }
  }
  grid.targets = targets.names();
  grid.raters = raters.names();
  grid.ratersByTarget.assign(grid.raters.size(),
                             std::vector<std::optional<double>>(grid.targets.size(), std::nullopt));
  for (const auto& [key, row] : rowOf) {
    const std::optional<double> score = table.numberIfGiven(row, "score");
    grid.ratersByTarget[key.first][key.second] = score;
    grid.given += score ? 1 : 0;
  }
  return grid;
}

Outcome<NumberTable> completeTable(const RatingGrid& grid) {
  const std::size_t wanted = grid.targets.size() * grid.raters.size();
  if (grid.given != wanted) {
    return Outcome<NumberTable>::undefined(incomplete(wanted - grid.given, wanted).reason());
  }
  NumberTable table(grid.targets.size(), grid.raters.size());
  for (std::size_t r = 0; r < grid.raters.size(); ++r) {
    for (std::size_t t = 0; t < grid.targets.size(); ++t) {
      table.at(t, r) = *grid.ratersByTarget[r][t];
    }
  }
  return table;
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
  std::vector<NamePlaces> raters;  // by level; crossed: one list
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
  out.targets = targets.names().size();
  out.raters = raters.front().names().size();
  if (std::any_of(raters.begin(), raters.end(),
                  [&](const NamePlaces& list) { return list.names().size() != out.raters; })) {
    out.tables =
        Outcome<std::vector<NumberTable>>::undefined(Text::tr("the tasks have different numbers of raters"));
    return out;
  }
  const std::size_t wanted = out.levels.size() * out.targets * out.raters;
  std::vector<NumberTable> tables(out.levels.size(), NumberTable(out.targets, out.raters));
  std::size_t given = 0;
  for (const auto& [key, row] : rowOf) {
    if (const std::optional<double> score = table.numberIfGiven(row, "score")) {
      const auto& [level, target, rater] = key;
      tables[level].at(target, rater) = *score;
      ++given;
    }
  }
  out.tables = given == wanted ? Outcome<std::vector<NumberTable>>(std::move(tables))
                               : incomplete(wanted - given, wanted);
  return out;
}

}  // namespace torsio::cli
