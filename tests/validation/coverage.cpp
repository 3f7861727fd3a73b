// SPDX-License-Identifier: GPL-3.0-or-later
// Coverage of each 95 % interval over 10,000 simulated sets of the stated size and shape. Prints a table. Not
// a test: `ninja torsio_coverage`, then run it (some minutes; `torsio_coverage SETS NAME` for intervals whose
// names contain NAME); slow intervals use 1,000 sets.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "assessment/domain/rating/instrument.h"
#include "assessment/scoring/evaluation_resampling.h"
#include "assessment/statistics/curve_fit.h"
#include "assessment/statistics/standard_setting.h"
#include "tests/validation/coverage_cases.h"

namespace torsio::coverage {
namespace {

/// Intervals added after those of cases(), whose random numbers must not change.
void addLaterCases(std::vector<Case>& all) {
  for (const int n : {12, 30}) {
    all.push_back({"exponential learning curve, band at the last attempt", std::to_string(n),
                   [n](Random& random, Shape shape) {
                     std::vector<double> attempt;
                     std::vector<double> value;
                     for (int i = 1; i <= n; ++i) {
                       attempt.push_back(i);
                       value.push_back(20.0 + 30.0 * std::exp(-0.3 * (i - 1)) + 2.0 * draw(random, shape));
                     }
                     const auto curve = fitLearningCurve(LearningFamily::kExponential, attempt, value);
                     return curve ? holds(learningBandAt(*curve, n), 20.0 + 30.0 * std::exp(-0.3 * (n - 1)))
                                  : -1;
                   },
                   true});
  }
  for (const int n : {8, 20}) {
    all.push_back(
        {"bound that covers nine in ten, experts", std::to_string(n), [n](Random& random, Shape shape) {
           const auto found = proficiencyThreshold(sample(random, shape, n), {});
           return found ? (found->toleranceBound >= nineInTen(shape) ? 1 : 0) : -1;
         }});
  }
  all.push_back({"comprehensive score N, panels drawn anew", "20 + 10 + 10",
                 [](Random& random, Shape shape) {
                   EvaluationInstrument instrument = paperInstrument();
                   instrument.scale = {0, 10'000, 10};
                   ModelRatings model{"PM", {}};
                   const std::array<int, 3> raters{20, 10, 10};
                   for (std::size_t c = 0; c < raters.size(); ++c) {
                     for (int i = 0; i < raters[c]; ++i) {
                       RaterSheet sheet{std::to_string(c) + "-" + std::to_string(i), c, {}};
                       const double own = draw(random, shape);
                       for (std::size_t j = 0; j < instrument.indices.size(); ++j) {
                         sheet.steps.emplace_back(
                             std::llround(5000.0 + 300.0 * own + 300.0 * draw(random, shape)));
                       }
                       model.sheets.push_back(std::move(sheet));
                     }
                   }
                   const ScoreRange range = resampledScore(instrument, model, {999, random.next()});
                   return holds({range.lower, range.upper}, 500.0);
                 },
                 true});
}

std::vector<Case> cases() {
  std::vector<Case> all;
  addComparisonCases(all);
  addReliabilityCases(all);
  addMixedCase(all);
  addRaterCases(all);
  addModelCases(all);
  addLaterCases(all);
  addPrimaryComparisonCases(all);
  return all;
}

int run(int most, const std::string& named) {
  std::printf("| interval | n | sets | normal | skewed | uniform |\n|---|---|---|---|---|---|\n");
  std::uint64_t stream = 0;
  for (const Case& one : cases()) {
    constexpr int kSlower = 10;
    if (one.interval.find(named) == std::string::npos) {
      stream += 3;  // so that the others keep their numbers
      continue;
    }
    const int sets = one.slow ? most / kSlower : most;
    std::printf("| %s | %s | %d |", one.interval.c_str(), one.size.c_str(), sets);
    for (const Shape shape : {Shape::kNormal, Shape::kSkewed, Shape::kUniform}) {
      Random random = Random::forStream(1, ++stream);
      int defined = 0;
      int held = 0;
      for (int set = 0; set < sets; ++set) {
        const int result = one.trial(random, shape);
        defined += result >= 0 ? 1 : 0;
        held += result == 1 ? 1 : 0;
      }
      std::printf(" %.1f", 100.0 * held / std::max(1, defined));
      if (defined < sets) {
        std::printf(" (%d undefined)", sets - defined);
      }
      std::printf(" |");
      std::fflush(stdout);
    }
    std::printf("\n");
  }
  return 0;
}

}  // namespace
}  // namespace torsio::coverage

int main(int count, char** arguments) {
  constexpr int kSets = 10'000;
  return torsio::coverage::run(count > 1 ? std::atoi(arguments[1]) : kSets, count > 2 ? arguments[2] : "");
}
