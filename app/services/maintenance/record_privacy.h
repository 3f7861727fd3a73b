// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/core/text.h"

namespace torsio {

/// "Other accounts of this computer could read FILE; now only yours can"
[[nodiscard]] Text othersCouldRead(const std::filesystem::path& file);

/// Takes the rights of other accounts away from the record at `locator`, from the copies that lie beside it
/// under its name (backups before a restore, copies before a new schema), from Torsio's own folder of data
/// when the record lies there (a folder that somebody chose keeps its mode), and from `folder` with all in
/// it; empty: none. Returns one sentence a file that could be read by others until now. A record on a server
/// has no files.
[[nodiscard]] std::vector<Text> closeRecordFiles(const std::string& locator,
                                                 const std::filesystem::path& folder);

}  // namespace torsio
