// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/demonstration_data.h"

#include <map>

#include "assessment/domain/people/audit_entry.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/system/schema_tables.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

constexpr const char* kNone = "FALSE";
constexpr const char* kFlag = "demonstration";
/// The current display of a station belongs to the station, not to the trial.
constexpr const char* kStations = "station_state";

using Conditions = std::map<std::string, std::string>;

std::string listOf(const std::vector<std::string>& columns) {
  std::string list;
  for (const std::string& column : columns) {
    list.append(list.empty() ? "" : ", ").append(column);
  }
  return "(" + list + ")";
}

/// Returns the condition for rows that refer to a parent row satisfying `condition`.
std::string refersTo(const TableReference& reference, const std::string& condition) {
  const std::string parents = listOf(reference.parentColumns);
  return listOf(reference.columns) + " IN (SELECT " + parents.substr(1, parents.size() - 2) + " FROM " +
         reference.parent + " WHERE " + condition + ")";
}

Conditions conditionsOf(const std::vector<SchemaTable>& tables) {
  Conditions conditions;
  for (const SchemaTable& table : tables) {
    std::string condition = kNone;
    if (table.has(kFlag)) {
      condition = std::string(kFlag) + " = TRUE";
    } else if (!table.references.empty() && table.name != kStations) {
      const TableReference& owner = table.references.front();
      const std::string& parent = conditions.at(owner.parent);
      if (parent != kNone) {
        condition = refersTo(owner, parent);
      }
    }
    conditions[table.name] = condition;
  }
  return conditions;
}

std::int64_t countOf(Connection& connection, const std::string& table, const std::string& condition) {
  if (condition == kNone) {
    return 0;
  }
  return selectFirst(connection, "SELECT count(*) FROM " + table + " WHERE " + condition, {}, readInt64)
      .value_or(0);
}

/// A real row that refers to a simulated one, which therefore cannot be removed.
struct DemonstrationUse {
  std::string table;  // of the real rows
  std::string used;   // table of the simulated ones
  std::int64_t rows = 0;
};

std::vector<DemonstrationUse> usesOf(Connection& connection, const std::vector<SchemaTable>& tables,
                                     const Conditions& conditions) {
  std::vector<DemonstrationUse> uses;
  for (const SchemaTable& table : tables) {
    if (table.name == kStations) {
      continue;
    }
    for (const TableReference& reference : table.references) {
      const std::string& parent = conditions.at(reference.parent);
      if (parent == kNone) {
        continue;
      }
      const std::int64_t rows =
          countOf(connection, table.name,
                  "NOT (" + conditions.at(table.name) + ") AND " + refersTo(reference, parent));
      if (rows > 0) {
        uses.push_back({table.name, reference.parent, rows});
      }
    }
  }
  return uses;
}

void refuseUses(Connection& connection, const std::vector<DemonstrationUse>& uses) {
  if (uses.empty()) {
    return;
  }
  const DemonstrationUse& use = uses.front();
  refuse(
      Text::tr("real data use the demonstration: %1 {row refers|rows refer} from %2 to simulated rows of %3",
               use.rows, use.table, use.used),
      connection.location(), Text::tr("Finish or move what uses them first; nothing was removed"));
}

/// Throws on a station of a prepared server, which may add rows but not remove any.
void requireOwner(Connection& connection) {
  if (connection.engine() != Engine::kPostgresql ||
      selectFirst(connection, "SELECT has_table_privilege('trial', 'DELETE')", {}, readBoolean)
          .value_or(false)) {
    return;
  }
  throw Error(ErrorCode::kPermission,
              Text::tr("a station may not remove rows from this server, the demonstration neither"),
              connection.location(),
              Text::tr("Start Torsio once with the account that owns the database, and remove it there"));
}

}  // namespace

std::vector<DemonstrationRows> demonstrationRows(Connection& connection) {
  const std::vector<SchemaTable> tables = tablesInReferenceOrder(connection);
  const Conditions conditions = conditionsOf(tables);
  std::vector<DemonstrationRows> rows;
  for (const SchemaTable& table : tables) {
    const std::string& condition = conditions.at(table.name);
    rows.push_back({table.name, condition, countOf(connection, table.name, condition)});
  }
  return rows;
}

bool holdsOnlySimulated(Connection& connection) {
  std::int64_t simulated = 0;
  for (const SchemaTable& table : tablesInReferenceOrder(connection)) {
    if (!table.has(kFlag)) {
      continue;
    }
    if (countOf(connection, table.name, std::string(kFlag) + " = FALSE") > 0) {
      return false;
    }
    simulated += countOf(connection, table.name, std::string(kFlag) + " = TRUE");
  }
  return simulated > 0;
}

std::vector<DemonstrationRows> removeDemonstration(Connection& connection, const std::string& requestedBy,
                                                   const std::string& station, const std::string& reason,
                                                   std::int64_t utc_us) {
  requireOwner(connection);
  Transaction transaction(connection);
  const std::vector<SchemaTable> tables = tablesInReferenceOrder(connection);
  const Conditions conditions = conditionsOf(tables);
  refuseUses(connection, usesOf(connection, tables, conditions));
  NewAuditEntry entry{.atUtc_us = utc_us,
                      .actor = requestedBy,
                      .station = station,
                      .action = AuditAction::kDemonstrationRemove,
                      .objectKind = AuditObject::kDemonstration,
                      .reason = reason};

  constexpr const char* kGate = "demonstration";
  connection.execute(insertInto("erasure_gate", "id, reason, opened_utc_us"), {kGate, reason, utc_us});
  connection.execute(
      "UPDATE station_state SET trial_id = NULL WHERE trial_id IN (SELECT id FROM trial WHERE " +
      conditions.at("trial") + ")");
  std::vector<DemonstrationRows> removed;
  std::int64_t all = 0;
  for (auto table = tables.rbegin(); table != tables.rend(); ++table) {
    const std::string& condition = conditions.at(table->name);
    if (condition == kNone) {
      continue;
    }
    const std::int64_t rows = connection.execute("DELETE FROM " + table->name + " WHERE " + condition);
    if (rows > 0) {
      removed.push_back({table->name, condition, rows});
    }
    all += rows;
  }
  connection.execute("DELETE FROM erasure_gate WHERE id = ?", {kGate});
  entry.newJson = R"({"rows_removed":)" + std::to_string(all) + "}";
  AuditRepository(connection).append(entry);
  transaction.commit();
  return removed;
}

}  // namespace torsio
