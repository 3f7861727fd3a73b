// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/base/csv_table.h"
#include "app/services/base/name_places.h"
#include "assessment/attempt/competence.h"
#include "assessment/statistics/curve_fit.h"
#include "assessment/statistics/cusum.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/standard_setting.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

struct LearningArguments {
  std::string file;
  CompetenceDesign design;  ///< as in torsio competence
  std::optional<double> limit;
  std::optional<double> target;
  std::optional<double> sigma;
  double h = 5.0;
  std::optional<double> threshold;
  std::string better = "lower";
  std::size_t consecutive = 2;
  std::size_t further = 0;
};

constexpr std::int64_t kMaxAttempts = 100'000;
constexpr std::size_t kMaxWatched = 10'000;  // attempts for which the relapse monitoring is computed
constexpr double kDefaultReference = 0.5;    // k of the tabular CUSUM, in sigma

/// Attempts of one subject, in order.
struct Attempts {
  std::string subject;
  std::map<std::int64_t, std::size_t> rowOf;  // attempt -> row
};

std::vector<Attempts> readAttempts(const CsvTable& table) {
  std::vector<Attempts> list;
  NamePlaces subjects;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = table.text(row, "subject");
    const std::int64_t attempt = table.whole(row, "attempt", 1, kMaxAttempts);
    const std::size_t place = subjects(name);
    if (place == list.size()) {
      list.push_back({name, {}});
    }
    const auto [first, isNew] = list[place].rowOf.emplace(attempt, row);
    if (!isNew) {
      table.refuse(row,
                   "attempt " + std::to_string(attempt) + " of subject \"" + name +
                       "\" is given a second time, first in " + table.where(first->second),
                   Text::verbatim("Keep one value for each subject and attempt"));
    }
  }
  return list;
}

std::optional<bool> failedAt(const CsvTable& table, std::size_t row) {
  const std::string& text = table.cell(row, "value");
  if (text == "pass") {
    return false;
  }
  if (text == "fail") {
    return true;
  }
  return std::nullopt;
}

/// True if the table contains pass and fail; throws if it contains both kinds of scores.
bool holdsOutcomes(const CsvTable& table) {
  const bool outcomes = failedAt(table, 0).has_value();
  for (std::size_t row = 1; row < table.rows(); ++row) {
    if (failedAt(table, row).has_value() != outcomes) {
      table.refuse(row,
                   "value \"" + table.cell(row, "value") + "\" stands among " +
                       (outcomes ? "pass and fail" : "numbers"),
                   Text::verbatim("Give either numbers or pass and fail in the whole column"));
    }
  }
  return outcomes;
}

Json curveJson(LearningFamily family, const std::vector<double>& t, const std::vector<double>& y) {
  return outcomeJson(fitLearningCurve(family, t, y), [&](const LearningCurve& curve) {
    Json out{{"asymptote", curve.asymptote}, {"gain", curve.gain}, {"rate", curve.rate}};
    const std::vector<double>& errors = curve.fit.errors;
    const std::size_t shift = curve.asymptoteAtZero ? 1 : 0;
    out["asymptote_error"] =
        curve.asymptoteAtZero ? undefinedJson("the asymptote is held at its bound 0") : Json(errors[0]);
    out["gain_error"] = errors[1 - shift];
    out["rate_error"] = errors[2 - shift];
    out["asymptote_at_zero"] = curve.asymptoteAtZero;
    out["rss"] = curve.fit.rss;
    out["sigma"] = curve.fit.sigma;
    out["aicc"] = curve.fit.aicc;
    out["band"] = Json::array();
    const std::vector<Interval> band = learningBand(curve, t);
    for (std::size_t i = 0; i < t.size(); ++i) {
      out["band"].push_back({{"attempt", static_cast<std::int64_t>(t[i])},
                             {"value", learningCurveAt(curve, t[i])},
                             {"lower", band[i].lower},
                             {"upper", band[i].upper}});
    }
    return out;
  });
}

/// `runLength`: common to all subjects.
Json tabularJson(const LearningArguments& arguments, const std::vector<double>& y, const Json& runLength) {
  if (const std::optional<Text> reason =
          beyondArithmetic(y, std::array{*arguments.target, *arguments.sigma, arguments.h})) {
    return undefinedJson(reason->str());
  }
  const TabularCusum cusum = tabularCusum(y, *arguments.target, kDefaultReference * *arguments.sigma,
                                          arguments.h * *arguments.sigma);
  Json out{{"upper", Json::array()}, {"lower", Json::array()}};
  for (const TabularCusumPoint& point : cusum.points) {
    out["upper"].push_back(point.upper);
    out["lower"].push_back(point.lower);
  }
  out["first_signal"] = cusum.firstSignal ? Json(*cusum.firstSignal) : undefinedJson("there is no signal");
  out["average_run_length"] = runLength;
  return out;
}

/// Returns the attempt by which proficiency was shown: so many in a row, and so many more after these.
Json proficiencyJson(const LearningArguments& arguments, const std::vector<double>& t,
                     const std::vector<double>& y) {
  const Better better = arguments.better == "lower" ? Better::kLower : Better::kHigher;
  const auto at = proficientAt(y, *arguments.threshold, better, arguments.consecutive, arguments.further);
  return at ? Json(static_cast<std::int64_t>(t[*at - 1])) : undefinedJson("proficiency was not reached");
}

Json valuesJson(const LearningArguments& arguments, const CsvTable& table,
                const std::vector<Attempts>& subjects) {
  Json list = Json::array();
  const Json runLength = arguments.target
                             ? numberJson(averageRunLengthTwoSided(kDefaultReference, arguments.h, 0.0),
                                          "it is longer than 1e12 values")
                             : Json();
  for (const Attempts& subject : subjects) {
    std::vector<double> t;
    std::vector<double> y;
    for (const auto& [attempt, row] : subject.rowOf) {
      t.push_back(static_cast<double>(attempt));
      y.push_back(table.number(row, "value"));
    }
    Json entry{{"subject", subject.subject}, {"attempts", y.size()}};
    entry["power"] = curveJson(LearningFamily::kPower, t, y);
    entry["exponential"] = curveJson(LearningFamily::kExponential, t, y);
    const bool both = entry["power"].contains("aicc") && entry["exponential"].contains("aicc");
    entry["better_by_aicc"] =
        !both ? undefinedJson("it requires a fit of both families")
              : Json(entry["power"]["aicc"].get<double>() < entry["exponential"]["aicc"].get<double>()
                         ? "power"
                         : "exponential");
    entry["log_log"] = outcomeJson(logLogLine(t, y), [](const LogLogLine& line) {
      return Json{{"intercept", line.intercept},
                  {"slope", line.slope},
                  {"rate_per_doubling", line.ratePerDoubling},
                  {"r_squared", line.rSquared}};
    });
    if (arguments.target) {
      entry["cusum"] = tabularJson(arguments, y, runLength);
    }
    if (arguments.threshold) {
      entry["proficient_at"] = proficiencyJson(arguments, t, y);
      const auto byChance = [&](double failureRate) {
        return proficientProbability(1.0 - failureRate, y.size(), arguments.consecutive, arguments.further);
      };
      entry["proficient_if_adequate"] = byChance(arguments.design.adequate);
      entry["proficient_if_inadequate"] = byChance(arguments.design.inadequate);
    }
    list.push_back(std::move(entry));
  }
  return {{"kind", "values"}, {"subjects", list}};
}

/// Returns the outcomes of attempts 1, 2, 3 ...; a CUSUM allows no gaps.
std::vector<bool> outcomesOf(const CsvTable& table, const Attempts& subject) {
  std::vector<bool> failed;
  for (const auto& [attempt, row] : subject.rowOf) {
    if (attempt != std::ssize(failed) + 1) {
      table.refuse(row,
                   "subject \"" + subject.subject + "\" has attempt " + std::to_string(attempt) +
                       " but no attempt " + std::to_string(failed.size() + 1),
                   Text::verbatim("Number the attempts 1, 2, 3 ... without gaps"));
    }
    failed.push_back(failedAt(table, row).value_or(false));
  }
  return failed;
}

Json outcomeSubjectJson(const LearningArguments& arguments, const LcCusumDesign& design,
                        const std::string& name, const std::vector<bool>& failed) {
  Json entry{{"subject", name}, {"attempts", failed.size()}};
  entry["failures"] = std::count(failed.begin(), failed.end(), true);
  const BinaryCusum cusum = binaryCusum(failed, arguments.design.adequate, arguments.design.inadequate,
                                        arguments.design.falsePassMost, arguments.design.falseFailMost);
  entry["cusum"] = {{"s", cusum.s}, {"h0", cusum.h0}, {"h1", cusum.h1}, {"sums", cusum.sums}};
  const LcCusum learning = lcCusum(failed, design);
  Json lc{{"success_weight", learning.successWeight},
          {"failure_weight", learning.failureWeight},
          {"sums", learning.sums}};
  const std::string never = "competence was not reached";
  lc["competent_at"] = learning.competentAt ? Json(*learning.competentAt) : undefinedJson(never);
  entry["lc_cusum"] = std::move(lc);
  if (!learning.competentAt) {
    entry["relapse"] = undefinedJson(never);
    return entry;
  }
  const std::vector<bool> later(failed.begin() + static_cast<std::ptrdiff_t>(*learning.competentAt),
                                failed.end());
  const RelapseWatch watch = watchForRelapse(later, design);
  entry["relapse"] = {{"sums", watch.sums},
                      {"alarm_at", watch.alarmAt ? Json(*learning.competentAt + *watch.alarmAt)
                                                 : undefinedJson("there is no alarm")}};
  return entry;
}

Json outcomesJson(const LearningArguments& arguments, const CsvTable& table,
                  const std::vector<Attempts>& subjects) {
  std::vector<std::vector<bool>>
      failed;  // read first, so that an invalid table is reported before anything else
  std::size_t longest = 0;
  for (const Attempts& subject : subjects) {
    failed.push_back(outcomesOf(table, subject));
    longest = std::max(longest, failed.back().size());
  }
  LcCusumDesign design = cusumOf(arguments.design);
  const std::optional<double> limit =
      arguments.limit ? arguments.limit : chooseLcCusumLimit(design, longest, arguments.design.falsePassMost);
  if (!limit) {
    refuse("no limit keeps the false pass rate below " + std::to_string(arguments.design.falsePassMost) +
               " in so few attempts",
           table.name(), Text::verbatim("Record more attempts, or give --limit or a larger --false-pass"));
  }
  design.limit = *limit;
  Json out{{"kind", "pass/fail"}};
  out["design"] = {{"adequate", design.adequate},
                   {"inadequate", design.inadequate},
                   {"limit", design.limit},
                   {"limit_chosen", !arguments.limit.has_value()},
                   {"session_correlation", design.dependence.session},
                   {"lag_correlation", design.dependence.lag},
                   {"runs_per_session", design.dependence.perSession},
                   {"attempts", longest},
                   {"pass_if_adequate", lcCusumProbability(design, design.adequate, longest)},
                   {"pass_if_inadequate", lcCusumProbability(design, design.inadequate, longest)},
                   {"not_able_in_the_end_if_adequate",
                    longest <= kMaxWatched ? Json(lcCusumNotAble(design, design.adequate, longest))
                                           : undefinedJson("it is computed for at most 10,000 attempts")}};
  out["subjects"] = Json::array();
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    out["subjects"].push_back(outcomeSubjectJson(arguments, design, subjects[i].subject, failed[i]));
  }
  return out;
}

void runLearning(const LearningArguments& arguments) {
  requireSoundNumbers(arguments.design);
  if (arguments.target.has_value() != arguments.sigma.has_value()) {
    refuseUsage("a CUSUM of values needs both --target and --sigma", "learning", "Give both or none");
  }
  const CsvTable table = CsvTable::read(arguments.file, {"subject", "attempt", "value"});
  noteTable(table);
  const std::vector<Attempts> subjects = readAttempts(table);
  printJson(holdsOutcomes(table) ? outcomesJson(arguments, table, subjects)
                                 : valuesJson(arguments, table, subjects));
}

void addProficiency(CLI::App& command, LearningArguments& arguments) {
  command.add_option("--threshold", arguments.threshold, "Values: standard that a proficient trainee meets");
  addDefaulted(command, "--better", arguments.better,
               "Values: whether lower or higher values meet the standard",
               CLI::IsMember({"lower", "higher"}));
  addDefaulted(command, "--consecutive", arguments.consecutive,
               "Values: attempts in a row that meet the standard", CLI::Range(1, 1000));
  addDefaulted(command, "--further", arguments.further,
               "Values: attempts after these that meet it, not in a row", CLI::Range(0, 1000));
}

}  // namespace

void addLearning(CLI::App& program) {
  auto arguments = std::make_shared<LearningArguments>();
  CLI::App* command =
      program.add_subcommand("learning", "Learning curves of values; CUSUM and LC-CUSUM of pass and fail");
  command->add_option("FILE", arguments->file, "CSV: subject,attempt,value with numbers or pass and fail")
      ->required();
  addDesignOptions(*command, arguments->design);
  command->add_option("--limit", arguments->limit, "Limit h of the LC-CUSUM instead of the chosen one")
      ->check(CLI::Range(0.01, 100.0));
  command->add_option("--target", arguments->target, "Values: target of a tabular CUSUM");
  command->add_option("--sigma", arguments->sigma, "Values: standard deviation in control")
      ->check(CLI::PositiveNumber);
  addDefaulted(*command, "--cusum-limit", arguments->h, "Values: limit of the CUSUM in sigma",
               CLI::PositiveNumber);
  addProficiency(*command, *arguments);
  command->callback([arguments, command] {
    for (const char* name : {"--better", "--consecutive", "--further"}) {
      if (command->count(name) > 0 && !arguments->threshold) {
        refuseUsage(std::string(name) + " belongs to a threshold", "learning", "Give --threshold too");
      }
    }
    runLearning(*arguments);
  });
}

}  // namespace torsio::cli
