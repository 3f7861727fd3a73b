// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/base/csv_table.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "assessment/statistics/categorical_agreement.h"
#include "assessment/statistics/reliability.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

/// Who was rated by whom, in the order in which the file names them.
struct RatingGrid {
  std::vector<std::string> targets;
  std::vector<std::string> raters;
  IncompleteRatings ratersByTarget;
  std::size_t given = 0;
  bool negative = false;
};

std::size_t positionOf(std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  names.push_back(name);
  return names.size() - 1;
}

RatingGrid readGrid(const CsvTable& table) {
  RatingGrid grid;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> rowOf;  // rater, target
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& target = table.text(row, "target");
    const std::string& rater = table.text(row, "rater");
    const std::pair key{positionOf(grid.raters, rater), positionOf(grid.targets, target)};
    const auto [first, isNew] = rowOf.emplace(key, row);
    if (!isNew)
      table.refuse(row,
                   "rater \"" + rater + "\" rates target \"" + target + "\" a second time, first in " +
                       table.where(first->second),
                   "Keep one score for each rater and target");
  }
  grid.ratersByTarget.assign(grid.raters.size(),
                             std::vector<std::optional<double>>(grid.targets.size(), std::nullopt));
  for (const auto& [key, row] : rowOf) {
    const std::optional<double> score = table.numberIfGiven(row, "score");
    grid.ratersByTarget[key.first][key.second] = score;
    if (score) ++grid.given;
    grid.negative = grid.negative || (score && *score < 0.0);
  }
  return grid;
}

/// Targets x raters; undefined with a missing rating.
Outcome<NumberTable> completeTable(const RatingGrid& grid) {
  const std::size_t wanted = grid.targets.size() * grid.raters.size();
  if (grid.given != wanted)
    return Outcome<NumberTable>::undefined(std::to_string(wanted - grid.given) + " of " +
                                           std::to_string(wanted) +
                                           " ratings are missing, and this needs a complete table");
  NumberTable table(grid.targets.size(), grid.raters.size());
  for (std::size_t r = 0; r < grid.raters.size(); ++r)
    for (std::size_t t = 0; t < grid.targets.size(); ++t) table.at(t, r) = *grid.ratersByTarget[r][t];
  return table;
}

Json formJson(const IccForm& form) {
  const std::string reason = "the error variance is zero";
  Json out{{"estimate", form.estimate}};
  out["lower"] = form.interval ? Json(form.interval->lower) : undefinedJson(reason);
  out["upper"] = form.interval ? Json(form.interval->upper) : undefinedJson(reason);
  return out;
}

Json iccJson(const Outcome<IccResult>& icc) {
  Json out;
  const auto add = [&](const char* name, IccForm IccResult::*form) {
    out[name] = icc ? formJson((*icc).*form) : undefinedJson(icc.reason());
  };
  add("ICC(1,1)", &IccResult::oneWaySingle);
  add("ICC(2,1)", &IccResult::agreementSingle);
  add("ICC(3,1)", &IccResult::consistencySingle);
  add("ICC(1,k)", &IccResult::oneWayMean);
  add("ICC(2,k)", &IccResult::agreementMean);
  add("ICC(3,k)", &IccResult::consistencyMean);
  return out;
}

Json krippendorffJson(const RatingGrid& grid) {
  const auto alpha = [&](AlphaMetric metric) {
    return outcomeJson(krippendorffAlpha(grid.ratersByTarget, metric),
                       [](const KrippendorffResult& result) { return Json(result.alpha); });
  };
  Json out;
  out["nominal"] = alpha(AlphaMetric::kNominal);
  out["ordinal"] = alpha(AlphaMetric::kOrdinal);
  out["interval"] = alpha(AlphaMetric::kInterval);
  out["ratio"] =
      grid.negative ? undefinedJson("a ratio scale has no negative scores") : alpha(AlphaMetric::kRatio);
  return out;
}

void runAgreement(const std::string& file) {
  const CsvTable table = CsvTable::read(file, {"target", "rater", "score"});
  noteIgnoredColumns(table);
  const RatingGrid grid = readGrid(table);
  const Outcome<NumberTable> complete = completeTable(grid);
  const auto icc =
      complete ? intraclassCorrelation(*complete) : Outcome<IccResult>::undefined(complete.reason());
  const auto kendall = complete ? kendallW(*complete) : Outcome<KendallResult>::undefined(complete.reason());
  const auto cronbach =
      complete ? cronbachAlpha(*complete) : Outcome<CronbachResult>::undefined(complete.reason());
  Json out;
  out["icc"] = iccJson(icc);
  out["krippendorff"] = krippendorffJson(grid);
  out["kendall_w"] = outcomeJson(kendall, [](const KendallResult& w) {
    return Json{{"w", w.w}, {"chi_squared", w.chiSquared}, {"df", w.df}, {"p", w.p}};
  });
  out["cronbach"] = outcomeJson(cronbach, [](const CronbachResult& alpha) {
    return Json{{"alpha", alpha.alpha}, {"lower", alpha.interval.lower}, {"upper", alpha.interval.upper}};
  });
  out["sem"] = outcomeJson(icc, [](const IccResult& result) {
    return Json{{"agreement", result.semAgreement}, {"consistency", result.semConsistency}};
  });
  out["targets"] = grid.targets.size();
  out["raters"] = grid.raters.size();
  out["missing"] = grid.targets.size() * grid.raters.size() - grid.given;
  out["confidence"] = kUsualConfidence;
  printJson(out);
}

}  // namespace

void addAgreement(CLI::App& program) {
  auto file = std::make_shared<std::string>();
  CLI::App* command =
      program.add_subcommand("agreement", "How well raters agree: ICC, Krippendorff, Kendall, Cronbach");
  command->add_option("--ratings", *file, "CSV with the columns target,rater,score")->required();
  command->callback([file] { runAgreement(*file); });
}

}  // namespace torsio::cli
