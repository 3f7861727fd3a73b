// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/occasion_repository.h"

#include <utility>
#include <vector>

namespace torsio {

Occasions OccasionRepository::all() {
  std::vector<Occasion> list;
  Statement row = connection_.prepare("SELECT code, label FROM scoring_point ORDER BY position, code");
  row.execute();
  while (row.step()) {
    list.push_back({row.text(0), row.text(1), {}});
  }
  return Occasions(std::move(list));
}

void OccasionRepository::add(const Occasion& occasion) {
  connection_.execute(
      "INSERT INTO scoring_point (code, label, position)"
      " VALUES (?, ?, (SELECT COALESCE(MAX(s.position), 0) + 1 FROM scoring_point s))",
      {occasion.code, occasion.label});
}

std::set<std::string> OccasionRepository::usedBy(const std::string& cohortId) {
  std::set<std::string> codes;
  Statement row = connection_.prepare(
      "SELECT m.scoring_point FROM training_mark m JOIN enrolment e ON e.id = m.enrolment_id"
      " WHERE e.cohort_id = ?"
      " UNION SELECT a.scoring_point FROM assignment a JOIN enrolment e ON e.id = a.enrolment_id"
      " WHERE e.cohort_id = ?");
  row.execute({cohortId, cohortId});
  while (row.step()) {
    codes.insert(row.text(0));
  }
  return codes;
}

}  // namespace torsio
