// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/audit_repository.h"

#include <map>
#include <set>

#include "db/repository/field_digest.h"
#include "db/repository/seals.h"
#include "db/repository/trial_repository.h"
#include "sim/base/error.h"
#include "sim/record/content_hash.h"

namespace torsio {

namespace {

constexpr std::int64_t kProgressEvery = 16;  // recordings
constexpr const char* kColumns =
    "sequence, at_utc_us, actor, station, action, object_kind, object_id, old_json, new_json, reason,"
    " object_hash, previous_hash, entry_hash";
constexpr const char* kInTime = " WHERE at_utc_us >= ? AND at_utc_us <= ?";

using Hashes = std::map<std::string, std::string>;

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

/// Ids of trials whose samples were erased with their trainee.
std::set<std::string> erasedTrials(Connection& connection) {
  std::set<std::string> trials;
  Statement row = connection.prepare("SELECT t.id FROM trial t JOIN erasure e ON e.person_id = t.trainee_id");
  row.execute();
  while (row.step()) trials.insert(row.text(0));
  return trials;
}

void checkChain(Connection& connection, std::map<std::string, Hashes>& sealed,
                std::vector<AuditFinding>& findings) {
  Statement row =
      connection.prepare(std::string("SELECT ") + kColumns + " FROM audit_entry ORDER BY sequence");
  row.execute();
  std::string previous;
  std::int64_t expected = 0;
  while (row.step()) {
    const AuditEntry entry = entryOf(row);
    const auto report = [&](const char* what) {
      findings.push_back({entry.sequence, entry.objectKind, entry.objectId, what});
    };
    ++expected;
    if (entry.sequence != expected) report("entries before this one are missing");
    if (entry.previousHash != previous) report("does not follow the entry before it");
    if (entry.entryHash != auditHash(entry)) report("the entry itself was changed");
    expected = entry.sequence;
    previous = entry.entryHash;
    if (!entry.objectHash.empty()) sealed[entry.objectKind][entry.objectId] = entry.objectHash;
    if (entry.action == kDemonstrationRemoved) sealed[entry.objectKind].erase(entry.objectId);
  }
}

void compare(const std::string& kind, const Hashes& sealed, const Hashes& now,
             std::vector<AuditFinding>& findings) {
  for (const auto& [id, hash] : sealed) {
    const auto row = now.find(id);
    if (row == now.end()) {
      findings.push_back({0, kind, id, "was recorded, but is gone"});
    } else if (row->second != hash) {
      findings.push_back({0, kind, id, "differs from what was recorded"});
    }
  }
  for (const auto& [id, hash] : now) {
    if (!sealed.contains(id)) findings.push_back({0, kind, id, "is there, but was never recorded"});
  }
}

void checkTrials(Connection& connection, const Hashes& trials, std::vector<AuditFinding>& findings,
                 const VerifyProgress& progress) {
  const std::set<std::string> erased = erasedTrials(connection);
  TrialRepository repository(connection);
  std::int64_t done = 0;
  for (const auto& [id, hash] : trials) {
    if (progress && done % kProgressEvery == 0) progress(done, static_cast<std::int64_t>(trials.size()));
    ++done;
    if (erased.contains(id)) continue;
    try {
      verifyContent(repository.load(id));
    } catch (const Error& error) {
      if (error.code() != ErrorCode::kVerifyFailed) throw;
      findings.push_back({0, kSealedTrial, id, error.happened()});
    }
  }
}

void checkComments(Connection& connection, std::vector<AuditFinding>& findings) {
  Statement row =
      connection.prepare("SELECT id, comment, comment_hash FROM training_mark WHERE comment IS NOT NULL");
  row.execute();
  while (row.step()) {
    if (textHash(row.text(1)) != row.text(2)) {
      findings.push_back({0, kSealedMark, row.text(0), "its comment differs from what was recorded"});
    }
  }
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

std::vector<AuditFinding> AuditRepository::verify(const VerifyProgress& progress) {
  std::vector<AuditFinding> findings;
  std::map<std::string, Hashes> sealed;
  checkChain(connection_, sealed, findings);
  const Hashes trials = trialHashes(connection_);
  compare(kSealedMark, sealed[kSealedMark], markHashes(connection_), findings);
  compare(kSealedEvaluationMark, sealed[kSealedEvaluationMark], evaluationMarkHashes(connection_), findings);
  compare(kSealedTrial, sealed[kSealedTrial], trials, findings);
  checkTrials(connection_, trials, findings, progress);
  checkComments(connection_, findings);
  return findings;
}

}  // namespace torsio
