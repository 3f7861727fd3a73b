// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace torsio {

struct Arm;

/// One generated file: its path below assets/ and its bytes, the same on every platform.
struct ShippedFile {
  std::string path;
  std::string bytes;
};

/// All that torsio_make_organs writes. Some seconds.
[[nodiscard]] std::vector<ShippedFile> shippedFiles();

/// Describes an arm as assets/organs/forearm_markers.json does: ends, zero line, ten markers, each with the
/// way along the axis and the angle about it. `file`: the name of its organ.
[[nodiscard]] std::string armMarkersJson(const Arm& arm, const std::string& file);

/// Draws the organs anew in about a hundred thousand triangles each; they are not shipped.
[[nodiscard]] std::vector<ShippedFile> fineOrgans();

}  // namespace torsio
