// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a mesh file: the check before the importer must refuse or accept them. The first byte selects
// the file name.
#include <array>

#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_file_check.h"
#include "tests/fuzz/fuzz_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::array<std::string_view, 7> kEndings{"ply", "off", "stl", "glb", "gltf", "dae", "obj"};
  if (size == 0) {
    return 0;
  }
  const std::string_view ending = kEndings[data[0] % kEndings.size()];
  const std::string_view bytes = torsio::fuzz::textOf(data + 1, size - 1);
  try {
    if (ending == "ply") {
      torsio::requirePlausiblePly(bytes, "fuzz");
    } else if (ending == "off") {
      torsio::requirePlausibleOff(bytes, "fuzz");
    } else {
      torsio::requirePlausibleHead(bytes, bytes.size(), ending, "fuzz");
    }
  } catch (const torsio::Error&) {
  }
  return 0;
}
