// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "assessment/statistics/ancova.h"
#include "assessment/statistics/categorical_agreement.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/generalizability.h"
#include "assessment/statistics/rank_tests.h"
#include "assessment/statistics/rasch.h"
#include "assessment/statistics/reliability.h"
#include "assessment/statistics/resampling.h"
#include "tests/validation/coverage_cases.h"

namespace torsio::coverage {

double draw(Random& random, Shape shape) {
  switch (shape) {
    case Shape::kNormal:
      return random.normal();
    case Shape::kSkewed:  // exponential
      return -std::log(1.0 - random.uniform()) - 1.0;
    case Shape::kUniform:
      return std::sqrt(12.0) * (random.uniform() - 0.5);
  }
  return 0.0;
}

std::vector<double> sample(Random& random, Shape shape, int n, double mean, double sd) {
  std::vector<double> out;
  for (int i = 0; i < n; ++i) {
    out.push_back(mean + sd * draw(random, shape));
  }
  return out;
}

int holds(const Interval& interval, double truth) {
  return interval.lower <= truth && truth <= interval.upper ? 1 : 0;
}

NumberTable ratings(Random& random, Shape shape, std::size_t targets, std::size_t raters) {
  NumberTable out(targets, raters);
  const std::vector<double> severity = sample(random, shape, static_cast<int>(raters), 0.0, 0.5);
  for (std::size_t i = 0; i < targets; ++i) {
    const double level = draw(random, shape);
    for (std::size_t r = 0; r < raters; ++r) {
      out.at(i, r) = level + severity[r] + 0.7 * draw(random, shape);
    }
  }
  return out;
}

namespace {

/// Three groups whose spreads about the line are `sd`; the second gains 0.5 more.
Study unequal(Random& random, Shape shape, const std::array<int, 3>& sizes, const std::array<double, 3>& sd) {
  Study out;
  for (std::size_t g = 0; g < sizes.size(); ++g) {
    out.before.push_back(sample(random, shape, sizes[g], 5.0));
    out.after.emplace_back();
    for (const double x : out.before.back()) {
      out.after.back().push_back(0.8 * x + (g == 1 ? 0.5 : 0.0) + sd[g] * draw(random, shape));
    }
  }
  return out;
}

/// Adds the intervals of the report's primary comparison.
void addPrimaryCases(const std::string& size, const std::array<int, 3>& sizes,
                     const std::array<double, 3>& sd, std::vector<Case>& all) {
  constexpr std::array kTruths{-0.5, 0.0, 0.5};
  all.push_back({"adjusted difference, HC3", size, [=](Random& random, Shape shape) {
                   const Study of = unequal(random, shape, sizes, sd);
                   return holds(concludedPairs(*ancova(of.before, of.after))[0].interval, kTruths[0]);
                 }});
  all.push_back({"adjusted difference, HC3, after Holm", size, [=](Random& random, Shape shape) {
                   const Study of = unequal(random, shape, sizes, sd);
                   return holds(concludedPairs(*ancova(of.before, of.after))[0].asHolm, kTruths[0]);
                 }});
  all.push_back({"all three differences, HC3, after Holm", size, [=](Random& random, Shape shape) {
                   const Study of = unequal(random, shape, sizes, sd);
                   const Outcome<Ancova> found = ancova(of.before, of.after);
                   int all3 = 1;
                   for (std::size_t i = 0; i < kTruths.size(); ++i) {
                     all3 *= holds(concludedPairs(*found)[i].asHolm, kTruths[i]);
                   }
                   return all3;
                 }});
}

/// Draws one of ten categories of a rating scale with thresholds from -2 to 2.
int rated(Random& random, double level) {
  constexpr int kHighest = 9;
  std::array<double, kHighest + 1> weights{1.0};
  double sum = 1.0;
  double exponent = 0.0;
  for (int k = 1; k <= kHighest; ++k) {
    exponent += level + 2.0 - 4.0 * (k - 1) / (kHighest - 1);
    weights[static_cast<std::size_t>(k)] = std::exp(exponent);
    sum += weights[static_cast<std::size_t>(k)];
  }
  double at = random.uniform() * sum;
  int category = 0;
  while (category < kHighest && (at -= weights[static_cast<std::size_t>(category)]) > 0.0) {
    ++category;
  }
  return category;
}

}  // namespace

Study study(Random& random, Shape shape, int n, double more) {
  Study out;
  for (int g = 0; g < 3; ++g) {
    out.before.push_back(sample(random, shape, n, 5.0));
    out.after.emplace_back();
    for (const double x : out.before.back()) {
      out.after.back().push_back(1.0 + (0.8 + (g == 1 ? more : 0.0)) * (x - 5.0) + (g == 1 ? 0.5 : 0.0) +
                                 0.6 * draw(random, shape));
    }
  }
  return out;
}

std::vector<MarkedTrainee> marked(Random& random, Shape shape) {
  const std::vector<double> severity = sample(random, shape, 5, 0.0, 0.5);
  std::vector<MarkedTrainee> out;
  for (std::size_t i = 0; i < 30; ++i) {
    MarkedTrainee trainee;
    trainee.group = i % 3;
    const double score = draw(random, shape);
    const double later = 0.8 * score + (trainee.group == 1 ? 0.5 : 0.0) + 0.5 * draw(random, shape);
    for (const double rater : severity) {
      trainee.before.emplace_back(score);  // known: an error of the covariate would bias the truth itself
      const double mark = later + rater + 0.7 * draw(random, shape);
      trainee.after.push_back(random.uniform() < 0.15 ? std::nullopt : std::optional(mark));
    }
    out.push_back(std::move(trainee));
  }
  return out;
}

NumberTable agreeing(Random& random, Shape shape, int targets) {
  const std::array<double, 3> upTo = shape == Shape::kNormal   ? std::array{0.15, 0.5, 0.85}
                                     : shape == Shape::kSkewed ? std::array{0.6, 0.85, 0.95}
                                                               : std::array{0.25, 0.5, 0.75};
  const auto category = [&] {
    const double u = random.uniform();
    return static_cast<std::size_t>(std::upper_bound(upTo.begin(), upTo.end(), u) - upTo.begin());
  };
  NumberTable counts(4, 4);
  for (int i = 0; i < targets; ++i) {
    const std::size_t first = category();
    const std::size_t second = random.uniform() < 0.5 ? first : category();
    counts.at(first, second) += 1.0;
  }
  return counts;
}

NumberTable unrelated(Random& random, Shape shape, std::size_t targets, std::size_t raters) {
  NumberTable out(targets, raters);
  for (std::size_t i = 0; i < targets; ++i) {
    const double level = draw(random, shape);
    for (std::size_t r = 0; r < raters; ++r) {
      out.at(i, r) = level + std::sqrt(0.74) * draw(random, shape);
    }
  }
  return out;
}

double medianOfShape(Shape shape) {
  return shape == Shape::kSkewed ? std::log(2.0) - 1.0 : 0.0;
}

double nineInTen(Shape shape) {
  return shape == Shape::kNormal   ? 1.2815515655446004
         : shape == Shape::kSkewed ? std::log(10.0) - 1.0
                                   : std::sqrt(12.0) * 0.4;
}

void addMixedCase(std::vector<Case>& all) {
  all.push_back({"difference, mixed model, 15 % missing", "3 x 10, 5 raters",
                 [](Random& random, Shape shape) {
                   const auto model = mixedComparison(marked(random, shape), 3);
                   return model ? holds(model->pairs[0].difference.interval, -0.5) : -1;
                 },
                 true});
}

void addModelCases(std::vector<Case>& all) {
  for (const int n : {10, 40}) {
    const std::string size = "3 x " + std::to_string(n);
    all.push_back({"adjusted mean, ANCOVA", size, [n](Random& random, Shape shape) {
                     const Study of = study(random, shape, n);
                     double sum = 0.0;
                     for (const std::vector<double>& group : of.before) {
                       sum += meanOf(group) / 3.0;
                     }
                     return holds(ancova(of.before, of.after)->adjusted[0].interval, 1.0 + 0.8 * (sum - 5.0));
                   }});
    all.push_back({"adjusted difference at 90 %, equivalence", size, [n](Random& random, Shape shape) {
                     const Study of = study(random, shape, n);
                     const Outcome<Ancova> test = ancova(of.before, of.after);
                     const AdjustedDifference& pair = test->pairs[0];
                     return holds(equivalence(pair.difference, pair.error, test->residualDf, 1.0).interval,
                                  -0.5);
                   }});
    all.push_back({"median, bootstrap BCa", std::to_string(n),
                   [n](Random& random, Shape shape) {
                     const std::vector<double> x = sample(random, shape, n);
                     const ResampledStatistic median = [&](std::span<const std::size_t> rows) {
                       std::vector<double> values;
                       for (const std::size_t row : rows) {
                         values.push_back(x[row]);
                       }
                       return medianOf(values);
                     };
                     const auto result = bootstrap(x.size(), median, {random.next(), 999, false, 0.95});
                     return result ? holds(result->bca, medianOfShape(shape)) : -1;
                   },
                   true});
  }
  const std::string marks = "3 x 10, 5 raters";
  all.push_back({"all three differences, mixed model, Bonferroni", marks,
                 [](Random& random, Shape shape) {
                   const auto model = mixedComparison(marked(random, shape), 3);
                   return model ? holds(model->pairs[0].simultaneous, -0.5) *
                                      holds(model->pairs[1].simultaneous, 0.0) *
                                      holds(model->pairs[2].simultaneous, 0.5)
                                : -1;
                 },
                 true});
  all.push_back({"adjusted mean, mixed model", marks,
                 [](Random& random, Shape shape) {
                   const auto model = mixedComparison(marked(random, shape), 3);
                   return model ? holds(model->adjusted[0].interval, 0.8 * model->covariateMean) : -1;
                 },
                 true});
  all.push_back({"slope on the score before, mixed model", marks,
                 [](Random& random, Shape shape) {
                   const auto model = mixedComparison(marked(random, shape), 3);
                   return model ? holds(model->slope.interval, 0.8) : -1;
                 },
                 true});
}

void addReliabilityCases(std::vector<Case>& all) {
  const double single = 1.0 / (1.0 + 0.25 + 0.49);
  for (const auto& [targets, raters] : {std::pair{10, 4}, std::pair{30, 10}}) {
    const std::string size = std::to_string(targets) + " x " + std::to_string(raters);
    const auto form = [=](IccForm IccResult::*of, double truth) {
      return [=](Random& random, Shape shape) {
        const auto icc = intraclassCorrelation(
            ratings(random, shape, static_cast<std::size_t>(targets), static_cast<std::size_t>(raters)));
        return icc && ((*icc).*of).interval ? holds(*((*icc).*of).interval, truth) : -1;
      };
    };
    const double k = raters;
    all.push_back({"ICC(2,1)", size, form(&IccResult::agreementSingle, single)});
    all.push_back({"ICC(2,k)", size, form(&IccResult::agreementMean, 1.0 / (1.0 + (0.25 + 0.49) / k))});
    all.push_back({"ICC(3,1)", size, form(&IccResult::consistencySingle, 1.0 / 1.49)});
    all.push_back({"Cronbach alpha, Feldt", size, [=](Random& random, Shape shape) {
                     const auto alpha = cronbachAlpha(ratings(
                         random, shape, static_cast<std::size_t>(targets), static_cast<std::size_t>(raters)));
                     return alpha ? holds(alpha->interval, 1.0 / (1.0 + 0.49 / k)) : -1;
                   }});
  }
}

void addPrimaryComparisonCases(std::vector<Case>& all) {
  addPrimaryCases("3 x 10", {10, 10, 10}, {0.6, 0.6, 0.6}, all);
  addPrimaryCases("3 x 10, SD 0.3, 0.6, 0.9", {10, 10, 10}, {0.3, 0.6, 0.9}, all);
  addPrimaryCases("5, 5, 5, SD 0.9, 0.6, 0.3", {5, 5, 5}, {0.9, 0.6, 0.3}, all);
  addPrimaryCases("4, 12, 12, SD 0.9, 0.6, 0.3", {4, 12, 12}, {0.9, 0.6, 0.3}, all);
  addPrimaryCases("3 x 40, SD 0.3, 0.6, 0.9", {40, 40, 40}, {0.3, 0.6, 0.9}, all);
  for (const std::size_t k : {3U, 10U}) {
    for (const bool mean : {false, true}) {
      all.push_back({mean ? "dependability of the mean of all, within groups"
                          : "dependability of one rater, within groups",
                     "3 x 10 x " + std::to_string(k), [k, mean](Random& random, Shape shape) {
                       const std::vector<double> severity =
                           sample(random, shape, static_cast<int>(k), 0.0, 0.5);
                       std::vector<NumberTable> groups(3, NumberTable(10, k));
                       for (std::size_t g = 0; g < groups.size(); ++g) {
                         for (std::size_t i = 0; i < 10; ++i) {
                           const double level = 2.0 * static_cast<double>(g) + draw(random, shape);
                           for (std::size_t r = 0; r < k; ++r) {
                             groups[g].at(i, r) = level + severity[r] + 0.7 * draw(random, shape);
                           }
                         }
                       }
                       const double raters = mean ? static_cast<double>(k) : 1.0;
                       const auto found = dependabilityInterval(*gStudyPRWithin(groups), raters);
                       return found ? holds(*found, 1.0 / (1.0 + (0.25 + 0.49) / raters)) : -1;
                     }});
    }
  }
}

void addRaterCases(std::vector<Case>& all) {
  for (const auto& [targets, raters] : {std::pair{10, 4}, std::pair{30, 10}}) {
    const auto n = static_cast<std::size_t>(targets);
    const auto k = static_cast<std::size_t>(raters);
    const std::string size = std::to_string(targets) + " x " + std::to_string(raters);
    all.push_back({"ICC(1,1), raters of their own", size, [=](Random& random, Shape shape) {
                     const auto icc = intraclassCorrelation(unrelated(random, shape, n, k));
                     return icc && icc->oneWaySingle.interval ? holds(*icc->oneWaySingle.interval, 1.0 / 1.74)
                                                              : -1;
                   }});
    all.push_back({"Krippendorff alpha, units resampled", size,
                   [=](Random& random, Shape shape) {
                     const NumberTable table = unrelated(random, shape, n, k);
                     IncompleteRatings byRater(k);
                     for (std::size_t r = 0; r < k; ++r) {
                       for (std::size_t i = 0; i < n; ++i) {
                         byRater[r].emplace_back(table.at(i, r));
                       }
                     }
                     const auto found =
                         krippendorffInterval(byRater, AlphaMetric::kInterval, random.next(), 999);
                     return found ? holds(found->interval, 1.0 / 1.74) : -1;
                   },
                   true});
    all.push_back({"offset of a rater, Student", size, [=](Random& random, Shape shape) {
                     const std::vector<double> severity = sample(random, shape, raters, 0.0, 0.5);
                     std::vector<double> offsets;
                     for (std::size_t i = 0; i < n; ++i) {
                       double others = 0.0;
                       const double own = severity[0] + 0.7 * draw(random, shape);
                       for (std::size_t r = 1; r < k; ++r) {
                         others += severity[r] + 0.7 * draw(random, shape);
                       }
                       offsets.push_back(own - others / static_cast<double>(k - 1));
                     }
                     double truth = severity[0];
                     for (std::size_t r = 1; r < k; ++r) {
                       truth -= severity[r] / static_cast<double>(k - 1);
                     }
                     return holds(*meanInterval(offsets), truth);
                   }});
  }
  for (const std::size_t k : {3U, 5U, 10U}) {
    all.push_back({"severity of a rater, Rasch, corrected", "30 x " + std::to_string(k),
                   [k](Random& random, Shape shape) {
                     std::vector<double> severity = sample(random, shape, static_cast<int>(k), 0.0, 0.6);
                     const double middle = meanOf(severity);
                     CategoryRatings given;
                     std::map<int, int> used;
                     for (std::size_t i = 0; i < 30; ++i) {
                       const double ability = 1.2 * draw(random, shape);
                       given.emplace_back();
                       for (std::size_t r = 0; r < k; ++r) {
                         given.back().emplace_back(rated(random, ability - severity[r] + middle));
                         used[*given.back().back()] = 0;
                       }
                     }
                     int highest = -1;
                     for (auto& [category, place] : used) {
                       place = ++highest;
                     }
                     for (auto& row : given) {
                       for (std::optional<int>& rating : row) {
                         rating = used.at(*rating);
                       }
                     }
                     const auto found = manyFacetRasch(given, highest);
                     const auto own = found ? correctedSeverities(given, *found).front() : std::nullopt;
                     return own ? holds(own->interval, severity[0] - middle) : -1;
                   },
                   true});
  }
  for (const int n : {30, 100}) {
    for (const auto& [name, weights] :
         {std::pair{"Cohen kappa", KappaWeights::kUnweighted},
          std::pair{"Cohen kappa, quadratic weights", KappaWeights::kQuadratic}}) {
      all.push_back({name, std::to_string(n), [n, weights = weights](Random& random, Shape shape) {
                       const auto kappa = cohenKappa(agreeing(random, shape, n), weights);
                       return kappa ? holds(kappa->interval, 0.5) : -1;
                     }});
    }
  }
}

namespace {

void addPairCases(int n, std::vector<Case>& all) {
  const std::string size = "2 x " + std::to_string(n);
  all.push_back({"difference, Student", size, [n](Random& random, Shape shape) {
                   return holds(studentT(sample(random, shape, n, 0.5), sample(random, shape, n))->interval,
                                0.5);
                 }});
  all.push_back({"difference, Welch, SD 1 and 2", size, [n](Random& random, Shape shape) {
                   return holds(
                       welchT(sample(random, shape, n, 0.5), sample(random, shape, n, 0.0, 2.0))->interval,
                       0.5);
                 }});
  all.push_back({"Hedges g, noncentral t", size, [n](Random& random, Shape shape) {
                   return holds(hedgesG(sample(random, shape, n, 0.8), sample(random, shape, n))->interval,
                                0.8);
                 }});
  all.push_back({"shift, Hodges-Lehmann", size, [n](Random& random, Shape shape) {
                   const auto test = mannWhitney(sample(random, shape, n, 0.5), sample(random, shape, n));
                   return test && test->hodgesLehmannInterval ? holds(*test->hodgesLehmannInterval, 0.5) : -1;
                 }});
}

void addStudyCases(int n, std::vector<Case>& all) {
  all.push_back({"adjusted difference, ANCOVA", "3 x " + std::to_string(n), [n](Random& random, Shape shape) {
                   const Study of = study(random, shape, n);
                   return holds(ancova(of.before, of.after)->pairs[0].interval, -0.5);
                 }});
  all.push_back({"all three adjusted differences, Bonferroni", "3 x " + std::to_string(n),
                 [n](Random& random, Shape shape) {
                   const Study of = study(random, shape, n);
                   const Outcome<Ancova> test = ancova(of.before, of.after);
                   return holds(test->pairs[0].simultaneous, -0.5) * holds(test->pairs[1].simultaneous, 0.0) *
                          holds(test->pairs[2].simultaneous, 0.5);
                 }});
  all.push_back({"difference at a score before, separate slopes", "3 x " + std::to_string(n),
                 [n](Random& random, Shape shape) {
                   const Study of = study(random, shape, n, 0.5);
                   const std::vector<double> at{6.0};
                   return holds(separateSlopes(of.before, of.after, at)->pairs[0].at[0].interval, -1.0);
                 }});
  all.push_back({"all pairs, Tukey", "3 x " + std::to_string(n),
                 [n](Random& random, Shape shape) {
                   const Groups groups{sample(random, shape, n), sample(random, shape, n, 0.5),
                                       sample(random, shape, n)};
                   const auto pairs = tukeyPairs(groups);
                   return holds((*pairs)[0].interval, 0.5) * holds((*pairs)[1].interval, 0.0) *
                          holds((*pairs)[2].interval, -0.5);
                 },
                 true});
  all.push_back({"all pairs, Games-Howell, SD 1, 2, 3", "3 x " + std::to_string(n),
                 [n](Random& random, Shape shape) {
                   const Groups groups{sample(random, shape, n), sample(random, shape, n, 0.5, 2.0),
                                       sample(random, shape, n, 0.0, 3.0)};
                   const auto pairs = gamesHowellPairs(groups);
                   return holds((*pairs)[0].interval, 0.5) * holds((*pairs)[1].interval, 0.0) *
                          holds((*pairs)[2].interval, -0.5);
                 },
                 true});
}

void addSampleCases(int n, std::vector<Case>& all) {
  all.push_back({"correlation 0.6, Fisher", std::to_string(n), [n](Random& random, Shape shape) {
                   const std::vector<double> x = sample(random, shape, n);
                   std::vector<double> y;
                   for (const double value : x) {
                     y.push_back(0.6 * value + 0.8 * draw(random, shape));
                   }
                   return holds(*pearson(x, y)->fisherInterval, 0.6);
                 }});
  for (const char* which : {"percentile", "basic", "BCa"}) {
    all.push_back({std::string("mean, bootstrap ") + which, std::to_string(n),
                   [n, which = std::string(which)](Random& random, Shape shape) {
                     const std::vector<double> x = sample(random, shape, n);
                     const ResampledStatistic mean = [&](std::span<const std::size_t> rows) {
                       double sum = 0.0;
                       for (const std::size_t row : rows) {
                         sum += x[row];
                       }
                       return sum / static_cast<double>(rows.size());
                     };
                     const auto result = bootstrap(x.size(), mean, {random.next(), 999, false, 0.95});
                     if (!result) {
                       return -1;
                     }
                     return holds(which == "percentile" ? result->percentile
                                  : which == "basic"    ? result->basic
                                                        : result->bca,
                                  0.0);
                   },
                   true});
  }
  all.push_back({"Bland-Altman lower limit", std::to_string(n), [n](Random& random, Shape shape) {
                   const std::vector<double> x = sample(random, shape, n);
                   std::vector<double> zero(x.size(), 0.0);
                   return holds(blandAltman(x, zero)->lowerLimitInterval, -kAgreementLimit);
                 }});
}

}  // namespace

void addComparisonCases(std::vector<Case>& all) {
  for (const int n : {5, 10, 40}) {
    all.push_back({"mean, Student", std::to_string(n), [n](Random& random, Shape shape) {
                     return holds(*meanInterval(sample(random, shape, n)), 0.0);
                   }});
  }
  for (const int n : {10, 40}) {
    addPairCases(n, all);
    addStudyCases(n, all);
    addSampleCases(n, all);
  }
}

}  // namespace torsio::coverage
