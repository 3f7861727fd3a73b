// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

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

}  // namespace torsio::coverage
