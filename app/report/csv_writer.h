// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace torsio {

/// Comma-separated, UTF-8, one header row, fields quoted when needed, lines end in CRLF (RFC 4180), decimal
/// point whatever the locale. Each row must be as long as `columns`. Throws Error{kFileUnwritable}.
void writeCsv(const std::filesystem::path& file, const std::vector<std::string>& columns,
              const std::vector<std::vector<std::string>>& rows);

}  // namespace torsio
