// SPDX-License-Identifier: GPL-3.0-or-later
// Tests of the same subjects at several occasions, and bootstrap intervals: compare-groups --paired,
// --bootstrap.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/cli/comparison_methods.h"
#include "app/cli/json_output.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/rank_tests.h"
#include "assessment/statistics/resampling.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

/// First and last scores of the same subjects.
struct PairedScores {
  std::vector<double> before;
  std::vector<double> after;
};

/// Differences in integer steps of the scale; a step is at least 10^-6.
struct WholeDifferences {
  std::vector<std::int64_t> steps;
  double step = 1.0;
};

PairedScores firstAndLast(const std::vector<std::vector<double>>& scores) {
  PairedScores out;
  for (const std::vector<double>& row : scores) {
    out.before.push_back(row.front());
    out.after.push_back(row.back());
  }
  return out;
}

std::optional<WholeDifferences> wholeDifferences(const PairedScores& pairs) {
  std::vector<double> all = pairs.after;
  all.insert(all.end(), pairs.before.begin(), pairs.before.end());
  const auto whole = asWholeNumbers(all);
  if (!whole) {
    return std::nullopt;
  }
  WholeDifferences out;
  for (std::size_t i = 0; i < pairs.after.size(); ++i) {
    out.steps.push_back((*whole)[i] - (*whole)[i + pairs.after.size()]);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i] != 0.0) {
      out.step = 1.0 / std::round(static_cast<double>((*whole)[i]) / all[i]);
      break;
    }
  }
  return out;
}

Json tJson(const PairedScores& pairs) {
  return outcomeJson(pairedT(pairs.after, pairs.before), [&](const TTest& test) {
    Json out = testJson(test.t, test.df, test.p,
                        namedValue("cohen_dz", test.t / std::sqrt(static_cast<double>(pairs.after.size()))),
                        intervalJson(test.interval));
    out["difference"] = test.difference;
    return out;
  });
}

Json signedRankJson(const WholeDifferences& differences, const MonteCarlo& choice) {
  const std::vector<double> steps(differences.steps.begin(), differences.steps.end());
  return outcomeJson(signedRank(steps, choice), [&](const SignedRank& test) {
    const double n = static_cast<double>(test.n);
    const double highest = 0.5 * n * (n + 1.0);
    Json out = testJson(test.v, undefinedJson("a rank test has none"), test.pTwoSided,
                        namedValue("rank_biserial", 2.0 * test.v / highest - 1.0),
                        undefinedJson("this test has no interval"));
    out["p_greater"] = test.pGreater;
    out["hodges_lehmann"] = test.hodgesLehmann * differences.step;
    out["zeros"] = test.zeros;
    addMonteCarlo(test.exact, test.error, choice, out);
    return out;
  });
}

Json pairedPermutationJson(const WholeDifferences& differences, const MonteCarlo& choice) {
  return outcomeJson(pairedPermutationTest(differences.steps, choice), [&](const PermutationTest& test) {
    double sum = 0.0;
    for (const std::int64_t step : differences.steps) {
      sum += static_cast<double>(step);
    }
    Json out = testJson(sum * differences.step / static_cast<double>(differences.steps.size()),
                        undefinedJson("a permutation test has none"), test.p, undefinedJson("see --paired t"),
                        noInterval());
    out["count"] = test.count;
    out["total"] = test.total;
    addMonteCarlo(test.exact, test.error, choice, out);
    return out;
  });
}

Json friedmanJson(const std::vector<std::vector<double>>& scores, const std::vector<std::string>& occasions) {
  if (scores.size() < 2) {
    return undefinedJson("there are fewer than two subjects with every occasion");
  }
  return outcomeJson(friedman(NumberTable(scores)), [&](const Friedman& test) {
    Json out =
        testJson(test.chiSquared, test.df, test.p, namedValue("kendall_w", test.kendallW), noInterval());
    const std::string alike = "every subject ranks the occasions alike";
    out["iman_davenport"] = {{"statistic", numberJson(test.imanDavenport, alike)},
                             {"p", numberJson(test.pImanDavenport, alike)}};
    out["rank_sums"] = Json::array();
    for (std::size_t o = 0; o < occasions.size(); ++o) {
      out["rank_sums"].push_back({{"occasion", occasions[o]}, {"sum", test.rankSums[o]}});
    }
    return out;
  });
}

Json testOf(PairedTest test, const std::vector<std::vector<double>>& scores,
            const std::vector<std::string>& occasions, const MonteCarlo& choice) {
  if (test == PairedTest::kFriedman) {
    return friedmanJson(scores, occasions);
  }
  const PairedScores pairs = firstAndLast(scores);
  if (test == PairedTest::kT) {
    return tJson(pairs);
  }
  const std::optional<WholeDifferences> differences = wholeDifferences(pairs);
  if (!differences) {
    return undefinedJson(
        "the scores are neither decimals of at most six places nor means of them, so they cannot be counted "
        "exactly");
  }
  if (differences->steps.empty()) {
    return undefinedJson("nobody has a score at both occasions");
  }
  return test == PairedTest::kSignedRank ? signedRankJson(*differences, choice)
                                         : pairedPermutationJson(*differences, choice);
}

Json correlationJson(const PairedScores& pairs) {
  return outcomeJson(pearson(pairs.before, pairs.after), [](const Correlation& correlation) {
    Json out{{"r", correlation.r}};
    out["interval"] = correlation.fisherInterval
                          ? intervalJson(*correlation.fisherInterval)
                          : undefinedJson("it requires four pairs that are not on a line");
    return out;
  });
}

constexpr double kMaxResamples = 1e6;

/// Median of values drawn with repetition. The values are sorted once, so that each resample only needs
/// counting.
class DrawnMedian {
 public:
  explicit DrawnMedian(const std::vector<double>& values)
      : ordered_(values), place_(values.size()), drawn_(values.size()) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      ordered_[i] = values[order[i]];
      place_[order[i]] = i;
    }
  }

  double operator()(std::span<const std::size_t> rows) {
    std::fill(drawn_.begin(), drawn_.end(), std::size_t{0});
    for (const std::size_t row : rows) {
      ++drawn_[place_[row]];
    }
    std::size_t at = 0;
    std::size_t before = drawn_.front();  // number drawn up to `at`
    const auto valueOf = [&](std::size_t rank) {
      while (before <= rank) {
        before += drawn_[++at];
      }
      return ordered_[at];
    };
    const std::size_t half = rows.size() / 2;
    if (rows.size() % 2 == 1) {
      return valueOf(half);
    }
    const double lower = valueOf(half - 1);
    return 0.5 * (lower + valueOf(half));
  }

 private:
  std::vector<double> ordered_;
  std::vector<std::size_t> place_;
  std::vector<std::size_t> drawn_;
};

Json bootstrapOf(std::vector<double> values, const BootstrapRequest& request) {
  std::sort(values.begin(), values.end());  // the interval does not depend on the order of the lines
  const double n = static_cast<double>(values.size());
  if (request.everyResample && std::pow(n, n) > kMaxResamples) {
    return undefinedJson("more than seven subjects have more than a million resamples");
  }
  DrawnMedian median(values);
  const ResampledStatistic statistic = [&](std::span<const std::size_t> rows) {
    if (request.median) {
      return median(rows);
    }
    std::vector<double> drawn;
    for (const std::size_t row : rows) {
      drawn.push_back(values[row]);
    }
    return meanOf(drawn);
  };
  const BootstrapOptions options{request.seed, request.resamples, request.everyResample, kDefaultConfidence};
  return outcomeJson(bootstrap(values.size(), statistic, options), [](const Bootstrap& result) {
    return Json{{"estimate", result.estimate},
                {"error", result.error},
                {"percentile", intervalJson(result.percentile)},
                {"basic", intervalJson(result.basic)},
                {"bca", intervalJson(result.bca)},
                {"z0", result.z0},
                {"acceleration", result.acceleration},
                {"bca_levels", intervalJson(result.bcaLevels)},
                {"resamples", result.resamples}};
  });
}

}  // namespace

Json pairedJson(const Study& study, PairedTest test, std::uint64_t seed) {
  const bool all = test == PairedTest::kFriedman;
  const std::vector<std::string> occasions =
      all ? study.occasions : std::vector<std::string>{study.occasions.front(), study.occasions.back()};
  Json list = Json::array();
  for (std::size_t g = 0; g < study.groups.size(); ++g) {
    const CompleteSubjects complete = completeSubjects(study, g, occasions);
    Json entry{
        {"group", study.groups[g]}, {"n", complete.scores.size()}, {"left_out", complete.leftOut.size()}};
    entry["left_out_subjects"] = complete.leftOut;
    const double size = static_cast<double>(complete.scores.size());
    const MonteCarlo choice = permutationsWithin(seed, size, static_cast<double>(study.groups.size()));
    entry["test"] = testOf(test, complete.scores, occasions, choice);
    entry["correlation"] = correlationJson(firstAndLast(complete.scores));
    list.push_back(std::move(entry));
  }
  return list;
}

Json bootstrapJson(const std::vector<std::string>& names, const Groups& values,
                   const BootstrapRequest& request) {
  Json out{{"statistic", request.median ? "median" : "mean"}, {"groups", Json::array()}};
  for (std::size_t g = 0; g < values.size(); ++g) {
    Json entry{{"group", names[g]}, {"n", values[g].size()}};
    entry.update(bootstrapOf(values[g], request));
    out["groups"].push_back(std::move(entry));
  }
  if (!request.everyResample) {
    out["seed"] = request.seed;
  }
  return out;
}

Groups gainsOf(const Study& study) {
  Groups gains(study.groups.size());
  for (std::size_t g = 0; g < study.groups.size(); ++g) {
    const PairedScores pairs =
        firstAndLast(completeSubjects(study, g, {study.occasions.front(), study.occasions.back()}).scores);
    for (std::size_t i = 0; i < pairs.after.size(); ++i) {
      gains[g].push_back(pairs.after[i] - pairs.before[i]);
    }
  }
  return gains;
}

}  // namespace torsio::cli
