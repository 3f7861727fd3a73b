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

// Rights on a PostgreSQL server. The owner of the tables brings the schema up to date and prepares the
// station role; stations work as that role. docs/server.md says what this protects against.

/// The rights of the station role on a table that is not only added to, as GRANT takes them: "SELECT, INSERT,
/// UPDATE". No value: the table has no line here, so it must be append-only.
[[nodiscard]] std::optional<std::string_view> declaredRightsOn(std::string_view table);

/// What a prepared server has besides the schema, as schemaFindings() names it: the bodies of its functions,
/// which run with the rights of the owner and only look up who asks, but for erase_person, and which tables
/// have row policies.
[[nodiscard]] std::map<std::string, std::string> serverParts();

/// Makes the station role unless it exists, takes all rights from it and from everybody else, and gives it
/// those of `tables`: the declared ones, else SELECT and INSERT where the table is among `appendOnly`; makes
/// the functions, and the policies by which rows of marks and drafts are seen by
/// whom they concern, in place of all others. May be repeated. All or nothing. Throws DbError when the
/// account may not, Error (kBadParameter) for a role that is not made of lower-case letters, digits and
/// underscores or is the owner itself, (kUsage) for SQLite; ContractError for a table that is neither
/// declared nor append-only.
void writeServerRoles(Connection& connection, std::span<const std::string> tables,
                      const std::set<std::string>& appendOnly, const std::string& role);

/// Whoever changes roles or rights in the database of this connection waits here for whoever does so already,
/// until the end of the transaction. PostgreSQL keeps them in rows that all records of a database share, and
/// refuses the second of two who change one at once.
void waitForRightsOfDatabase(Connection& connection);

/// Whether the account of this connection owns the tables of the record.
[[nodiscard]] bool isOwnerOfTables(Connection& connection);

/// For whatever reads all marks: throws Error (kPermission) where the policies hide some of them from whoever
/// asks, who would be told that they are gone, or get means without them.
void requireEveryRow(Connection& connection);

/// On a server: says who asks from now on, so that the policies let this user see what concerns them. Empty:
/// nobody. Lost when the transaction in which it was said is rolled back.
void sayWhoAsks(Connection& connection, const std::string& userId);

/// Erases on a prepared server through its function. False: there is none, so the account does it itself.
[[nodiscard]] bool eraseOnServer(Connection& connection, const std::string& personId,
                                 const std::string& requestedBy, const std::string& reason,
                                 std::int64_t utc_us);

}  // namespace torsio
