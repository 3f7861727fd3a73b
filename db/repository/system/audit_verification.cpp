// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/audit_verification.h"

#include <map>
#include <set>

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

/// Ids of trials whose samples were erased with their trainee.
std::set<std::string> erasedTrials(Connection& connection) {
  const std::vector<std::string> trials = selectAll(
      connection, "SELECT t.id FROM trial t JOIN erasure e ON e.person_id = t.trainee_id", {}, readText);
  return {trials.begin(), trials.end()};
}

void checkChain(Connection& connection, std::map<std::string, Hashes>& sealed,
                std::vector<AuditFinding>& findings) {
  std::string previous;
  std::int64_t expected = 0;
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
      sealed[entry.objectKind][entry.objectId] = entry.objectHash;
    }
    if (entry.action == storedText(AuditAction::kDemonstrationRemove)) {
      sealed[entry.objectKind].erase(entry.objectId);
    }
  });
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
  const Hashes trials = trialHashes(connection);
  compare(kMark, sealed[kMark], markHashes(connection), findings);
  compare(kEvaluationMark, sealed[kEvaluationMark], evaluationMarkHashes(connection), findings);
  compare(kTrial, sealed[kTrial], trials, findings);
  checkTrials(connection, trials, findings, progress);
  checkComments(connection, findings);
  return findings;
}

}  // namespace torsio
