// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "db/connection/connection.h"
#include "sim/core/text.h"

namespace torsio {

/// A column of a row for insertIdempotent().
struct IdempotentColumn {
  /// Role of a column when a row is inserted again.
  enum class Kind {
    kKey,      ///< part of the key that identifies the row
    kContent,  ///< must be equal
    kIgnored,  ///< may differ, such as the time of storing
  };
  std::string_view name;
  Value value;
  Kind kind = Kind::kContent;
};

enum class Inserted { kNew, kThereAlready };

/// Inserts a row; inserting the same row again is no error, since a server whose answer was lost may have
/// stored it. `what` names the row in the message ("this second of the trial"). Throws DbError (kUnique) if a
/// row with that key and other content exists.
Inserted insertIdempotent(Connection& connection, std::string_view table,
                          std::span<const IdempotentColumn> columns, const Text& what);

/// Throws the DbError (kUnique) for a row that is stored with other content.
[[noreturn]] void refuseOtherContent(Connection& connection, std::string_view table, const Text& what);

/// True if a value read back equals the given one: SQLite returns booleans as integers.
[[nodiscard]] bool sameStored(const Value& given, const Value& read);

}  // namespace torsio
