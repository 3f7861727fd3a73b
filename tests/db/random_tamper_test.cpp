// SPDX-License-Identifier: GPL-3.0-or-later
// Random changes of any column of any table, and of any byte of the file. TORSIO_TAMPER_CHANGES=1000 runs
// more than the default.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "db/connection/connection.h"
#include "db/connection/db_error.h"
#include "db/connection/row_reader.h"
#include "db/migrations/backup.h"
#include "db/migrations/migrations.h"
#include "db/repository/base/changed_statement.h"
#include "db/repository/base/row_seal.h"
#include "db/repository/base/seal_rules.h"
#include "db/repository/system/schema_tables.h"
#include "sim/core/file_io.h"
#include "sim/core/random.h"
#include "tests/db/full_record.h"
#include "tests/db/tampering.h"
#include "tests/db/test_database.h"

namespace torsio {
namespace {

int changesWanted() {
  const char* wanted = std::getenv("TORSIO_TAMPER_CHANGES");
  return wanted == nullptr ? 40 : std::atoi(wanted);
}

std::set<std::string> findingsIn(Connection& connection) {
  const std::vector<std::string> all = allFindings(connection);
  return {all.begin(), all.end()};
}

/// True for columns without a seal, which the rules justify: "table.column", or "table.*".
bool carriesNothing(const std::string& table, const std::string& column) {
  for (const SealRule& rule : kSealRules) {
    if (rule.table != table) {
      continue;
    }
    if (rule.sealing == Sealing::kNot) {
      return true;
    }
    for (const std::string& unsealed : columnsOf(rule.unsealed)) {
      if (unsealed == column) {
        return true;
      }
    }
  }
  return false;
}

class Changer {
 public:
  explicit Changer(std::uint64_t seed) : random_(seed) {}

  std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_.next() % count); }

  /// Another value of the same type.
  Value other(const Value& value) {
    if (const auto* number = std::get_if<std::int64_t>(&value.storage())) {
      return *number == 0 || *number == 1 ? 1 - *number
                                          : *number + 1 - 2 * static_cast<std::int64_t>(below(2));
    }
    if (const auto* flag = std::get_if<bool>(&value.storage())) {
      return !*flag;
    }
    if (const auto* number = std::get_if<double>(&value.storage())) {
      return *number * 0.5 + 0.01;
    }
    if (const auto* text = std::get_if<std::string>(&value.storage())) {
      std::string changed = *text;
      if (changed.empty() || below(4) == 0) {
        return changed + "x";
      }
      char& letter = changed[below(changed.size())];
      letter = letter == 'a' ? 'b' : 'a';
      return changed;
    }
    if (const auto* bytes = std::get_if<Blob>(&value.storage())) {
      Blob changed = *bytes;
      if (changed.empty()) {
        return Blob{std::byte{1}};
      }
      changed[below(changed.size())] ^= std::byte{1};
      return changed;
    }
    return "something";
  }

 private:
  Random random_;
};

class RandomTamper : public DatabaseTest {};

TEST_F(RandomTamper, ValuesOfAnotherTypeAndMissingColumnsAreFindings) {
  if (onPostgresql()) {
    GTEST_SKIP() << "a server keeps the kind of every column";
  }
  const FullRecord real(connection(), "real", false);
  Connection behind = open();
  disarm(behind);
  const std::set<std::string> before = findingsIn(behind);
  for (const char* change : {"UPDATE operation SET label = CAST(label AS BLOB) WHERE code = 'practice'",
                             "UPDATE role SET code = CAST(code AS BLOB) WHERE code = 'trainee'",
                             "UPDATE schema_migration SET name = CAST(name AS BLOB)",
                             "UPDATE audit_entry SET reason = CAST(reason AS BLOB) WHERE sequence = 1",
                             "UPDATE row_seal SET row_hash = CAST(row_hash AS BLOB) WHERE position = 1",
                             "UPDATE seal_salt SET salt = CAST(salt AS BLOB)",
                             "UPDATE trial_chunk SET digest = CAST(digest AS BLOB)",
                             "ALTER TABLE consent RENAME COLUMN purpose TO purpoze"}) {
    const Transaction undone(behind);
    behind.executeVerbatim(change);
    EXPECT_NE(findingsIn(behind), before) << change;
  }
}

TEST_F(RandomTamper, EveryChangeOfAnyColumnIsDetected) {
  const FullRecord real(connection(), "real", false);
  const FullRecord simulated(connection(), "demo", true);
  Connection behind = open();
  disarm(behind);
  const std::set<std::string> before = findingsIn(behind);
  std::vector<SchemaTable> tables = tablesInReferenceOrder(behind);
  tables.push_back(
      {"schema_migration", {{"version"}, {"name"}, {"description"}, {"checksum"}, {"compatible_from"}}, {}});
  Changer changer(20251121);
  int made = 0;
  std::map<std::string, int> leftOut;
  std::vector<std::string> missed;

  for (int tries = 0; made < changesWanted() && tries < 50 * changesWanted(); ++tries) {
    const SchemaTable& table = tables[changer.below(tables.size())];
    const std::string column = table.columns[changer.below(table.columns.size())].name;
    if (carriesNothing(table.name, column)) {
      ++leftOut[table.name + "." + column];
      continue;
    }
    const Transaction undone(behind);
    std::vector<std::vector<Value>> rows;
    std::vector<std::string> names;
    forEachSelected(behind, "SELECT * FROM " + table.name, [&](const Statement& row) {
      rows.push_back(valuesOf(row));
      names = columnNamesOf(row);
    });
    if (rows.empty()) {
      continue;
    }
    const std::vector<Value>& row = rows[changer.below(rows.size())];
    std::vector<Value> values;
    std::string where;
    for (const SealRule& rule : kSealRules) {
      if (rule.table != table.name) {
        continue;
      }
      for (const std::string& key : columnsOf(rule.key)) {
        where += (where.empty() ? " WHERE " : " AND ") + key + " = ?";
        values.push_back(
            row[static_cast<std::size_t>(std::find(names.begin(), names.end(), key) - names.begin())]);
      }
    }
    const Value was =
        row[static_cast<std::size_t>(std::find(names.begin(), names.end(), column) - names.begin())];
    values.insert(values.begin(), changer.other(was));
    try {
      behind.prepare("UPDATE " + table.name + " SET " + column + " = ?" + where).execute(values);
    } catch (const DbError&) {
      continue;  // the column's rules reject the value
    }
    ++made;
    bool found = false;
    try {
      found = findingsIn(behind) != before;
    } catch (const Error&) {
      found = true;                           // the record cannot be opened, with an explanation
    } catch (const std::exception& broken) {  // verification must not fail on tampered data
      missed.push_back(table.name + "." + column + ": " + broken.what());
      continue;
    }
    if (!found) {
      missed.push_back(table.name + "." + column);
    }
  }

  EXPECT_EQ(made, changesWanted());
  EXPECT_EQ(missed, std::vector<std::string>{});
  std::cout << made << " changes, " << made - static_cast<int>(missed.size()) << " found; " << leftOut.size()
            << " columns carry nothing by the rules\n";
}

/// Everything in a file: its schema and the hash of every table.
std::vector<std::string> contentOf(Connection& connection) {
  std::vector<std::string> content = selectAll(
      connection,
      "SELECT coalesce(type, '') || coalesce(name, '') || coalesce(sql, '') FROM sqlite_master ORDER BY 1",
      {}, readText);
  const Transaction look(connection, Transaction::Purpose::kReadOnly);
  for (SchemaTable& table : tablesInReferenceOrder(connection)) {
    std::erase_if(table.columns,
                  [&](const TableColumn& column) { return carriesNothing(table.name, column.name); });
    if (table.columns.empty()) {
      continue;
    }
    const TableDigest digest = digestOf(connection, table);
    content.push_back(digest.table + " " + std::to_string(digest.rows) + " " + digest.hash);
  }
  content.push_back(
      selectAll(connection, "SELECT name || checksum || compatible_from FROM schema_migration", {}, readText)
          .at(0));
  return content;
}

TEST_F(RandomTamper, EveryFlippedByteIsDetectedOrHarmless) {
  if (onPostgresql()) {
    GTEST_SKIP() << "the files of a server are not Torsio's";
  }
  {
    Connection connection = openWithSchema();
    const FullRecord real(connection, "real", false);
    connection.executeVerbatim("PRAGMA journal_mode = DELETE");
    connection.executeVerbatim("PRAGMA page_size = 512");  // fewer empty bytes
    connection.executeVerbatim("VACUUM");
  }
  const std::string sound = readFile(locator());
  const std::string copy = locator() + ".flipped";
  std::vector<std::string> content;
  {
    Connection connection = openRecord(locator(), OpenMode::kReadOnly);
    content = contentOf(connection);
    ASSERT_TRUE(integrityFindings(connection).empty());
    ASSERT_EQ(allFindings(connection), std::vector<std::string>{});
  }
  Changer changer(7);
  int found = 0;
  int without = 0;
  for (int i = 0; i < changesWanted(); ++i) {
    std::string bytes = sound;
    std::size_t at = changer.below(bytes.size());
    for (int tries = 0; bytes[at] == 0 && tries < 200; ++tries) {  // most of a small file is empty
      at = changer.below(bytes.size());
    }
    bytes[at] = static_cast<char>(bytes[at] ^ (1 << changer.below(8)));
    std::ofstream(copy, std::ios::binary) << bytes;
    bool tells = false;
    bool same = false;
    try {
      Connection connection = openRecord(copy, OpenMode::kReadOnly);
      tells = !integrityFindings(connection).empty() || !allFindings(connection).empty();
      same = !tells && contentOf(connection) == content;  // without schema differences
    } catch (const Error&) {
      tells = true;
    } catch (const std::exception& broken) {
      ADD_FAILURE() << "byte " << at << ": " << broken.what();
      continue;
    }
    found += tells ? 1 : 0;
    without += same ? 1 : 0;
    EXPECT_TRUE(tells || same) << "byte " << at << " of " << bytes.size() << ": "
                               << sound.substr(at - std::min<std::size_t>(at, 60), 120);
  }
  std::cout << found << " flipped bytes found, " << without << " without effect\n";
}

}  // namespace
}  // namespace torsio
