// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// A part of the schema or of the permission matrix that differs from this program's migrations.
struct SchemaFinding {
  std::string part{};  ///< kind and name: "trigger person_code_frozen", "right trainee user.manage"
  std::string what{};  ///< one sentence without a full stop
};

/// Compares the schema of a record with the migrations', so that removed or added triggers and loosened rules
/// are detected. SQLite: every table, index, trigger and view. PostgreSQL: every column, reference, key,
/// index, trigger (its action, and whether it is enabled) and function, the number of checks, and any rules,
/// settings and tables of other schemas that would bypass the triggers or make an account read something
/// else. A record newer than this program is a finding, as nothing was compared. Empty: no difference, or an
/// older record. `serverParts`: additional parts of a prepared server, which must be present completely or
/// not at all.
[[nodiscard]] std::vector<SchemaFinding> schemaFindings(
    Connection& connection, const std::map<std::string, std::string>& serverParts = {});

/// Creates an in-memory record with the migrations' rows only.
[[nodiscard]] Connection freshRecord();

}  // namespace torsio
