// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "db/connection/connection.h"
#include "sim/core/text.h"

namespace torsio {

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
