// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as an organ file with a correct digest: the result must be an Error or a closed surface.
#include <cstdlib>
#include <string>

#include "sim/core/digest.h"
#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/scene/organ_file.h"
#include "tests/fuzz/fuzz_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const torsio::fuzz::FuzzFile kFile(".organ");
  std::string bytes(torsio::fuzz::textOf(data, size));
  torsio::Digest digest;
  digest.update(bytes);
  bytes += digest.hex();
  try {
    const torsio::OrganFile organ = torsio::readOrganFile(kFile.holding(bytes));
    if (!torsio::checkMesh(organ.mesh).closed()) {
      std::abort();
    }
  } catch (const torsio::Error&) {
  }
  return 0;
}
