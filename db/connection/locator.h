// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace torsio {

enum class Engine { kSqlite, kPostgresql };

/// One parameter of a server's address that PostgreSQL's own library reads: "sslmode" = "verify-full".
struct ServerParameter {
  std::string name{};
  std::string value{};

  [[nodiscard]] bool operator==(const ServerParameter&) const = default;
};

/// Where a record lies: the path of an SQLite file, or postgresql://user:password@host:port/database with
/// parameters behind a `?`: schema=NAME and those of kServerParameters. Parts are percent-decoded.
struct Locator {
  Engine engine = Engine::kSqlite;
  std::string file{};  ///< SQLite; ":memory:" is a private database in memory
  std::string user{};
  std::string password{};
  std::string host{};      ///< empty: the service says it
  int port = 5432;         ///< 0: the service says it
  std::string database{};  ///< empty: the service says it
  std::string schema{};    ///< empty: the server's search path
  std::vector<ServerParameter> parameters{};

  /// For messages: never contains the password.
  [[nodiscard]] std::string shown() const;
  /// The value of a parameter; empty: it was not given.
  [[nodiscard]] std::string parameter(std::string_view name) const;
};

/// Throws Error (kBadParameter) for a postgresql:// text that lacks a host or a database and names no
/// service, has a schema name that is not made of lower-case letters, digits and underscores, or a parameter
/// that is unknown, empty, given twice, or holds a semicolon: nothing of an address is ever ignored.
[[nodiscard]] Locator parseLocator(const std::string& text);

/// The address of a server as text, with the password where there is one. parseLocator() reads it back.
[[nodiscard]] std::string addressOf(const Locator& server);

}  // namespace torsio
