// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/site_heterogeneity.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "assessment/statistics/descriptive.h"
#include "assessment/statistics/distributions.h"

namespace torsio {

namespace {

/// Means of a group at a centre.
struct SiteCell {
  double n = 0.0;
  double before = 0.0;
  double after = 0.0;
};

/// The model in which each group has a level of its own at each centre, with a common slope.
struct SiteCells {
  std::map<std::pair<std::size_t, std::size_t>, SiteCell> at;  ///< by site and group
  double slope = 0.0;
  double xx = 0.0;
  double variance = 0.0;
  double df = 0.0;
};

Outcome<SiteCells> siteCells(const std::vector<SiteTrainee>& trainees) {
  SiteCells out;
  for (const SiteTrainee& one : trainees) {
    SiteCell& cell = out.at[{one.site, one.group}];
    cell.n += 1.0;
    cell.before += one.before;
    cell.after += one.after;
  }
  for (auto& [place, cell] : out.at) {
    cell.before /= cell.n;
    cell.after /= cell.n;
  }
  double xy = 0.0;
  double yy = 0.0;
  for (const SiteTrainee& one : trainees) {
    const SiteCell& cell = out.at.at({one.site, one.group});
    const double x = one.before - cell.before;
    const double y = one.after - cell.after;
    out.xx += x * x;
    xy += x * y;
    yy += y * y;
  }
  out.df = static_cast<double>(trainees.size() - out.at.size()) - 1.0;
  if (out.df <= 0.0) {
    return Outcome<SiteCells>::undefined(Text::tr("there are too few trainees"));
  }
  if (out.xx == 0.0) {
    return Outcome<SiteCells>::undefined(Text::tr("the scores before do not vary within groups"));
  }
  out.slope = xy / out.xx;
  out.variance = (yy - out.slope * xy) / out.df;
  if (!(yy - out.slope * xy > kLeftByRounding * yy)) {
    return Outcome<SiteCells>::undefined(Text::tr("the scores after follow the scores before exactly"));
  }
  return out;
}

/// Weighted mean if the true differences vary by `tau` (a variance).
struct WeightedMean {
  double weights = 0.0;
  double mean = 0.0;
};

WeightedMean meanWith(const std::vector<SiteDifference>& sites, double tau) {
  WeightedMean out;
  for (const SiteDifference& one : sites) {
    const double weight = 1.0 / (one.error * one.error + tau);
    out.weights += weight;
    out.mean += weight * one.difference;
  }
  out.mean /= out.weights;
  return out;
}

/// Weighted squares about that mean.
double squaresWith(const std::vector<SiteDifference>& sites, double tau) {
  const double mean = meanWith(sites, tau).mean;
  double out = 0.0;
  for (const SiteDifference& one : sites) {
    const double distance = one.difference - mean;
    out += distance * distance / (one.error * one.error + tau);
  }
  return out;
}

/// Returns the variance at which the weighted squares have this value; 0 if they are below it from the start.
double tauAt(const std::vector<SiteDifference>& sites, double value) {
  if (squaresWith(sites, 0.0) <= value) {
    return 0.0;
  }
  double low = 0.0;
  double high = 1.0;
  while (squaresWith(sites, high) > value) {
    low = high;
    high *= 2.0;
  }
  for (int i = 0; i < 200 && low < high; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle == low || middle == high) {
      break;
    }
    (squaresWith(sites, middle) > value ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace

Outcome<std::vector<Heterogeneity>> heterogeneityOfSites(const std::vector<SiteTrainee>& trainees,
                                                         double confidence) {
  using Undefined = Outcome<std::vector<Heterogeneity>>;
  if (const std::optional<Text> reason = sitesNotComparable(trainees)) {
    return Undefined::undefined(*reason);
  }
  const Outcome<SiteCells> cells = siteCells(trainees);
  if (!cells) {
    return Undefined::undefined(cells.reason());
  }
  const std::vector<std::size_t> groups = present(trainees, &SiteTrainee::group);
  const double t = tQuantile(0.5 * (1.0 + confidence), cells->df);
  std::vector<Heterogeneity> out;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    for (std::size_t j = i + 1; j < groups.size(); ++j) {
      Heterogeneity pair;
      pair.first = groups[i];
      pair.second = groups[j];
      for (const std::size_t site : present(trainees, &SiteTrainee::site)) {
        const auto first = cells->at.find({site, groups[i]});
        const auto second = cells->at.find({site, groups[j]});
        if (first == cells->at.end() || second == cells->at.end()) {
          continue;
        }
        const SiteCell& a = first->second;
        const SiteCell& b = second->second;
        const double shift = a.before - b.before;
        SiteDifference one{site,
                           static_cast<std::size_t>(a.n),
                           static_cast<std::size_t>(b.n),
                           a.after - b.after - cells->slope * shift,
                           std::sqrt(cells->variance * (1.0 / a.n + 1.0 / b.n + shift * shift / cells->xx)),
                           {}};
        one.interval = {one.difference - t * one.error, one.difference + t * one.error};
        pair.sites.push_back(one);
      }
      if (pair.sites.size() < 2) {
        continue;
      }
      const auto df = static_cast<double>(pair.sites.size() - 1);
      pair.q = squaresWith(pair.sites, 0.0);
      pair.p = chiSquaredUpper(pair.q, df);
      pair.iSquared = pair.q > 0.0 ? std::max(0.0, (pair.q - df) / pair.q) : 0.0;
      pair.tauSquared = tauAt(pair.sites, df);
      pair.tauInterval = {tauAt(pair.sites, chiSquaredQuantile(0.5 * (1.0 + confidence), df)),
                          tauAt(pair.sites, chiSquaredQuantile(0.5 * (1.0 - confidence), df))};
      const WeightedMean middle = meanWith(pair.sites, pair.tauSquared);
      // Hartung and Knapp: squaresWith(tau) / df is 1 here, or counts as 1 where tau is 0.
      const double reach = tQuantile(0.5 * (1.0 + confidence), df) / std::sqrt(middle.weights);
      pair.average = middle.mean;
      pair.averageInterval = {middle.mean - reach, middle.mean + reach};
      out.push_back(std::move(pair));
    }
  }
  if (out.empty()) {
    return Undefined::undefined(Text::tr("no two centres have trainees of the same two groups"));
  }
  return out;
}

}  // namespace torsio
