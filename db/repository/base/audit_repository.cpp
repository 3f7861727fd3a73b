// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/base/audit_repository.h"

#include <array>

#include "db/repository/base/field_digest.h"
#include "db/repository/base/row_columns.h"

namespace torsio {

namespace {

constexpr auto kEntry = rowColumns<AuditEntry>(
    "audit_entry",
    "sequence, at_utc_us, actor, station, action, object_kind, object_id, old_json, new_json, reason,"
    " object_hash, previous_hash, entry_hash",
    &AuditEntry::sequence, &AuditEntry::atUtc_us, &AuditEntry::actor, &AuditEntry::station,
    &AuditEntry::action, &AuditEntry::objectKind, &AuditEntry::objectId, &AuditEntry::oldJson,
    &AuditEntry::newJson, &AuditEntry::reason, &AuditEntry::objectHash, &AuditEntry::previousHash,
    &AuditEntry::entryHash);
const std::string kSelectEntries = kEntry.select("n") + " FROM audit_entry n";
constexpr const char* kInTime = " WHERE at_utc_us >= ? AND at_utc_us <= ?";
constexpr const char* kActs = " AND action <> 'record.seal'";  // seals of rows are nobody's acts

/// Returns the entry that `added` becomes after `previous`, without its own hash.
AuditEntry following(const NewAuditEntry& added, std::int64_t sequence, const std::string& previous) {
  return {.sequence = sequence,
          .atUtc_us = added.atUtc_us,
          .actor = added.actor,
          .station = added.station,
          .action = std::string(storedText(added.action)),
          .objectKind = std::string(storedText(added.objectKind)),
          .objectId = added.objectId,
          .oldJson = added.oldJson,
          .newJson = added.newJson,
          .reason = added.reason,
          .objectHash = added.objectHash,
          .previousHash = previous};
}

bool moreThanLimit(Connection& connection, const AuditFilter& filter) {
  return selectFirst(connection, std::string("SELECT 1 FROM audit_entry") + kInTime + " LIMIT 1 OFFSET ?",
                     {filter.fromUtc_us, filter.toUtc_us, filter.limit}, readInt64)
      .has_value();
}

}  // namespace

std::string auditHash(const AuditEntry& entry) {
  FieldDigest digest("torsio audit 1");
  digest.add(entry.previousHash).add(entry.sequence).add(entry.atUtc_us).add(entry.actor).add(entry.station);
  digest.add(entry.action).add(entry.objectKind).add(entry.objectId).add(entry.oldJson).add(entry.newJson);
  digest.add(entry.reason).add(entry.objectHash);
  return digest.hex();
}

std::int64_t AuditRepository::append(std::span<const NewAuditEntry> entries) {
  Transaction transaction(connection_);
  if (connection_.engine() == Engine::kPostgresql) {
    // SQLite already holds its only write lock. No table lock: a role that may only insert may not take one.
    connection_.executeVerbatim("SELECT pg_advisory_xact_lock(1414484563, hashtext(current_schema()::text))");
  }
  auto [sequence, previous] = head();
  Statement insert = connection_.prepare(kEntry.insert());
  for (const NewAuditEntry& added : entries) {
    AuditEntry entry = following(added, ++sequence, previous);
    entry.entryHash = auditHash(entry);
    insert.execute(kEntry.values(entry));
    previous = entry.entryHash;
  }
  transaction.commit();
  return sequence;
}

std::vector<AuditEntry> AuditRepository::entries(const AuditFilter& filter) {
  // For a large time range, walk the chain backwards up to the limit instead of sorting for the newest; the
  // unary plus keeps the time index out of the plan. For a small range, use that index.
  const bool walk = !filter.objectKind && filter.objectId.empty() && moreThanLimit(connection_, filter);
  std::string where = walk ? " WHERE +at_utc_us >= ? AND +at_utc_us <= ?" : kInTime;
  std::vector<Value> values{filter.fromUtc_us, filter.toUtc_us};
  if (filter.objectKind) {
    where += " AND object_kind = ?";
    values.emplace_back(storedText(*filter.objectKind));
  }
  if (!filter.objectId.empty()) {
    where += " AND object_id = ?";
    values.emplace_back(filter.objectId);
  }
  where += kActs;
  values.emplace_back(filter.limit);
  return selectAll(connection_, kSelectEntries + where + " ORDER BY sequence DESC LIMIT ?", values, kEntry);
}

void AuditRepository::forEach(const std::function<void(const AuditEntry&)>& take) const {
  Statement entries = connection_.prepare(kSelectEntries + " ORDER BY sequence");
  entries.execute();
  while (entries.step()) {
    take(readRow(entries, kEntry));
  }
}

std::int64_t AuditRepository::count(std::int64_t fromUtc_us, std::int64_t toUtc_us) const {
  return selectFirst(connection_, std::string("SELECT count(*) FROM audit_entry") + kInTime + kActs,
                     {fromUtc_us, toUtc_us}, readInt64)
      .value_or(0);
}

TrailHead AuditRepository::head() const {
  return selectFirst(connection_,
                     "SELECT sequence, entry_hash FROM audit_entry ORDER BY sequence DESC LIMIT 1", {},
                     [](RowReader& row) {
                       return TrailHead{row.int64(), row.text()};
                     })
      .value_or(TrailHead{});
}

bool AuditRepository::contains(const TrailHead& head) const {
  return selectFirst(connection_, "SELECT count(*) FROM audit_entry WHERE sequence = ? AND entry_hash = ?",
                     {head.length, head.hash}, readInt64)
             .value_or(0) > 0;
}

std::int64_t AuditRepository::length() const {
  return selectFirst(connection_, "SELECT count(*) FROM audit_entry", {}, readInt64).value_or(0);
}

namespace {

/// One query per kind of object for its display text; a condition on `x.id` is appended.
constexpr std::array kSubjects{
    "SELECT x.id, x.code FROM person x WHERE x.id",
    "SELECT x.id, x.login FROM app_user x WHERE x.id",
    "SELECT x.id, p.code FROM enrolment x JOIN person p ON p.id = x.trainee_id WHERE x.id",
    "SELECT x.id, p.code FROM trial x JOIN person p ON p.id = x.trainee_id WHERE x.id",
    "SELECT x.id, p.code FROM exposure x JOIN enrolment e ON e.id = x.enrolment_id"
    " JOIN person p ON p.id = e.trainee_id WHERE x.id",
    "SELECT x.id, p.code FROM deviation x JOIN enrolment e ON e.id = x.enrolment_id"
    " JOIN person p ON p.id = e.trainee_id WHERE x.id",
    "SELECT x.id, p.code FROM person_request x JOIN person p ON p.id = x.person_id WHERE x.id",
    "SELECT x.id, p.code FROM live_call x JOIN enrolment e ON e.id = x.enrolment_id"
    " JOIN person p ON p.id = e.trainee_id WHERE x.id",
    "SELECT x.id, p.code || ': ' || x.case_label FROM assignment x JOIN person p ON p.id = x.rater_id WHERE "
    "x.id",
    "SELECT x.id, p.code || ': ' || a.case_label FROM training_mark x JOIN assignment a ON a.id = "
    "x.assignment_id"
    " JOIN person p ON p.id = x.rater_id WHERE x.id",
    "SELECT x.id, p.code FROM allocation x JOIN enrolment e ON e.id = x.enrolment_id"
    " JOIN person p ON p.id = e.trainee_id WHERE x.id",
    "SELECT x.id, p.code FROM evaluation_mark x JOIN person p ON p.id = x.rater_id WHERE x.id",
    "SELECT x.id, p.code FROM rater_warmup x JOIN person p ON p.id = x.rater_id WHERE x.id",
    "SELECT x.id, p.code FROM trial_remark x JOIN trial t ON t.id = x.trial_id"
    " JOIN person p ON p.id = t.trainee_id WHERE x.id",  // a question has the id of its remark
    "SELECT x.id, p.code FROM duty_request x JOIN person p ON p.id = x.subject WHERE x.id",
    "SELECT x.id, u.login FROM duty_request x JOIN app_user u ON u.id = x.subject WHERE x.id",
    "SELECT x.id, c.name FROM duty_request x JOIN cohort c ON c.id = x.subject WHERE x.id",
    "SELECT x.id, c.name FROM allocation_design x JOIN cohort c ON c.id = x.cohort_id WHERE x.id",
    "SELECT x.id, c.name || ': ' || x.number FROM curriculum_version x"
    " JOIN curriculum c ON c.id = x.curriculum_id WHERE x.id",
    "SELECT x.id, c.name FROM deviation x JOIN cohort c ON c.id = x.cohort_id"
    " WHERE x.enrolment_id IS NULL AND x.id",
    "SELECT x.id, x.name FROM frozen_dataset x WHERE x.id",
    "SELECT x.id, x.name FROM cohort x WHERE x.id",
    "SELECT x.id, x.name FROM curriculum x WHERE x.id",
    "SELECT x.id, x.name FROM evaluation_campaign x WHERE x.id",
};

}  // namespace

std::map<std::string, std::string> auditSubjects(Connection& connection, std::int64_t fromSequence) {
  std::map<std::string, std::string> subjects;
  for (const char* select : kSubjects) {
    Statement statement = connection.prepare(
        std::string(select) + " IN (SELECT n.object_id FROM audit_entry n WHERE n.sequence >= ?)");
    statement.execute({fromSequence});
    while (statement.step()) {
      RowReader row(statement);
      std::string id = row.text();
      subjects.emplace(std::move(id), row.text());
    }
  }
  return subjects;
}

}  // namespace torsio
