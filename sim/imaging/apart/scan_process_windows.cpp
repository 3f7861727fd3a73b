// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/imaging/apart/scan_process.h"

namespace torsio {

ScanApart scanApart(const ScanRequest& request, const ScanProgress& progress, const HelperLimits&) {
  return {surfaceOfScan(request, progress), 0.0, 0.0};
}

}  // namespace torsio
