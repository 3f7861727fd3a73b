// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a NIfTI file: the result must be an Error or a volume of the stated size. The first byte
// selects the name of a compressed file, whose content may be uncompressed all the same.
#include <cstdlib>

#include "sim/core/error.h"
#include "sim/imaging/scan/nifti_file.h"
#include "tests/fuzz/fuzz_file.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const torsio::fuzz::FuzzFile kPlain(".nii");
  static const torsio::fuzz::FuzzFile kPacked(".nii.gz");
  if (size == 0) {
    return 0;
  }
  const auto& file = data[0] % 2 == 0 ? kPlain : kPacked;
  try {
    const torsio::ScanRead scan = torsio::readNifti(file.holding(torsio::fuzz::textOf(data + 1, size - 1)));
    const auto& count = scan.volume.count;
    if (scan.volume.values.size() != count[0] * count[1] * count[2] || scan.volume.voxel_mm3() == 0.0) {
      std::abort();
    }
  } catch (const torsio::Error&) {
  }
  return 0;
}
