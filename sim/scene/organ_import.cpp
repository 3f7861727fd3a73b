// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/scene/organ_import.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <ctime>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/short_number.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_holes.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/mesh/mesh_space.h"
#include "sim/geometry/mesh/mesh_thinning.h"
#include "sim/imaging/apart/scan_process.h"
#include "sim/scene/scene.h"
#include "sim/scene/scene_file.h"

namespace torsio {

namespace {

constexpr double kThinnestWall_m = 1e-4;
constexpr double kThickestWall_m = 0.05;
constexpr std::size_t kDrawnTriangles = 12'000;  // of a picture the size of a thumb

/// Volumes of organs of living people, generously; docs/organs.md names the sources.
struct UsualVolume {
  std::string_view anatomy;
  double least_ml;
  double most_ml;
};
constexpr std::array<UsualVolume, 7> kDefaultVolumes{{{"forearm", 500.0, 8000.0},
                                                      {"stomach", 100.0, 3000.0},
                                                      {"gastric-organo-axial", 100.0, 3000.0},
                                                      {"gastric-mesentero-axial", 100.0, 3000.0},
                                                      {"testis", 3.0, 100.0},
                                                      {"sigmoid", 50.0, 8000.0},
                                                      {"midgut", 20.0, 5000.0}}};

void checkImportRequest(const OrganImportRequest& request) {
  requireUnit(request.scale_m, request.file.string());
  if (request.ends.fixedEnd_m.has_value() != request.ends.freeEnd_m.has_value()) {
    throw Error(ErrorCode::kUsage, Text::tr("one end of the organ is given without the other"), "",
                Text::tr("Give both ends."));
  }
  if (request.wall_m && !(*request.wall_m >= kThinnestWall_m && *request.wall_m <= kThickestWall_m)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("the wall must be 0.1 to 50 mm thick"),
                request.file.string(), Text::tr("Give its thickness in millimetres"));
  }
  const std::vector<std::string> scenes = sceneIds(request.assets);
  if (!request.anatomy.empty() && std::find(scenes.begin(), scenes.end(), request.anatomy) == scenes.end()) {
    throw Error(ErrorCode::kBadParameter, Text::tr("no scene is called '%1'", request.anatomy), "",
                Text::tr("Choose one of %1.", listed(scenes)));
  }
}

OrganFinding note(const char* code, Text what) {
  return {code, FindingWeight::kNote, std::move(what), "", std::nullopt, ""};
}

void addRepairs(const MeshRepairs& done, std::vector<OrganFinding>& findings) {
  const auto add = [&findings](const char* code, std::size_t count, Text what) {
    if (count > 0) {
      OrganFinding finding = note(code, std::move(what));
      finding.value = static_cast<double>(count);
      findings.push_back(std::move(finding));
    }
  };
  add("M10", done.degenerateFaces + done.duplicateFaces,
      Text::tr("%1 doubled or flat {face|faces} removed",
               std::to_string(done.degenerateFaces + done.duplicateFaces)));
  add("M13", done.turnedFaces,
      Text::tr("%1 {face|faces} turned that faced the wrong way", std::to_string(done.turnedFaces)));
  add("M13", done.insideOut ? 1 : 0, Text::tr("the surface was inside out and was turned"));
  add("M14", done.droppedComponents,
      Text::tr("%1 small separate {piece|pieces} left out", std::to_string(done.droppedComponents)));
  add("M15", done.droppedShells,
      Text::tr("%1 inner {shell|shells} left out", std::to_string(done.droppedShells)));
  // An inner wall matters to the organ's numbers: report that it is gone.
  for (OrganFinding& finding : findings) {
    if (finding.code == "M15") {
      finding.weight = FindingWeight::kWarning;
      finding.remedy = Text::tr("Give the thickness of the wall instead");
    }
  }
}

void addIgnored(const MeshExtras& ignored, std::vector<OrganFinding>& findings) {
  const std::size_t all = ignored.textures + ignored.bones + ignored.animations;
  if (all == 0) {
    return;
  }
  OrganFinding finding =
      note("M21", Text::tr("left out: %1 {texture|textures}, %2 {bone|bones}, %3 {animation|animations}",
                           std::to_string(ignored.textures), std::to_string(ignored.bones),
                           std::to_string(ignored.animations)));
  finding.value = static_cast<double>(all);
  findings.push_back(std::move(finding));
}

/// Closes holes where asked for: reports small ones, warns of large ones. A face along a rim that
/// disagrees with its neighbours would hide the hole: faces are turned first. Returns what else was mended.
MeshRepairs mendHoles(const OrganImportRequest& request, TriangleMesh& mesh,
                      std::vector<OrganFinding>& findings) {
  constexpr double kSmallHole = 0.05;  // of the largest side
  MeshRepairs done;
  if (!request.closeHoles) {
    return done;
  }
  requireSound(mesh, request.file.string());
  const double side_m = checkMesh(mesh).largestSide_m();
  weldVertices(mesh, 1e-6 * side_m, done);  // as checkedMesh does
  removeDegenerateFaces(mesh, done);
  static_cast<void>(orientFaces(mesh, done));  // one-sided: checkedMesh refuses it
  const ClosedHoles closed = closeHoles(mesh);
  if (closed.count == 0) {
    return done;
  }
  OrganFinding finding =
      note("M11", Text::tr("%1 {hole|holes} closed, the largest %2 mm across", std::to_string(closed.count),
                           shortNumber(1000.0 * closed.widest_m)));
  finding.value = static_cast<double>(closed.count);
  if (closed.widest_m > kSmallHole * side_m) {
    finding.weight = FindingWeight::kWarning;
    finding.remedy = Text::tr("Check whether the organ ends there, or close it in a mesh editor");
  }
  findings.push_back(std::move(finding));
  return done;
}

/// A volume that no such organ has: most often a wrong unit.
void addVolume(const OrganImportRequest& request, double volume_ml, std::vector<OrganFinding>& findings) {
  for (const UsualVolume& usual : kDefaultVolumes) {
    if (usual.anatomy != request.anatomy || (volume_ml >= usual.least_ml && volume_ml <= usual.most_ml)) {
      continue;
    }
    findings.push_back(
        {"M09", FindingWeight::kRefusal,
         Text::tr("the organ holds %1 ml; such an organ holds %2 to %3 ml", shortNumber(volume_ml),
                  shortNumber(usual.least_ml), shortNumber(usual.most_ml)),
         request.file.filename().string(), volume_ml,
         Text::tr("Check the unit of the file, and which organ it is")});
  }
}

void sortFindings(std::vector<OrganFinding>& findings) {
  std::stable_sort(findings.begin(), findings.end(), [](const OrganFinding& a, const OrganFinding& b) {
    return static_cast<int>(a.weight) > static_cast<int>(b.weight);
  });
}

std::string plainNumber(double x) {
  constexpr int kDigits = 7;
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), x == 0.0 ? 0.0 : x,
                                 std::chars_format::general, kDigits);
  return {text.data(), end.ptr};
}

/// " --fixed-end 1 2 3", in a unit.
std::string option(const std::string& name, const Vec3& v, double unit) {
  return " --" + name + ' ' + plainNumber(v.x / unit) + ' ' + plainNumber(v.y / unit) + ' ' +
         plainNumber(v.z / unit);
}

/// The command that asks for these ends; of a scan only its options.
std::string commandFor(const OrganImportRequest& request, const OrganEnds& ends) {
  constexpr double kMillimetre = 1e-3;
  const MeshSpace space = meshSpaceOf(request.file);  // the options are in the file's own axes
  std::string words;
  if (!request.ofScan) {
    words = "torsio organ import '" + request.file.string() + "'";
    words += request.scale_m == kMillimetre ? "" : " --scale " + plainNumber(request.scale_m / kMillimetre);
    words += request.anatomy.empty() ? "" : " --anatomy " + request.anatomy;
    words += request.closeHoles ? " --close-holes" : "";
  }
  return words + option("fixed-end", space.toLps(*ends.fixedEnd_m), request.scale_m) +
         option("free-end", space.toLps(*ends.freeEnd_m), request.scale_m) +
         option("fixed-cut", space.toLps(ends.fixedCut), 1.0) +
         option("free-cut", space.toLps(ends.freeCut), 1.0);
}

/// Says that the organ was cut across its ends, and how to ask for that.
OrganFinding cutNote(const OrganImportRequest& request, const OrganEnds& ends) {
  OrganFinding finding =
      note("M28", Text::tr("cut across both ends: as they are no pattern leaves the organ whole; what lies "
                           "beyond a cut moves as a whole"));
  finding.where = Text::tr("the whole organ");
  finding.remedy = Text::tr("The same by hand, to change it: %1", commandFor(request, ends));
  return finding;
}

void judgeMesh(const OrganImportRequest& request, RawMesh raw, OrganImport& import) {
  MeshImportOptions options;
  options.scale_m = request.scale_m;
  options.unitStated = meshSpaceOf(request.file).unit_m.has_value();
  const MeshRepairs before = mendHoles(request, raw.mesh, import.findings);
  import.organ.mesh = checkedMesh(std::move(raw.mesh), request.file.string(), options, &import.repairs);
  import.repairs.add(before);
  import.volume_ml = 1e6 * signedVolume_m3(import.organ.mesh);
  addRepairs(import.repairs, import.findings);
  addIgnored(raw.ignored, import.findings);
  addVolume(request, *import.volume_ml, import.findings);
  CoarserSurfaces coarser;
  if (request.pictures) {
    const auto ofAtMost = [](const TriangleMesh& mesh, std::size_t most) {
      return std::make_shared<const TriangleMesh>(thinned(mesh, most));
    };
    import.shown = ofAtMost(import.organ.mesh, kJudgedTriangles);
    import.drawn = ofAtMost(*import.shown, kDrawnTriangles);
    coarser = {import.shown.get(), import.drawn.get()};
  }
  FittedOrgan fitted = fitOrgan(import.organ, request.assets, coarser);
  import.organ.ends = fitted.ends;
  import.measures = fitted.judgement.measures;
  import.patterns = std::move(fitted.patterns);
  for (OrganFinding& finding : fitted.judgement.findings) {
    import.findings.push_back(std::move(finding));
  }
  if (fitted.otherEnds) {
    import.findings.push_back(cutNote(request, fitted.ends));
  }
}

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
  request.ofScan = true;
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
void addScan(const ScanSurface& surface, const std::filesystem::path& assets, OrganImport& import) {
  std::vector<OrganFinding> found;
  addWallMap(surface, import, found);
  if (import.organ.wallMap) {  // it is the wall that is wrung
    import.patterns = judgePatterns(assets, import.organ, kAllPatterns, import.drawn.get());
    replaceBroken(import.patterns, import.findings);
  }
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

std::vector<OrganWarning> warningsAmong(const std::vector<OrganFinding>& findings) {
  std::vector<OrganWarning> warnings;
  for (const OrganFinding& finding : findings) {
    if (finding.weight == FindingWeight::kWarning) {
      warnings.push_back({finding.code, finding.what});
    }
  }
  return warnings;
}

void addFindings(OrganImport& import, std::vector<OrganFinding> found) {
  for (OrganFinding& finding : found) {
    import.findings.push_back(std::move(finding));
  }
  sortFindings(import.findings);
  import.accepted = import.findings.empty() || import.findings.front().weight != FindingWeight::kRefusal;
  import.organ.warnings = warningsAmong(import.findings);
  for (PatternJudgement& one : import.patterns) {
    one.accepted = one.accepted && import.accepted;
  }
  import.organ.patterns = acceptedAmong(import.patterns);
}

OrganImport importOrgan(const OrganImportRequest& request) {
  return importOrgan(request,
                     [&request] { return readMeshApart(request.file, request.scale_m, request.reading); });
}

OrganImport importOrgan(const OrganImportRequest& request, const std::function<RawMesh()>& read) {
  checkImportRequest(request);
  OrganImport import;
  import.organ.ends = request.ends;
  import.organ.anatomy = request.anatomy;
  import.organ.wall_m = request.wall_m;
  import.organ.source = request.file.filename().string();
  try {
    judgeMesh(request, read(), import);
  } catch (const Error& refusal) {
    const bool aboutTheMesh =
        refusal.code() == ErrorCode::kBadMesh || refusal.code() == ErrorCode::kFileUnreadable;
    if (!aboutTheMesh) {
      throw;
    }
    OrganFinding finding = findingOf(refusal);
    if (finding.code == "M11" && !request.closeHoles) {
      finding.remedy =
          Text::tr("Take --close-holes (in the window: Close holes and open ends), or a mesh editor");
    }
    import.findings.push_back(std::move(finding));
  }
  addFindings(import, {});
  return import;
}

OrganReconstruction reconstructOrgan(OrganImportRequest request, const ScanRequest& scan,
                                     const ScanProgress& progress) {
  OrganReconstruction result;
  const std::filesystem::path assets = request.assets;
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
  addScan(result.scan, assets, result.import);
  return result;
}

OrganImport judgedSurface(OrganImportRequest request, const ScanRequest& scan, const ScanSurface& surface) {
  const std::filesystem::path assets = request.assets;
  OrganImport import = importOrgan(requestFor(std::move(request), scan), [&surface] {
    return RawMesh{surface.mesh, {}};
  });
  addScan(surface, assets, import);
  return import;
}

}  // namespace torsio
