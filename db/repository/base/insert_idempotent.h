// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "db/connection/connection.h"
#include "sim/core/text.h"

namespace torsio {

/// One column of a row that is added by insertIdempotent().
struct IdempotentColumn {
  /// What a retry must find again.
  enum class Kind {
    kKey,      ///< with the other key columns: which row
    kContent,  ///< must be the same
    kIgnored,  ///< when it was stored: may differ
  };
  std::string_view name;
  Value value;
  Kind kind = Kind::kContent;
};

enum class Inserted { kNew, kThereAlready };

/// Adds a row; the same row once more is no error. A server whose answer was lost may have kept what it was
/// given: whoever gives it again must neither double it nor be refused. `what` names the row in the message
/// ("this second of the trial"). Throws DbError (kUnique) when a row of that key is there with other content.
Inserted insertIdempotent(Connection& connection, std::string_view table,
                          std::span<const IdempotentColumn> columns, const Text& what);

/// The DbError (kUnique) for a row that is stored already with other content.
[[noreturn]] void refuseOtherContent(Connection& connection, std::string_view table, const Text& what);

/// Whether a value that was read is the one that was given: SQLite gives booleans back as integers.
[[nodiscard]] bool sameStored(const Value& given, const Value& read);

}  // namespace torsio
