// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// A part of the schema, or of the matrix of rights, that is not as the steps of this program made it.
struct SchemaFinding {
  std::string part{};  ///< kind and name: "trigger person_code_frozen", "right trainee user.manage"
  std::string what{};  ///< one sentence without a full stop
};

/// Compares the schema of a record with what the steps make, so that nobody can take a trigger away, add one,
/// or loosen a rule unseen. SQLite: every table, index, trigger and view. PostgreSQL: every column,
/// reference, key, index, trigger (what it does, and whether it is on) and function, the number of checks,
/// and rules, settings and tables of other schemas that would pass the triggers by, or let an account read
/// something else. Of the schema that this program knows; empty: nothing differs, or the record is newer.
/// `serverParts`: what a prepared server has besides, all of it or nothing.
[[nodiscard]] std::vector<SchemaFinding> schemaFindings(
    Connection& connection, const std::map<std::string, std::string>& serverParts = {});

/// A record in memory as the steps make it, with no row but theirs.
[[nodiscard]] Connection freshRecord();

}  // namespace torsio
