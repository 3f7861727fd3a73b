// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "app/services/recording/unstored_trials.h"
#include "assessment/domain/people/outdated_access.h"
#include "db/repository/system/record_copy.h"

namespace torsio {

struct Maintainer;

/// A database on a PostgreSQL server, as entered by the user.
struct ServerAddress {
  std::string host{};
  int port = 5432;
  std::string database{};
  std::string user{};
  std::string password{};  ///< used only for this operation, never stored
  std::string schema{};    ///< empty: the server's search path
  std::string tlsMode{};   ///< sslmode: "verify-full" checks the server; empty: default of PostgreSQL's
                           ///< library
  std::string rootCertificate{};  ///< file with the certificate authority of the server; empty: default
};

/// Returns the locator with the password, for use in memory only. Throws Error (kBadParameter) without host,
/// database or user, or for an invalid schema name.
[[nodiscard]] std::string typedLocator(const ServerAddress& address);
/// Returns the locator that a station stores: without the password, which comes from the account's password
/// file.
[[nodiscard]] std::string lastingLocator(const ServerAddress& address);
/// Returns the password file (.pgpass) line for this address, with a placeholder for the password.
[[nodiscard]] std::string passwordFileLine(const ServerAddress& address);

/// Result of checking a server, which is not changed.
struct ServerCheck {
  std::string location{};          ///< without a password
  std::string server{};            ///< "PostgreSQL 15.8"
  std::int64_t schemaVersion = 0;  ///< 0: Torsio's tables do not exist yet
  /// Why the record cannot be moved there, one sentence; empty: it can.
  std::string hindrance{};
  bool holdsRecord = false;           ///< contains a record of a known version, which this station could join
  bool opensWithoutPassword = false;  ///< the password file or the server admits this account
};

/// Connects and checks whether the database is empty or has only empty tables of a known version, and whether
/// the account may create tables. kDatabaseRestore. Throws Error, DbError (kUnreachable) if the server does
/// not answer or rejects the password.
[[nodiscard]] ServerCheck checkServer(SessionContext& session, const ServerAddress& address);

/// Copies this record to the server and compares both (copyDatabase()). The record itself only gets an audit
/// entry before copying (so it is in the copy too), and another after a failure. kDatabaseRestore. Throws
/// Error: kDatabase while others work on the record, kBadData if recordings of this station are waiting in
/// files of `unstored` or the target is not empty, kVerifyFailed if the copy differs; what `progress` throws.
/// The server is unchanged then.
[[nodiscard]] CopyReport moveToServer(SessionContext& session, const ServerAddress& address,
                                      const ProgressCallback& progress = {},
                                      const std::filesystem::path& unstored = unstoredFolder());

/// Call before this station switches to the server: checks that nobody wrote to the record since `copied` and
/// that the server opens without the entered password, and audits the switch in the server's record. Returns
/// the locator to store. kDatabaseRestore. Throws Error (kBadData) if something was written, (kDatabase) if
/// the password would be needed.
[[nodiscard]] std::string switchToServer(SessionContext& session, const ServerAddress& address,
                                         const CopyReport& copied);

/// Switches another station to a record that is already on the server; the local record is kept but no longer
/// used. Audited in both records. Returns the locator to store. kDatabaseRestore. Throws Error (kBadData) if
/// recordings of this station are waiting in files of `unstored` or there is no record on the server,
/// (kDatabase) if the password would be needed.
[[nodiscard]] std::string joinServer(SessionContext& session, const ServerAddress& address,
                                     const std::filesystem::path& unstored = unstoredFolder());

/// Migrates the schema of a server and creates the roles (db/repository/people/server_roles.h) as the owner
/// of its tables. Audited. An empty database becomes a record without a centre; in that case only the system
/// account can be the maintainer. kDatabaseRestore. Throws Error: kUsage for a file, kPermission if the
/// account is not the owner; DbError.
/// Returns which cards and links open nothing there.
OutdatedAccess prepareServer(const Maintainer& maintainer, const std::string& locator,
                             const std::string& stationRole);
/// Creates the roles on the server of this session. kDatabaseRestore. Throws like the overload above.
OutdatedAccess prepareServer(SessionContext& session, const std::string& stationRole);

}  // namespace torsio
