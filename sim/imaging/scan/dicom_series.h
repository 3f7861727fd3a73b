// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "sim/imaging/scan/scan_volume.h"

namespace torsio {

/// What is to be read of a folder of DICOM files.
struct DicomRequest {
  std::filesystem::path folder;  ///< searched with its folders; links are not followed
  int series = 0;         ///< number in the list of its CT series, from 1; 0: the one with the most slices
  bool resample = false;  ///< take slices at uneven distances, in between by straight lines
};

/// Reads a CT series: plain, deflated, RLE, lossless JPEG and JPEG-LS. Hounsfield units slice by slice,
/// -1024 to 3071. Where the slices lie and how far apart is taken from their positions alone; a tilted gantry
/// makes voxels that lean. Nothing that names the patient is kept or said: a file whose name holds a part of
/// the patient's name is called by its number. Throws Error{kFileUnreadable} with the code of the rule (D01
/// to D12, D15).
[[nodiscard]] ScanRead readDicomSeries(const DicomRequest& request);

}  // namespace torsio
