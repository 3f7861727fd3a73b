// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// One numbered step of the schema: the file NNNN_name.sql, embedded in the program.
struct Migration {
  std::int64_t version = 0;
  std::string name{};               ///< "0001_first_release"
  std::string description{};        ///< from the line `-- description: ...`
  std::int64_t compatibleFrom = 1;  ///< oldest schema version whose programs can still read the result
  std::string sql{};
  std::string checksum{};  ///< BLAKE2b-256 over the text with \n line ends
};

/// All steps that this program knows, in order. Versions count 1, 2, 3 ... without a gap.
[[nodiscard]] std::vector<Migration> embeddedMigrations();

/// Reads the head lines of a migration text. Throws Error (kBadData) when one is missing.
[[nodiscard]] Migration parseMigration(const std::string& name, const std::string& text);

struct SchemaState {
  std::int64_t version = 0;  ///< of the database; 0: empty
  std::int64_t compatibleFrom = 0;
  std::int64_t known = 0;  ///< newest version of this program
};

/// Compares the database with what this program knows. Throws Error: kNewerSchema when the database is newer
/// than this program (allowed when it is opened read-only and its compatible_from permits), kVerifyFailed
/// when a step that was applied is not the step that we know (checksum), kFileUnreadable when the database
/// holds somebody else's tables. Changes nothing.
[[nodiscard]] SchemaState checkSchema(Connection& connection, const std::vector<Migration>& migrations);

struct MigrationOptions {
  std::string softwareVersion = "unknown";
  std::int64_t now_us = 0;  ///< wall clock; 0: the machine's
  bool backup = true;       ///< of an existing SQLite file, before the first step
  std::string station{};    ///< this machine, for the register of copies
};

struct MigrationReport {
  std::int64_t fromVersion = 0;
  std::int64_t toVersion = 0;
  std::optional<std::filesystem::path> backup{};  ///< written beside the database
};

/// Applies the missing steps, each in one transaction of its own; a step that fails leaves the database at
/// the step before. A step on an existing record seals in its transaction what has no seal yet. Two programs
/// that start at once do not disturb each other. Within a Transaction of the caller all steps are kept with
/// it or not at all (then without `backup`). Throws Error, DbError.
MigrationReport migrate(Connection& connection, const std::vector<Migration>& migrations,
                        const MigrationOptions& options);

/// openDatabase, checkSchema and, unless `mode` is read-only, migrate with the embedded steps; changes are
/// sealed from then on (db/repository/base/row_ledger.h).
[[nodiscard]] Connection openRecord(const std::string& locator, OpenMode mode,
                                    const MigrationOptions& options = {});

}  // namespace torsio
