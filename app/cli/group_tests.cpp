// SPDX-License-Identifier: GPL-3.0-or-later
// Tests between groups of subjects: compare-groups without --paired.
#include <functional>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/cli/comparison_methods.h"
#include "app/cli/json_output.h"
#include "assessment/statistics/ancova.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/mixed_anova.h"
#include "assessment/statistics/multiplicity.h"
#include "assessment/statistics/rank_tests.h"

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

/// Two lists and their names.
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

Json permutationJson(const Pair& pair) {
  std::vector<double> all(pair.x.begin(), pair.x.end());
  all.insert(all.end(), pair.y.begin(), pair.y.end());
  const auto whole = asWholeNumbers(all);
  if (!whole) {
    return undefinedJson("the scores have more than six decimals, so they cannot be counted exactly");
  }
  const std::span<const std::int64_t> counts(*whole);
  return outcomeJson(permutationTest(counts.first(pair.x.size()), counts.subspan(pair.x.size())),
                     [&](const PermutationTest& test) {
                       Json out = testJson(meanOf(pair.x) - meanOf(pair.y),
                                           undefinedJson("a permutation test has none"), test.p,
                                           hedgesJson(pair.x, pair.y), noInterval());
                       out["count"] = test.count;
                       out["total"] = test.total;
                       return out;
                     });
}

/// The comparisons between groups at one occasion.
class Comparison {
 public:
  Comparison(const std::vector<std::string>& names, const Groups& groups, Adjustment adjustment)
      : names_(names), groups_(groups), adjustment_(adjustment) {}

  void addTo(Json& out) const {
    out["welch_t"] = pairs([](const Pair& p) { return tTestJson(welchT(p.x, p.y), p); });
    out["student_t"] = pairs([](const Pair& p) { return tTestJson(studentT(p.x, p.y), p); });
    out["welch_anova"] = welchAnovaJson();
    out["anova"] = anovaJson();
    out["mann_whitney"] = pairs(mannWhitneyJson);
    out["permutation"] = pairs(permutationJson);
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
  /// Two groups: the test itself. More: one entry a pair, with p adjusted by Holm over the pairs.
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
    const std::vector<double> chosen = adjusted(adjustment_, p);
    std::size_t at = 0;
    for (Json& entry : list) {
      if (entry.contains("p")) {
        entry["p_holm"] = holm[at];
        if (adjustment_ != Adjustment::kHolm) {
          entry["p_adjusted"] = chosen[at];
        }
        ++at;
      }
    }
    return {{"pairs", list}};
  }

  /// Distances of all scores from the means of their groups.
  std::vector<double> residuals() const {
    std::vector<double> out;
    for (const std::vector<double>& group : groups_) {
      for (const double score : group) {
        out.push_back(score - meanOf(group));
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
        entry["difference"] = pair.difference;  // second minus first, as is the effect size
        pairs.push_back(labelled(pair.first, pair.second, std::move(entry)));
      }
      return Json{{"pairs", pairs}};
    });
  }

  const std::vector<std::string>& names_;
  const Groups& groups_;
  Adjustment adjustment_;
};

Json effectJson(const std::optional<AnovaEffect>& effect) {
  if (!effect) {
    return undefinedJson("there is only one group");
  }
  Json out = testJson(effect->f, {effect->df, effect->dfError}, effect->p,
                      namedValue("generalised_eta_squared", effect->generalizedEtaSquared), noInterval());
  out["partial_eta_squared"] = effect->partialEtaSquared;
  if (effect->pGreenhouseGeisser) {
    out["p_greenhouse_geisser"] = *effect->pGreenhouseGeisser;
  }
  if (effect->pHuynhFeldt) {
    out["p_huynh_feldt"] = *effect->pHuynhFeldt;
  }
  return out;
}

}  // namespace

void addGroupTests(Json& out, const std::vector<std::string>& names, const Groups& groups,
                   Adjustment adjustment) {
  Comparison(names, groups, adjustment).addTo(out);
}

Json ancovaJson(const Study& study) {
  Groups before(study.groups.size());
  Groups after(study.groups.size());
  std::size_t left = 0;
  for (std::size_t g = 0; g < study.groups.size(); ++g) {
    const CompleteSubjects complete =
        completeSubjects(study, g, {study.occasions.front(), study.occasions.back()});
    left += complete.leftOut;
    for (const std::vector<double>& scores : complete.scores) {
      before[g].push_back(scores.front());
      after[g].push_back(scores.back());
    }
  }
  return outcomeJson(ancova(before, after), [&](const Ancova& result) {
    Json out = testJson(result.group.f, {result.group.df1, result.group.df2}, result.group.p,
                        namedValue("partial_eta_squared", result.partialEtaSquared), noInterval());
    out["covariate"] = study.occasions.front();
    out["outcome"] = study.occasions.back();
    out["left_out"] = left;
    out["slope"] = result.slope;
    out["slope_error"] = result.slopeError;
    out["adjusted_means"] = Json::array();
    for (std::size_t g = 0; g < result.adjusted.size(); ++g) {
      out["adjusted_means"].push_back({{"group", study.groups[g]},
                                       {"mean", result.adjusted[g].mean},
                                       {"interval", intervalJson(result.adjusted[g].interval)}});
    }
    out["pairs"] = Json::array();
    for (const AdjustedDifference& pair : result.pairs) {
      out["pairs"].push_back({{"groups", {study.groups[pair.first], study.groups[pair.second]}},
                              {"statistic", pair.t},
                              {"df", result.residualDf},
                              {"p", pair.p},
                              {"p_holm", pair.pHolm},
                              {"difference", pair.difference},
                              {"interval", intervalJson(pair.interval)}});
    }
    out["equal_slopes"] = outcomeJson(result.equalSlopes, [](const FTest& test) {
      return Json{{"statistic", test.f}, {"df", {test.df1, test.df2}}, {"p", test.p}};
    });
    return out;
  });
}

Json mixedAnovaJson(const Study& study) {
  std::vector<NumberTable> tables;
  std::size_t left = 0;
  for (std::size_t g = 0; g < study.groups.size(); ++g) {
    const CompleteSubjects complete = completeSubjects(study, g, study.occasions);
    left += complete.leftOut;
    tables.emplace_back(complete.scores);
  }
  return outcomeJson(mixedAnova(tables), [&](const MixedAnova& result) {
    Json out;
    out["group"] = effectJson(result.group);
    out["time"] = effectJson(result.time);
    out["interaction"] = effectJson(result.interaction);
    out["sphericity"] = {{"greenhouse_geisser", result.sphericity.greenhouseGeisser},
                         {"huynh_feldt", result.sphericity.huynhFeldt},
                         {"mauchly_w", result.sphericity.mauchlyW},
                         {"mauchly_p", result.sphericity.mauchlyP}};
    out["left_out"] = left;
    return out;
  });
}

}  // namespace torsio::cli
