// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/geometry/apart/mesh_process.h"
#include "sim/geometry/mesh/mesh_repair.h"
#include "sim/imaging/surface/scan_surface.h"
#include "sim/scene/organ_file.h"
#include "sim/scene/organ_fit.h"
#include "sim/scene/organ_judgement.h"

namespace torsio {

/// What is known of a mesh that is to become an organ.
struct OrganImportRequest {
  std::filesystem::path assets;  ///< the assets folder, for the names of anatomies
  std::filesystem::path file;
  double scale_m = 0.001;        ///< one file unit in metres
  OrganEnds ends;                ///< in metres
  std::string anatomy;           ///< id of a scene; empty: not known
  std::optional<double> wall_m;  ///< 0.1 to 50 mm
  bool closeHoles = false;       ///< close gaps and the ends of an open tube; told, and warned of when large
  MeshReadLimits reading;
  bool ofScan = false;    ///< the surface was drawn from a scan
  bool pictures = false;  ///< keep surfaces to be drawn, and the shapes of one in every pattern
};

/// What became of it.
struct OrganImport {
  bool accepted = false;
  OrganFile organ;                     ///< complete when accepted
  std::vector<OrganFinding> findings;  ///< refusals first, then warnings, then notes
  MeshRepairs repairs;
  OrganMeasures measures;
  std::vector<PatternJudgement> patterns;     ///< of its anatomy; none: it was not twisted
  std::shared_ptr<const TriangleMesh> shown;  ///< of at most kJudgedTriangles; null: no pictures
  std::shared_ptr<const TriangleMesh> drawn;  ///< coarse, whose shapes the patterns have; null: no pictures
  std::optional<double> volume_ml;            ///< none: the surface encloses nothing
};

/// Reads a mesh file in a process of its own, welds, checks, repairs and judges it. A mesh that is refused is
/// no error: the findings say why. Throws Error{kFileMissing} for a file that is not there,
/// {kBadParameter} for a request out of range or an anatomy that no scene has.
[[nodiscard]] OrganImport importOrgan(const OrganImportRequest& request);

/// Welds, checks, repairs and judges, as importOrgan(request), the surface that `read` returns or refuses;
/// `request.file` names it in what is said. Throws what `read` throws but for refusals of the file or mesh.
[[nodiscard]] OrganImport importOrgan(const OrganImportRequest& request,
                                      const std::function<RawMesh()>& read);

/// Adds what else was found, in its place among the findings; the organ keeps the warnings.
void addFindings(OrganImport& import, std::vector<OrganFinding> found);

/// Returns the warnings among findings, as a scene and a recording keep them.
[[nodiscard]] std::vector<OrganWarning> warningsAmong(const std::vector<OrganFinding>& findings);

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
/// patient: its source is the kind of scan. A refused scan is not an error: the findings say why. Throws
/// Error{kFileMissing} for a scan that is not there, {kBadParameter} for a request out of range.
[[nodiscard]] OrganReconstruction reconstructOrgan(OrganImportRequest request, const ScanRequest& scan,
                                                   const ScanProgress& progress = {});

/// Checks and judges anew, with what is known of the organ now, a surface that was drawn. Throws as
/// reconstructOrgan().
[[nodiscard]] OrganImport judgedSurface(OrganImportRequest request, const ScanRequest& scan,
                                        const ScanSurface& surface);

}  // namespace torsio
