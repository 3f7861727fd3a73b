// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/audit_verification.h"

#include <set>
#include <utility>
#include <vector>

#include "db/connection/db_error.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/seal_rules.h"
#include "db/repository/people/server_roles.h"
#include "db/repository/system/seal_verification.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/record/content_hash.h"

namespace torsio {

namespace {

constexpr std::int64_t kProgressEvery = 16;  // recordings

const std::string kTrial(storedText(AuditObject::kTrial));

void checkChain(Connection& connection, SealVerification& seals, std::vector<AuditFinding>& findings) {
  std::string previous;
  std::int64_t expected = 0;
  AuditRepository(connection).forEach([&](const AuditEntry& entry) {
    const auto report = [&](const Phrase& what) {
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
    seals.take(entry);
  });
}

/// Reports a committed row in erasure_gate: the gate may be open only within the transaction of an erase.
void checkGate(Connection& connection, std::vector<AuditFinding>& findings) {
  for (const std::string& id : selectAll(connection, "SELECT id FROM erasure_gate", {}, readText)) {
    findings.push_back({0, "erasure_gate", id, "is open: sealed rows can be changed"});
  }
}

/// Reports values of the wrong type: SQLite accepts any type in any column, and bytes read as text. Rows with
/// a hash of their own are checked by it.
void checkKinds(Connection& connection, std::vector<AuditFinding>& findings) {
  if (connection.engine() != Engine::kSqlite) {
    return;
  }
  for (const SealRule& rule : kSealRules) {
    if (rule.sealing != Sealing::kElsewhere) {
      continue;
    }
    const std::string table(rule.table);
    std::string other;
    for (const auto& [column, declared] : selectAll(
             connection, "SELECT name, type FROM pragma_table_info('" + table + "')", {}, [](RowReader& row) {
               return std::pair{row.text(), row.text()};
             })) {
      const char* kind = declared == "TEXT" ? "text" : declared == "BLOB" ? "blob" : "integer";
      other.append(other.empty() ? "" : " OR ").append("typeof(").append(column).append(") <> '");
      other.append(kind).append("'");
    }
    const std::int64_t rows =
        selectFirst(connection, "SELECT count(*) FROM " + table + " WHERE " + other, {}, readInt64)
            .value_or(0);
    if (rows > 0) {
      findings.push_back({0, table, {}, "has rows with a value of another kind than their column"});
    }
  }
}

/// An ended trial and its trainee (empty: none).
struct EndedTrial {
  std::string id;
  std::string traineeId;
};

void checkTrials(Connection& connection, const std::set<std::string>& erased,
                 std::vector<AuditFinding>& findings, const VerifyProgress& progress) {
  const std::vector<EndedTrial> trials =
      selectAll(connection,
                "SELECT t.id, t.trainee_id FROM trial_end e JOIN trial t ON t.id = e.trial_id ORDER BY t.id",
                {}, [](RowReader& row) {
                  return EndedTrial{row.text(), row.text()};
                });
  TrialLoader loader(connection);
  std::int64_t done = 0;
  for (const EndedTrial& trial : trials) {
    if (progress && done % kProgressEvery == 0) {
      progress(done, static_cast<std::int64_t>(trials.size()));
    }
    ++done;
    if (erased.contains(trial.traineeId)) {
      continue;
    }
    try {
      verifyContent(loader.load(trial.id));
    } catch (const DbError&) {
      throw;
    } catch (const Error& error) {
      findings.push_back({0, kTrial, trial.id, error.happened()});
    }
  }
}

}  // namespace

std::vector<AuditFinding> verifyAuditTrail(Connection& connection, const VerifyProgress& progress) {
  requireEveryRow(connection);
  Transaction oneMoment(connection, Transaction::Purpose::kLook);
  std::vector<AuditFinding> findings;
  SealVerification seals(connection, findings);
  checkChain(connection, seals, findings);
  checkGate(connection, findings);
  checkKinds(connection, findings);
  seals.compareRows();
  checkTrials(connection, seals.erased(), findings, progress);
  oneMoment.commit();
  return findings;
}

}  // namespace torsio
