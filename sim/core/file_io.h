// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace torsio {

/// Throws Error (kFileUnwritable) that names the file and what to look at.
[[noreturn]] void refuseUnwritable(const std::filesystem::path& file);

/// Reads the whole file as bytes. Throws Error (kFileMissing, kFileUnreadable).
[[nodiscard]] std::string readFile(const std::filesystem::path& file);

/// Refuses to overwrite a database with a report, a table or a picture: naming the record by mistake must not
/// destroy it. Throws Error (kFileUnwritable).
void requireNoDatabase(const std::filesystem::path& file);

/// Writes through a temporary file beside `file` and renames it, so that no half file is ever seen.
/// Throws Error (kFileUnwritable), also for requireNoDatabase(); then the old file, if any, is untouched.
void writeFileAtomically(const std::filesystem::path& file, std::string_view bytes);

/// Writes what `write` puts into the stream through a temporary file beside `file`. `write` may throw; then
/// nothing is left behind. Throws Error (kFileUnwritable).
void writeFileAtomically(const std::filesystem::path& file, const std::function<void(std::ostream&)>& write);

/// Returns the temporary name that an external writer (PDF, database) should use before renaming to `file`.
[[nodiscard]] std::filesystem::path temporaryBeside(const std::filesystem::path& file);

/// Creates the folder with its parents if it is missing. Throws Error (kFileUnwritable).
void ensureFolder(const std::filesystem::path& folder);

}  // namespace torsio
