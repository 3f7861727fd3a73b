// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/audit_repository.h"

#include "db/repository/base/field_digest.h"

namespace torsio {

namespace {

constexpr const char* kColumns =
    "sequence, at_utc_us, actor, station, action, object_kind, object_id, old_json, new_json, reason,"
    " object_hash, previous_hash, entry_hash";
constexpr const char* kInTime = " WHERE at_utc_us >= ? AND at_utc_us <= ?";

AuditEntry entryOf(const Statement& row) {
  return {.sequence = row.int64(0),
          .atUtc_us = row.int64(1),
          .actor = row.text(2),
          .station = row.text(3),
          .action = row.text(4),
          .objectKind = row.text(5),
          .objectId = row.text(6),
          .oldJson = row.text(7),
          .newJson = row.text(8),
          .reason = row.text(9),
          .objectHash = row.text(10),
          .previousHash = row.text(11),
          .entryHash = row.text(12)};
}

bool moreThanLimit(Connection& connection, const AuditFilter& filter) {
  Statement next =
      connection.prepare(std::string("SELECT 1 FROM audit_entry") + kInTime + " LIMIT 1 OFFSET ?");
  next.execute({filter.fromUtc_us, filter.toUtc_us, filter.limit});
  return next.step();
}

}  // namespace

std::string auditHash(const AuditEntry& entry) {
  FieldDigest digest("torsio audit 1");
  digest.add(entry.previousHash).add(entry.sequence).add(entry.atUtc_us).add(entry.actor).add(entry.station);
  digest.add(entry.action).add(entry.objectKind).add(entry.objectId).add(entry.oldJson).add(entry.newJson);
  digest.add(entry.reason).add(entry.objectHash);
  return digest.hex();
}

void AuditRepository::append(std::span<const AuditEntry> entries) {
  Transaction transaction(connection_);
  if (connection_.engine() == Engine::kPostgresql) {
    // SQLite holds its one write lock already.
    connection_.executeVerbatim("LOCK TABLE audit_entry IN SHARE ROW EXCLUSIVE MODE");
  }
  std::int64_t sequence = 0;
  std::string previous;
  Statement last =
      connection_.prepare("SELECT sequence, entry_hash FROM audit_entry ORDER BY sequence DESC LIMIT 1");
  last.execute();
  while (last.step()) {
    sequence = last.int64(0);
    previous = last.text(1);
  }
  Statement insert = connection_.prepare(std::string("INSERT INTO audit_entry (") + kColumns +
                                         ") VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  for (AuditEntry entry : entries) {
    entry.sequence = ++sequence;
    entry.previousHash = previous;
    entry.entryHash = auditHash(entry);
    insert.execute({entry.sequence, entry.atUtc_us, entry.actor, entry.station, entry.action,
                    entry.objectKind, entry.objectId, entry.oldJson, entry.newJson, entry.reason,
                    entry.objectHash, entry.previousHash, entry.entryHash});
    previous = entry.entryHash;
  }
  transaction.commit();
}

std::vector<AuditEntry> AuditRepository::entries(const AuditFilter& filter) {
  // Many entries of a time are not sorted for the newest of them: the chain is walked backwards to the limit.
  // The sign keeps the index of the times out of the plan. Few are found by that index, wherever they lie.
  const bool walk =
      filter.objectKind.empty() && filter.objectId.empty() && moreThanLimit(connection_, filter);
  std::string where = walk ? " WHERE +at_utc_us >= ? AND +at_utc_us <= ?" : kInTime;
  std::vector<Value> values{filter.fromUtc_us, filter.toUtc_us};
  if (!filter.objectKind.empty()) {
    where += " AND object_kind = ?";
    values.emplace_back(filter.objectKind);
  }
  if (!filter.objectId.empty()) {
    where += " AND object_id = ?";
    values.emplace_back(filter.objectId);
  }
  values.emplace_back(filter.limit);
  std::vector<AuditEntry> entries;
  Statement row = connection_.prepare(std::string("SELECT ") + kColumns + " FROM audit_entry" + where +
                                      " ORDER BY sequence DESC LIMIT ?");
  row.execute(values);
  while (row.step()) entries.push_back(entryOf(row));
  return entries;
}

std::int64_t AuditRepository::count(std::int64_t fromUtc_us, std::int64_t toUtc_us) {
  Statement row = connection_.prepare(std::string("SELECT count(*) FROM audit_entry") + kInTime);
  row.execute({fromUtc_us, toUtc_us});
  return row.step() ? row.int64(0) : 0;
}

std::int64_t AuditRepository::length() {
  Statement row = connection_.prepare("SELECT count(*) FROM audit_entry");
  row.execute();
  return row.step() ? row.int64(0) : 0;
}

}  // namespace torsio
