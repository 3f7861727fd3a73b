// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/base/csv_table.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "assessment/statistics/ancova.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/mixed_anova.h"
#include "assessment/statistics/multiplicity.h"
#include "assessment/statistics/rank_tests.h"
#include "sim/base/error.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

struct CompareArguments {
  std::string file;
  std::string occasion;
};

struct Subject {
  std::string name;
  std::size_t group = 0;
  std::size_t row = 0;
  std::map<std::string, double> scores;  // by occasion
};

/// Groups, occasions and subjects in the order in which the file names them.
struct Study {
  std::vector<std::string> groups;
  std::vector<std::string> occasions;
  std::vector<Subject> subjects;
};

template <class Items, class Same>
std::size_t place(Items& items, const Same& same, typename Items::value_type item) {
  const auto found = std::find_if(items.begin(), items.end(), same);
  if (found != items.end()) return static_cast<std::size_t>(found - items.begin());
  items.push_back(std::move(item));
  return items.size() - 1;
}

std::size_t placeName(std::vector<std::string>& names, const std::string& name) {
  return place(
      names, [&](const std::string& other) { return other == name; }, name);
}

Study readStudy(const CsvTable& table) {
  Study study;
  std::map<std::pair<std::string, std::string>, std::size_t> rowOf;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string& name = table.text(row, "subject");
    const std::string occasion = table.has("occasion") ? table.text(row, "occasion") : "only";
    const std::size_t group = placeName(study.groups, table.text(row, "group"));
    placeName(study.occasions, occasion);
    const auto [first, isNew] = rowOf.emplace(std::pair{name, occasion}, row);
    if (!isNew)
      table.refuse(row,
                   "subject \"" + name + "\" has a second score" +
                       (table.has("occasion") ? " at occasion \"" + occasion + "\"" : "") + ", first in " +
                       table.where(first->second),
                   "Average marks over the raters first: one score for each subject and occasion");
    const std::size_t s = place(
        study.subjects, [&](const Subject& other) { return other.name == name; },
        Subject{name, group, row, {}});
    if (study.subjects[s].group != group)
      table.refuse(row,
                   "subject \"" + name + "\" is in group \"" + study.groups[group] +
                       "\", but in another in " + table.where(study.subjects[s].row),
                   "A subject belongs to one group");
    if (const auto score = table.numberIfGiven(row, "score")) study.subjects[s].scores[occasion] = *score;
  }
  return study;
}

/// Scores at one occasion, group by group.
Groups scoresAt(const Study& study, const std::string& occasion) {
  Groups groups(study.groups.size());
  for (const Subject& subject : study.subjects)
    if (const auto score = subject.scores.find(occasion); score != subject.scores.end())
      groups[subject.group].push_back(score->second);
  return groups;
}

/// One test in the form that all share; what a test does not have is said, never left out.
Json testJson(double statistic, Json df, double p, Json effect, Json interval) {
  Json out;
  out["statistic"] = statistic;
  out["df"] = std::move(df);
  out["p"] = p;
  out["effect_size"] = std::move(effect);
  out["interval"] = std::move(interval);
  return out;
}

Json namedValue(const char* name, double value) {
  return {{"name", name}, {"value", value}};
}

Json noInterval() {
  return undefinedJson("this test has no interval");
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
  if (!whole)
    return undefinedJson("the scores have more than six decimals, so they cannot be counted exactly");
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
  Comparison(const std::vector<std::string>& names, const Groups& groups) : names_(names), groups_(groups) {}

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
  }

 private:
  /// Two groups: the test itself. More: one entry a pair, with p adjusted by Holm over the pairs.
  Json pairs(const PairTest& test) const {
    if (groups_.size() < 2) return undefinedJson("there is only one group");
    if (groups_.size() == 2) return labelled(0, 1, test({groups_[0], groups_[1]}));
    Json list = Json::array();
    std::vector<double> p;
    for (std::size_t i = 0; i < groups_.size(); ++i)
      for (std::size_t j = i + 1; j < groups_.size(); ++j) {
        list.push_back(labelled(i, j, test({groups_[i], groups_[j]})));
        if (list.back().contains("p")) p.push_back(list.back()["p"].get<double>());
      }
    const std::vector<double> holm = adjustHolm(p);
    std::size_t at = 0;
    for (Json& entry : list)
      if (entry.contains("p")) entry["p_holm"] = holm[at++];
    return {{"pairs", list}};
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
      Json effect = equal ? namedValue("omega_squared", equal->omegaSquared) : undefinedJson(equal.reason());
      return testJson(test.f, {test.df1, test.df2}, test.p, std::move(effect), noInterval());
    });
  }

  Json kruskalWallisJson() const {
    return outcomeJson(kruskalWallis(groups_), [&](const KruskalWallis& test) {
      Json out =
          testJson(test.h, test.df, test.p, namedValue("epsilon_squared", test.epsilonSquared), noInterval());
      if (test.pExact) out["p_exact"] = *test.pExact;
      Json pairs = Json::array();
      for (const DunnPair& pair : test.pairs)
        pairs.push_back({{"groups", {names_[pair.first], names_[pair.second]}},
                         {"statistic", pair.z},
                         {"p", pair.p},
                         {"p_holm", pair.pHolm},
                         {"mean_rank_difference", pair.difference}});
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
};

Json ancovaJson(const Study& study) {
  Groups before(study.groups.size());
  Groups after(study.groups.size());
  std::size_t left = 0;
  for (const Subject& subject : study.subjects) {
    const auto first = subject.scores.find(study.occasions.front());
    const auto last = subject.scores.find(study.occasions.back());
    if (first == subject.scores.end() || last == subject.scores.end()) {
      ++left;
      continue;
    }
    before[subject.group].push_back(first->second);
    after[subject.group].push_back(last->second);
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
    for (std::size_t g = 0; g < result.adjusted.size(); ++g)
      out["adjusted_means"].push_back({{"group", study.groups[g]},
                                       {"mean", result.adjusted[g].mean},
                                       {"interval", intervalJson(result.adjusted[g].interval)}});
    out["pairs"] = Json::array();
    for (const AdjustedDifference& pair : result.pairs)
      out["pairs"].push_back({{"groups", {study.groups[pair.first], study.groups[pair.second]}},
                              {"statistic", pair.t},
                              {"df", result.residualDf},
                              {"p", pair.p},
                              {"p_holm", pair.pHolm},
                              {"difference", pair.difference},
                              {"interval", intervalJson(pair.interval)}});
    out["equal_slopes"] = outcomeJson(result.equalSlopes, [](const FTest& test) {
      return Json{{"statistic", test.f}, {"df", {test.df1, test.df2}}, {"p", test.p}};
    });
    return out;
  });
}

Json effectJson(const std::optional<AnovaEffect>& effect) {
  if (!effect) return undefinedJson("there is only one group");
  Json out = testJson(effect->f, {effect->df, effect->dfError}, effect->p,
                      namedValue("generalised_eta_squared", effect->generalizedEtaSquared), noInterval());
  out["partial_eta_squared"] = effect->partialEtaSquared;
  if (effect->pGreenhouseGeisser) out["p_greenhouse_geisser"] = *effect->pGreenhouseGeisser;
  if (effect->pHuynhFeldt) out["p_huynh_feldt"] = *effect->pHuynhFeldt;
  return out;
}

Json mixedAnovaJson(const Study& study) {
  std::vector<std::vector<std::vector<double>>> rows(study.groups.size());
  std::size_t left = 0;
  for (const Subject& subject : study.subjects) {
    std::vector<double> row;
    for (const std::string& occasion : study.occasions)
      if (const auto score = subject.scores.find(occasion); score != subject.scores.end())
        row.push_back(score->second);
    if (row.size() == study.occasions.size())
      rows[subject.group].push_back(std::move(row));
    else
      ++left;
  }
  const std::vector<NumberTable> tables(rows.begin(), rows.end());
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

Json groupsJson(const Study& study, const Groups& groups) {
  Json out = Json::array();
  for (std::size_t g = 0; g < groups.size(); ++g) {
    Json entry{{"group", study.groups[g]}, {"n", groups[g].size()}};
    entry["mean"] = groups[g].empty() ? undefinedJson("nobody has a score") : Json(meanOf(groups[g]));
    entry["sd"] = numberJson(sampleDeviation(groups[g]), "fewer than two scores");
    out.push_back(std::move(entry));
  }
  return out;
}

void runCompareGroups(const CompareArguments& arguments) {
  const CsvTable table = CsvTable::read(arguments.file, {"subject", "group", "score"}, {"occasion"});
  noteIgnoredColumns(table);
  const Study study = readStudy(table);
  const std::string occasion = arguments.occasion.empty() ? study.occasions.back() : arguments.occasion;
  if (std::find(study.occasions.begin(), study.occasions.end(), occasion) == study.occasions.end())
    throw Error(ErrorCode::kBadParameter, "the table has no occasion \"" + occasion + "\"", table.name(),
                "Give one of its occasions after --occasion");
  const Groups groups = scoresAt(study, occasion);
  Json out;
  Comparison(study.groups, groups).addTo(out);
  if (study.occasions.size() > 1) {
    out["ancova"] = ancovaJson(study);
    out["mixed_anova"] = mixedAnovaJson(study);
  }
  out["groups"] = groupsJson(study, groups);
  if (table.has("occasion")) {
    out["occasions"] = study.occasions;
    out["occasion"] = occasion;
  }
  out["confidence"] = kUsualConfidence;
  printJson(out);
}

}  // namespace

void addCompareGroups(CLI::App& program) {
  auto arguments = std::make_shared<CompareArguments>();
  CLI::App* command = program.add_subcommand("compare-groups", "Tests and effect sizes between groups");
  command->add_option("FILE", arguments->file, "CSV with the columns subject,group,score and maybe occasion")
      ->required();
  command->add_option("--occasion", arguments->occasion,
                      "Occasion at which the groups are compared; default: the last of the file");
  command->callback([arguments] { runCompareGroups(*arguments); });
}

}  // namespace torsio::cli
