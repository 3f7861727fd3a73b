// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/organ_reconstruction.h"

#include <ctime>
#include <utility>
#include <vector>

#include "sim/geometry/mesh/mesh_check.h"
#include "sim/imaging/apart/scan_process.h"

namespace torsio {

namespace {

constexpr double kScanUnit_m = 1e-3;  // seeds, boxes and ends are in millimetres

OrganFinding findingOfScan(const ScanRemark& remark) {
  return {remark.code,  remark.warning ? FindingWeight::kWarning : FindingWeight::kNote,
          remark.what,  Text::tr("the scan"),
          remark.value, remark.remedy};
}

}  // namespace

OrganReconstruction reconstructOrgan(OrganImportRequest request, const ScanRequest& scan,
                                     const ScanProgress& progress) {
  OrganReconstruction result;
  request.file = scan.source;
  request.scale_m = kScanUnit_m;
  const std::clock_t begun = std::clock();
  result.import = importOrgan(request, [&result, &scan, &progress] {
    ScanApart apart = scanApart(scan, progress);
    result.scan = std::move(apart.surface);
    result.processor_s = apart.processor_s;
    result.peak_MB = apart.peak_MB;
    result.euler = checkMesh(result.scan.mesh).euler;
    return RawMesh{std::move(result.scan.mesh), {}};
  });
  result.processor_s += static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  std::vector<OrganFinding> found;
  for (const ScanRemark& remark : result.scan.remarks) {
    found.push_back(findingOfScan(remark));
  }
  addFindings(result.import, std::move(found));
  result.import.organ.source = result.scan.kind;
  if (result.scan.ownWall_mm) {
    result.import.organ.wall_m = kScanUnit_m * *result.scan.ownWall_mm;
  }
  return result;
}

}  // namespace torsio
