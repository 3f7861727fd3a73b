// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace torsio {

/// From now on every file that this process makes is for its owner alone (mode 0600), every folder too
/// (0700): records, backups, packages, exports, pictures; and leaveNoDump(). On Windows the user's folders
/// are private already. Call once, before any thread.
void keepFilesPrivate() noexcept;

/// A crash of this process leaves no core dump, which would hold names, passwords or a scan, and no other
/// program of the same account reads its memory.
void leaveNoDump() noexcept;

/// Takes the rights of group and others away from `file`, or from a folder and all that lies in it. Returns
/// whether anything had to be taken away. A file of somebody else stays as it is.
bool makePrivate(const std::filesystem::path& file) noexcept;

}  // namespace torsio
