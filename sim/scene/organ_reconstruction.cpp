// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/organ_reconstruction.h"

#include <algorithm>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include "sim/core/short_number.h"
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

/// Where the wall is how thick, on the lattice of an organ that was not refused.
void addWallMap(const ScanSurface& surface, OrganImport& import, std::vector<OrganFinding>& found) {
  if (!import.accepted || surface.wallRays.empty()) {
    return;
  }
  const SectionLattice lattice(import.organ.mesh, latticeFor(import.organ.ends));
  import.organ.wallMap = wallMapOf(surface.wallRays, import.organ.mesh, lattice);
  if (!import.organ.wallMap) {
    return;
  }
  const OrganWallMap& map = *import.organ.wallMap;
  const auto [least, most] = std::minmax_element(map.thickness_m.begin(), map.thickness_m.end());
  const std::size_t seen = map.seenPatches();
  const bool whole = 2 * seen >= map.seen.size();
  found.push_back({"D18", whole ? FindingWeight::kNote : FindingWeight::kWarning,
                   Text::tr("the map of the wall goes from %1 to %2 mm; %3 of its %4 places are seen in the "
                            "scan, the others are filled in from those around them",
                            shortNumber(1000.0 * *least), shortNumber(1000.0 * *most), std::to_string(seen),
                            std::to_string(map.seen.size())),
                   Text::tr("the scan"), static_cast<double>(seen) / static_cast<double>(map.seen.size()),
                   whole ? Text{} : Text::tr("Give the thickness of the wall where you know it better")});
}

/// What only the scan knows of the organ.
void addScan(const ScanSurface& surface, OrganImport& import) {
  std::vector<OrganFinding> found;
  addWallMap(surface, import, found);
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
