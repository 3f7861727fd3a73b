// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scoring/cohort_occasions.h"

#include <set>
#include <utility>
#include <vector>

#include "assessment/study/cohort.h"
#include "assessment/study/curriculum.h"
#include "db/connection/connection.h"
#include "db/repository/study/curriculum_repository.h"
#include "db/repository/study/occasion_repository.h"
#include "db/repository/study/study_repository.h"
#include "sim/base/ids.h"

namespace torsio {

Occasions occasionsOfCohort(Connection& connection, const CohortId& cohortId) {
  const Cohort cohort = StudyRepository(connection).cohort(cohortId);
  OccasionRepository repository(connection);
  Occasions all = repository.all();
  const auto version = CurriculumRepository(connection).version(cohort.curriculumVersionId);
  if (!version || version->plannedOccasions.empty()) {
    return all;
  }
  std::set<std::string> used = repository.usedBy(cohortId);
  std::vector<Occasion> own;
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
