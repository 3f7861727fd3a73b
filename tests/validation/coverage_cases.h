// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "assessment/statistics/mean_tests.h"
#include "assessment/statistics/missing_marks.h"
#include "assessment/statistics/values.h"
#include "sim/core/random.h"

namespace torsio::coverage {

// Simulated sets with a known truth, and the intervals under test.

enum class Shape { kNormal, kSkewed, kUniform };

/// Draws a number with mean 0, standard deviation 1.
double draw(Random& random, Shape shape);
std::vector<double> sample(Random& random, Shape shape, int n, double mean = 0.0, double sd = 1.0);

/// Targets x raters: standard deviation 1 for targets, 0.5 for raters, 0.7 for residuals.
NumberTable ratings(Random& random, Shape shape, std::size_t targets, std::size_t raters);

struct Study {
  Groups before;
  Groups after;
};

/// Three groups; the second gains 0.5 more. The `slope` of the second group differs by `more`.
Study study(Random& random, Shape shape, int n, double more = 0.0);

/// Marks of three groups of ten by five raters, each missing with probability 0.15.
std::vector<MarkedTrainee> marked(Random& random, Shape shape);

/// Two raters who agree with probability 0.5 and otherwise choose independently: every kappa is 0.5. The
/// shape determines the frequencies of four categories.
NumberTable agreeing(Random& random, Shape shape, int targets);

/// Marks of targets by different raters each: standard deviation 1 for targets, sqrt(0.74) for residuals.
NumberTable unrelated(Random& random, Shape shape, std::size_t targets, std::size_t raters);

double medianOfShape(Shape shape);
/// The 90th percentile of a shape.
double nineInTen(Shape shape);

/// Result for one set: 1 the interval contains the truth, 0 it does not, -1 undefined.
using Trial = std::function<int(Random&, Shape)>;

int holds(const Interval& interval, double truth);

struct Case {
  std::string interval;
  std::string size;
  Trial trial;
  bool slow = false;  ///< uses a tenth of the sets
};

// Intervals by subject; new ones are appended, so that the earlier ones keep their random numbers.
void addComparisonCases(std::vector<Case>& all);   ///< means, differences, groups
void addReliabilityCases(std::vector<Case>& all);  ///< intraclass correlation
void addRaterCases(std::vector<Case>& all);        ///< agreement and rater offsets
void addMixedCase(std::vector<Case>& all);         ///< the difference with missing marks
void addModelCases(std::vector<Case>& all);        ///< adjusted means and the mixed model
void addPrimaryComparisonCases(
    std::vector<Case>& all);  ///< as the first page and the raters' section have them

}  // namespace torsio::coverage
