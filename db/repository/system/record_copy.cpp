// SPDX-License-Identifier: GPL-3.0-or-later
#include "db/repository/system/record_copy.h"

#include <algorithm>
#include <array>

#include "assessment/domain/people/audit_entry.h"
#include "db/connection/connection.h"
#include "db/connection/row_reader.h"
#include "db/repository/base/audit_repository.h"
#include "db/repository/base/row_ledger.h"
#include "db/repository/base/seal_rules.h"
#include "db/repository/system/audit_verification.h"
#include "sim/core/error.h"

namespace torsio {

namespace {

/// Filled by migrations: rows here do not make a record nonempty.
constexpr std::array<std::string_view, 3> kSeeded{"role", "operation", "role_operation"};
constexpr std::int64_t kRowsPerProgress = 500;

bool isSeeded(const std::string& table) {
  return std::find(kSeeded.begin(), kSeeded.end(), table) != kSeeded.end() ||
         std::find(kGrowingSeeds.begin(), kGrowingSeeds.end(), table) != kGrowingSeeds.end();
}

std::int64_t countOf(Connection& connection, const std::string& table) {
  return selectFirst(connection, "SELECT count(*) FROM " + table, {}, readInt64).value_or(0);
}

std::vector<std::string> schemaSteps(Connection& connection) {
  return selectAll(connection, "SELECT checksum FROM schema_migration ORDER BY version", {}, readText);
}

/// Returns a table with rows beyond the migrations'; empty: none.
std::string usedTable(Connection& connection, const std::vector<SchemaTable>& tables) {
  for (const SchemaTable& table : tables) {
    if (!isSeeded(table.name) && countOf(connection, table.name) > 0) {
      return table.name;
    }
  }
  return {};
}

void requireFit(Connection& from, Connection& to, const std::vector<SchemaTable>& tables) {
  if (schemaSteps(from) != schemaSteps(to)) {
    refuse(Text::tr("the two databases have different schemas"), to.location(),
           Text::tr("Open both with this version of Torsio first"));
  }
  if (const std::string used = usedTable(to, tables); !used.empty()) {
    refuse(Text::tr("the target is not empty: it has rows in the table %1", used), to.location(),
           Text::tr("Name a new file, or an empty database"));
  }
}

void clearSeeds(Connection& to, const std::vector<SchemaTable>& tables) {
  for (auto table = tables.rbegin(); table != tables.rend(); ++table) {
    if (isSeeded(table->name)) {
      to.execute("DELETE FROM " + table->name);
    }
  }
}

void copyTable(Connection& from, Connection& to, const SchemaTable& table,
               const std::function<void()>& step) {
  std::string marks;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    marks += i == 0 ? "?" : ", ?";
  }
  Statement insert =
      to.prepare("INSERT INTO " + table.name + " (" + table.columnList() + ") VALUES (" + marks + ")");
  std::vector<Value> values(table.columns.size());
  forEachRow(from, table, "", [&](const Statement& row) {
    for (std::size_t column = 0; column < values.size(); ++column) {
      values[column] = row.value(static_cast<int>(column));
      const auto* number = std::get_if<std::int64_t>(&values[column].storage());
      if (table.columns[column].boolean && number != nullptr) {
        values[column] = *number != 0;
      }
    }
    insert.execute(values);
    step();
  });
}

void requireSame(Connection& to, const TableDigest& original, const TableDigest& copy) {
  if (original == copy) {
    return;
  }
  throw Error(
      ErrorCode::kVerifyFailed,
      Text::tr("the table %1 differs after copying (%2 {row|rows} before, %3 after); nothing was kept",
               original.table, original.rows, copy.rows),
      to.location(), Text::tr("Check both machines, then copy again"));
}

VerifyProgress verifyProgress(const CopyProgress& progress, CopyPhase phase) {
  if (!progress) {
    return {};
  }
  return [&progress, phase](std::int64_t done, std::int64_t all) { progress({phase, {}, done, all}); };
}

/// `rows`: total over all tables, both sides.
void compareTables(Connection& from, Connection& to, const std::vector<SchemaTable>& tables,
                   std::int64_t rows, CopyReport& report, const CopyProgress& progress) {
  std::int64_t done = 0;
  for (const SchemaTable& table : tables) {
    const auto step = [&] {
      if (++done % kRowsPerProgress == 0 && progress) {
        progress({CopyPhase::kComparing, table.name, done, 2 * rows});
      }
    };
    report.tables.push_back(digestOf(from, table, {}, step));
    requireSame(to, report.tables.back(), digestOf(to, table, {}, step));
  }
}

}  // namespace

bool isEmptyRecord(Connection& connection) {
  return usedTable(connection, tablesInReferenceOrder(connection)).empty();
}

CopyReport copyRecord(Connection& from, Connection& to, const CopyProgress& progress) {
  const std::vector<SchemaTable> tables = tablesInReferenceOrder(from);
  requireFit(from, to, tables);
  Transaction reading(from);
  if (from.engine() == Engine::kPostgresql) {
    from.executeVerbatim("SET TRANSACTION ISOLATION LEVEL REPEATABLE READ");  // one snapshot of all tables
  }
  const std::vector<AuditFinding> findings =
      verifyAuditTrail(from, verifyProgress(progress, CopyPhase::kVerifying));
  if (!findings.empty()) {
    refuse(Text::tr("its audit trail does not verify (%1 {finding|findings})", findings.size()),
           from.location(), Text::tr("Run torsio audit verify on it and restore a backup"));
  }
  std::int64_t all = 0;
  for (const SchemaTable& table : tables) {
    all += countOf(from, table.name);
  }

  const UnsealedCopy bringsItsSeals(to);
  Transaction writing(to);
  requireFit(from, to, tables);  // again, now that nobody else can write
  clearSeeds(to, tables);
  CopyReport report;
  for (const SchemaTable& table : tables) {
    copyTable(from, to, table, [&] {
      if (++report.rows % kRowsPerProgress == 0 && progress) {
        progress({CopyPhase::kCopying, table.name, report.rows, all});
      }
    });
  }
  compareTables(from, to, tables, all, report, progress);
  if (!verifyAuditTrail(to, verifyProgress(progress, CopyPhase::kVerifyingCopy)).empty()) {
    throw Error(ErrorCode::kVerifyFailed,
                Text::tr("the audit trail does not verify after copying; nothing was kept"), to.location(),
                Text::tr("Check both machines, then copy again"));
  }
  report.auditEntries = AuditRepository(to).length();
  writing.commit();
  reading.commit();
  return report;
}

}  // namespace torsio
