// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/apart/scan_process.h"

namespace torsio {

ScanApart scanApart(const ScanRequest& request, const ScanProgress& progress, const HelperLimits&) {
  return {surfaceOfScan(request, progress), 0.0, 0.0};
}

ToolSurface toolApart(const ToolRequest& request, const ScanProgress& progress, const HelperLimits&) {
  return toolOfScan(request, progress);
}

ScanPreview previewApart(const ScanRequest& request, bool find, const ScanProgress& progress,
                         const HelperLimits&) {
  requireScanRequest(request);
  return previewOfScan(request, find, progress);
}

}  // namespace torsio
