// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace torsio {

/// Whether the bytes of a file tell of an SQLite database in it, also of one that nobody can open any more:
/// its first words, or, where these were destroyed, a whole page of rows or of an index among a sample of its
/// pages (4096 bytes each, as Torsio writes them). False for a file that is missing, none or cannot be read.
[[nodiscard]] bool tellsOfDatabase(const std::filesystem::path& file);

}  // namespace torsio
