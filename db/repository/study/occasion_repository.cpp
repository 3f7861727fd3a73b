// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/study/occasion_repository.h"

#include <utility>
#include <vector>

#include "assessment/domain/ids.h"
#include "db/connection/row_reader.h"
#include "sim/core/foreign_recording.h"

namespace torsio {

Occasions OccasionRepository::all() const {
  return Occasions(selectAll(connection_, "SELECT code, label FROM occasion ORDER BY position, code", {},
                             [](RowReader& row) {
                               return Occasion{row.text(), row.text(), {}};
                             }));
}

void OccasionRepository::add(const Occasion& occasion) {
  connection_.execute(
      "INSERT INTO occasion (code, label, position)"
      " VALUES (?, ?, (SELECT COALESCE(MAX(s.position), 0) + 1 FROM occasion s))",
      {occasion.code, occasion.label});
}

bool OccasionRepository::cameFromElsewhere(const CohortId& cohortId) const {
  return selectFirst(connection_,
                     "SELECT t.id FROM trial t JOIN enrolment e ON e.id = t.enrolment_id"
                     " WHERE e.cohort_id = ? AND t.scene_id = ? AND t.phase_id IS NULL LIMIT 1",
                     {cohortId, std::string(kForeignScene)}, readText)
      .has_value();
}

std::set<std::string> OccasionRepository::usedBy(const CohortId& cohortId) const {
  const std::vector<std::string> codes =
      selectAll(connection_,
                // The first sheet or mark of each occasion is enough; a large study has a hundred thousand.
                "SELECT s.code FROM occasion s WHERE"
                " EXISTS (SELECT 1 FROM enrolment e JOIN assignment a ON a.enrolment_id = e.id"
                " WHERE e.cohort_id = ? AND a.occasion = s.code)"
                " OR EXISTS (SELECT 1 FROM enrolment e JOIN training_mark m ON m.enrolment_id = e.id"
                " WHERE e.cohort_id = ? AND m.occasion = s.code)",
                {cohortId, cohortId}, readText);
  return {codes.begin(), codes.end()};
}

}  // namespace torsio
