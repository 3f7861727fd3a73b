// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/outputs/tables/export_table.h"
#include "app/services/base/progress.h"

namespace torsio {

enum class TableFormat {
  kCsv,   ///< UTF-8 with byte order mark, numbers in full precision, times in ISO 8601
  kR,     ///< the same plus a script that reads them with their types
  kSpss,  ///< .sav with labels of variables, measures and tables
};

/// Parses "csv", "r" or "spss". Throws Error{kUsage} for another word.
[[nodiscard]] TableFormat tableFormat(const std::string& word);

/// Returns a table as comma-separated values in UTF-8 with a header, without byte order mark.
[[nodiscard]] std::string tableText(const ExportTable& table);

/// Writes each table as a file of its name into `folder`, which is created if missing, and codebook.csv:
/// table, column, meaning, unit, type, source. Returns the files. Existing files are replaced completely or
/// kept. Throws Error{kFileUnwritable}, {kBadData} for a table that the format cannot hold. If `progress`
/// throws to cancel, new files are removed.
std::vector<std::filesystem::path> writeTables(const std::vector<const ExportTable*>& tables,
                                               TableFormat format, const std::filesystem::path& folder,
                                               const ProgressCallback& progress = {});

/// Writes a table as an SPSS data file. Throws like writeTables().
void writeSpssFile(const ExportTable& table, const std::filesystem::path& file);

}  // namespace torsio
