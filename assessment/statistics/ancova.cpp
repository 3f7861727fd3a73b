// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/ancova.h"

#include <cmath>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"
#include "assessment/statistics/multiplicity.h"

namespace torsio {

namespace {

/// Sums of squares and products about the means.
struct Moments {
  double n = 0.0;
  double meanX = 0.0;
  double meanY = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
};

Moments momentsOf(const std::vector<double>& x, const std::vector<double>& y) {
  TORSIO_EXPECTS(x.size() == y.size());
  Moments m;
  m.n = static_cast<double>(x.size());
  m.meanX = meanOf(x);
  m.meanY = meanOf(y);
  m.xx = sumOfSquares(x);
  m.yy = sumOfSquares(y);
  for (std::size_t i = 0; i < x.size(); ++i) {
    m.xy += (x[i] - m.meanX) * (y[i] - m.meanY);
  }
  return m;
}

Outcome<FTest> slopesTest(const std::vector<Moments>& groups, double residual, double n) {
  const double k = static_cast<double>(groups.size());
  double separate = 0.0;
  for (const Moments& m : groups) {
    if (m.xx == 0.0) {
      return Outcome<FTest>::undefined(Text::tr("the scores before do not vary in one group"));
    }
    separate += m.yy - m.xy * m.xy / m.xx;
  }
  FTest test;
  test.df1 = k - 1.0;
  test.df2 = n - 2.0 * k;
  if (test.df2 <= 0.0 || !(separate > 0.0)) {
    return Outcome<FTest>::undefined(Text::tr("too few trainees for separate slopes"));
  }
  test.f = (residual - separate) / test.df1 / (separate / test.df2);
  test.p = fUpper(std::max(0.0, test.f), test.df1, test.df2);
  return test;
}

void addPairs(const std::vector<Moments>& groups, const Moments& within, double t, Ancova& out) {
  std::vector<double> p;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size(); ++j) {
      AdjustedDifference pair;
      pair.first = i;
      pair.second = j;
      pair.difference = out.adjusted[i].mean - out.adjusted[j].mean;
      const double shift = groups[i].meanX - groups[j].meanX;
      pair.error = std::sqrt(out.residualVariance *
                             (1.0 / groups[i].n + 1.0 / groups[j].n + shift * shift / within.xx));
      pair.t = pair.difference / pair.error;
      pair.p = tTwoSided(pair.t, out.residualDf);
      pair.interval = {pair.difference - t * pair.error, pair.difference + t * pair.error};
      p.push_back(pair.p);
      out.pairs.push_back(pair);
    }
  }
  const std::vector<double> adjusted = adjustHolm(p);
  for (std::size_t i = 0; i < adjusted.size(); ++i) {
    out.pairs[i].pHolm = adjusted[i];
  }
}

}  // namespace

Outcome<Ancova> ancova(const Groups& before, const Groups& after, double confidence) {
  TORSIO_EXPECTS(before.size() == after.size());
  for (const Groups* scores : {&before, &after}) {
    if (const std::optional<Text> reason = beyondArithmetic(*scores)) {
      return Outcome<Ancova>::undefined(*reason);
    }
  }
  if (before.size() < 2) {
    return Outcome<Ancova>::undefined(Text::tr("there are fewer than two groups"));
  }
  std::vector<Moments> groups;
  Moments within;
  std::vector<double> allX;
  std::vector<double> allY;
  for (std::size_t g = 0; g < before.size(); ++g) {
    if (before[g].empty()) {
      return Outcome<Ancova>::undefined(Text::tr("a group is empty"));
    }
    groups.push_back(momentsOf(before[g], after[g]));
    within.xx += groups.back().xx;
    within.xy += groups.back().xy;
    within.yy += groups.back().yy;
    allX.insert(allX.end(), before[g].begin(), before[g].end());
    allY.insert(allY.end(), after[g].begin(), after[g].end());
  }
  const Moments total = momentsOf(allX, allY);
  const double k = static_cast<double>(groups.size());
  Ancova out;
  out.residualDf = total.n - k - 1.0;
  if (out.residualDf <= 0.0) {
    return Outcome<Ancova>::undefined(Text::tr("there are too few trainees"));
  }
  if (within.xx == 0.0) {
    return Outcome<Ancova>::undefined(Text::tr("the scores before do not vary within groups"));
  }
  out.slope = within.xy / within.xx;
  const double residual = within.yy - out.slope * within.xy;
  if (!(residual > 0.0)) {
    return Outcome<Ancova>::undefined(Text::tr("the scores after follow the scores before exactly"));
  }
  out.residualVariance = residual / out.residualDf;
  out.slopeError = std::sqrt(out.residualVariance / within.xx);
  const double withoutGroups = total.yy - total.xy * total.xy / total.xx;
  out.group.df1 = k - 1.0;
  out.group.df2 = out.residualDf;
  out.group.f = (withoutGroups - residual) / out.group.df1 / out.residualVariance;
  out.group.p = fUpper(std::max(0.0, out.group.f), out.group.df1, out.group.df2);
  out.partialEtaSquared = (withoutGroups - residual) / withoutGroups;
  const double t = tQuantile(0.5 * (1.0 + confidence), out.residualDf);
  for (const Moments& m : groups) {
    AdjustedMean adjusted;
    const double shift = m.meanX - total.meanX;
    adjusted.mean = m.meanY - out.slope * shift;
    adjusted.error = std::sqrt(out.residualVariance * (1.0 / m.n + shift * shift / within.xx));
    adjusted.interval = {adjusted.mean - t * adjusted.error, adjusted.mean + t * adjusted.error};
    out.adjusted.push_back(adjusted);
  }
  addPairs(groups, within, t, out);
  out.equalSlopes = slopesTest(groups, residual, total.n);
  return out;
}

}  // namespace torsio
