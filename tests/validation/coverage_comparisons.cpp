// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <span>
#include <string>

#include "assessment/statistics/ancova.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/rank_tests.h"
#include "assessment/statistics/reliability.h"
#include "assessment/statistics/resampling.h"
#include "tests/validation/coverage_cases.h"

namespace torsio::coverage {

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
