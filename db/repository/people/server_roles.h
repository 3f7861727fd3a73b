// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace torsio {

class Connection;

// Rights on a PostgreSQL server. The owner of the tables migrates the schema and prepares the station role,
// as which stations work. docs/server.md explains what this protects against.

/// Returns the station role's rights on a table in GRANT syntax: "SELECT, INSERT, UPDATE". Empty: not listed,
/// so the table must be append-only.
[[nodiscard]] std::optional<std::string_view> declaredRightsOn(std::string_view table);

/// Returns what a prepared server has besides the schema, named as by schemaFindings(): bodies of its
/// functions (server_functions.h) and the tables with row policies.
[[nodiscard]] std::map<std::string, std::string> serverParts();

/// Creates the station role if missing, revokes all rights from it and everybody else, and grants those of
/// `tables`: the declared ones, or SELECT and INSERT for tables in `appendOnly`. Creates the functions, and
/// the policies that restrict rows to the users concerned, replacing all others, and hides stored passwords
/// (stored_password.h).
/// Repeatable and atomic. Throws DbError if the account lacks permission, Error (kBadParameter) for a role
/// name with other characters than lower-case letters, digits and underscores or that of the owner, (kUsage)
/// for SQLite; ContractError for a table that is neither declared nor append-only.
void writeServerRoles(Connection& connection, std::span<const std::string> tables,
                      const std::set<std::string>& appendOnly, const std::string& role);

/// Serialises changes of roles and rights in this connection's database until the end of the transaction.
/// PostgreSQL keeps them in rows shared by all records of a database and rejects concurrent changes of one.
void waitForRightsOfDatabase(Connection& connection);

/// True if the account of this connection owns the record's tables.
[[nodiscard]] bool isOwnerOfTables(Connection& connection);

/// Throws Error (kPermission) if row policies hide some marks from the current user. Call it before reading
/// all marks, which would otherwise seem deleted, or yield wrong means.
void requireEveryRow(Connection& connection);

/// Returns the sealed tables of which the current user sees only some rows: names, groups, the seed of an
/// allocation, codes. Empty for the owner and on SQLite.
[[nodiscard]] std::set<std::string> tablesSeenInPart(Connection& connection);

/// Tells a server whose session this is: the token that open_session() gave, in lower-case hexadecimal;
/// empty: nobody's. Reverted if the transaction in which it was told is rolled back.
void tellSession(Connection& connection, const std::string& token);

/// Erases through the function of a prepared server. Returns false without one: the account then does it
/// itself.
[[nodiscard]] bool eraseOnServer(Connection& connection, const std::string& personId,
                                 const std::string& requestedBy, const std::string& reason,
                                 std::int64_t utc_us);

}  // namespace torsio
