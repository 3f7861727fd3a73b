// SPDX-License-Identifier: GPL-3.0-or-later
// Tests between groups over several occasions: analysis of covariance, mixed model, analysis of variance.
#include <algorithm>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/cli/comparison_methods.h"
#include "app/cli/json_output.h"
#include "assessment/statistics/ancova.h"
#include "assessment/statistics/missing_marks.h"
#include "assessment/statistics/mixed_anova.h"

namespace torsio::cli {

namespace {

using Json = nlohmann::ordered_json;

/// Lists the subjects excluded for a missing score.
void addLeftOut(const std::vector<std::string>& subjects, Json& out) {
  out["left_out"] = subjects.size();
  out["left_out_subjects"] = subjects;
}

/// Lists the groups that are not compared.
Json leftOutGroups(const Study& study, const std::vector<std::size_t>& compared) {
  Json left = Json::array();
  for (std::size_t g = 0; g < study.groups.size(); ++g) {
    if (std::find(compared.begin(), compared.end(), g) == compared.end()) {
      left.push_back(study.groups[g]);
    }
  }
  return left;
}

Json fTestJson(const Outcome<FTest>& outcome) {
  return outcomeJson(outcome, [](const FTest& test) {
    return Json{{"statistic", test.f}, {"df", {test.df1, test.df2}}, {"p", test.p}};
  });
}

/// A difference of two groups with its intervals; `margin`: of the equivalence test; empty: no test.
Json differenceJson(const AdjustedDifference& pair, const std::optional<double>& margin) {
  Json out{{"statistic", pair.t},
           {"df", pair.df},
           {"p", pair.p},
           {"p_holm", pair.pHolm},
           {"difference", pair.difference},
           {"error", pair.error},
           {"interval", intervalJson(pair.interval)},
           {"interval_holm", intervalJson(pair.asHolm)},
           {"interval_simultaneous", intervalJson(pair.simultaneous)}};
  if (margin) {
    out["equivalence"] = equivalenceJson(pair.difference, pair.error, pair.df, *margin);
  }
  return out;
}

Json pairJson(const Study& study, std::size_t first, std::size_t second, const Json& what) {
  Json out{{"groups", {study.groups[first], study.groups[second]}}};
  out.update(what);
  return out;
}

Json regionJson(const SignificantRegion& region) {
  if (region.inside) {
    return {{"between", intervalJson(*region.inside)}};
  }
  if (region.outside) {
    return {{"outside", intervalJson(*region.outside)}};
  }
  return region.everywhere ? "everywhere" : "nowhere";
}

/// Differences with one slope per group; needed if the slopes differ significantly.
Json slopesJson(const Study& study, const CompleteCases& cases) {
  return outcomeJson(
      separateSlopes(cases.before, cases.after, defaultBaselines(cases.before)),
      [&](const SeparateSlopes& result) {
        Json out{{"slopes", Json::array()}, {"baselines", result.baselines}, {"pairs", Json::array()}};
        for (std::size_t g = 0; g < result.slopes.size(); ++g) {
          out["slopes"].push_back({{"group", study.groups[result.groups[g]]},
                                   {"slope", result.slopes[g]},
                                   {"error", result.slopeErrors[g]}});
        }
        for (const SlopesPair& pair : result.pairs) {
          Json entry{{"at", Json::array()}};
          for (std::size_t b = 0; b < pair.at.size(); ++b) {
            Json at{{"baseline", result.baselines[b]}};
            at.update(differenceJson(pair.at[b], std::nullopt));
            entry["at"].push_back(std::move(at));
          }
          entry["differ"] = regionJson(pair.region);
          out["pairs"].push_back(pairJson(study, pair.first, pair.second, entry));
        }
        return out;
      });
}

/// Residuals by subject, with the normal quantiles.
Json residualsJson(const std::vector<std::vector<std::string>>& subjects, const Ancova& result) {
  Json list = Json::array();
  for (std::size_t g = 0; g < subjects.size(); ++g) {
    for (std::size_t i = 0; i < subjects[g].size(); ++i) {
      list.push_back({{"subject", subjects[g][i]},
                      {"fitted", result.fitted[g][i]},
                      {"residual", result.residuals[g][i]},
                      {"normal_quantile", result.quantiles[g][i]}});
    }
  }
  return list;
}

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

Json estimateJson(const ModelEstimate& estimate) {
  return {{"statistic", estimate.t}, {"df", estimate.df},
          {"p", estimate.p},         {"estimate", estimate.value},
          {"error", estimate.error}, {"interval", intervalJson(estimate.interval)}};
}

Json comparisonJson(const Study& study, const MixedComparison& result, const CovarianceRequest& request) {
  Json out = fTestJson(result.group);
  out["df_method"] = "Satterthwaite";
  out["subjects"] = result.trainees;
  out["marks"] = result.marks;
  out["left_out_groups"] = leftOutGroups(study, result.groups);
  out["variances"] = {{"subjects", result.varianceTrainees},
                      {"raters", result.varianceRaters},
                      {"residual", result.varianceResidual}};
  out["restricted_criterion"] = result.criterion;
  out["slope"] = estimateJson(result.slope);
  out["adjusted_means"] = Json::array();
  for (std::size_t g = 0; g < result.adjusted.size(); ++g) {
    Json entry{{"group", study.groups[result.groups[g]]}};
    entry.update(estimateJson(result.adjusted[g]));
    for (const char* against0 : {"statistic", "p"}) {  // the origin of a scale is no hypothesis
      entry.erase(against0);
    }
    out["adjusted_means"].push_back(std::move(entry));
  }
  out["pairs"] = Json::array();
  for (const MixedComparison::Pair& pair : result.pairs) {
    Json entry = estimateJson(pair.difference);
    entry["p_holm"] = pair.pHolm;
    entry["interval_holm"] = intervalJson(pair.asHolm);
    entry["interval_simultaneous"] = intervalJson(pair.simultaneous);
    if (request.margin) {
      entry["equivalence"] =
          equivalenceJson(pair.difference.value, pair.difference.error, pair.difference.df, *request.margin);
    }
    out["pairs"].push_back(pairJson(study, pair.first, pair.second, entry));
  }
  return out;
}

Json boundsJson(const Study& study, const std::vector<MarkedTrainee>& subjects, const Interval& scale) {
  constexpr std::size_t kMaxGroups = 20;
  if (study.groups.size() > kMaxGroups) {
    return undefinedJson("bounds are computed for at most 20 groups");
  }
  const auto show = [](const AdjustedDifference& pair) {
    return Json{{"difference", pair.difference}, {"interval", intervalJson(pair.interval)}};
  };
  Json list = Json::array();
  for (const MissingBounds& pair : missingBounds(subjects, study.groups.size(), scale.lower, scale.upper)) {
    list.push_back(
        pairJson(study, pair.first, pair.second,
                 {{"worst", outcomeJson(pair.worst, show)}, {"best", outcomeJson(pair.best, show)}}));
  }
  return list;
}

}  // namespace

Json equivalenceJson(double difference, double error, double df, double margin) {
  const Equivalence test = equivalence(difference, error, df, margin);
  return {{"margin", test.margin}, {"p", test.p}, {"interval", intervalJson(test.interval)}};
}

Json ancovaJson(const Study& study, const CovarianceRequest& request) {
  CompleteCases cases;
  std::vector<std::string> left;
  std::vector<std::vector<std::string>> subjects;
  for (std::size_t g = 0; g < study.groups.size(); ++g) {
    const CompleteSubjects complete = completeSubjects(study, g, {request.covariate, request.outcome});
    subjects.push_back(complete.names);
    left.insert(left.end(), complete.leftOut.begin(), complete.leftOut.end());
    cases.before.emplace_back();
    cases.after.emplace_back();
    for (const std::vector<double>& scores : complete.scores) {
      cases.before.back().push_back(scores.front());
      cases.after.back().push_back(scores.back());
    }
  }
  return outcomeJson(ancova(cases.before, cases.after), [&](const Ancova& result) {
    Json out = testJson(result.group.f, {result.group.df1, result.group.df2}, result.group.p,
                        namedValue("partial_eta_squared", result.partialEtaSquared), noInterval());
    out["covariate"] = request.covariate;
    out["outcome"] = request.outcome;
    addLeftOut(left, out);
    out["left_out_groups"] = leftOutGroups(study, result.groups);
    out["slope"] = result.slope;
    out["slope_error"] = result.slopeError;
    out["adjusted_means"] = Json::array();
    for (std::size_t g = 0; g < result.adjusted.size(); ++g) {
      out["adjusted_means"].push_back({{"group", study.groups[result.groups[g]]},
                                       {"mean", result.adjusted[g].mean},
                                       {"interval", intervalJson(result.adjusted[g].interval)}});
    }
    const std::vector<AdjustedDifference>& concluded = concludedPairs(result);
    const bool robust = &concluded != &result.pairs;
    out["errors"] = robust ? "HC3" : "pooled";
    out["spread"] = {{"largest", result.spread.largest}, {"smallest", result.spread.smallest}};
    out["spread"]["equal"] = fTestJson(result.spread.test);
    out["pairs"] = Json::array();
    for (std::size_t i = 0; i < concluded.size(); ++i) {
      Json pair = differenceJson(concluded[i], request.margin);
      if (robust) {
        pair["pooled"] = differenceJson(result.pairs[i], request.margin);
      }
      out["pairs"].push_back(pairJson(study, concluded[i].first, concluded[i].second, pair));
    }
    out["equal_slopes"] = fTestJson(result.equalSlopes);
    if (result.equalSlopes && result.equalSlopes->p < kSlopesDiffer) {
      out["separate_slopes"] = slopesJson(study, cases);
    }
    if (request.residuals) {
      out["residuals"] = residualsJson(subjects, result);
    }
    return out;
  });
}

Json mixedModelJson(const Study& study, const CovarianceRequest& request) {
  const std::vector<MarkedTrainee> subjects = markedSubjects(study, request.covariate, request.outcome);
  Json out = outcomeJson(mixedComparison(subjects, study.groups.size()), [&](const MixedComparison& result) {
    return comparisonJson(study, result, request);
  });
  out["covariate"] = request.covariate;
  out["outcome"] = request.outcome;
  std::vector<std::string> left;
  for (const std::size_t i : completeCases(subjects, study.groups.size()).leftOut) {
    left.push_back(study.subjects[i].name);
  }
  addLeftOut(left, out);
  out["missing_marks"] = Json::array();
  const std::vector<MissingCount> missing = missingMarks(subjects);
  for (std::size_t i = 0; i < missing.size(); ++i) {
    if (missing[i].before + missing[i].after > 0) {
      out["missing_marks"].push_back({{"subject", study.subjects[i].name},
                                      {"covariate", missing[i].before},
                                      {"outcome", missing[i].after}});
    }
  }
  if (request.scale) {
    out["bounds"] = boundsJson(study, subjects, *request.scale);
  }
  return out;
}

Json mixedAnovaJson(const Study& study) {
  std::vector<NumberTable> tables;
  std::vector<std::string> left;
  std::vector<std::size_t> compared;
  for (std::size_t g = 0; g < study.groups.size(); ++g) {
    const CompleteSubjects complete = completeSubjects(study, g, study.occasions);
    if (!complete.scores.empty()) {
      compared.push_back(g);
    }
    left.insert(left.end(), complete.leftOut.begin(), complete.leftOut.end());
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
    addLeftOut(left, out);
    out["left_out_groups"] = leftOutGroups(study, compared);
    return out;
  });
}

}  // namespace torsio::cli
