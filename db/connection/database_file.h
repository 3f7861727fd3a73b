// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "db/connection/connection.h"
#include "sim/core/text.h"

namespace torsio {

/// Says why an SQLite file cannot be opened, where the engine would only be "unable to open database file": a
/// folder, a pipe, an empty file, a link to nothing, something read-only. Throws Error (kFileMissing,
/// kFileUnreadable, kFileUnwritable).
void requireUsableFile(const std::filesystem::path& file, OpenMode mode);

/// Throws Error (kFileUnwritable) that says what to do.
[[noreturn]] void refuseReadOnly(const Text& what, const std::filesystem::path& path);

/// Whether a change was begun there (SQLite's rollback journal) that only somebody who may write takes back.
[[nodiscard]] bool hasJournal(const std::string& file);

}  // namespace torsio
