// SPDX-License-Identifier: GPL-3.0-or-later
#include <span>
#include <string>

#include "assessment/statistics/ancova.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/resampling.h"
#include "tests/validation/coverage_cases.h"

namespace torsio::coverage {

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

}  // namespace torsio::coverage
