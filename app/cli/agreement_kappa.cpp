// SPDX-License-Identifier: GPL-3.0-or-later
// Agreement in categories: Cohen's and Fleiss' kappa.
#include <algorithm>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/cli/agreement_methods.h"
#include "app/cli/json_output.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxKappaCategories = 100;

/// Categories of the ratings: as given, or the scores that occur.
class CategoryList {
 public:
  CategoryList(const RatingGrid& grid, const AgreementOptions& options)
      : values_(options.categories.empty() ? distinctScores(grid) : options.categories) {
    if (values_.size() > kMaxKappaCategories) {
      refuse(std::to_string(values_.size()) + " different scores are too many categories",
             Text::verbatim("the ratings"),
             Text::verbatim("Collapse them to at most %1, or use Krippendorff's alpha", kMaxKappaCategories));
    }
    for (auto value = values_.begin(); value != values_.end(); ++value) {
      if (std::find(values_.begin(), value, *value) != value) {
        refuseParameter("the category " + shown(*value) + " appears twice", Text::verbatim("--categories"),
                        Text::verbatim("Name every category once"));
      }
    }
    for (const double score : distinctScores(grid)) {
      if (!find(score)) {
        refuse("the score " + shown(score) + " is not one of the categories", Text::verbatim("--categories"),
               Text::verbatim("Name every category that raters could give"));
      }
    }
  }

  [[nodiscard]] const std::vector<double>& values() const { return values_; }
  [[nodiscard]] std::size_t size() const { return values_.size(); }
  [[nodiscard]] std::optional<std::size_t> find(double score) const {
    const auto found = std::find(values_.begin(), values_.end(), score);
    return found == values_.end() ? std::nullopt
                                  : std::optional(static_cast<std::size_t>(found - values_.begin()));
  }
  [[nodiscard]] std::size_t at(double score) const { return find(score).value(); }

  [[nodiscard]] static std::string shown(double value) { return Json(value).dump(); }

 private:
  std::vector<double> values_;
};

/// Reads custom disagreements: 0 on the diagonal, symmetric; throws for a missing pair.
NumberTable readDisagreement(const std::string& file, const CategoryList& categories) {
  const CsvTable table = CsvTable::read(file, {"first", "second", "disagreement"});
  noteIgnoredColumns(table);
  std::vector<std::vector<std::optional<double>>> weights(
      categories.size(), std::vector<std::optional<double>>(categories.size(), std::nullopt));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto first = categories.find(table.number(row, "first"));
    const auto second = categories.find(table.number(row, "second"));
    const double weight = table.number(row, "disagreement");
    if (!first || !second) {
      table.refuse(row, Text::verbatim("this is not a pair of categories"),
                   Text::verbatim("Give two of the categories, or name them in --categories"));
    }
    if (weight < 0.0 || (first == second && weight != 0.0)) {
      table.refuse(row,
                   "the disagreement " + table.cell(row, "disagreement") +
                       " is negative, or of a category with itself",
                   Text::verbatim("Give 0 for equal categories and a positive number for others"));
    }
    for (std::optional<double>* place : {&weights[*first][*second], &weights[*second][*first]}) {
      if (*place && **place != weight) {
        table.refuse(row, Text::verbatim("these two categories already have another disagreement"),
                     Text::verbatim("Give one for each pair"));
      }
      *place = weight;
    }
  }
  NumberTable out(categories.size(), categories.size());
  for (std::size_t i = 0; i < categories.size(); ++i) {
    for (std::size_t j = i + 1; j < categories.size(); ++j) {
      if (!weights[i][j]) {
        refuse("no disagreement of " + CategoryList::shown(categories.values()[i]) + " and " +
                   CategoryList::shown(categories.values()[j]),
               table.name(), Text::verbatim("Give one for each pair of categories"));
      }
      out.at(i, j) = out.at(j, i) = *weights[i][j];
    }
  }
  return out;
}

Json cohenJson(const Outcome<KappaResult>& outcome) {
  return outcomeJson(outcome, [](const KappaResult& result) {
    Json out{{"kappa", result.kappa},
             {"lower", result.interval.lower},
             {"upper", result.interval.upper},
             {"observed", result.observed},
             {"expected", result.expected},
             {"error", result.error},
             {"error_under_null", result.errorUnderNull}};
    out["z"] = numberJson(result.z, "the error under the null hypothesis is zero");
    return out;
  });
}

Json pairJson(const RatingGrid& grid, std::size_t i, std::size_t j, const CategoryList& categories,
              const std::optional<NumberTable>& disagreement) {
  const SharedScores shared = sharedScores(grid, i, j);
  NumberTable counts(categories.size(), categories.size());
  for (std::size_t t = 0; t < shared.first.size(); ++t) {
    counts.at(categories.at(shared.first[t]), categories.at(shared.second[t])) += 1.0;
  }
  Json entry{{"raters", {grid.raters[i], grid.raters[j]}}, {"n", shared.first.size()}};
  entry["unweighted"] = cohenJson(cohenKappa(counts, KappaWeights::kUnweighted));
  entry["linear"] = cohenJson(cohenKappa(counts, KappaWeights::kLinear));
  entry["quadratic"] = cohenJson(cohenKappa(counts, KappaWeights::kQuadratic));
  if (disagreement) {
    entry["own_weights"] = cohenJson(cohenKappa(counts, *disagreement));
  }
  return entry;
}

Json fleissJson(const RatingGrid& grid, const CategoryList& categories) {
  NumberTable counts(grid.targets.size(), categories.size());
  std::vector<std::size_t> ratings(grid.targets.size(), 0);
  for (const auto& rater : grid.ratersByTarget) {
    for (std::size_t t = 0; t < grid.targets.size(); ++t) {
      if (rater[t]) {
        counts.at(t, categories.at(*rater[t])) += 1.0;
        ++ratings[t];
      }
    }
  }
  if (std::any_of(ratings.begin(), ratings.end(),
                  [&](std::size_t n) { return n != ratings.front() || n < 2; })) {
    return undefinedJson("every target needs the same number of ratings, at least two");
  }
  return outcomeJson(fleissKappa(counts), [&](const FleissResult& result) {
    Json out{{"kappa", result.kappa},
             {"observed", result.observed},
             {"expected", result.expected},
             {"error_under_null", result.errorUnderNull},
             {"z", result.z}};
    out["by_category"] = Json::array();
    for (std::size_t c = 0; c < categories.size(); ++c) {
      Json entry{{"category", categories.values()[c]}};
      entry["kappa"] = numberJson(result.byCategory[c], "nobody or everybody used this category");
      out["by_category"].push_back(std::move(entry));
    }
    out["error_by_category"] = result.errorByCategory;
    return out;
  });
}

}  // namespace

Json kappaJson(const RatingGrid& grid, const AgreementOptions& options) {
  const CategoryList categories(grid, options);
  const std::optional<NumberTable> disagreement =
      options.disagreement.empty() ? std::nullopt
                                   : std::optional(readDisagreement(options.disagreement, categories));
  Json out;
  out["pairs"] = Json::array();
  for (std::size_t i = 0; i < grid.raters.size(); ++i) {
    for (std::size_t j = i + 1; j < grid.raters.size(); ++j) {
      out["pairs"].push_back(pairJson(grid, i, j, categories, disagreement));
    }
  }
  out["fleiss"] = fleissJson(grid, categories);
  out["categories"] = categories.values();
  return out;
}

}  // namespace torsio::cli
