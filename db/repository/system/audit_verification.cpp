// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/audit_verification.h"

#include <map>
#include <set>
#include <vector>

#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/seals.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/base/error.h"
#include "sim/record/content_hash.h"

namespace torsio {

namespace {

constexpr std::int64_t kProgressEvery = 16;  // recordings

const std::string kMark(storedText(AuditObject::kTrainingMark));
const std::string kEvaluationMark(storedText(AuditObject::kEvaluationMark));
const std::string kTrial(storedText(AuditObject::kTrial));

using Hashes = std::map<std::string, std::string>;

/// Ids of trials whose samples were erased with their trainee, as the trail tells: a tombstone alone would
/// excuse seconds that somebody changed.
std::set<std::string> erasedTrials(Connection& connection) {
  const std::vector<std::string> trials = selectAll(
      connection,
      "SELECT t.id FROM trial t JOIN erasure e ON e.person_id = t.trainee_id WHERE EXISTS (SELECT 1 FROM"
      " audit_entry a WHERE a.object_kind = ? AND a.object_id = e.person_id AND a.action = ?)",
      {storedText(AuditObject::kPerson), storedText(AuditAction::kPersonErase)}, readText);
  return {trials.begin(), trials.end()};
}

/// Entries that tell of sealed rows which went with the demonstration. They count when the entry for the
/// whole follows, of the same person at the same moment: one alone would hide a row that was taken away.
class Removals {
 public:
  explicit Removals(std::vector<AuditFinding>& findings) : findings_(findings) {}

  void take(const AuditEntry& entry, std::map<std::string, Hashes>& sealed) {
    if (!waiting_.empty() &&
        (waiting_.back().actor != entry.actor || waiting_.back().atUtc_us != entry.atUtc_us)) {
      interrupted();
    }
    if (entry.objectKind != storedText(AuditObject::kDemonstration)) {
      waiting_.push_back(entry);
      return;
    }
    for (const AuditEntry& removed : waiting_) {
      sealed[removed.objectKind].erase(removed.objectId);
    }
    waiting_.clear();
  }

  /// Something else followed: what waits belongs to no removal.
  void interrupted() {
    for (const AuditEntry& entry : waiting_) {
      findings_.push_back(
          {entry.sequence, entry.objectKind, entry.objectId, "tells of a removal that did not take place"});
    }
    waiting_.clear();
  }

 private:
  std::vector<AuditFinding>& findings_;
  std::vector<AuditEntry> waiting_;
};

void checkChain(Connection& connection, std::map<std::string, Hashes>& sealed,
                std::vector<AuditFinding>& findings) {
  std::string previous;
  std::int64_t expected = 0;
  Removals removals(findings);
  AuditRepository(connection).forEach([&](const AuditEntry& entry) {
    const auto report = [&](Phrase what) {
      findings.push_back({entry.sequence, entry.objectKind, entry.objectId, std::string(what.english())});
    };
    ++expected;
    if (entry.sequence != expected) {
      report(Text::tr("entries before this one are missing"));
    }
    if (entry.previousHash != previous) {
      report(Text::tr("does not follow the entry before it"));
    }
    if (entry.entryHash != auditHash(entry)) {
      report(Text::tr("the entry itself was changed"));
    }
    expected = entry.sequence;
    previous = entry.entryHash;
    if (!entry.objectHash.empty()) {
      const auto [seal, first] = sealed[entry.objectKind].emplace(entry.objectId, entry.objectHash);
      if (!first && seal->second != entry.objectHash) {
        report(Text::tr("seals a row otherwise that was sealed before"));
      }
    }
    if (entry.action == storedText(AuditAction::kDemonstrationRemove)) {
      removals.take(entry, sealed);
    } else {
      removals.interrupted();
    }
  });
  removals.interrupted();
}

/// The gate of an erase is open within its transaction only.
void checkGate(Connection& connection, std::vector<AuditFinding>& findings) {
  for (const std::string& id : selectAll(connection, "SELECT id FROM erasure_gate", {}, readText)) {
    findings.push_back({0, "erasure_gate", id, "is open: sealed rows can be changed"});
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
    if (!sealed.contains(id)) {
      findings.push_back({0, kind, id, "is there, but was never recorded"});
    }
  }
}

void checkTrials(Connection& connection, const Hashes& trials, std::vector<AuditFinding>& findings,
                 const VerifyProgress& progress) {
  const std::set<std::string> erased = erasedTrials(connection);
  TrialRepository repository(connection);
  std::int64_t done = 0;
  for (const auto& [id, hash] : trials) {
    if (progress && done % kProgressEvery == 0) {
      progress(done, static_cast<std::int64_t>(trials.size()));
    }
    ++done;
    if (erased.contains(id)) {
      continue;
    }
    try {
      verifyContent(repository.load(id));
    } catch (const Error& error) {
      if (error.code() != ErrorCode::kVerifyFailed) {
        throw;
      }
      findings.push_back({0, kTrial, id, error.happened()});
    }
  }
}

void checkComments(Connection& connection, std::vector<AuditFinding>& findings) {
  Statement comments =
      connection.prepare("SELECT id, comment, comment_hash FROM training_mark WHERE comment IS NOT NULL");
  comments.execute();
  while (comments.step()) {
    RowReader row(comments);
    const std::string id = row.text();
    const std::string hash = textHash(row.text());
    if (hash != row.text()) {
      findings.push_back({0, kMark, id, "its comment differs from what was recorded"});
    }
  }
}

}  // namespace

std::vector<AuditFinding> verifyAuditTrail(Connection& connection, const VerifyProgress& progress) {
  std::vector<AuditFinding> findings;
  std::map<std::string, Hashes> sealed;
  checkChain(connection, sealed, findings);
  checkGate(connection, findings);
  const Hashes trials = trialHashes(connection);
  compare(kMark, sealed[kMark], markHashes(connection), findings);
  compare(kEvaluationMark, sealed[kEvaluationMark], evaluationMarkHashes(connection), findings);
  compare(kTrial, sealed[kTrial], trials, findings);
  checkTrials(connection, trials, findings, progress);
  checkComments(connection, findings);
  return findings;
}

}  // namespace torsio
