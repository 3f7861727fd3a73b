// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "app/services/access/session_context.h"
#include "app/services/base/progress.h"
#include "app/services/recording/unstored_trials.h"
#include "db/repository/system/record_copy.h"

namespace torsio {

struct Maintainer;

/// A database on a PostgreSQL server, as somebody types it.
struct ServerAddress {
  std::string host{};
  int port = 5432;
  std::string database{};
  std::string user{};
  std::string password{};  ///< for this piece of work only: it is stored nowhere
  std::string schema{};    ///< empty: the server's search path
  std::string tlsMode{};   ///< sslmode: "verify-full" checks the server; empty: as PostgreSQL's library does
  std::string
      rootCertificate{};  ///< file of the authority that the server must be signed by; empty: the usual
};

/// The locator with the password, to be kept in memory only. Throws Error (kBadParameter) without host,
/// database or user, or for a schema name that is not allowed.
[[nodiscard]] std::string typedLocator(const ServerAddress& address);
/// The locator that a station keeps: without the password, which then comes from the account's password file.
[[nodiscard]] std::string lastingLocator(const ServerAddress& address);
/// The line of the password file (.pgpass) for this address, with a word in place of the password.
[[nodiscard]] std::string passwordFileLine(const ServerAddress& address);

/// What a look at a server found. Nothing was changed there.
struct ServerCheck {
  std::string location{};          ///< without a password
  std::string server{};            ///< "PostgreSQL 15.8"
  std::int64_t schemaVersion = 0;  ///< 0: Torsio's tables are not there yet
  /// Why the record cannot go there, one plain sentence; empty: it can.
  std::string hindrance{};
  bool holdsRecord = false;  ///< somebody's record of a version that we know: this station could join it
  bool opensWithoutPassword = false;  ///< the password file or the server lets this account in
};

/// Connects and looks: whether the database is empty or holds the empty tables of a version that we know, and
/// whether the account may make tables. kDatabaseRestore. Throws Error, DbError (kUnreachable) when it does
/// not answer or refuses the password.
[[nodiscard]] ServerCheck checkServer(SessionContext& session, const ServerAddress& address);

/// Copies this record to the server and compares both (copyDatabase). The record itself stays as it is but
/// for an audit entry before, which is copied too, and another when it failed. kDatabaseRestore. Throws
/// Error: kDatabase while others work at the record, kBadData while recordings of this station wait in files
/// of `unstored` or when the target is not empty, kVerifyFailed when the copy differs; whatever `progress`
/// throws. The server is as it was then.
[[nodiscard]] CopyReport moveToServer(SessionContext& session, const ServerAddress& address,
                                      const ProgressCallback& progress = {},
                                      const std::filesystem::path& unstored = unstoredFolder());

/// Before this station turns to the server: nobody wrote to the record since `copied`, and the server opens
/// without the typed password. Tells of it in the audit trail of the server's record. Returns the locator to
/// keep. kDatabaseRestore. Throws Error (kBadData) when something was written, (kDatabase) when the
/// password would be needed.
[[nodiscard]] std::string switchToServer(SessionContext& session, const ServerAddress& address,
                                         const CopyReport& copied);

/// Another station turns to a record that lies on the server already; the record here stays as it is and is
/// not used any more. Told in both audit trails. Returns the locator to keep. kDatabaseRestore. Throws Error
/// (kBadData) while recordings of this station wait in files of `unstored` or when no record is there,
/// (kDatabase) when the password would be needed.
[[nodiscard]] std::string joinServer(SessionContext& session, const ServerAddress& address,
                                     const std::filesystem::path& unstored = unstoredFolder());

/// Brings the schema of a server up to date and writes the roles (db/repository/people/server_roles.h), as
/// the owner of its tables. Audited. An empty database becomes a record without a centre; then only the
/// system can have been named. kDatabaseRestore. Throws Error: kUsage for a file, kPermission when the
/// account is not the owner; DbError.
void prepareServer(const Maintainer& maintainer, const std::string& locator, const std::string& stationRole);
/// Writes the roles of the server that the session works on. kDatabaseRestore. Throws like the one above.
void prepareServer(SessionContext& session, const std::string& stationRole);

}  // namespace torsio
