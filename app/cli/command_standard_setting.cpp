// SPDX-License-Identifier: GPL-3.0-or-later
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/base/csv_table.h"
#include "app/services/study/standard_tables.h"
#include "assessment/statistics/standard_setting.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

struct StandardArguments {
  std::string file;
  std::string method;
  std::string better = "lower";
  ProficiencyOptions proficiency;
  std::optional<double> borderline;
};

Json contrastingGroupsJson(const CsvTable& table) {
  const ContrastedScores groups = readContrastedScores(table);
  const std::vector<double>& novices = groups.novices;
  const std::vector<double>& masters = groups.masters;
  return outcomeJson(contrastingGroups(novices, masters), [&](const ContrastingGroups& result) {
    Json out{{"cut", result.cutNormal}};
    out["false_pass"] = result.falsePass;
    out["false_fail"] = result.falseFail;
    out["other_crossing"] = numberJson(result.otherRoot, "the groups have the same spread");
    const std::string apart = "the groups do not overlap";
    out["logistic"] = {{"cut", numberJson(result.cutLogistic, apart)}};
    if (result.cutLogistic) {
      out["logistic"].update({{"intercept", result.logistic[0]},
                              {"slope", result.logistic[1]},
                              {"intercept_error", result.logisticErrors[0]},
                              {"slope_error", result.logisticErrors[1]}});
    }
    out["midpoint"] = result.midpoint;
    out["novices"] = {{"n", novices.size()}, {"mean", result.meanNovices}, {"sd", result.deviationNovices}};
    out["masters"] = {{"n", masters.size()}, {"mean", result.meanMasters}, {"sd", result.deviationMasters}};
    return out;
  });
}

Json angoffJson(const CsvTable& table) {
  const JudgedItems judged = readJudgedItems(table);
  return outcomeJson(angoff(judged.percent), [&](const Angoff& result) {
    Json out{{"cut", result.cut}, {"items", judged.items.size()}, {"percent", result.percent}};
    const std::string alone = "there is only one judge";
    out["sd"] = numberJson(result.deviation, alone);
    out["error"] = numberJson(result.error, alone);
    out["judges"] = Json::array();
    for (std::size_t judge = 0; judge < judged.judges.size(); ++judge) {
      out["judges"].push_back({{"judge", judged.judges[judge]}, {"cut", result.judgeTotals[judge]}});
    }
    return out;
  });
}

Json borderlineJson(const CsvTable& table, double borderline) {
  const RatedScores rated = readRatedScores(table);
  return outcomeJson(borderlineRegression(rated.ratings, rated.scores, borderline),
                     [&](const BorderlineRegression& result) {
                       return Json{{"cut", result.cut},
                                   {"error", result.error},
                                   {"borderline", borderline},
                                   {"slope", result.slope},
                                   {"intercept", result.intercept},
                                   {"r_squared", result.rSquared},
                                   {"subjects", rated.scores.size()}};
                     });
}

Json proficiencyJson(const CsvTable& table, const ProficiencyOptions& options) {
  const std::vector<double> values = readExpertValues(table);
  return outcomeJson(proficiencyThreshold(values, options), [&](const ProficiencyThreshold& result) {
    return Json{{"mean", result.mean},
                {"one_sd", result.oneDeviation},
                {"two_sd", result.twoDeviations},
                {"tolerance_bound", result.toleranceBound},
                {"tolerance_factor", result.toleranceFactor},
                {"sd", result.deviation},
                {"sd_of", options.logScale ? "logarithms" : "values"},
                {"experts", result.experts},
                {"dropped", result.dropped},
                {"coverage", options.coverage},
                {"confidence", options.confidence}};
  });
}

Json standardJson(const StandardArguments& arguments) {
  const auto read = [&](std::initializer_list<std::string_view> columns) {
    CsvTable table = CsvTable::read(arguments.file, columns);
    noteTable(table);
    return table;
  };
  if (arguments.method == "contrasting-groups") {
    return contrastingGroupsJson(read({"subject", "group", "score"}));
  }
  if (arguments.method == "angoff") {
    return angoffJson(read({"judge", "item", "percent"}));
  }
  if (arguments.method == "borderline-regression") {
    if (!arguments.borderline) {
      refuseUsage("the method needs the global rating of a borderline trainee",
                  "standard-setting --method borderline-regression", "Give --borderline");
    }
    return borderlineJson(read({"subject", "global", "score"}), *arguments.borderline);
  }
  ProficiencyOptions options = arguments.proficiency;
  options.better = arguments.better == "lower" ? Better::kLower : Better::kHigher;
  return proficiencyJson(read({"expert", "value"}), options);
}

/// Rejects options that would be silently ignored.
void requireOptionsThatCount(const CLI::App& command, const std::string& method) {
  const auto refuse = [&](const std::string& name, const std::string& owner) {
    if (command.count(name) > 0 && method != owner) {
      refuseUsage("the method " + method + " does not read " + name, "standard-setting " + name,
                  "Give --method " + owner + " or leave the option out");
    }
  };
  refuse("--borderline", "borderline-regression");
  for (const char* name : {"--better", "--log", "--drop-outliers", "--coverage", "--certainty"}) {
    refuse(name, "proficiency");
  }
}

}  // namespace

void addStandardSetting(CLI::App& program) {
  auto arguments = std::make_shared<StandardArguments>();
  CLI::App* command =
      program.add_subcommand("standard-setting", "Where to draw the line between pass and fail");
  command->add_option("FILE", arguments->file, "CSV; its columns depend on the method, see docs/cli.md")
      ->required();
  command->add_option("--method", arguments->method, "How the standard is set")
      ->check(CLI::IsMember({"contrasting-groups", "angoff", "borderline-regression", "proficiency"}))
      ->required();
  command->add_option("--borderline", arguments->borderline,
                      "borderline-regression: the global rating that means borderline");
  addDefaulted(*command, "--better", arguments->better,
               "proficiency: whether lower or higher values are better", CLI::IsMember({"lower", "higher"}));
  command->add_flag("--log", arguments->proficiency.logScale,
                    "proficiency: compute on logarithms, as for times");
  command->add_flag("--drop-outliers", arguments->proficiency.dropOutliers,
                    "proficiency: leave out experts beyond 1.96 standard deviations, once");
  addDefaulted(*command, "--coverage", arguments->proficiency.coverage,
               "proficiency: share of experts within the bound", CLI::Range(0.5, 0.999));
  addDefaulted(*command, "--certainty", arguments->proficiency.confidence,
               "proficiency: confidence of the bound", CLI::Range(0.5, 0.999));
  command->callback([arguments, command] {
    requireOptionsThatCount(*command, arguments->method);
    Json out{{"method", arguments->method}};
    out["standard"] = standardJson(*arguments);
    printJson(out);
  });
}

}  // namespace torsio::cli
