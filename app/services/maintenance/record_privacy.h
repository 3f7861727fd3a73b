// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

/// Returns "Other accounts of this computer could read FILE; now only yours can".
[[nodiscard]] Text othersCouldRead(const std::filesystem::path& file);

/// Removes other accounts' access to the record at `locator`, to the copies of its name next to it (backups
/// before a restore, copies before a migration), to Torsio's own data folder if the record is there (a folder
/// chosen by the user keeps its mode), and to `folder` with its contents unless it is empty. Returns one
/// sentence per file that others could read before. A record on a server has no files.
[[nodiscard]] std::vector<Text> closeRecordFiles(const std::string& locator,
                                                 const std::filesystem::path& folder);

}  // namespace torsio
