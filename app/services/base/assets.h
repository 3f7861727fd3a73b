// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace torsio {

/// The folder with organs, scenes and instruments: $TORSIO_ASSETS when set, else the one beside the
/// installed program (../share/torsio/assets), else that of the source tree it was built from.
/// Throws Error{kFileMissing} when none exists.
[[nodiscard]] std::filesystem::path assetsFolder();

}  // namespace torsio
