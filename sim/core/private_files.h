// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace torsio {

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

}  // namespace torsio
