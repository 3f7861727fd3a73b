// SPDX-License-Identifier: GPL-3.0-or-later
// Tests between groups of subjects at one occasion: compare-groups without --paired.
#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/cli/comparison_methods.h"
#include "app/cli/json_output.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/multiplicity.h"
#include "assessment/statistics/rank_tests.h"
#include "assessment/statistics/shapiro_wilk.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

std::vector<double> adjusted(Adjustment adjustment, const std::vector<double>& p) {
  switch (adjustment) {
    case Adjustment::kHolm:
      return adjustHolm(p);
    case Adjustment::kHochberg:
      return adjustHochberg(p);
    case Adjustment::kBonferroni:
      return adjustBonferroni(p);
    case Adjustment::kBenjaminiHochberg:
      return adjustBenjaminiHochberg(p);
  }
  return p;
}

Json hedgesJson(std::span<const double> x, std::span<const double> y) {
  return outcomeJson(hedgesG(x, y), [](const HedgesG& effect) {
    Json out = namedValue("hedges_g", effect.g);
    out["lower"] = effect.interval.lower;
    out["upper"] = effect.interval.upper;
    return out;
  });
}

/// Two groups with their names.
struct Pair {
  std::span<const double> x;
  std::span<const double> y;
};
using PairTest = std::function<Json(const Pair&)>;

Json tTestJson(const Outcome<TTest>& test, const Pair& pair) {
  return outcomeJson(test, [&](const TTest& t) {
    Json out = testJson(t.t, t.df, t.p, hedgesJson(pair.x, pair.y), intervalJson(t.interval));
    out["difference"] = t.difference;
    return out;
  });
}

Json mannWhitneyJson(const Pair& pair) {
  return outcomeJson(mannWhitney(pair.x, pair.y), [](const MannWhitney& test) {
    Json interval = test.hodgesLehmannInterval
                        ? intervalJson(*test.hodgesLehmannInterval)
                        : undefinedJson("the exact interval of the shift needs scores without ties");
    Json out =
        testJson(test.u, undefinedJson("a rank test has none"), test.pExact ? *test.pExact : test.pCorrected,
                 namedValue("cliff_delta", test.cliffDelta), std::move(interval));
    out["exact"] = test.pExact.has_value();
    out["superiority"] = test.superiority;
    out["hodges_lehmann"] = test.hodgesLehmann;
    return out;
  });
}

Json permutationJson(const Pair& pair, const MonteCarlo& choice) {
  std::vector<double> all(pair.x.begin(), pair.x.end());
  all.insert(all.end(), pair.y.begin(), pair.y.end());
  const auto whole = asWholeNumbers(all);
  if (!whole) {
    return undefinedJson(
        "the scores are neither decimals of at most six places nor means of them, so they cannot be counted "
        "exactly");
  }
  const std::span<const std::int64_t> counts(*whole);
  return outcomeJson(permutationTest(counts.first(pair.x.size()), counts.subspan(pair.x.size()), choice),
                     [&](const PermutationTest& test) {
                       Json out = testJson(meanOf(pair.x) - meanOf(pair.y),
                                           undefinedJson("a permutation test has none"), test.p,
                                           hedgesJson(pair.x, pair.y), noInterval());
                       out["count"] = test.count;
                       out["total"] = test.total;
                       addMonteCarlo(test.exact, test.error, choice, out);
                       return out;
                     });
}

/// The comparisons of groups at one occasion.
class Comparison {
 public:
  Comparison(const std::vector<std::string>& names, const Groups& groups, const GroupRequest& request)
      : names_(names), groups_(groups), request_(request) {}

  void addTo(Json& out) const {
    out["left_out_groups"] = Json::array();
    for (std::size_t g = 0; g < groups_.size(); ++g) {
      if (groups_[g].empty()) {
        out["left_out_groups"].push_back(names_[g]);
      }
    }
    out["welch_t"] = pairs([this](const Pair& p) {
      const Outcome<TTest> test = welchT(p.x, p.y);
      Json entry = tTestJson(test, p);
      if (test && request_.margin) {
        entry["equivalence"] = equivalenceJson(test->difference, test->error, test->df, *request_.margin);
      }
      return entry;
    });
    out["student_t"] = pairs([](const Pair& p) { return tTestJson(studentT(p.x, p.y), p); });
    out["welch_anova"] = welchAnovaJson();
    out["anova"] = anovaJson();
    out["mann_whitney"] = pairs(mannWhitneyJson);
    double size = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      for (std::size_t j = i + 1; j < groups_.size(); ++j) {
        size = std::max(size, static_cast<double>(std::min(groups_[i].size(), groups_[j].size())));
        count += 1.0;
      }
    }
    const MonteCarlo choice = permutationsWithin(request_.seed, size, count);
    out["permutation"] = pairs([&](const Pair& pair) { return permutationJson(pair, choice); });
    out["kruskal_wallis"] = kruskalWallisJson();
    out["games_howell"] = rangePairsJson(gamesHowellPairs(groups_));
    out["tukey"] = rangePairsJson(tukeyPairs(groups_));
    out["hedges_g"] = pairs([](const Pair& p) { return hedgesJson(p.x, p.y); });
    out["brown_forsythe"] = outcomeJson(brownForsythe(groups_), [](const FTest& test) {
      return testJson(test.f, {test.df1, test.df2}, test.p, undefinedJson("a test of spread, not of means"),
                      noInterval());
    });
    out["bartlett"] = outcomeJson(bartlett(groups_), [](const ChiSquaredTest& test) {
      return testJson(test.statistic, test.df, test.p, undefinedJson("a test of spread, not of means"),
                      noInterval());
    });
    out["shapiro_wilk"] = outcomeJson(shapiroWilk(residuals()), [](const NormalityTest& test) {
      return testJson(test.w, undefinedJson("this test has none"), test.p,
                      undefinedJson("a test of shape, not of means"), noInterval());
    });
  }

 private:
  /// Two groups: a single test. More: one entry per pair, with p adjusted by Holm.
  Json pairs(const PairTest& test) const {
    if (groups_.size() < 2) {
      return undefinedJson("there is only one group");
    }
    if (groups_.size() == 2) {
      return labelled(0, 1, test({groups_[0], groups_[1]}));
    }
    Json list = Json::array();
    std::vector<double> p;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      for (std::size_t j = i + 1; j < groups_.size(); ++j) {
        list.push_back(labelled(i, j, test({groups_[i], groups_[j]})));
        if (list.back().contains("p")) {
          p.push_back(list.back()["p"].get<double>());
        }
      }
    }
    const std::vector<double> holm = adjustHolm(p);
    const std::vector<double> chosen = adjusted(request_.adjustment, p);
    std::size_t at = 0;
    for (Json& entry : list) {
      if (entry.contains("p")) {
        entry["p_holm"] = holm[at];
        if (request_.adjustment != Adjustment::kHolm) {
          entry["p_adjusted"] = chosen[at];
        }
        ++at;
      }
    }
    return {{"pairs", list}};
  }

  /// Deviations of all scores from their group means.
  std::vector<double> residuals() const {
    std::vector<double> out;
    for (const std::vector<double>& group : groups_) {
      const double mean = group.empty() ? 0.0 : meanOf(group);
      const bool varies = !group.empty() && squaresBeyondRounding(group) > 0.0;
      for (const double score : group) {
        out.push_back(varies ? score - mean : 0.0);
      }
    }
    return out;
  }

  Json labelled(std::size_t i, std::size_t j, Json entry) const {
    Json out{{"groups", {names_[i], names_[j]}}};
    out.update(entry);
    return out;
  }

  Json anovaJson() const {
    return outcomeJson(oneWayAnova(groups_), [](const OneWayAnova& test) {
      Json out = testJson(test.f, {test.df1, test.df2}, test.p,
                          namedValue("omega_squared", test.omegaSquared), noInterval());
      out["eta_squared"] = test.etaSquared;
      out["epsilon_squared"] = test.epsilonSquared;
      return out;
    });
  }

  Json welchAnovaJson() const {
    return outcomeJson(welchAnova(groups_), [&](const FTest& test) {
      const auto equal = oneWayAnova(groups_);
      Json effect =
          equal ? namedValue("omega_squared", equal->omegaSquared) : undefinedJson(equal.reason().str());
      return testJson(test.f, {test.df1, test.df2}, test.p, std::move(effect), noInterval());
    });
  }

  Json kruskalWallisJson() const {
    return outcomeJson(kruskalWallis(groups_), [&](const KruskalWallis& test) {
      Json out =
          testJson(test.h, test.df, test.p, namedValue("epsilon_squared", test.epsilonSquared), noInterval());
      if (test.pExact) {
        out["p_exact"] = *test.pExact;
      }
      Json pairs = Json::array();
      for (const DunnPair& pair : test.pairs) {
        pairs.push_back({{"groups", {names_[pair.first], names_[pair.second]}},
                         {"statistic", pair.z},
                         {"p", pair.p},
                         {"p_holm", pair.pHolm},
                         {"mean_rank_difference", pair.difference}});
      }
      out["dunn"] = std::move(pairs);
      return out;
    });
  }

  Json rangePairsJson(const Outcome<std::vector<PairComparison>>& outcome) const {
    return outcomeJson(outcome, [&](const std::vector<PairComparison>& list) {
      Json pairs = Json::array();
      for (const PairComparison& pair : list) {
        Json entry = testJson(pair.q, pair.df, pair.p, hedgesJson(groups_[pair.second], groups_[pair.first]),
                              intervalJson(pair.interval));
        entry["difference"] = pair.difference;  // second minus first, like the effect size
        pairs.push_back(labelled(pair.first, pair.second, std::move(entry)));
      }
      return Json{{"pairs", pairs}};
    });
  }

  const std::vector<std::string>& names_;
  const Groups& groups_;
  const GroupRequest& request_;
};

}  // namespace

void addGroupTests(Json& out, const std::vector<std::string>& names, const Groups& groups,
                   const GroupRequest& request) {
  Comparison(names, groups, request).addTo(out);
}

MonteCarlo permutationsWithin(std::uint64_t seed, double size, double tests) {
  constexpr double kMaxDraws = 2e7;
  constexpr double kFewest = 299.0;  // minimum for a thousand pairs and more
  constexpr double kMost = 99'999.0;
  constexpr double kMaxAdditions = 1e9;
  const double each = std::max(1.0, tests);
  MonteCarlo out;
  out.seed = seed;
  out.draws = static_cast<std::int64_t>(
      std::clamp(std::floor(kMaxDraws / (std::max(1.0, size) * each)), kFewest, kMost));
  out.mostAdditions = static_cast<std::int64_t>(kMaxAdditions / each);
  return out;
}

void addMonteCarlo(bool exact, double error, const MonteCarlo& choice, Json& out) {
  out["exact"] = exact;
  if (!exact) {
    out["monte_carlo_error"] = error;
    out["draws"] = choice.draws;
    out["seed"] = choice.seed;
  }
}

}  // namespace torsio::cli
