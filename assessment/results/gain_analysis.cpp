// SPDX-License-Identifier: GPL-3.0-or-later
// Gains of the groups, by ranks of whole numbers and by the median.
#include <algorithm>
#include <cstddef>
#include <functional>
#include <future>
#include <iterator>
#include <span>
#include <vector>

#include "assessment/results/study_parts.h"
#include "assessment/statistics/resampling.h"

namespace torsio {

namespace {

/// Returns the median with its interval by resampling trainees. For a resample, counts how often each of the
/// sorted gains was drawn instead of sorting.
Outcome<Bootstrap> medianGain(const std::vector<double>& before, const std::vector<double>& after) {
  std::vector<double> gains;
  for (std::size_t i = 0; i < before.size(); ++i) {
    gains.push_back(after[i] - before[i]);
  }
  std::vector<double> sorted = gains;
  std::sort(sorted.begin(), sorted.end());
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
