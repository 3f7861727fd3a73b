// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/comparison_methods.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/base/csv_table.h"
#include "assessment/statistics/descriptive.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

struct CompareArguments {
  std::string file;
  std::string occasion;
  std::string covariate;
  std::optional<double> margin;
  std::optional<double> lowest;
  std::optional<double> highest;
  bool residuals = false;
  std::string adjust = "holm";
  std::string paired;     ///< empty: compare groups
  std::string bootstrap;  ///< empty: none
  BootstrapRequest request;
};

const std::map<std::string, Adjustment> kAdjustments = {
    {"holm", Adjustment::kHolm},
    {"hochberg", Adjustment::kHochberg},
    {"bonferroni", Adjustment::kBonferroni},
    {"benjamini-hochberg", Adjustment::kBenjaminiHochberg}};
const std::map<std::string, PairedTest> kPairedTests = {{"t", PairedTest::kT},
                                                        {"signed-rank", PairedTest::kSignedRank},
                                                        {"permutation", PairedTest::kPermutation},
                                                        {"friedman", PairedTest::kFriedman}};

Json groupsJson(const Study& study, const Groups& groups) {
  Json out = Json::array();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    Json entry{{"group", study.groups[g]}, {"n", groups[g].size()}};
    if (const std::optional<Text> reason = beyondArithmetic(groups[g])) {
      entry["mean"] = undefinedJson(reason->str());
      entry["sd"] = undefinedJson(reason->str());
      entry["interval"] = undefinedJson(reason->str());
    } else {
      entry["mean"] = groups[g].empty() ? undefinedJson("nobody has a score") : Json(meanOf(groups[g]));
      entry["sd"] = numberJson(sampleDeviation(groups[g]), "fewer than two scores");
      const std::optional<Interval> interval = meanInterval(groups[g]);
      entry["interval"] = interval ? intervalJson(*interval) : undefinedJson("fewer than two scores");
    }
    out.push_back(std::move(entry));
  }
  return out;
}

/// Prints the --paired tests: the same subjects at two or more occasions.
void comparePaired(const CompareArguments& arguments) {
  const CsvTable table = CsvTable::read(arguments.file, {"subject", "occasion", "score"}, {"group", "rater"});
  noteTable(table);
  const Study study = readStudy(table);
  if (study.occasions.size() < 2) {
    refuse(Text::verbatim("a paired comparison needs two occasions"), table.name(),
           Text::verbatim("Give the scores of at least two occasions"));
  }
  Json out{{"paired", arguments.paired}};
  out["groups"] = pairedJson(study, kPairedTests.at(arguments.paired), arguments.request.seed);
  if (!arguments.bootstrap.empty()) {
    out["bootstrap"] = bootstrapJson(study.groups, gainsOf(study), arguments.request);
  }
  out["occasions"] = study.occasions;
  out["confidence"] = kDefaultConfidence;
  printJson(out);
}

std::string occasionOr(const Study& study, const CsvTable& table, const std::string& wanted,
                       const std::string& otherwise, const char* option) {
  if (wanted.empty()) {
    return otherwise;
  }
  if (std::find(study.occasions.begin(), study.occasions.end(), wanted) == study.occasions.end()) {
    refuseParameter("the table has no occasion \"" + wanted + "\"", table.name(),
                    Text::verbatim("Give one of its occasions after %1", option));
  }
  return wanted;
}

/// Returns the compared occasion and the covariate. Both are printed, as confusing them reverses the result.
CovarianceRequest covarianceRequest(const CompareArguments& arguments, const Study& study,
                                    const CsvTable& table) {
  CovarianceRequest request;
  request.outcome = occasionOr(study, table, arguments.occasion, study.occasions.back(), "--occasion");
  request.covariate = occasionOr(study, table, arguments.covariate, study.occasions.front(), "--covariate");
  request.margin = arguments.margin;
  request.residuals = arguments.residuals;
  if (arguments.lowest) {
    if (!(*arguments.lowest < *arguments.highest)) {
      refuseParameter(Text::verbatim("the lowest mark is not below the highest"),
                      Text::verbatim("compare-groups"),
                      Text::verbatim("Give for example --lowest 1 --highest 10"));
    }
    request.scale = Interval{*arguments.lowest, *arguments.highest};
  }
  if (!arguments.covariate.empty() && request.covariate == request.outcome) {
    refuseParameter("the scores at \"" + request.outcome + "\" cannot adjust themselves", table.name(),
                    Text::verbatim("Give two occasions after --occasion and --covariate"));
  }
  if (arguments.covariate.empty() && study.occasions.size() > 1 && request.covariate != request.outcome) {
    std::cerr << "torsio: " << table.name() << ": \"" << request.outcome << "\" is adjusted for \""
              << request.covariate << "\", the first occasion of the file; --covariate names another\n";
  }
  return request;
}

void compareGroups(const CompareArguments& arguments) {
  const CsvTable table = CsvTable::read(arguments.file, {"subject", "group", "score"}, {"occasion", "rater"});
  noteTable(table);
  const Study study = readStudy(table);
  const CovarianceRequest request = covarianceRequest(arguments, study, table);
  const Groups groups = scoresAt(study, request.outcome);
  Json out;
  addGroupTests(out, study.groups, groups,
                {kAdjustments.at(arguments.adjust), arguments.margin, arguments.request.seed});
  if (study.occasions.size() > 1) {
    const bool adjustable = request.covariate != request.outcome;
    const std::string reason = "the compared occasion is the first one: give another with --covariate";
    out["ancova"] = adjustable ? ancovaJson(study, request) : undefinedJson(reason);
    if (table.has("rater")) {
      out["mixed_model"] = adjustable ? mixedModelJson(study, request) : undefinedJson(reason);
    }
    out["mixed_anova"] = mixedAnovaJson(study);
  }
  if (!arguments.bootstrap.empty()) {
    out["bootstrap"] = bootstrapJson(study.groups, groups, arguments.request);
  }
  out["groups"] = groupsJson(study, groups);
  if (table.has("occasion")) {
    out["occasions"] = study.occasions;
    out["occasion"] = request.outcome;
  }
  out["confidence"] = kDefaultConfidence;
  printJson(out);
}

/// Rejects options that would be silently ignored.
void requireOptionsThatCount(const CLI::App& command) {
  for (const char* name : {"--resamples", "--every-resample"}) {
    if (command.count(name) > 0 && command.count("--bootstrap") == 0) {
      refuseUsage(std::string(name) + " belongs to a bootstrap", "compare-groups",
                  "Give --bootstrap mean or --bootstrap median too");
    }
  }
  for (const char* name :
       {"--occasion", "--covariate", "--margin", "--lowest", "--highest", "--residuals", "--adjust"}) {
    if (command.count(name) > 0 && command.count("--paired") > 0) {
      refuseUsage(std::string(name) + " belongs to a comparison between groups", "compare-groups --paired",
                  "Leave one of the two out");
    }
  }
}

void addResampling(CLI::App& command, CompareArguments& arguments) {
  command
      .add_option("--bootstrap", arguments.bootstrap,
                  "Bootstrap intervals of the mean or median of each group; with --paired of the gains")
      ->check(CLI::IsMember({"mean", "median"}));
  addDefaulted(command, "--resamples", arguments.request.resamples, "Resamples of the bootstrap",
               CLI::Range(99, 1'000'000));
  addDefaulted(command, "--seed", arguments.request.seed,
               "Seed of the bootstrap, and of random permutations");
  command.add_flag("--every-resample", arguments.request.everyResample,
                   "All resamples instead of random ones: up to seven subjects");
}

}  // namespace

void addCompareGroups(CLI::App& program) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command =
      program.add_subcommand("compare-groups", "Tests and effect sizes between groups and occasions");
  command->add_option("FILE", arguments->file, "CSV: subject,group,score and optionally occasion,rater")
      ->required();
  command->add_option("--occasion", arguments->occasion,
                      "Occasion at which the groups are compared; default: the last of the file");
  command->add_option("--covariate", arguments->covariate,
                      "Occasion whose scores adjust the comparison; default: the first of the file");
  command
      ->add_option("--margin", arguments->margin,
                   "Largest difference that does not matter: tests equivalence, in the unit of the scores")
      ->check(CLI::PositiveNumber);
  auto* lowest = command->add_option("--lowest", arguments->lowest,
                                     "Lowest mark of the scale, for bounds on the effect of missing marks");
  auto* highest = command->add_option("--highest", arguments->highest, "Highest mark of the scale");
  lowest->needs(highest);
  highest->needs(lowest);
  command->add_flag("--residuals", arguments->residuals,
                    "Adds each subject's residual of the analysis of covariance, for plots");
  addDefaulted(*command, "--adjust", arguments->adjust,
               "Adjustment of p over the pairs of more than two groups", CLI::IsMember(kAdjustments));
  command
      ->add_option("--paired", arguments->paired,
                   "Compare occasions of the same subjects, last against first; friedman: all occasions")
      ->check(CLI::IsMember(kPairedTests));
  addResampling(*command, *arguments);
  command->callback([arguments, command] {
    requireOptionsThatCount(*command);
    arguments->request.median = arguments->bootstrap == "median";
    if (arguments->paired.empty()) {
      compareGroups(*arguments);
    } else {
      comparePaired(*arguments);
    }
  });
}

}  // namespace torsio::cli
