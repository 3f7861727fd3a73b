// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "sim/imaging/surface/scan_surface.h"
#include "sim/scene/organ_import.h"

namespace torsio {

/// What became of a scan that was to become an organ.
struct OrganReconstruction {
  OrganImport import;        ///< as of a mesh, with what was found about the scan
  ScanSurface scan;          ///< as it was drawn, before it was checked
  std::int64_t euler = 0;    ///< Euler number of the surface that was drawn; 2: one piece without handles
  double processor_s = 0.0;  ///< of reading, drawing and judging
  double peak_MB = 0.0;      ///< most memory of the process that read the scan
};

/// Reads a scan in a process of its own, draws the organ in it, and checks and judges it as importOrgan()
/// does a mesh. Of `request` the anatomy, the ends and the wall are used. The organ says nothing of the
/// patient: its source is the kind of scan. A scan that is refused is no error: the findings say why. Throws
/// Error{kFileMissing} for a scan that is not there, {kBadParameter} for a request out of range.
[[nodiscard]] OrganReconstruction reconstructOrgan(OrganImportRequest request, const ScanRequest& scan,
                                                   const ScanProgress& progress = {});

/// Checks and judges anew, with what is known of the organ now, a surface that was drawn. Throws as
/// reconstructOrgan().
[[nodiscard]] OrganImport judgedSurface(OrganImportRequest request, const ScanRequest& scan,
                                        const ScanSurface& surface);

}  // namespace torsio
