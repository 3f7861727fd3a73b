// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "sim/base/text.h"

namespace torsio {

/// Takes the rights of other accounts away from the record at `locator`, from the copies that lie beside it
/// under its name (backups before a restore, copies before a new schema) and from `folder` with all in it.
/// Returns one sentence a file that could be read by others until now. A record on a server has no files.
[[nodiscard]] std::vector<Text> closeRecordFiles(const std::string& locator,
                                                 const std::filesystem::path& folder);

}  // namespace torsio
