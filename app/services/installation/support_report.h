// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>

#include "app/services/installation/installation_check.h"

namespace torsio {

inline constexpr std::size_t kSupportLogLines = 500;

/// Writes what somebody who helps needs to know of an installation, as one file of JSON that its sender can
/// read before: versions, the configuration, the findings of checkInstallation() and the newest lines of the
/// log. Nobody is in it: no name, mark or secret; "~" stands for the folder of this account, and addresses of
/// servers are without accounts. Throws Error{kFileUnwritable}, also instead of replacing a record.
void writeSupportReport(const std::filesystem::path& file, const Installation& installation);

}  // namespace torsio
