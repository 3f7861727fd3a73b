// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "db/connection/locator.h"

namespace torsio {

/// Turns the text of a migration into the statements of one engine. The language is plain SQL that both
/// engines read, plus:
///
///   {{blob}}                   BLOB or BYTEA
///   {{append_only_support}}    what the next line needs; once, after the table erasure_gate
///   {{append_only TABLE}}      rows may be added; changing or deleting one is refused by a trigger, unless
///   the
///                              same transaction put a row into erasure_gate (person erase, demo removal)
///   {{immutable TABLE}}        the same without that gate: not even an erase may touch it
///   {{frozen TABLE COLUMN}}    the column keeps the value it was inserted with, always
///
/// A statement ends with `;` at the end of a line; a line that starts with `--` is a comment.
/// Throws Error (kBadData) for an unknown token or a statement without its end.
[[nodiscard]] std::vector<std::string> statementsFor(Engine engine, std::string_view migration,
                                                     const std::string& where);

/// Returns the tables that a migration declares append-only or immutable, in its order.
[[nodiscard]] std::vector<std::string> appendOnlyTables(std::string_view migration);

}  // namespace torsio
