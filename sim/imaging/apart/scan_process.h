// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "sim/geometry/apart/helper_process.h"
#include "sim/imaging/surface/scan_preview.h"
#include "sim/imaging/surface/scan_surface.h"
#include "sim/imaging/surface/tool_surface.h"

namespace torsio {

/// What reading a scan may cost.
inline constexpr HelperLimits kScanLimits{4'000, 600, 1'800};

/// A scan's surface and what it cost.
struct ScanApart {
  ScanSurface surface;
  double processor_s = 0.0;  ///< of the process that read it
  double peak_MB = 0.0;      ///< its memory at most
};

/// Does what surfaceOfScan() does in a process of its own (`torsio-scan`, beside the running program, or the
/// one that TORSIO_SCAN_PROGRAM names): a scan that takes the reader down, hangs it or asks for all memory
/// ends that process only. `progress` is called from this thread, also while nothing changes;
/// when it throws, the process is ended. Throws as surfaceOfScan(); D04 where the process ended without an
/// answer. On Windows it is done in this process, and the costs are 0.
[[nodiscard]] ScanApart scanApart(const ScanRequest& request, const ScanProgress& progress = {},
                                  const HelperLimits& limits = kScanLimits);

/// As toolOfScan(), in such a process.
[[nodiscard]] ToolSurface toolApart(const ToolRequest& request, const ScanProgress& progress = {},
                                    const HelperLimits& limits = kScanLimits);

/// As previewOfScan(), in such a process.
[[nodiscard]] ScanPreview previewApart(const ScanRequest& request, bool find,
                                       const ScanProgress& progress = {},
                                       const HelperLimits& limits = kScanLimits);

}  // namespace torsio
