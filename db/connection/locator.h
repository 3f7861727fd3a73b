// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

enum class Engine { kSqlite, kPostgresql };

/// A libpq parameter in a server's address: "sslmode" = "verify-full".
struct ServerParameter {
  std::string name{};
  std::string value{};

  [[nodiscard]] bool operator==(const ServerParameter&) const = default;
};

/// Address of a database: the path of an SQLite file, or postgresql://user:password@host:port/database with
/// parameters after `?`: schema=NAME and those of kServerParameters. Parts are percent-decoded.
struct Locator {
  Engine engine = Engine::kSqlite;
  std::string file{};  ///< SQLite; ":memory:" is a private database in memory
  std::string user{};
  std::string password{};
  std::string host{};      ///< empty: from the service
  int port = 5432;         ///< 0: from the service
  std::string database{};  ///< empty: from the service
  std::string schema{};    ///< empty: the server's search path
  std::vector<ServerParameter> parameters{};

  /// Returns the address for messages, without the password.
  [[nodiscard]] std::string shown() const;
  /// Returns the value of a parameter; empty if absent.
  [[nodiscard]] std::string parameter(std::string_view name) const;
};

/// Parses an address. Throws Error (kBadParameter) for a postgresql:// text without host or database that
/// names no service, a schema name with other characters than lower-case letters, digits and underscores, or
/// a parameter that is unknown, empty, duplicate or contains a semicolon: nothing is silently ignored.
[[nodiscard]] Locator parseLocator(const std::string& text);

/// Formats a server's address, including any password. parseLocator() reads it back.
[[nodiscard]] std::string addressOf(const Locator& server);

enum class OpenMode {
  kCreate,     ///< SQLite: created if missing. PostgreSQL: the database must exist
  kReadWrite,  ///< must exist
  kReadOnly,   ///< must exist; read-only
};

/// Checks that an SQLite file can be opened, where the engine would only report "unable to open database
/// file":
/// a folder, a pipe, an empty file, a dangling link, no write permission. Throws Error (kFileMissing,
/// kFileUnreadable, kFileUnwritable).
void requireUsableFile(const std::filesystem::path& file, OpenMode mode);

/// Throws Error (kFileUnwritable) with the remedy.
[[noreturn]] void refuseReadOnly(const Text& what, const std::filesystem::path& path);

/// True if an interrupted change (SQLite's rollback journal) awaits rollback, which needs write access.
[[nodiscard]] bool hasJournal(const std::string& file);

}  // namespace torsio
