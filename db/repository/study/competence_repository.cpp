// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/study/competence_repository.h"

#include <utility>

#include "assessment/domain/ids.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/stored_term.h"

namespace torsio {

namespace {

constexpr const char* kColumns =
    "module_id, version, registered_utc_us, tolerance_rad, tolerance_source, experts, adequate, inadequate,"
    " attempts, false_pass_most, false_fail_most, sum_limit, reason";

CompetenceDesign designOf(RowReader& row) {
  return {.moduleId = row.text(),
          .version = row.int64(),
          .registeredUtc_us = row.int64(),
          .tolerance_rad = row.real(),
          .source = readTerm<ToleranceSource>(row, "tolerance_source"),
          .experts = row.int64(),
          .adequate = row.real(),
          .inadequate = row.real(),
          .attempts = row.int64(),
          .falsePassMost = row.real(),
          .falseFailMost = row.real(),
          .limit = row.real(),
          .reason = row.text()};
}

}  // namespace

CompetenceDesign CompetenceRepository::add(CompetenceDesign design) {
  Transaction transaction(connection_);
  const std::vector<CompetenceDesign> before = ofModule(design.moduleId);
  design.version = before.empty() ? 1 : before.back().version + 1;
  connection_.execute(
      insertInto("competence_design", kColumns),
      {design.moduleId, design.version, design.registeredUtc_us, design.tolerance_rad,
       storedText(design.source), design.experts, design.adequate, design.inadequate, design.attempts,
       design.falsePassMost, design.falseFailMost, design.limit, design.reason});
  transaction.commit();
  return design;
}

std::vector<CompetenceDesign> CompetenceRepository::ofModule(const ModuleId& moduleId) const {
  return selectAll(
      connection_,
      "SELECT " + std::string(kColumns) + " FROM competence_design WHERE module_id = ? ORDER BY version",
      {moduleId}, designOf);
}

}  // namespace torsio
