// SPDX-License-Identifier: GPL-3.0-or-later
// Properties of the raters derived from the marks: agreement in whole points, number needed, severity on one
// scale.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <functional>
#include <future>
#include <iterator>
#include <set>
#include <span>
#include <vector>

#include "assessment/results/study_parts.h"
#include "assessment/statistics/resampling.h"

namespace torsio {

namespace {

PointAgreement agreementInPoints(const OccasionMarks& at, const std::vector<std::size_t>& groupOf,
                                 std::size_t group) {
  const auto pointOf = [&](double mark) { return static_cast<std::int64_t>(std::lround(mark)); };
  PointAgreement out;
  for (auto a = at.present.begin(); a != at.present.end(); ++a) {
    for (auto b = std::next(a); b != at.present.end(); ++b) {
      std::vector<double> first;
      std::vector<double> second;
      ++out.pairs;
      for (std::size_t i = 0; i < at.marks.size(); ++i) {
        const std::vector<std::optional<double>>& marks = at.marks[i];
        if (groupOf[i] != group || !marks[*a] || !marks[*b]) {
          continue;
        }
        const std::int64_t x = pointOf(*marks[*a]);
        const std::int64_t y = pointOf(*marks[*b]);
        first.push_back(static_cast<double>(x));
        second.push_back(static_cast<double>(y));
        ++out.shared;
        out.same += x == y ? 1 : 0;
        out.withinOne += std::abs(x - y) <= 1 ? 1 : 0;
      }
      if (const Outcome<double> kappa = quadraticKappa(first, second)) {
        out.kappas.push_back(*kappa);
      }
    }
  }
  return out;
}

/// Returns the minimum number of raters whose mean is dependable enough; empty if more than kMaxRaters.
template <typename Dependable>
std::optional<std::size_t> fewestRaters(const Dependable& dependable) {
  for (std::size_t raters = 1; raters <= kMaxRaters; ++raters) {
    if (dependable(static_cast<double>(raters))) {
      return raters;
    }
  }
  return std::nullopt;
}

RatersNeeded ratersNeeded(const OccasionMarks& last) {
  RatersNeeded out;
  out.marks = last.completeTrainees * std::ssize(last.present);
  if (!last.within) {
    return out;
  }
  const GStudy& found = *last.within;
  for (const std::size_t raters : std::set<std::size_t>{1, 2, 3, 5, 10, last.present.size()}) {
    const auto k = static_cast<double>(raters);
    out.planned.push_back({raters, dStudyPR(found, k), dependabilityInterval(found, k)});
  }
  out.fewestByEstimate = fewestRaters([&](double raters) {
    const Outcome<DStudy> of = dStudyPR(found, raters);
    return of && of->dependability >= kWantedDependability;
  });
  out.fewest = fewestRaters([&](double raters) {
    const std::optional<Interval> of = dependabilityInterval(found, raters);
    return of && of->lower >= kWantedDependability;
  });
  return out;
}

/// Uses the marks that occur, in order, as categories without gaps.
void putOnOneScale(const OccasionMarks& last, StudyAnalysis& out) {
  std::set<double> used;
  for (const auto& row : last.marks) {
    for (const std::optional<double>& mark : row) {
      if (mark) {
        used.insert(*mark);
      }
    }
  }
  if (used.size() < 2) {
    out.rasch = Outcome<RaschResult>::undefined(Text::tr("every rating is the same"));
    return;
  }
  CategoryRatings ratings;
  for (const auto& row : last.marks) {
    ratings.emplace_back();
    for (const std::optional<double>& mark : row) {
      ratings.back().push_back(
          mark ? std::optional(static_cast<int>(std::distance(used.begin(), used.find(*mark))))
               : std::nullopt);
    }
  }
  out.rasch = manyFacetRasch(ratings, static_cast<int>(used.size()) - 1, out.raters);
  if (out.rasch) {
    out.onOneScale = correctedSeverities(ratings, *out.rasch);
  }
}

}  // namespace

void addRaterModels(StudyAnalysis& study) {
  for (OccasionMarks& occasion : study.occasions) {
    for (GroupAgreement& of : occasion.groups) {
      of.points = agreementInPoints(occasion, study.groupOf, of.group);
    }
  }
  study.needed = ratersNeeded(study.occasions.back());
  putOnOneScale(study.occasions.back(), study);
}

namespace {

/// Returns the median with its interval by resampling trainees. For a resample, counts how often each of the
/// sorted gains was drawn instead of sorting.
Outcome<Bootstrap> medianGain(const std::vector<double>& before, const std::vector<double>& after) {
  std::vector<double> gains;
  for (std::size_t i = 0; i < before.size(); ++i) {
    gains.push_back(after[i] - before[i]);
  }
  std::sort(gains.begin(), gains.end());  // the interval does not depend on the order of the trainees
  std::vector<double> sorted = gains;
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  std::vector<std::size_t> rankOf;
  for (const double gain : gains) {
    rankOf.push_back(static_cast<std::size_t>(
        std::distance(sorted.begin(), std::lower_bound(sorted.begin(), sorted.end(), gain))));
  }
  std::vector<std::size_t> drawn(sorted.size());
  return bootstrap(before.size(), [&](std::span<const std::size_t> chosen) {
    std::fill(drawn.begin(), drawn.end(), std::size_t{0});
    for (const std::size_t i : chosen) {
      ++drawn[rankOf[i]];
    }
    std::size_t at = 0;
    std::size_t upTo = drawn.front();
    const auto next = [&](std::size_t place) {
      while (upTo <= place) {
        upTo += drawn[++at];
      }
      return sorted[at];
    };
    const std::size_t half = chosen.size() / 2;
    if (chosen.size() % 2 == 1) {
      return next(half);
    }
    const double lower = next(half - 1);
    return 0.5 * (lower + next(half));
  });
}

}  // namespace

void addGains(const CohortInputs& in, StudyAnalysis& study) {
  GainAnalysis out;
  std::vector<std::future<Outcome<Bootstrap>>> medians;  // in parallel, as far as there are cores
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const auto exact = exactGains(in.scores, 0, in.occasions.size() - 1, g);
    if (!exact) {
      return;
    }
    out.gains.emplace_back(exact->begin(), exact->end());
    GroupGain gain;
    gain.n = std::ssize(study.ends.before[g]);
    medians.push_back(std::async(std::launch::async, medianGain, std::cref(study.ends.before[g]),
                                 std::cref(study.ends.after[g])));
    gain.ranks = signedRank(out.gains.back());
    gain.occasions = friedman(study.courses[g]);
    out.within.push_back(std::move(gain));
  }
  for (std::size_t g = 0; g < medians.size(); ++g) {
    out.within[g].median = medians[g].get();
  }
  out.between = kruskalWallis(out.gains);
  if (out.between) {
    for (const DunnPair& pair : out.between->pairs) {
      out.pairs.push_back(mannWhitney(out.gains[pair.first], out.gains[pair.second]));
    }
  }
  study.gains = std::move(out);
}

}  // namespace torsio
