// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/core/vec3.h"
#include "sim/imaging/scan/dicom_slice.h"
#include "sim/imaging/scan/scan_volume.h"

namespace torsio {

// For the .cpp files of this folder only.

/// Slices in their order along the patient, and the grid that they make.
struct DicomStack {
  std::vector<DicomSlice> slices;   ///< one a place
  std::vector<DicomSlice> twins;    ///< at the place of another one; their pixels have to be the same
  std::vector<std::size_t> twinOf;  ///< whose
  std::vector<double> at;           ///< place of each slice, in layers of the grid from the first
  std::size_t layers = 0;           ///< of the grid; as many as slices where they lie evenly
  Vec3 origin_mm;
  std::array<Vec3, 3> step_mm{};
};

/// Orders slices of one size, spacing and orientation by their positions. Throws Error{kFileUnreadable}: D07
/// (shifted against each other), D09 (uneven distances, unless `resample`), D10 (tilted by more than 35
/// degrees), D11 (fewer than 10). What else there is to say is added to `remarks`.
[[nodiscard]] DicomStack stacked(std::vector<DicomSlice> slices, bool resample, const std::string& where,
                                 std::vector<ScanRemark>& remarks);

}  // namespace torsio
