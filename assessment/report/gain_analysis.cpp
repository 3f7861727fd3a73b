// SPDX-License-Identifier: GPL-3.0-or-later
// What the groups gained, by ranks of whole numbers and by the median.
#include <cstddef>
#include <span>
#include <vector>

#include "assessment/report/study_parts.h"
#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/quantiles.h"

namespace torsio {

namespace {

/// The median with its interval by resampling trainees.
Outcome<Bootstrap> medianGain(const std::vector<double>& before, const std::vector<double>& after) {
  const auto median = [&](std::span<const std::size_t> chosen) {
    std::vector<double> values;
    for (const std::size_t i : chosen) {
      values.push_back(after[i] - before[i]);
    }
    return medianOf(values);
  };
  return bootstrap(before.size(), median);
}

}  // namespace

void addGains(const CohortInputs& in, StudyAnalysis& study) {
  GainAnalysis out;
  for (std::size_t g = 0; g < in.groups.size(); ++g) {
    const auto exact = exactGains(in.scores, 0, in.occasions.size() - 1, g);
    if (!exact) {
      return;
    }
    out.gains.emplace_back(exact->begin(), exact->end());
    GroupGain gain;
    gain.n = std::ssize(study.ends.before[g]);
    gain.median = medianGain(study.ends.before[g], study.ends.after[g]);
    gain.ranks = signedRank(out.gains.back());
    gain.occasions = friedman(study.courses[g]);
    out.within.push_back(std::move(gain));
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
