// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/audit_verification.h"

#include <algorithm>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "assessment/domain/people/audit_entry.h"
#include "assessment/domain/people/audit_terms.h"
#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/connection/row_reader.h"
#include "db/migrations/schema_check.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/changed_statement.h"
#include "db/repository/base/row_seal.h"
#include "db/repository/base/seal_rules.h"
#include "db/repository/people/person_data.h"
#include "db/repository/people/server_roles.h"
#include "db/repository/system/site_repository.h"
#include "db/repository/trial/trial_repository.h"
#include "sim/core/error.h"
#include "sim/record/content_hash.h"

namespace torsio {

namespace {

constexpr std::int64_t kProgressEvery = 16;  // recordings

const std::string kTrial(storedText(AuditObject::kTrial));

/// Replays the row seals along the audit trail, then compares the rows with them. Call take() with every
/// entry of the chain, oldest first, then compareRows(), inside one transaction.
class SealVerification {
 public:
  SealVerification(Connection& connection, std::vector<AuditFinding>& findings)
      : connection_(connection), findings_(findings) {}

  void take(const AuditEntry& entry);
  /// Reads all seals and all rows. Throws DbError.
  void compareRows();
  /// Returns the people whose erase is in the trail with its tombstone: their recordings are missing
  /// legitimately.
  [[nodiscard]] const std::set<std::string>& erased() const { return erased_; }

 private:
  /// An entry that seals nothing.
  struct Act {
    std::string actor;
    std::string erased{};  // person
    bool removesDemonstration = false;
  };
  /// An entry that seals rows, with the other entries of its transaction.
  struct SealEntry {
    std::int64_t sequence = 0;
    std::string hash{};
    std::set<std::string> erasedPeople{};
    bool removesDemonstration = false;
  };
  /// The newest seal of a row.
  struct Last {
    std::string rowHash{};
    std::string personalHash{};
    bool removed = false;
    bool simulated = false;
    bool seen = false;
  };
  using Rows = std::unordered_map<std::string, Last>;

  void report(std::int64_t sequence, std::string_view table, const std::string& key, const Phrase& what);
  void readSeals();
  void apply(const SealEntry& entry, const RowSeal& seal);
  void requireGenuine(const SealEntry& entry, const RowSeal& seal, const Last& before);
  /// True if the table has a demonstration flag.
  [[nodiscard]] bool hasFlag(const std::string& table);
  [[nodiscard]] bool concernsErased(const SealEntry& entry, const RowSeal& seal);
  void readSchemaRows();
  void compareTable(const SealRule& rule);

  Connection& connection_;
  std::vector<AuditFinding>& findings_;
  std::vector<Act> recent_;  // since the last seal
  std::vector<SealEntry> entries_;
  std::unordered_map<std::string, Rows> tables_;
  std::unordered_map<std::string, std::unordered_map<std::string, std::string>> salts_;
  std::unordered_map<std::string, std::set<std::string>> ofPeople_;  // keys of a person's rows
  std::unordered_map<std::string, bool> flagged_;
  std::set<std::string> erased_;
};

constexpr std::string_view kTombstones = "erasure";

bool isAct(const AuditEntry& entry, AuditAction action, AuditObject object) {
  return entry.action == storedText(action) && entry.objectKind == storedText(object);
}

void SealVerification::report(std::int64_t sequence, std::string_view table, const std::string& key,
                              const Phrase& what) {
  findings_.push_back({sequence, std::string(table), key, std::string(what.english())});
}

void SealVerification::take(const AuditEntry& entry) {
  if (entry.action != storedText(AuditAction::kRecordSeal)) {
    Act act{.actor = entry.actor};
    if (isAct(entry, AuditAction::kPersonErase, AuditObject::kPerson)) {
      act.erased = entry.objectId;
    }
    act.removesDemonstration = isAct(entry, AuditAction::kDemonstrationRemove, AuditObject::kDemonstration);
    recent_.push_back(std::move(act));
    return;
  }
  const std::int64_t own = entriesOf(entry.newJson);
  SealEntry seal{.sequence = entry.sequence, .hash = entry.objectHash};
  const bool complete = own >= 0 && own <= static_cast<std::int64_t>(recent_.size());
  if (!complete || (own > 0 && recent_.back().actor != entry.actor)) {
    report(entry.sequence, entry.objectKind, {}, Text::tr("seals a change that the trail does not contain"));
  } else {
    for (auto act = recent_.end() - own; act != recent_.end(); ++act) {
      if (!act->erased.empty()) {
        seal.erasedPeople.insert(act->erased);
      }
      seal.removesDemonstration = seal.removesDemonstration || act->removesDemonstration;
    }
  }
  recent_.clear();
  entries_.push_back(std::move(seal));
}

void SealVerification::compareRows() {
  forEachSelected(connection_, "SELECT table_name, row_key, salt FROM seal_salt",
                  [&](const Statement& row) { salts_[row.text(0)][row.text(1)] = row.text(2); });
  readSchemaRows();
  readSeals();
  const std::set<std::string> seenInPart = tablesSeenInPart(connection_);
  for (const SealRule& rule : kSealRules) {
    if (rule.sealing != Sealing::kOnce && rule.sealing != Sealing::kEachChange) {
      continue;
    }
    if (seenInPart.contains(std::string(rule.table))) {
      salts_.erase(std::string(rule.table));
      continue;
    }
    try {
      compareTable(rule);
    } catch (const DbError&) {
      throw;
    } catch (const Error& error) {  // the columns differ from this version's
      findings_.push_back({0, "schema", error.where(), error.happened()});
    }
  }
  for (const auto& [table, salts] : salts_) {
    for (const auto& [key, salt] : salts) {
      report(0, "seal_salt", table + "/" + key, Text::tr("belongs to no seal"));
    }
  }
  for (const SealRule& rule : kSealRules) {
    tables_.erase(std::string(rule.table));
  }
  for (const auto& [table, rows] : tables_) {
    report(0, table, {}, Text::tr("is sealed, but this version knows no such table"));
  }
}

void SealVerification::readSchemaRows() {
  Connection fresh = freshRecord();
  const Transaction look(fresh, Transaction::Purpose::kReadOnly);
  for (const std::string_view table : kGrowingSeeds) {
    forEachSealable(fresh, *sealRuleOf(table),
                    [&](const SealShape& shape, std::span<const Value> row, const std::string& seal) {
                      tables_[std::string(table)][shape.keyOf(row)] = {.rowHash = seal};
                    });
  }
}

void SealVerification::readSeals() {
  auto entry = entries_.begin();
  SealDigest digest;
  const auto finish = [&] {
    if (digest.hex() != entry->hash) {
      report(entry->sequence, "row_seal", {}, Text::tr("its seals were changed"));
    }
    digest = {};
    ++entry;
  };
  forEachSeal(connection_, [&](std::int64_t sequence, std::int64_t position, const RowSeal& seal) {
    while (entry != entries_.end() && entry->sequence < sequence) {
      finish();
    }
    if (entry == entries_.end() || entry->sequence != sequence) {
      report(sequence, seal.table, seal.key, Text::tr("its seal belongs to no entry"));
      return;
    }
    digest.add(position, seal);
    apply(*entry, seal);
  });
  while (entry != entries_.end()) {
    finish();
  }
}

void SealVerification::apply(const SealEntry& entry, const RowSeal& seal) {
  const auto [row, first] = tables_[seal.table].try_emplace(seal.key);
  const SealRule* rule = sealRuleOf(seal.table);
  if (!first && rule != nullptr && rule->sealing == Sealing::kOnce) {
    requireGenuine(entry, seal, row->second);
  }
  const Last& last = row->second;
  if (!seal.before.empty() && (last.removed || seal.before != last.rowHash + last.personalHash)) {
    report(entry.sequence, seal.table, seal.key,
           Text::tr("was changed behind the trail before this change of it"));
  }
  if (seal.table == kTombstones && !seal.removed) {
    if (entry.erasedPeople.contains(seal.key)) {
      erased_.insert(seal.key);
    } else {
      report(entry.sequence, seal.table, seal.key, Text::tr("records an erasure that did not take place"));
    }
  }
  row->second = {.rowHash = seal.rowHash,
                 .personalHash = seal.personalHash,
                 .removed = seal.removed,
                 .simulated = seal.simulated};
}

void SealVerification::requireGenuine(const SealEntry& entry, const RowSeal& seal, const Last& before) {
  if (before.removed) {  // simulated rows that were added again
    return;
  }
  if (seal.removed) {
    const bool flagged = before.simulated || !hasFlag(seal.table);
    if (!entry.removesDemonstration || !flagged) {
      report(entry.sequence, seal.table, seal.key, Text::tr("records a removal that did not take place"));
    }
    return;
  }
  if (before.rowHash == seal.rowHash && before.personalHash == seal.personalHash) {
    return;
  }
  if (before.rowHash != seal.rowHash || !concernsErased(entry, seal)) {
    report(entry.sequence, seal.table, seal.key, Text::tr("seals a row otherwise that was sealed before"));
  }
}

bool SealVerification::hasFlag(const std::string& table) {
  const auto [flag, first] = flagged_.try_emplace(table, false);
  if (first) {
    Statement none = connection_.prepare("SELECT * FROM " + table + " LIMIT 0");
    none.execute();
    const std::vector<std::string> columns = columnNamesOf(none);
    flag->second = std::find(columns.begin(), columns.end(), "demonstration") != columns.end();
  }
  return flag->second;
}

bool SealVerification::concernsErased(const SealEntry& entry, const RowSeal& seal) {
  const auto* rule = std::find_if(kPersonRules.begin(), kPersonRules.end(),
                                  [&](const PersonRule& part) { return part.table == seal.table; });
  if (rule == kPersonRules.end() || rule->onErase == OnErase::kKeep) {
    return false;
  }
  return std::any_of(entry.erasedPeople.begin(), entry.erasedPeople.end(), [&](const std::string& person) {
    const auto [keys, first] = ofPeople_.try_emplace(seal.table + "/" + person);
    if (first) {
      const auto marks = std::count(rule->condition.begin(), rule->condition.end(), '?');
      const std::vector<Value> values(static_cast<std::size_t>(marks), Value(person));
      std::string key;  // see SealShape::keyOf()
      for (const std::string& column : columnsOf(sealRuleOf(seal.table)->key)) {
        key += (key.empty() ? "CAST(" : " || '/' || CAST(") + column + " AS TEXT)";
      }
      for (std::string& id :
           selectAll(connection_,
                     "SELECT " + key + " FROM " + seal.table + " WHERE " + std::string(rule->condition),
                     values, readText)) {
        keys->second.insert(std::move(id));
      }
    }
    return keys->second.contains(seal.key);
  });
}

void SealVerification::compareTable(const SealRule& rule) {
  const std::string table(rule.table);
  Rows& sealed = tables_[table];
  auto& salts = salts_[table];
  forEachSealable(
      connection_, rule,
      [&](const SealShape& shape, std::span<const Value> row, const std::string& seal) {
        const std::string key = shape.keyOf(row);
        const auto last = sealed.find(key);
        const auto salt = salts.find(key);
        const std::string personal = shape.personal(row, salt == salts.end() ? std::string() : salt->second);
        if (last != sealed.end() && !last->second.personalHash.empty() && salt != salts.end()) {
          salts.erase(salt);
        }
        if (last == sealed.end() || last->second.removed) {
          report(0, table, key, Text::tr("is present, but was never recorded"));
          return;
        }
        last->second.seen = true;
        if (last->second.rowHash != seal || last->second.personalHash != personal) {
          report(0, table, key, Text::tr("differs from what was recorded"));
        }
      },
      [&](const std::string& key) {
        report(0, table, key, Text::tr("is missing, but its dependent rows exist"));
      });
  for (const auto& [key, last] : sealed) {
    if (!last.seen && !last.removed) {
      report(0, table, key, Text::tr("was recorded, but is missing"));
    }
  }
}

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

/// Says of what a centre delivered from which one it came.
void nameSites(Connection& connection, std::vector<AuditFinding>& findings) {
  const SiteRepository sites(connection);
  for (AuditFinding& finding : findings) {
    if (const std::string site = sites.siteOfRow(finding.objectId); !site.empty()) {
      finding.what += ", delivered by centre " + site;
    }
  }
}

}  // namespace

std::vector<AuditFinding> verifyAuditTrail(Connection& connection, const VerifyProgress& progress) {
  requireEveryRow(connection);
  Transaction oneMoment(connection, Transaction::Purpose::kReadOnly);
  std::vector<AuditFinding> findings;
  SealVerification seals(connection, findings);
  checkChain(connection, seals, findings);
  checkGate(connection, findings);
  checkKinds(connection, findings);
  seals.compareRows();
  checkTrials(connection, seals.erased(), findings, progress);
  nameSites(connection, findings);
  oneMoment.commit();
  return findings;
}

}  // namespace torsio
