// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsio {

/// One generated file: its path below assets/ and its bytes, the same on every platform.
struct ShippedFile {
  std::string path;
  std::string bytes;
};

/// All that torsio_make_organs writes. Some seconds.
[[nodiscard]] std::vector<ShippedFile> shippedFiles();

/// Draws the organs anew in about a hundred thousand triangles each; they are not shipped.
[[nodiscard]] std::vector<ShippedFile> fineOrgans();

}  // namespace torsio
