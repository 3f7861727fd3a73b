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

OrganImportRequest requestFor(OrganImportRequest request, const ScanRequest& scan) {
  request.file = scan.source;
  request.scale_m = kScanUnit_m;
  request.closeHoles = false;
  return request;
}

/// What only the scan knows of the organ.
void addScan(const ScanSurface& surface, OrganImport& import) {
  std::vector<OrganFinding> found;
  for (const ScanRemark& remark : surface.remarks) {
    found.push_back(findingOfScan(remark));
  }
  addFindings(import, std::move(found));
  import.organ.source = surface.kind;
  if (surface.ownWall_mm) {
    import.organ.wall_m = kScanUnit_m * *surface.ownWall_mm;
  }
}

}  // namespace

OrganReconstruction reconstructOrgan(OrganImportRequest request, const ScanRequest& scan,
                                     const ScanProgress& progress) {
  OrganReconstruction result;
  const std::clock_t begun = std::clock();
  result.import = importOrgan(requestFor(std::move(request), scan), [&result, &scan, &progress] {
    ScanApart apart = scanApart(scan, progress);
    result.scan = std::move(apart.surface);
    result.processor_s = apart.processor_s;
    result.peak_MB = apart.peak_MB;
    result.euler = checkMesh(result.scan.mesh).euler;
    return RawMesh{result.scan.mesh, {}};
  });
  result.processor_s += static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC;
  addScan(result.scan, result.import);
  return result;
}

OrganImport judgedSurface(OrganImportRequest request, const ScanRequest& scan, const ScanSurface& surface) {
  OrganImport import = importOrgan(requestFor(std::move(request), scan), [&surface] {
    return RawMesh{surface.mesh, {}};
  });
  addScan(surface, import);
  return import;
}

}  // namespace torsio
