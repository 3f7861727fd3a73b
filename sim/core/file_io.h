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

/// Makes every file that this process creates from now on private to its owner (mode 0600), every folder too
/// (0700): records, backups, packages, exports, pictures; calls disableCoreDumps(). On Windows the user's
/// folders are private already. Call once, before any thread.
void keepFilesPrivate() noexcept;
/// Disables core dumps of this process, which would hold names, passwords or a scan, and keeps other programs
/// of the account from reading its memory.
void disableCoreDumps() noexcept;
/// Removes the permissions of group and others from `file`, or from a folder and everything in it. Returns
/// whether anything changed. Files of other owners stay as they are.
bool makePrivate(const std::filesystem::path& file) noexcept;

/// Tells whether a file holds an SQLite database, even one too damaged to open: by its header or, where that
/// is destroyed, by a whole b-tree page among a sample of its pages (4096 bytes each, as Torsio writes them).
/// False for a file that is missing or cannot be read.
[[nodiscard]] bool looksLikeDatabase(const std::filesystem::path& file);

}  // namespace torsio
