// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/people/person_data.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "assessment/domain/ids.h"
#include "assessment/domain/people/audit_entry.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/seal_rules.h"
#include "db/repository/people/server_roles.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Repeats the person's id for every `?` of the condition.
std::vector<Value> valuesFor(const PersonRule& rule, const PersonId& personId) {
  const auto marks = std::count(rule.condition.begin(), rule.condition.end(), '?');
  return std::vector<Value>(static_cast<std::size_t>(marks), Value(personId));
}

void applyRule(Connection& connection, const PersonRule& rule, const PersonId& personId) {
  if (rule.condition.empty() || rule.onErase == OnErase::kKeep) {
    return;
  }
  const std::string table(rule.table);
  const std::string act = rule.onErase == OnErase::kDelete
                              ? "DELETE FROM " + table
                              : "UPDATE " + table + " SET " + std::string(rule.cleared);
  connection.prepare(act + " WHERE " + std::string(rule.condition)).execute(valuesFor(rule, personId));
}

/// Keys of the sealed rows that an erase will touch.
struct TouchedRows {
  const PersonRule* rule;
  std::vector<std::vector<Value>> keys;
};

std::vector<TouchedRows> rowsToErase(Connection& connection, const PersonId& personId) {
  std::vector<TouchedRows> all;
  for (const PersonRule& rule : kPersonRules) {
    const SealRule* seal = sealRuleOf(rule.table);
    if (seal == nullptr || rule.condition.empty() || rule.onErase == OnErase::kKeep) {
      continue;
    }
    TouchedRows touched{&rule, {}};
    Statement row = connection.prepare("SELECT " + std::string(seal->key) + " FROM " +
                                       std::string(rule.table) + " WHERE " + std::string(rule.condition));
    row.execute(valuesFor(rule, personId));
    while (row.step()) {
      std::vector<Value> key;
      for (int column = 0; column < row.columnCount(); ++column) {
        key.push_back(row.value(column));
      }
      touched.keys.push_back(std::move(key));
    }
    all.push_back(std::move(touched));
  }
  return all;
}

/// Erases through the function of a prepared server. Its changes are not observed, so they are reported to
/// the ledger.
bool eraseThroughServer(Connection& connection, const PersonId& personId, const std::string& requestedBy,
                        const std::string& reason, std::int64_t utc_us) {
  std::vector<TouchedRows> touched = rowsToErase(connection, personId);
  if (!eraseOnServer(connection, personId, requestedBy, reason, utc_us)) {
    return false;
  }
  for (TouchedRows& rows : touched) {
    for (std::vector<Value>& key : rows.keys) {
      connection.reportChange(rows.rule->table, std::move(key), rows.rule->onErase == OnErase::kDelete);
    }
  }
  connection.reportChange("erasure", {Value(personId)}, false);
  return true;
}

/// Erases as owner of the tables. The function of a prepared server does the same (server_roles.cpp).
void eraseRows(Connection& connection, const PersonId& personId, const std::string& requestedBy,
               const std::string& reason, std::int64_t utc_us) {
  connection.execute(insertInto("erasure_gate", "id, reason, opened_utc_us"), {personId, reason, utc_us});
  for (const PersonRule& rule : kPersonRules) {
    applyRule(connection, rule, personId);
  }
  connection.execute("DELETE FROM erasure_gate WHERE id = ?", {personId});
  connection.execute(insertInto("erasure", "person_id, requested_by, reason, erased_utc_us"),
                     {personId, requestedBy, reason, utc_us});
}

}  // namespace

std::vector<PersonTable> exportPerson(Connection& connection, const PersonId& personId) {
  std::vector<PersonTable> tables;
  for (const PersonRule& rule : kPersonRules) {
    if (rule.condition.empty()) {
      continue;
    }
    PersonTable table{std::string(rule.table), {}, {}};
    Statement row = connection.prepare("SELECT " + std::string(rule.columns) + " FROM " + table.table +
                                       " WHERE " + std::string(rule.condition));
    row.execute(valuesFor(rule, personId));
    while (row.step()) {
      std::vector<Value> values;
      for (int column = 0; column < row.columnCount(); ++column) {
        if (table.rows.empty()) {
          table.columns.push_back(row.columnName(column));
        }
        values.push_back(row.value(column));
      }
      table.rows.push_back(std::move(values));
    }
    if (!table.rows.empty()) {
      tables.push_back(std::move(table));
    }
  }
  return tables;
}

void erasePerson(Connection& connection, const PersonId& personId, const std::string& requestedBy,
                 const std::string& reason, std::int64_t utc_us) {
  Transaction transaction(connection);
  if (connection.execute("UPDATE person SET state = 'erased' WHERE id = ? AND state <> 'erased'",
                         {personId}) != 1) {
    refuse(Text::tr("there is no such person, or they were erased already"), Text::tr("erase"),
           Text::tr("Check the code"));
  }
  if (!eraseThroughServer(connection, personId, requestedBy, reason, utc_us)) {
    eraseRows(connection, personId, requestedBy, reason, utc_us);
  }
  NewAuditEntry entry{.atUtc_us = utc_us,
                      .actor = requestedBy,
                      .station = {},
                      .action = AuditAction::kPersonErase,
                      .objectKind = AuditObject::kPerson,
                      .objectId = personId,
                      .reason = reason};
  AuditRepository(connection).append(entry);
  transaction.commit();
}

}  // namespace torsio
