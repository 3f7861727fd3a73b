// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace torsio {

/// Returns the folder with organs, scenes and instruments: $TORSIO_ASSETS if set, else that of the
/// installation (../share/torsio/assets), else that of the source tree. Throws Error{kFileMissing} if none
/// exists.
[[nodiscard]] std::filesystem::path assetsFolder();

}  // namespace torsio
