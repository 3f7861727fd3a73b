// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/agreement_methods.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/base/csv_table.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

struct AgreementArguments {
  std::string file;
  std::string method = "overview";
  AgreementOptions options;
};

const std::vector<std::string> kMethods = {"overview",     "icc",   "krippendorff",    "kappa",
                                           "bland-altman", "rasch", "generalizability"};

/// The method that reads each option.
const std::map<std::string, std::string> kMethodOf = {
    {"--categories", "kappa"},        {"--disagreement", "kappa"},
    {"--seed", "krippendorff"},       {"--lowest", "rasch"},
    {"--resamples", "krippendorff"},  {"--highest", "rasch"},
    {"--raters", "generalizability"}, {"--occasions", "generalizability"},
    {"--tasks", "generalizability"}};

/// Rejects options that the method would silently ignore.
void requireOptionsOfMethod(const CLI::App& command, const std::string& method) {
  for (const auto& [name, owner] : kMethodOf) {
    if (command.count(name) > 0 && method != owner) {
      refuseUsage("the method " + method + " does not read " + name, "agreement " + name,
                  "Give --method " + owner + " or leave the option out");
    }
  }
}

Json methodJson(const CsvTable& table, const AgreementArguments& arguments) {
  if (arguments.method == "generalizability") {
    return generalizabilityJson(table, arguments.options);
  }
  const RatingGrid grid = readRatingGrid(table);
  Json out = arguments.method == "icc"            ? intraclassJson(grid)
             : arguments.method == "krippendorff" ? krippendorffJson(grid, arguments.options)
             : arguments.method == "kappa"        ? kappaJson(grid, arguments.options)
             : arguments.method == "bland-altman" ? blandAltmanJson(grid)
             : arguments.method == "rasch"        ? raschJson(grid, arguments.options)
                                                  : overviewJson(grid);
  out["targets"] = grid.targets.size();
  out["raters"] = grid.raters.size();
  out["missing"] = grid.targets.size() * grid.raters.size() - grid.given;
  out["confidence"] = kDefaultConfidence;
  return out;
}

CsvTable readRatings(const AgreementArguments& arguments) {
  if (arguments.method == "generalizability") {
    return CsvTable::read(arguments.file, {"target", "rater", "score"}, {"occasion", "task"});
  }
  if (arguments.method == "icc") {
    return CsvTable::read(arguments.file, {"target", "rater", "score"}, {"group"});
  }
  return CsvTable::read(arguments.file, {"target", "rater", "score"});
}

void runAgreement(const AgreementArguments& arguments) {
  const CsvTable table = readRatings(arguments);
  noteTable(table);
  printJson(methodJson(table, arguments));
}

void addMethodOptions(CLI::App& command, AgreementOptions& options) {
  command
      .add_option("--categories", options.categories, "kappa: the full list in order; default: those used")
      ->delimiter(',');
  command.add_option("--disagreement", options.disagreement,
                     "kappa: custom weights, CSV with the columns first,second,disagreement");
  addDefaulted(command, "--seed", options.seed, "krippendorff: seed of the resamples");
  command
      .add_option("--resamples", options.resamples,
                  "krippendorff: resamples for the interval; default: 9999, fewer for more than 8000 scores")
      ->check(CLI::Range(99, 1'000'000));
  command.add_option("--lowest", options.lowest, "rasch: lowest category; default: the lowest score");
  command.add_option("--highest", options.highest, "rasch: highest category; default: the highest score");
  const auto planned = [&](const char* name, std::vector<double>& numbers, const char* what) {
    command.add_option(name, numbers, what)->delimiter(',')->check(CLI::Range(1.0, 1000.0));
  };
  planned("--raters", options.raters, "generalizability: numbers of raters to plan with, such as 2,5,10");
  planned("--occasions", options.occasions, "generalizability: numbers of occasions to plan with");
  planned("--tasks", options.tasks, "generalizability: numbers of tasks to plan with");
}

}  // namespace

void addAgreement(CLI::App& program) {
  auto arguments = std::make_shared<AgreementArguments>();
  CLI::App* command = program.add_subcommand(
      "agreement", "How well raters agree: ICC, Krippendorff, kappa, Bland-Altman, Rasch, generalizability");
  command->add_option("--ratings", arguments->file, "CSV with the columns target,rater,score")->required();
  addDefaulted(*command, "--method", arguments->method,
               "What to compute; the overview has the usual coefficients", CLI::IsMember(kMethods));
  addMethodOptions(*command, arguments->options);
  command->callback([arguments, command] {
    requireOptionsOfMethod(*command, arguments->method);
    runAgreement(*arguments);
  });
}

}  // namespace torsio::cli
