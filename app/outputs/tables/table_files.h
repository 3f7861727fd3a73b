// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/outputs/tables/export_table.h"
#include "app/services/base/progress.h"

namespace torsio {

enum class TableFormat {
  kCsv,   ///< UTF-8 with byte order mark, numbers with all their digits, times in ISO 8601
  kR,     ///< the same, and a script that reads them with their types
  kSpss,  ///< .sav with labels of variables, measures and a label for each table
};

/// "csv", "r", "spss". Throws Error{kUsage} for another word.
[[nodiscard]] TableFormat tableFormat(const std::string& word);

/// Returns a table as comma-separated values in UTF-8 under a line of names, without byte order mark.
[[nodiscard]] std::string tableText(const ExportTable& table);

/// Writes each table as a file of its name into `folder`, which is made where it is missing, and
/// codebook.csv: table, column, what it means, unit, type, where it comes from. Returns the files. A file
/// that was there is replaced as a whole or kept. Throws Error{kFileUnwritable}, {kBadData} for a table that
/// the format cannot hold. What `progress` throws gives it up: files that were not there before are taken
/// away again.
std::vector<std::filesystem::path> writeTables(const std::vector<const ExportTable*>& tables,
                                               TableFormat format, const std::filesystem::path& folder,
                                               const ProgressCallback& progress = {});

/// Writes a table as an SPSS data file. As above.
void writeSpssFile(const ExportTable& table, const std::filesystem::path& file);

}  // namespace torsio
