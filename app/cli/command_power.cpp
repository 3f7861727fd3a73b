// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "assessment/statistics/power.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

struct PowerArguments {
  std::string test;
  std::optional<double> n;
  std::optional<double> effect;
  std::optional<double> power;
  std::optional<double> correlation;
  double alpha = kDefaultAlpha;
  int groups = 3;
  std::optional<double> icc;
  std::optional<double> width;
  int raters = 2;
};

/// Three questions about one test: size, power and effect each follow from the other two.
struct Design {
  std::string effectName;
  std::function<double(double n, double effect)> power;
  std::function<double(double effect, double power)> size;
  std::function<double(double n, double power)> detectable;
};

Design designOf(const PowerArguments& arguments) {
  const double alpha = arguments.alpha;
  if (arguments.test == "t") {
    return {"cohen_d", [=](double n, double d) { return powerTwoSampleT(n, d, alpha); },
            [=](double d, double power) { return sizeTwoSampleT(d, power, alpha); },
            [=](double n, double power) { return detectableTwoSampleT(n, power, alpha); }};
  }
  if (arguments.test == "paired-t") {
    return {"cohen_dz", [=](double n, double d) { return powerPairedT(n, d, alpha); },
            [=](double d, double power) { return sizePairedT(d, power, alpha); },
            [=](double n, double power) { return detectablePairedT(n, power, alpha); }};
  }
  const int groups = arguments.groups;
  return {"cohen_f", [=](double n, double f) { return powerAnova(groups, n, f, alpha); },
          [=](double f, double power) { return sizeAnova(groups, f, power, alpha); },
          [=](double n, double power) { return detectableAnova(groups, n, power, alpha); }};
}

void requireTwoOfThree(const PowerArguments& arguments) {
  const int given = (arguments.n ? 1 : 0) + (arguments.effect ? 1 : 0) + (arguments.power ? 1 : 0);
  if (given != 2) {
    refuseUsage("one of size, effect and power follows from the other two", "power --test " + arguments.test,
                "Give exactly two of --n, --effect and --power");
  }
  if (arguments.power && *arguments.power <= arguments.alpha) {
    refuseParameter(Text::verbatim("a power up to alpha needs no trainees"), Text::verbatim("--power"),
                    "Give a power above " + Json(arguments.alpha).dump() + ", for example 0.8");
  }
}

/// Adds a size as computed, and rounded up to whole trainees.
void addSize(Json& out, const std::string& name, double size) {
  out[name] = size;
  out[name + "_needed"] = static_cast<std::int64_t>(std::ceil(size));
}

Json questionJson(const PowerArguments& arguments) {
  requireTwoOfThree(arguments);
  const Design design = designOf(arguments);
  const char* wanted = !arguments.n ? "n" : !arguments.effect ? "effect" : "power";
  const double n = arguments.n ? *arguments.n : design.size(*arguments.effect, *arguments.power);
  const double effect = arguments.effect ? *arguments.effect : design.detectable(n, *arguments.power);
  const double power = arguments.power ? *arguments.power : design.power(n, effect);
  Json out{{"test", arguments.test}, {"wanted", wanted}};
  if (arguments.n) {
    out["n"] = n;
  } else {
    addSize(out, "n", n);
  }
  out["effect"] = {{"name", design.effectName}, {"value", effect}};
  out["power"] = power;
  out["alpha"] = arguments.alpha;
  if (arguments.test == "anova") {
    out["groups"] = arguments.groups;
  }
  if (arguments.correlation) {
    addSize(out, "n_with_covariate", sizeWithCovariate(n, *arguments.correlation));
  }
  return out;
}

Json intraclassJson(const PowerArguments& arguments) {
  if (!arguments.icc || !arguments.width) {
    throw Error(
        ErrorCode::kUsage,
        Text::verbatim("the size of a study of agreement needs the ICC and the width of its interval"),
        Text::verbatim("power --test icc"), Text::verbatim("Give --icc and --width"));
  }
  Json out{{"test", "icc"}, {"wanted", "targets"}};
  addSize(out, "targets", sizeIccWidth(*arguments.icc, arguments.raters, *arguments.width));
  out["icc"] = *arguments.icc;
  out["raters"] = arguments.raters;
  out["width"] = *arguments.width;
  out["confidence"] = kDefaultConfidence;
  return out;
}

/// Rejects options that would be silently ignored.
void requireOptionsThatCount(const CLI::App& command, const PowerArguments& arguments) {
  const auto refuse = [&](const char* name, bool counts, const char* owner) {
    if (command.count(name) > 0 && !counts) {
      refuseUsage(std::string(name) + " does not belong to this question", "power --test " + arguments.test,
                  std::string("Use it with ") + owner + ", or leave it out");
    }
  };
  const bool icc = arguments.test == "icc";
  for (const char* name : {"--n", "--effect", "--power", "--alpha"}) {
    refuse(name, !icc, "t, paired-t or anova");
  }
  for (const char* name : {"--icc", "--raters", "--width"}) {
    refuse(name, icc, "icc");
  }
  refuse("--groups", arguments.test == "anova", "anova");
  refuse("--correlation", !arguments.n && (arguments.test == "t" || arguments.test == "anova"),
         "t or anova when the size is wanted");
}

}  // namespace

void addPower(CLI::App& program) {
  auto arguments = std::make_shared<PowerArguments>();
  CLI::App* command =
      program.add_subcommand("power", "How many trainees a study needs, or what it can detect");
  command->add_option("--test", arguments->test, "t, paired-t, anova or icc")
      ->check(CLI::IsMember({"t", "paired-t", "anova", "icc"}))
      ->required();
  command->add_option("--n", arguments->n, "Trainees in each group, or pairs")->check(CLI::Range(2.0, 1e5));
  command->add_option("--effect", arguments->effect, "Cohen's d, d of the differences, or f")
      ->check(CLI::Range(0.01, 20.0));
  command->add_option("--power", arguments->power, "Chance of finding the effect")
      ->check(CLI::Range(0.001, 0.9999));
  addDefaulted(*command, "--alpha", arguments->alpha, "Two-sided level of the test", CLI::Range(1e-6, 0.5));
  addDefaulted(*command, "--groups", arguments->groups, "anova: number of groups", CLI::Range(2, 100));
  command
      ->add_option("--correlation", arguments->correlation,
                   "Correlation of the scores before and after: size of an analysis of covariance")
      ->check(CLI::Range(-0.999, 0.999));
  command->add_option("--icc", arguments->icc, "icc: the expected coefficient")
      ->check(CLI::Range(0.0, 0.999));
  addDefaulted(*command, "--raters", arguments->raters, "icc: raters per target", CLI::Range(2, 1000));
  command->add_option("--width", arguments->width, "icc: wanted width of the 95 % interval")
      ->check(CLI::Range(0.001, 1.0));
  command->callback([arguments, command] {
    requireOptionsThatCount(*command, *arguments);
    printJson(arguments->test == "icc" ? intraclassJson(*arguments) : questionJson(*arguments));
  });
}

}  // namespace torsio::cli
