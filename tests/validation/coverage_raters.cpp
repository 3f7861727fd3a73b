// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>
#include <utility>

#include "assessment/statistics/categorical_agreement.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/reliability.h"
#include "assessment/statistics/resampling.h"
#include "tests/validation/coverage_cases.h"

namespace torsio::coverage {

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

}  // namespace torsio::coverage
