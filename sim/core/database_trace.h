// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace torsio {

/// Tells whether a file holds an SQLite database, even one too damaged to open: by its header or, where that
/// is destroyed, by a whole b-tree page among a sample of its pages (4096 bytes each, as Torsio writes them).
/// False for a file that is missing or cannot be read.
[[nodiscard]] bool looksLikeDatabase(const std::filesystem::path& file);

}  // namespace torsio
