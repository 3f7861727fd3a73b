// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/statistics/site_trainees.h"

#include <set>

#include "assessment/statistics/descriptive.h"

namespace torsio {

std::vector<std::size_t> present(const std::vector<SiteTrainee>& trainees, std::size_t SiteTrainee::*member) {
  std::set<std::size_t> found;
  for (const SiteTrainee& one : trainees) {
    found.insert(one.*member);
  }
  return {found.begin(), found.end()};
}

std::optional<Text> sitesNotComparable(const std::vector<SiteTrainee>& trainees) {
  std::vector<std::vector<double>> scores(2);
  for (const SiteTrainee& one : trainees) {
    scores[0].push_back(one.before);
    scores[1].push_back(one.after);
  }
  if (std::optional<Text> reason = beyondArithmetic(scores)) {
    return reason;
  }
  if (present(trainees, &SiteTrainee::group).size() < 2) {
    return Text::tr("fewer than two groups have scores at both occasions");
  }
  if (present(trainees, &SiteTrainee::site).size() < 2) {
    return Text::tr("fewer than two centres have scores at both occasions");
  }
  return std::nullopt;
}

}  // namespace torsio
