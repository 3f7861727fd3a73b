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

// Sets of a known truth, and the intervals that are tried on them.

enum class Shape { kNormal, kSkewed, kUniform };

/// Mean 0, standard deviation 1.
double draw(Random& random, Shape shape);
std::vector<double> sample(Random& random, Shape shape, int n, double mean = 0.0, double sd = 1.0);

/// Targets x raters: standard deviation 1 of the targets, 0.5 of the raters, 0.7 of the rest.
NumberTable ratings(Random& random, Shape shape, std::size_t targets, std::size_t raters);

struct Study {
  Groups before;
  Groups after;
};

/// Three groups; the second is better by 0.5 at the end. `slope` of the second group differs by `more`.
Study study(Random& random, Shape shape, int n, double more = 0.0);

/// Marks of three groups of ten by five raters, each missing with probability 0.15.
std::vector<MarkedTrainee> marked(Random& random, Shape shape);

/// Two raters who agree with probability 0.5 and else choose alike by chance: every kappa is 0.5. The shape
/// says how often each of four categories is chosen.
NumberTable agreeing(Random& random, Shape shape, int targets);

/// Marks of targets by raters of their own: standard deviation 1 of the targets, sqrt(0.74) of the rest.
NumberTable unrelated(Random& random, Shape shape, std::size_t targets, std::size_t raters);

double medianOfShape(Shape shape);
/// What nine in ten lie below.
double nineInTen(Shape shape);

/// One set: 1 the interval holds the truth, 0 it does not, -1 it is not defined.
using Trial = std::function<int(Random&, Shape)>;

int holds(const Interval& interval, double truth);

struct Case {
  std::string interval;
  std::string size;
  Trial trial;
  bool slow = false;  ///< a tenth of the sets
};

// Intervals by subject; each adds to the end, so that those before keep their random numbers.
void addComparisonCases(std::vector<Case>& all);   ///< of means, differences, groups
void addReliabilityCases(std::vector<Case>& all);  ///< of the intraclass correlation
void addRaterCases(std::vector<Case>& all);        ///< of agreement and offsets of raters
void addMixedCase(std::vector<Case>& all);         ///< of the difference where marks are missing
void addModelCases(std::vector<Case>& all);        ///< of adjusted means and the mixed model

}  // namespace torsio::coverage
