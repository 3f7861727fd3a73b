// SPDX-License-Identifier: GPL-3.0-or-later
// Models of raters: many-facet Rasch and generalizability.
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/cli/agreement_methods.h"
#include "app/cli/json_output.h"
#include "assessment/statistics/generalizability.h"
#include "assessment/statistics/rasch.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::int64_t kMaxCategories = 100;
constexpr double kLargestScore = 1e6;

/// Lowest and highest category of an integer scale.
struct Scale {
  std::int64_t lowest = 0;
  std::int64_t highest = 0;
};

Scale scaleOf(const RatingGrid& grid, const AgreementOptions& options) {
  const std::vector<double> scores = distinctScores(grid);
  if (scores.empty()) {
    refuse(Text::verbatim("every score is missing"), Text::verbatim("the ratings"),
           Text::verbatim("Give scores"));
  }
  for (const double score : scores) {
    if (score != std::floor(score) || std::abs(score) > kLargestScore) {
      refuse("the score " + Json(score).dump() + " is not a whole number up to a million",
             Text::verbatim("the ratings"),
             Text::verbatim("Give categories in whole numbers; collapse finer steps first"));
    }
  }
  const Scale scale{options.lowest.value_or(static_cast<std::int64_t>(scores.front())),
                    options.highest.value_or(static_cast<std::int64_t>(scores.back()))};
  if (static_cast<double>(scale.lowest) > scores.front() ||
      static_cast<double>(scale.highest) < scores.back()) {
    refuse("scores run from " + Json(scores.front()).dump() + " to " + Json(scores.back()).dump(),
           Text::verbatim("--lowest, --highest"), Text::verbatim("Give a scale that holds them all"));
  }
  if (scale.highest - scale.lowest >= kMaxCategories) {
    refuse(Text::verbatim("the scale has more than 100 categories"), Text::verbatim("--lowest, --highest"),
           Text::verbatim("Collapse categories first"));
  }
  return scale;
}

constexpr std::array kStatuses{"estimated", "extreme low", "extreme high", "no ratings"};

Json estimatesJson(const RatingGrid& grid, const Scale& scale, const RaschResult& result,
                   const std::vector<std::optional<CorrectedSeverity>>& corrected) {
  const std::string aside = "set aside: see the status";
  Json out;
  out["persons"] = Json::array();
  for (std::size_t n = 0; n < result.persons.size(); ++n) {
    const RaschPerson& person = result.persons[n];
    Json entry{{"target", grid.targets[n]}, {"status", wordOf(person.status, kStatuses)}};
    entry["ability"] = numberJson(person.ability, aside);
    entry["error"] = numberJson(person.error, aside);
    entry["joint_error"] = numberJson(person.jointError, aside);
    entry["fair_average"] = person.fairAverage ? Json(*person.fairAverage + static_cast<double>(scale.lowest))
                                               : undefinedJson(aside);
    entry["infit"] = numberJson(person.infit, aside);
    entry["outfit"] = numberJson(person.outfit, aside);
    out["persons"].push_back(std::move(entry));
  }
  out["raters"] = Json::array();
  for (std::size_t r = 0; r < result.raters.size(); ++r) {
    const RaschRater& rater = result.raters[r];
    Json entry{{"rater", grid.raters[r]}, {"status", wordOf(rater.status, kStatuses)}};
    entry["severity"] = numberJson(rater.severity, aside);
    entry["error"] = numberJson(rater.error, aside);
    if (const std::optional<CorrectedSeverity>& own = corrected[r]) {
      entry["corrected_severity"] = own->severity;
      entry["corrected_error"] = own->error;
      entry["corrected_95"] = {own->interval.lower, own->interval.upper};
    }
    entry["infit"] = numberJson(rater.infit, aside);
    entry["outfit"] = numberJson(rater.outfit, aside);
    out["raters"].push_back(std::move(entry));
  }
  out["thresholds"] = result.thresholds;
  out["log_likelihood"] = result.logLikelihood;
  out["iterations"] = result.iterations;
  return out;
}

Json componentsJson(const GStudy& study) {
  Json out = Json::array();
  for (const GComponent& component : study.components) {
    out.push_back({{"effect", component.effect},
                   {"sum_of_squares", component.sumOfSquares},
                   {"df", component.df},
                   {"mean_square", component.meanSquare},
                   {"variance", component.variance}});
  }
  return out;
}

Json coefficientsJson(const Outcome<DStudy>& outcome) {
  return outcomeJson(outcome, [](const DStudy& study) {
    return Json{{"generalizability", study.generalizability},
                {"dependability", study.dependability},
                {"relative_error", study.relativeError},
                {"absolute_error", study.absoluteError}};
  });
}

std::vector<double> planned(const std::vector<double>& numbers, std::size_t ofStudy) {
  return numbers.empty() ? std::vector<double>{static_cast<double>(ofStudy)} : numbers;
}

Json simpleStudyJson(const CsvTable& table, const AgreementOptions& options) {
  const RatingGrid grid = readRatingGrid(table);
  const CompleteTargets complete = completeTargets(grid);
  const auto study =
      complete.table ? gStudyPR(*complete.table) : Outcome<GStudy>::undefined(complete.table.reason());
  Json out{{"design", "persons x raters"}};
  out["components"] = outcomeJson(study, componentsJson);
  out["plans"] = outcomeJson(study, [&](const GStudy& result) {
    Json plans = Json::array();
    for (const double raters : planned(options.raters, grid.raters.size())) {
      Json plan{{"raters", raters}};
      plan.update(coefficientsJson(dStudyPR(result, raters)));
      plans.push_back(std::move(plan));
    }
    return plans;
  });
  out["left_out_targets"] = complete.leftOut;
  return out;
}

/// A design with a third facet: its names, its study and its projections.
struct FacetDesign {
  std::string name;
  std::string column;
  bool crossed = true;
  std::function<Outcome<GStudy>(const std::vector<NumberTable>&)> study;
  std::function<Outcome<DStudy>(const GStudy&, double raters, double levels)> plan;
};

Json facetStudyJson(const CsvTable& table, const FacetDesign& design, const std::vector<double>& raterNumbers,
                    const std::vector<double>& levelNumbers) {
  const FacetTables facets = readFacetTables(table, design.column, design.crossed);
  const auto study =
      facets.tables ? design.study(*facets.tables) : Outcome<GStudy>::undefined(facets.tables.reason());
  Json out{{"design", design.name}};
  out["components"] = outcomeJson(study, componentsJson);
  out["plans"] = outcomeJson(study, [&](const GStudy& result) {
    Json plans = Json::array();
    for (const double levels : planned(levelNumbers, facets.levels.size())) {
      for (const double raters : planned(raterNumbers, facets.raters)) {
        Json plan{{"raters", raters}, {design.column + "s", levels}};
        plan.update(coefficientsJson(design.plan(result, raters, levels)));
        plans.push_back(std::move(plan));
      }
    }
    return plans;
  });
  out["left_out_targets"] = facets.leftOut;
  return out;
}

/// Throws for an option about a facet that the table does not have.
void refuseWithout(const CsvTable& table, const std::vector<double>& numbers, const std::string& column) {
  if (!numbers.empty() && !table.has(column)) {
    refuseParameter("the table has no column \"" + column + "\"", "--" + column + "s",
                    Text::verbatim("Add the column or leave the option out"));
  }
}

}  // namespace

Json raschJson(const RatingGrid& grid, const AgreementOptions& options) {
  const Scale scale = scaleOf(grid, options);
  Json out;
  if (scale.lowest >= scale.highest) {
    out["rasch"] = undefinedJson("every score is the same");
    return out;
  }
  std::vector<std::vector<std::optional<int>>> categories(
      grid.targets.size(), std::vector<std::optional<int>>(grid.raters.size()));
  for (std::size_t r = 0; r < grid.raters.size(); ++r) {
    for (std::size_t t = 0; t < grid.targets.size(); ++t) {
      if (const std::optional<double>& score = grid.ratersByTarget[r][t]) {
        categories[t][r] = static_cast<int>(static_cast<std::int64_t>(*score) - scale.lowest);
      }
    }
  }
  out["rasch"] =
      outcomeJson(manyFacetRasch(categories, static_cast<int>(scale.highest - scale.lowest)),
                  [&](const RaschResult& result) {
                    return estimatesJson(grid, scale, result, correctedSeverities(categories, result));
                  });
  out["scale"] = {{"lowest", scale.lowest}, {"highest", scale.highest}};
  return out;
}

Json generalizabilityJson(const CsvTable& table, const AgreementOptions& options) {
  refuseWithout(table, options.occasions, "occasion");
  refuseWithout(table, options.tasks, "task");
  if (table.has("occasion") && table.has("task")) {
    refuse(Text::verbatim("the table has both occasions and tasks"), table.name(),
           Text::verbatim("Keep one of the two columns: occasions are crossed with raters, tasks have "
                          "raters of their own"));
  }
  if (table.has("occasion")) {
    return facetStudyJson(table,
                          {"persons x raters x occasions", "occasion", true, gStudyPRO,
                           [](const GStudy& study, double raters, double occasions) {
                             return dStudyPRO(study, raters, occasions);
                           }},
                          options.raters, options.occasions);
  }
  if (table.has("task")) {
    return facetStudyJson(
        table,
        {"persons x (raters in tasks)", "task", false, gStudyPRinT,
         [](const GStudy& study, double raters, double tasks) { return dStudyPRinT(study, tasks, raters); }},
        options.raters, options.tasks);
  }
  return simpleStudyJson(table, options);
}

}  // namespace torsio::cli
