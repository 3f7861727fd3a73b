// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

enum class Engine { kSqlite, kPostgresql };

/// Where a record lies: the path of an SQLite file, or postgresql://user:password@host:port/database with an
/// optional ?schema=NAME. Parts are percent-decoded.
struct Locator {
  Engine engine = Engine::kSqlite;
  std::string file{};  ///< SQLite; ":memory:" is a private database in memory
  std::string user{};
  std::string password{};
  std::string host{};
  int port = 5432;
  std::string database{};
  std::string schema{};  ///< empty: the server's search path

  /// For messages: never contains the password.
  [[nodiscard]] std::string shown() const;
};

/// Throws Error (kBadParameter) for a postgresql:// text that lacks a host or a database, or has a schema
/// name that is not made of lower-case letters, digits and underscores.
[[nodiscard]] Locator parseLocator(const std::string& text);

}  // namespace torsio
