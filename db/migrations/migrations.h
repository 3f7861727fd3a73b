// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// A numbered schema migration: the file NNNN_name.sql, embedded in the program.
struct Migration {
  std::int64_t version = 0;
  std::string name{};               ///< "0001_first_release"
  std::string description{};        ///< from the line `-- description: ...`
  std::int64_t compatibleFrom = 1;  ///< oldest schema version whose programs can still read the result
  std::string sql{};
  std::string checksum{};  ///< BLAKE2b-256 of the text with \n line ends
};

/// Returns all migrations of this program in order, numbered 1, 2, 3 ... without gaps.
[[nodiscard]] std::vector<Migration> embeddedMigrations();

/// Parses a migration's header lines. Throws Error (kBadData) if one is missing.
[[nodiscard]] Migration parseMigration(const std::string& name, const std::string& text);

struct SchemaState {
  std::int64_t version = 0;  ///< of the database; 0: empty
  std::int64_t compatibleFrom = 0;
  std::int64_t known = 0;  ///< newest version of this program
};

/// Compares the database with this program's migrations; changes nothing. Throws Error: kNewerSchema if the
/// database is newer (allowed for read-only access if its compatible_from permits), kVerifyFailed if the
/// checksum of an applied migration differs, kFileUnreadable if the database holds another program's tables.
[[nodiscard]] SchemaState checkSchema(Connection& connection, const std::vector<Migration>& migrations);

struct MigrationOptions {
  std::string softwareVersion = "unknown";
  std::int64_t now_us = 0;  ///< wall clock; 0: the machine's
  bool backup = true;       ///< of an existing SQLite file, before the first migration
  std::string station{};    ///< this machine, for the register of copies
};

struct MigrationReport {
  std::int64_t fromVersion = 0;
  std::int64_t toVersion = 0;
  std::optional<std::filesystem::path> backup{};  ///< written beside the database
};

/// Applies the missing migrations, each in its own transaction; if one fails, the database stays at the one
/// before. On an existing record each transaction also seals rows that have no seal yet. Safe if two programs
/// start at once. Inside a Transaction of the caller, all migrations are committed with it or not at all
/// (without `backup`). Throws Error, DbError.
MigrationReport migrate(Connection& connection, const std::vector<Migration>& migrations,
                        const MigrationOptions& options);

/// Opens a database, checks its schema and, unless read-only, migrates it; from then on changes are sealed
/// (db/repository/base/row_ledger.h).
[[nodiscard]] Connection openRecord(const std::string& locator, OpenMode mode,
                                    const MigrationOptions& options = {});

/// True while another connection migrates this record or fills it with a copy. Always false for a file.
[[nodiscard]] bool isBeingFilled(Connection& connection);

}  // namespace torsio
