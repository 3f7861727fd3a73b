// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/study/freeze_repository.h"

#include <array>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/insert_idempotent.h"

namespace torsio {

namespace {

const std::string kFreezes =
    "SELECT id, cohort_id, name, content_hash, manifest_json, created_by, created_utc_us, demonstration"
    " FROM frozen_dataset";

DataFreeze freezeOf(RowReader& row) {
  return {.id = row.text(),
          .cohortId = row.text(),
          .name = row.text(),
          .contentHash = row.text(),
          .manifestJson = row.text(),
          .createdBy = row.text(),
          .createdUtc_us = row.int64(),
          .demonstration = row.boolean()};
}

}  // namespace

void FreezeRepository::add(const DataFreeze& freeze) {
  using Kind = IdempotentColumn::Kind;
  Transaction transaction(connection_);
  const std::array<IdempotentColumn, 8> columns{{{"id", freeze.id, Kind::kKey},
                                                 {"cohort_id", freeze.cohortId},
                                                 {"name", freeze.name},
                                                 {"content_hash", freeze.contentHash},
                                                 {"manifest_json", freeze.manifestJson},
                                                 {"created_by", freeze.createdBy},
                                                 {"created_utc_us", freeze.createdUtc_us, Kind::kIgnored},
                                                 {"demonstration", freeze.demonstration}}};
  if (insertIdempotent(connection_, "frozen_dataset", columns, Text::tr("this frozen data set")) ==
      Inserted::kNew) {
    NewAuditEntry entry{.atUtc_us = freeze.createdUtc_us,
                        .actor = freeze.createdBy,
                        .station = station_,
                        .action = AuditAction::kDatasetFreeze,
                        .objectKind = AuditObject::kFrozenDataset,
                        .objectId = freeze.id,
                        .objectHash = freeze.contentHash};
    AuditRepository(connection_).append(entry);
  }
  transaction.commit();
}

std::optional<DataFreeze> FreezeRepository::findByName(const std::string& name) const {
  return selectFirst(connection_, kFreezes + " WHERE name = ?", {name}, freezeOf);
}

std::vector<DataFreeze> FreezeRepository::list(const CohortId& cohortId) const {
  return selectAll(connection_, kFreezes + " WHERE cohort_id = ? ORDER BY created_utc_us, id", {cohortId},
                   freezeOf);
}

}  // namespace torsio
