// SPDX-License-Identifier: GPL-3.0-or-later
// Coefficients of scores on a scale (overview, ICC, Krippendorff, Bland-Altman) and in categories (Cohen's
// and Fleiss' kappa).
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/cli/agreement_methods.h"
#include "app/cli/json_output.h"
#include "assessment/statistics/missing_marks.h"
#include "assessment/statistics/reliability.h"
#include "sim/core/error.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

Outcome<IccResult> intraclass(const CompleteTargets& complete) {
  return complete.table ? intraclassCorrelation(*complete.table)
                        : Outcome<IccResult>::undefined(complete.table.reason());
}

Json formJson(const IccForm& form, double errorVariance) {
  const std::string reason =
      errorVariance > 0.0 ? "too few ratings for an interval" : "the error variance is zero";
  Json out{{"estimate", form.estimate}};
  out["lower"] = form.interval ? Json(form.interval->lower) : undefinedJson(reason);
  out["upper"] = form.interval ? Json(form.interval->upper) : undefinedJson(reason);
  return out;
}

Json formsJson(const Outcome<IccResult>& icc) {
  Json out;
  const auto add = [&](const char* name, IccForm IccResult::*form) {
    out[name] = icc ? formJson((*icc).*form, icc->ems) : undefinedJson(icc.reason().str());
  };
  add("ICC(1,1)", &IccResult::oneWaySingle);
  add("ICC(2,1)", &IccResult::agreementSingle);
  add("ICC(3,1)", &IccResult::consistencySingle);
  add("ICC(1,k)", &IccResult::oneWayMean);
  add("ICC(2,k)", &IccResult::agreementMean);
  add("ICC(3,k)", &IccResult::consistencyMean);
  return out;
}

Json measurementErrorJson(const Outcome<IccResult>& icc) {
  return outcomeJson(icc, [](const IccResult& result) {
    return Json{{"agreement", result.semAgreement},
                {"consistency", result.semConsistency},
                {"agreement_of_mean", result.semMean}};
  });
}

/// Agreement within each group, with differences between the groups removed.
Json withinGroupsJson(const RatingGrid& grid) {
  Json list = Json::array();
  for (std::size_t g = 0; g < grid.groups.size(); ++g) {
    const CompleteTargets complete = completeTargets(grid, g);
    const Outcome<IccResult> icc = intraclass(complete);
    Json entry{{"group", grid.groups[g]}, {"targets", complete.table ? complete.table->rows() : 0}};
    entry["icc"] = formsJson(icc);
    entry["sem"] = measurementErrorJson(icc);
    entry["left_out_targets"] = complete.leftOut;
    list.push_back(std::move(entry));
  }
  return list;
}

/// Reliability by restricted maximum likelihood; allows missing marks.
Json reliabilityJson(const RatingGrid& grid) {
  return outcomeJson(incompleteReliability(grid.ratersByTarget), [](const IncompleteReliability& result) {
    return Json{{"marks", result.marks},
                {"raters_of_mean", result.usualRaters},
                {"variances",
                 {{"targets", result.varianceTargets},
                  {"raters", result.varianceRaters},
                  {"error", result.varianceResidual}}},
                {"one_rater", result.single},
                {"mean", result.mean},
                {"sem", result.semSingle},
                {"sem_of_mean", result.semMean}};
  });
}

bool anyNegative(const RatingGrid& grid) {
  return std::any_of(grid.ratersByTarget.begin(), grid.ratersByTarget.end(), [](const auto& rater) {
    return std::any_of(rater.begin(), rater.end(), [](const auto& score) { return score && *score < 0.0; });
  });
}

/// Calls `show` for each metric; a ratio scale has no negative scores.
template <class Show>
Json byMetric(const RatingGrid& grid, const Show& show) {
  Json out;
  out["nominal"] = show(AlphaMetric::kNominal);
  out["ordinal"] = show(AlphaMetric::kOrdinal);
  out["interval"] = show(AlphaMetric::kInterval);
  out["ratio"] =
      anyNegative(grid) ? undefinedJson("a ratio scale has no negative scores") : show(AlphaMetric::kRatio);
  return out;
}

Json limitsJson(const BlandAltmanResult& result) {
  Json out{{"n", result.n}, {"mean_difference", result.meanDifference}, {"sd", result.deviation}};
  out["limits"] = intervalJson(result.limits);
  out["mean_interval"] = intervalJson(result.meanInterval);
  out["lower_limit_interval"] = intervalJson(result.lowerLimitInterval);
  out["upper_limit_interval"] = intervalJson(result.upperLimitInterval);
  out["limit_error"] = result.limitError;
  out["limit_error_exact"] = result.limitErrorExact;
  out["slope"] = numberJson(result.slope, "the means of the pairs do not vary");
  return out;
}

Json panelJson(const RatingGrid& grid, const Outcome<NumberTable>& complete) {
  if (!complete) {
    return undefinedJson(complete.reason().str());
  }
  if (grid.raters.size() < 3) {
    return undefinedJson("two raters form no panel: see the pair");
  }
  Json list = Json::array();
  const std::vector<Outcome<BlandAltmanResult>> results = blandAltmanAgainstPanel(*complete);
  for (std::size_t r = 0; r < results.size(); ++r) {
    Json entry{{"rater", grid.raters[r]}};
    entry.update(outcomeJson(results[r], limitsJson));
    list.push_back(std::move(entry));
  }
  return list;
}

/// Number of resamples of so many scores that takes about a second for all metrics.
int resamplesWithin(std::size_t scores) {
  constexpr double kMaxDrawn = 8e7;
  constexpr double kFewest = 999.0;
  constexpr double kMost = 9999.0;
  return static_cast<int>(std::clamp(kMaxDrawn / std::max(1.0, static_cast<double>(scores)), kFewest, kMost));
}

}  // namespace

Json overviewJson(const RatingGrid& grid) {
  const CompleteTargets cases = completeTargets(grid);
  const Outcome<NumberTable>& complete = cases.table;
  const Outcome<IccResult> icc = intraclass(cases);
  const auto kendall = complete ? kendallW(*complete) : Outcome<KendallResult>::undefined(complete.reason());
  const auto cronbach =
      complete ? cronbachAlpha(*complete) : Outcome<CronbachResult>::undefined(complete.reason());
  Json out;
  out["icc"] = formsJson(icc);
  out["krippendorff"] = byMetric(grid, [&](AlphaMetric metric) {
    return outcomeJson(krippendorffAlpha(grid.ratersByTarget, metric),
                       [](const KrippendorffResult& result) { return Json(result.alpha); });
  });
  out["kendall_w"] = outcomeJson(kendall, [](const KendallResult& w) {
    return Json{{"w", w.w}, {"chi_squared", w.chiSquared}, {"df", w.df}, {"p", w.p}};
  });
  out["cronbach"] = outcomeJson(cronbach, [](const CronbachResult& alpha) {
    return Json{{"alpha", alpha.alpha}, {"lower", alpha.interval.lower}, {"upper", alpha.interval.upper}};
  });
  out["sem"] = measurementErrorJson(icc);
  out["left_out_targets"] = cases.leftOut;
  return out;
}

Json intraclassJson(const RatingGrid& grid) {
  const CompleteTargets cases = completeTargets(grid);
  const Outcome<IccResult> icc = intraclass(cases);
  Json out;
  out["icc"] = formsJson(icc);
  out["mean_squares"] = outcomeJson(icc, [](const IccResult& result) {
    return Json{{"targets", result.bms},
                {"within_targets", result.wms},
                {"raters", result.jms},
                {"error", result.ems}};
  });
  out["tests"] = outcomeJson(icc, [](const IccResult& result) {
    const auto test = [](const std::optional<double>& f, const std::optional<double>& p) {
      const std::string reason = "there is no residual variance";
      return Json{{"statistic", numberJson(f, reason)}, {"p", numberJson(p, reason)}};
    };
    return Json{{"one_way", test(result.fOneWay, result.pOneWay)},
                {"two_way", test(result.fTwoWay, result.pTwoWay)},
                {"raters", test(result.fRaters, result.pRaters)}};
  });
  out["variances"] = outcomeJson(icc, [](const IccResult& result) {
    return Json{{"targets", result.varianceTargets},
                {"raters", result.varianceRaters},
                {"error", result.varianceResidual}};
  });
  out["sem"] = measurementErrorJson(icc);
  out["reml"] = reliabilityJson(grid);
  if (!grid.groups.empty()) {
    out["within_groups"] = withinGroupsJson(grid);
  }
  out["left_out_targets"] = cases.leftOut;
  return out;
}

Json krippendorffJson(const RatingGrid& grid, const AgreementOptions& options) {
  const int resamples = options.resamples.value_or(resamplesWithin(grid.given));
  Json out;
  out["krippendorff"] = byMetric(grid, [&](AlphaMetric metric) {
    return outcomeJson(krippendorffAlpha(grid.ratersByTarget, metric), [&](const KrippendorffResult& result) {
      Json entry{{"alpha", result.alpha},
                 {"observed", result.observed},
                 {"expected", result.expected},
                 {"pairable", result.pairable}};
      entry["bootstrap"] =
          outcomeJson(krippendorffInterval(grid.ratersByTarget, metric, options.seed, resamples),
                      [](const AlphaBootstrap& bootstrap) {
                        Json interval = intervalJson(bootstrap.interval);
                        interval["resamples"] = bootstrap.resamples;
                        interval["without_variation"] = bootstrap.undefined;
                        return interval;
                      });
      return entry;
    });
  });
  out["seed"] = options.seed;
  return out;
}

Json blandAltmanJson(const RatingGrid& grid) {
  Json out;
  out["pairs"] = Json::array();
  for (std::size_t i = 0; i < grid.raters.size(); ++i) {
    for (std::size_t j = i + 1; j < grid.raters.size(); ++j) {
      const SharedScores shared = sharedScores(grid, i, j);
      Json entry{{"raters", {grid.raters[i], grid.raters[j]}}};
      entry.update(outcomeJson(blandAltman(shared.first, shared.second), limitsJson));
      out["pairs"].push_back(std::move(entry));
    }
  }
  const CompleteTargets cases = completeTargets(grid);
  out["against_panel"] = panelJson(grid, cases.table);
  out["left_out_targets"] = cases.leftOut;
  out["multiplier"] = kAgreementLimit;
  return out;
}

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
  noteTable(table);
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
