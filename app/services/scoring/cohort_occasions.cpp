// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/scoring/cohort_occasions.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/study/cohort.h"
#include "assessment/domain/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"

namespace torsio {

Occasions occasionsOfCohort(Connection& connection, const CohortId& cohortId) {
  const Cohort cohort = StudyRepository(connection).cohort(cohortId);
  OccasionRepository repository(connection);
  Occasions all = repository.all();
  const auto version = CurriculumRepository(connection).version(cohort.curriculumVersionId);
  const std::set<std::string> used = repository.usedBy(cohortId);
  std::vector<Occasion> own;
  if (!used.empty() && repository.cameFromElsewhere(cohortId)) {
    std::copy_if(all.begin(), all.end(), std::back_inserter(own),
                 [&](const Occasion& occasion) { return used.contains(occasion.code); });
    return Occasions(std::move(own));
  }
  if (!version || version->plannedOccasions.empty()) {
    return all;
  }
  for (Occasion occasion : all) {
    for (const PlannedOccasion& point : version->plannedOccasions) {
      if (point.code == occasion.code) {
        occasion.afterExposure_us = point.afterExposure_us;
      }
    }
    if (occasion.afterExposure_us || used.contains(occasion.code)) {
      own.push_back(std::move(occasion));
    }
  }
  return Occasions(std::move(own));
}

}  // namespace torsio
