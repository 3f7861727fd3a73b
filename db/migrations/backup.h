// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "db/connection/connection.h"

namespace torsio {

/// Writes a consistent copy of an open SQLite database while others go on working, checks it, and renames it
/// to `target` (an older file of that name is replaced). On failure nothing is left behind and an older
/// `target` is untouched. Throws Error, DbError.
void backupSqlite(Connection& connection, const std::filesystem::path& target);

/// What the engine finds wrong with the file or its references; empty: nothing.
[[nodiscard]] std::vector<std::string> integrityFindings(Connection& connection);

}  // namespace torsio
