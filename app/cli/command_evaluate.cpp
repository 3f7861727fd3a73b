// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <charconv>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/options.h"
#include "app/services/base/csv_table.h"
#include "assessment/scoring/evaluation.h"
#include "assessment/scoring/evaluation_resampling.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

struct EvaluateArguments {
  std::string ratings;
  std::vector<std::string> weights;
  std::vector<std::string> classWeights;
  std::string policy = "available";
  std::int64_t lowest = 0;
  std::int64_t highest = 10;
  std::int64_t stepsPerPoint = 10;
  std::int64_t resamples = 0;
  std::uint64_t seed = 1;
  bool scaleConfirmed = false;
};

/// Parses "0.15" or "name=0.15"; the name is empty if missing.
std::pair<std::string, double> namedWeight(const std::string& text, const std::string& option) {
  const std::size_t sign = text.rfind('=');
  const std::string name = sign == std::string::npos ? "" : text.substr(0, sign);
  const std::string digits = sign == std::string::npos ? text : text.substr(sign + 1);
  double weight = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), weight);
  if (error != std::errc() || end != digits.data() + digits.size()) {
    refuseUsage("\"" + text + "\" is not a weight", option,
                "Give weights such as 0.2,0.3,0.5 or A=0.2,B=0.3,C=0.5");
  }
  return {name, weight};
}

/// Returns the weights in the given order with their names; all named or none.
std::vector<std::pair<std::string, std::int64_t>> weightList(const std::vector<std::string>& texts,
                                                             const std::string& option) {
  std::vector<std::string> names;
  std::vector<double> weights;
  for (const std::string& text : texts) {
    const auto [name, weight] = namedWeight(text, option);
    names.push_back(name);
    weights.push_back(weight);
  }
  const auto unnamed = std::count(names.begin(), names.end(), "");
  if (unnamed != 0 && unnamed != std::ssize(names)) {
    refuseUsage("some weights have a name and some have none", option, "Name all of them or none");
  }
  std::vector<std::pair<std::string, std::int64_t>> list;
  const std::vector<std::int64_t> milli = weightsInMilli(weights);
  for (std::size_t i = 0; i < names.size(); ++i) {
    list.emplace_back(names[i], milli[i]);
  }
  return list;
}

/// Returns the paper's instrument, modified by the options. Unnamed weights in another number create indices
/// 1, 2, 3 ... and classes A, B, C ...
EvaluationInstrument instrumentOf(const EvaluateArguments& arguments) {
  EvaluationInstrument instrument = paperInstrument();
  instrument.scale = {arguments.lowest * arguments.stepsPerPoint, arguments.highest * arguments.stepsPerPoint,
                      arguments.stepsPerPoint};
  if (!arguments.weights.empty()) {
    const auto weights = weightList(arguments.weights, "--weights");
    const bool keepIds = weights.size() == instrument.indices.size() && weights[0].first.empty();
    if (!keepIds) {
      instrument.indices.assign(weights.size(), {});
    }
    for (std::size_t i = 0; i < weights.size(); ++i) {
      EvaluationIndex& index = instrument.indices[i];
      if (!keepIds) {
        index.id = weights[i].first.empty() ? std::to_string(i + 1) : weights[i].first;
      }
      if (!keepIds) {
        index.name = index.id;
      }
      index.weight_milli = weights[i].second;
    }
  }
  if (!arguments.classWeights.empty()) {
    const auto weights = weightList(arguments.classWeights, "--class-weights");
    const bool keepIds = weights.size() == instrument.classes.size() && weights[0].first.empty();
    if (!keepIds) {
      instrument.classes.assign(weights.size(), {});
    }
    constexpr std::size_t kLetters = 26;
    if (weights.size() > kLetters) {
      refuseParameter(Text::verbatim("there are more than 26 rater classes"),
                      Text::verbatim("--class-weights"), Text::verbatim("Give fewer classes"));
    }
    for (std::size_t c = 0; c < weights.size(); ++c) {
      RaterClass& raterClass = instrument.classes[c];
      const std::string letter(1, static_cast<char>('A' + c));
      if (!keepIds) {
        raterClass.id = weights[c].first.empty() ? letter : weights[c].first;
      }
      if (!keepIds) {
        raterClass.name = raterClass.id;
      }
      raterClass.weight_milli = weights[c].second;
    }
  }
  validateInstrument(instrument);
  return instrument;
}

/// Returns the position of the item with this id or name.
template <class Item>
std::optional<std::size_t> named(const std::vector<Item>& items, const std::string& text) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (items[i].id == text || items[i].name == text) {
      return i;
    }
  }
  return std::nullopt;
}

/// Returns the position of an item given by number, from 1.
std::optional<std::size_t> numbered(std::size_t count, const std::string& text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 1 || number > count) {
    return std::nullopt;
  }
  return number - 1;
}

/// Reads the marks and remembers how the file spells each index, so that the output uses the same words.
class MarkReader {
 public:
  MarkReader(const CsvTable& table, const EvaluationInstrument& instrument)
      : table_(table), instrument_(instrument), spelling_(instrument.indices.size()) {}

  std::vector<EvaluationRating> read() {
    std::vector<EvaluationRating> ratings;
    for (std::size_t row = 0; row < table_.rows(); ++row) {
      ratings.push_back(readRow(row));
    }
    return ratings;
  }

  /// Throws at the line of a missing score that the policy forbids. A rater without a line for an index is
  /// left to the evaluation. `ratings`: from read().
  void requireScores(const std::vector<EvaluationRating>& ratings, MissingPolicy policy) const {
    if (policy == MissingPolicy::kRefuse) {
      for (std::size_t row = 0; row < ratings.size(); ++row) {
        if (!ratings[row].steps) {
          table_.refuse(row,
                        "rater \"" + ratings[row].rater + "\" gave no score for index \"" +
                            table_.cell(row, "index") + "\" of model \"" + ratings[row].model + "\"",
                        Text::verbatim("Complete the ratings or choose another --policy for missing ones"));
        }
      }
    } else if (policy == MissingPolicy::kAvailableCase) {
      requireScoreOfEachClass(ratings);
    } else if (policy == MissingPolicy::kListWise) {
      requireWholeRater(ratings);
    }
  }

  [[nodiscard]] Json indexJson(std::size_t index) const {
    const std::string& text = spelling_[index];
    if (text.empty()) {
      return instrument_.indices[index].id;
    }
    return numbered(instrument_.indices.size(), text) ? Json(index + 1) : Json(text);
  }

 private:
  void requireScoreOfEachClass(const std::vector<EvaluationRating>& ratings) const {
    // model, class, index -> its first line, unless one has a score
    std::map<std::tuple<std::string, std::size_t, std::size_t>, std::optional<std::size_t>> without;
    for (std::size_t row = 0; row < ratings.size(); ++row) {
      const EvaluationRating& rating = ratings[row];
      const auto place =
          without.emplace(std::tuple{rating.model, rating.raterClass, rating.index}, row).first;
      if (rating.steps || instrument_.classes[rating.raterClass].weight_milli == 0) {
        place->second.reset();
      }
    }
    std::optional<std::size_t> first;
    for (const auto& [of, row] : without) {
      if (row && (!first || *row < *first)) {
        first = row;
      }
    }
    if (first) {
      table_.refuse(*first,
                    "class " + instrument_.classes[ratings[*first].raterClass].id +
                        " has no ratings for index \"" + table_.cell(*first, "index") + "\" of model \"" +
                        ratings[*first].model + "\": each of its scores is missing, this one first",
                    Text::verbatim("Collect the ratings, or choose --policy renormalise"));
    }
  }

  void requireWholeRater(const std::vector<EvaluationRating>& ratings) const {
    struct Sheet {
      std::size_t scores = 0;
      std::optional<std::size_t> firstEmpty;
    };
    std::map<std::pair<std::string, std::size_t>, std::map<std::string, Sheet>>
        classes;  // model, class; rater
    for (std::size_t row = 0; row < ratings.size(); ++row) {
      const EvaluationRating& rating = ratings[row];
      Sheet& sheet = classes[{rating.model, rating.raterClass}][rating.rater];
      sheet.scores += rating.steps ? 1 : 0;
      if (!rating.steps && !sheet.firstEmpty) {
        sheet.firstEmpty = row;
      }
    }
    for (const auto& [of, raters] : classes) {
      const auto& [model, raterClass] = of;
      std::optional<std::size_t> first;
      for (const auto& [rater, sheet] : raters) {
        if (sheet.scores == instrument_.indices.size()) {
          first.reset();
          break;
        }
        if (sheet.firstEmpty && (!first || *sheet.firstEmpty < *first)) {
          first = sheet.firstEmpty;
        }
      }
      if (first && instrument_.classes[raterClass].weight_milli > 0) {
        table_.refuse(*first,
                      "class " + instrument_.classes[raterClass].id +
                          " has no rater with every score of model \"" + model + "\"; here one is missing",
                      Text::verbatim("Collect the ratings, or choose another --policy"));
      }
    }
  }

  EvaluationRating readRow(std::size_t row) {
    EvaluationRating rating;
    rating.model = table_.text(row, "model");
    rating.rater = table_.text(row, "rater");
    rating.raterClass = classAt(row);
    rating.index = indexAt(row);
    if (!table_.cell(row, "score").empty()) {
      (void)table_.number(row, "score");  // reports text, NaN and decimal commas
      rating.steps = stepsFromText(table_.cell(row, "score"), instrument_.scale, table_.where(row));
    }
    const auto [first, isNew] = seen_.emplace(std::tuple{rating.model, rating.rater, rating.index}, row);
    if (!isNew) {
      table_.refuse(row,
                    "rater \"" + rating.rater + "\" scores index \"" + table_.cell(row, "index") +
                        "\" of model \"" + rating.model + "\" a second time, first in " +
                        table_.where(first->second),
                    Text::verbatim("Keep one score for each rater, index and model"));
    }
    const auto [known, newRater] = classOf_.emplace(rating.rater, std::pair{rating.raterClass, row});
    if (!newRater && known->second.first != rating.raterClass) {
      table_.refuse(row,
                    "rater \"" + rating.rater + "\" is in class \"" + table_.cell(row, "class") +
                        "\", but in another in " + table_.where(known->second.second),
                    Text::verbatim("A rater belongs to one class"));
    }
    return rating;
  }

  std::size_t classAt(std::size_t row) const {
    const std::string& text = table_.text(row, "class");
    if (const auto found = named(instrument_.classes, text)) {
      return *found;
    }
    std::string known;
    for (const RaterClass& raterClass : instrument_.classes) {
      known.append(known.empty() ? "" : ", ").append(raterClass.id);
    }
    table_.refuse(row, "there is no rater class \"" + text + "\"", "Classes: " + known);
  }

  std::size_t indexAt(std::size_t row) {
    const std::string& text = table_.text(row, "index");
    std::optional<std::size_t> found = named(instrument_.indices, text);
    if (!found) {
      found = numbered(instrument_.indices.size(), text);
    }
    if (!found) {
      std::string known;
      for (const EvaluationIndex& index : instrument_.indices) {
        known.append(known.empty() ? "" : ", ").append(index.id);
      }
      table_.refuse(row, "there is no index \"" + text + "\"",
                    "Indices: 1 to " + std::to_string(instrument_.indices.size()) + " or " + known);
    }
    if (spelling_[*found].empty()) {
      spelling_[*found] = text;
    }
    return *found;
  }

  const CsvTable& table_;
  const EvaluationInstrument& instrument_;
  std::vector<std::string> spelling_;
  std::map<std::tuple<std::string, std::string, std::size_t>, std::size_t> seen_;
  std::map<std::string, std::pair<std::size_t, std::size_t>> classOf_;
};

Json indexJson(const ScoreStatistics& s, Json name) {
  Json out;
  out["index"] = std::move(name);
  out["M"] = s.m;
  out["s2"] = s.s2;
  out["n"] = s.n;
  out["plain_mean"] = s.plainMean;
  out["population_variance"] = s.populationVariance;
  out["sample_variance"] = numberJson(s.sampleVariance, "there is only one mark");
  out["se"] = numberJson(s.standardError, "a weighted class has only one mark");
  out["min"] = s.min;
  out["max"] = s.max;
  out["class_weighted_moment"] = s.classWeightedMoment;
  out["se_df"] =
      numberJson(s.standardErrorDf, "there is no standard error, or nothing varies within the classes");
  out["missing"] = s.missing;
  out["flags"] = s.flags;
  return out;
}

Json modelJson(const ModelEvaluation& model, const EvaluationInstrument& instrument,
               const MarkReader& reader) {
  Json out;
  out["model"] = model.model;
  out["N"] = model.n27;
  out["indices"] = Json::array();
  for (std::size_t j = 0; j < model.indices.size(); ++j) {
    out["indices"].push_back(indexJson(model.indices[j], reader.indexJson(j)));
  }
  out["composites"] = Json::array();
  for (const RaterComposite& composite : model.composites) {
    out["composites"].push_back({{"rater", composite.rater},
                                 {"class", instrument.classes[composite.raterClass].id},
                                 {"score", numberJson(composite.score, "a mark of this rater is missing")}});
  }
  out["flags"] = model.flags;
  out["missing"] = model.missing;
  return out;
}

MissingPolicy policyOf(const std::string& name) {
  if (name == "refuse") {
    return MissingPolicy::kRefuse;
  }
  if (name == "renormalise") {
    return MissingPolicy::kRenormalise;
  }
  if (name == "list-wise") {
    return MissingPolicy::kListWise;
  }
  return MissingPolicy::kAvailableCase;
}

void runEvaluate(const EvaluateArguments& arguments) {
  const EvaluationInstrument instrument = instrumentOf(arguments);
  const CsvTable table = CsvTable::read(arguments.ratings, {"index", "rater", "class", "model", "score"});
  noteTable(table);
  MarkReader reader(table, instrument);
  const std::vector<EvaluationRating> ratings = reader.read();
  if (!arguments.scaleConfirmed) {
    std::vector<std::int64_t> steps;
    for (const EvaluationRating& rating : ratings) {
      if (rating.steps) {
        steps.push_back(*rating.steps);
      }
    }
    requireScaleUsed(
        steps, instrument.scale, table.name() + ", column \"score\"",
        Text::verbatim("Give --lowest and --highest as the raters had them, or --scale-confirmed if they "
                       "are right"));
  }
  EvaluationPolicy policy;
  policy.missing = policyOf(arguments.policy);
  reader.requireScores(ratings, policy.missing);
  Json out;
  out["models"] = Json::array();
  try {
    for (const ModelRatings& marks : groupRatings(instrument, ratings)) {
      Json model = modelJson(evaluateModel(instrument, marks, policy), instrument, reader);
      if (arguments.resamples > 0) {
        const ScoreRange range =
            resampledScore(instrument, marks, {.resamples = arguments.resamples, .seed = arguments.seed});
        model["N_interval"] = {range.lower, range.upper};
      }
      out["models"].push_back(std::move(model));
    }
  } catch (const Error& error) {
    throw Error(error.code(), error.happened(), table.name() + ", " + error.where(), error.remedy());
  }
  out["policy"] = arguments.policy;
  if (arguments.scaleConfirmed) {
    out["scale_confirmed"] = true;
  }
  out["formula"] = kEvaluationFormulaVersion;
  printJson(out);
}

}  // namespace

void addEvaluate(CLI::App& program) {
  auto arguments = std::make_shared<EvaluateArguments>();
  CLI::App* command =
      program.add_subcommand("evaluate", "Scores of models from the marks of raters (paper Eqs. 25 to 27)");
  command->add_option("--ratings", arguments->ratings, "CSV with the columns index,rater,class,model,score")
      ->required();
  command
      ->add_option("--weights", arguments->weights,
                   "Weights of the indices: 0.5,0.3,0.2 or id=0.5,...; default: the paper's nine")
      ->delimiter(',');
  command
      ->add_option("--class-weights", arguments->classWeights,
                   "Weights of the rater classes: 0.2,0.3,0.5 (A, B, C) or id=0.2,...; default: the paper's")
      ->delimiter(',');
  addDefaulted(*command, "--policy", arguments->policy, "Treatment of missing marks",
               CLI::IsMember({"refuse", "renormalise", "available", "list-wise"}));
  addDefaulted(*command, "--lowest", arguments->lowest, "Lowest score, points", CLI::Range(-1000, 1000));
  addDefaulted(*command, "--highest", arguments->highest, "Highest score, points", CLI::Range(-1000, 1000));
  addDefaulted(*command, "--steps-per-point", arguments->stepsPerPoint,
               "Steps per point; 10: scores in tenths", CLI::Range(1, 1000));
  command->add_flag("--scale-confirmed", arguments->scaleConfirmed,
                    "The scale is right although no score reaches a tenth of it");
  addDefaulted(*command, "--resamples", arguments->resamples,
               "Resampled panels of raters for an interval of N; 0: none", CLI::Range(0, 1'000'000));
  addDefaulted(*command, "--seed", arguments->seed, "Seed of the resampling");
  command->callback([arguments] { runEvaluate(*arguments); });
}

}  // namespace torsio::cli
