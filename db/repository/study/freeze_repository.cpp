// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/study/freeze_repository.h"

#include "assessment/domain/ids.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/row_columns.h"

namespace torsio {

namespace {

constexpr auto kFreeze = rowColumns<DataFreeze>(
    "frozen_dataset",
    "id, cohort_id, name, content_hash, manifest_json, created_by, created_utc_us, demonstration",
    &DataFreeze::id, &DataFreeze::cohortId, &DataFreeze::name, &DataFreeze::contentHash,
    &DataFreeze::manifestJson, &DataFreeze::createdBy, &DataFreeze::createdUtc_us,
    &DataFreeze::demonstration);

const std::string kFreezes = kFreeze.select("f") + " FROM frozen_dataset f";

}  // namespace

void FreezeRepository::add(const DataFreeze& freeze) {
  Transaction transaction(connection_);
  if (kFreeze.insertOnce(connection_, freeze, "id", "created_utc_us", Text::tr("this frozen data set")) ==
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
  return selectFirst(connection_, kFreezes + " WHERE f.name = ?", {name}, kFreeze);
}

std::vector<DataFreeze> FreezeRepository::list(const CohortId& cohortId) const {
  return selectAll(connection_, kFreezes + " WHERE f.cohort_id = ? ORDER BY f.created_utc_us, f.id",
                   {cohortId}, kFreeze);
}

}  // namespace torsio
