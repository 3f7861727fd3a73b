// SPDX-License-Identifier: GPL-3.0-or-later
// From a CT to the map of a wall, and from there into the model of a hollow organ.
#include "sim/scene/organ_wall.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "sim/imaging/surface/scan_surface.h"
#include "sim/scene/hollow_organ.h"
#include "sim/scene/organ_file.h"
#include "sim/scene/organ_import.h"
#include "sim/scene/scene.h"
#include "tests/support/dicom_files.h"
#include "tests/support/scan_files.h"
#include "tests/support/shipped_scene.h"

namespace torsio {
namespace {

constexpr double kVoxel_mm = 1.25;
constexpr double kLumen_mm = 16.0;
constexpr double kHalfLength_mm = 90.0;

/// 2 to 6 mm: along the tube and round it.
double wall_mm(const Vec3& p_mm) {
  const double share = std::clamp((p_mm.z + kHalfLength_mm) / (2.0 * kHalfLength_mm), 0.0, 1.0);
  const double r_mm = std::hypot(p_mm.x, p_mm.y);
  return 2.5 + 3.0 * share + (r_mm > 0.0 ? 0.5 * p_mm.x / r_mm : 0.0);
}

double value_HU(const Vec3& p_mm, bool neighbour) {
  const double r_mm = std::hypot(p_mm.x, p_mm.y);
  if (std::hypot(p_mm.x, p_mm.y, p_mm.z) > 2.0 * kHalfLength_mm) {
    return -1000.0;
  }
  if (std::abs(p_mm.z) < kHalfLength_mm && r_mm < kLumen_mm) {
    return -950.0;
  }
  if (std::abs(p_mm.z) < kHalfLength_mm + 4.0 && r_mm < kLumen_mm + wall_mm(p_mm)) {
    return 40.0;
  }
  // A liver against a quarter of its turn.
  return neighbour && p_mm.y > std::abs(p_mm.x) ? 60.0 : -100.0;
}

/// A tube of gas in a wall, in fat; the value of a voxel is the mean over 27 places in it.
ScanVolume tubeInFat(bool neighbour) {
  const std::array<std::size_t, 3> count{58, 58, 160};
  ScanVolume scan =
      testing::blankScan(count, {kVoxel_mm, kVoxel_mm, kVoxel_mm},
                         {-0.5 * kVoxel_mm * 57, -0.5 * kVoxel_mm * 57, -0.5 * kVoxel_mm * 159});
  for (std::size_t k = 0; k < count[2]; ++k) {
    for (std::size_t j = 0; j < count[1]; ++j) {
      for (std::size_t i = 0; i < count[0]; ++i) {
        double sum = 0.0;
        for (int n = 0; n < 27; ++n) {
          const Vec3 at{static_cast<double>(i) + (n % 3 - 1) / 3.0,
                        static_cast<double>(j) + (n / 3 % 3 - 1) / 3.0,
                        static_cast<double>(k) + (n / 9 - 1) / 3.0};
          sum += value_HU(scan.place_mm(at), neighbour);
        }
        scan.values[scan.index(i, j, k)] = static_cast<std::int16_t>(std::lround(sum / 27.0));
      }
    }
  }
  // Air at the corner, as in any CT.
  for (std::size_t n = 0; n < 58 * 58 * 2; ++n) {
    scan.values[n] = -1000;
  }
  return scan;
}

OrganImport importOfCt(const ScanVolume& scan, ScanTissue tissue, const std::string& anatomy,
                       const std::string& name) {
  ScanRequest request{.source = std::filesystem::path(::testing::TempDir()) / name, .tissue = tissue};
  std::filesystem::remove_all(request.source);
  testing::writeDicomSeries(request.source, scan);
  OrganImportRequest wanted;
  wanted.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  wanted.anatomy = anatomy;
  wanted.ends.fixedEnd_m = Vec3{0, 0, -0.09};
  wanted.ends.freeEnd_m = Vec3{0, 0, 0.09};
  return judgedSurface(wanted, request, surfaceOfScan(request));
}

std::string findingsOf(const OrganImport& import) {
  std::string said;
  for (const OrganFinding& one : import.findings) {
    said += one.code + ' ' + one.what.str() + '\n';
  }
  return said;
}

/// Differences from the drawn thickness, mm, sorted; of the patches that were seen, or of those that were
/// not.
std::vector<double> errorsOf_mm(const OrganImport& import, bool seen) {
  const OrganWallMap& map = import.organ.wallMap.value();
  const SectionLattice lattice(import.organ.mesh, latticeFor(import.organ.ends));
  std::vector<double> errors;
  for (int band = 1; band + 1 < map.bands; ++band) {  // not where the tube's lids are
    for (int ridge = 0; ridge < map.ridges; ++ridge) {
      const auto n = static_cast<std::size_t>(band * map.ridges + ridge);
      if ((map.seen[n] != 0) == seen) {
        const Vec3 middle_mm = 500.0 * (lattice.keyPoint_m(ridge, band) +
                                        lattice.keyPoint_m((ridge + 1) % map.ridges, band + 1));
        errors.push_back(std::abs(1000.0 * map.thickness_m[n] - wall_mm(middle_mm)));
      }
    }
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

TEST(OrganWall, ComesBackFromACtWithinHalfAVoxel) {
  const ScanVolume scan = tubeInFat(false);
  for (const ScanTissue tissue : {ScanTissue::kGasLumen, ScanTissue::kWall}) {
    const OrganImport import = importOfCt(scan, tissue, "", "wall-ct");

    ASSERT_TRUE(import.accepted) << findingsOf(import);
    ASSERT_TRUE(import.organ.wallMap.has_value()) << findingsOf(import);
    const std::vector<double> errors = errorsOf_mm(import, true);
    ASSERT_GT(errors.size(), 700U);
    EXPECT_LT(errors[errors.size() / 2], 0.25 * kVoxel_mm);
    EXPECT_LT(errors[errors.size() * 95 / 100], 0.5 * kVoxel_mm);
    // The scan's one median says nothing of this.
    const auto [least, most] = std::minmax_element(import.organ.wallMap->thickness_m.begin(),
                                                   import.organ.wallMap->thickness_m.end());
    EXPECT_LT(*least, 0.0028);
    EXPECT_GT(*most, 0.0052);
  }
}

TEST(OrganWall, FillsInWhatAnotherOrganHidesAndSaysHowMuch) {
  const OrganImport import = importOfCt(tubeInFat(true), ScanTissue::kGasLumen, "", "hidden-wall-ct");

  ASSERT_TRUE(import.organ.wallMap.has_value()) << findingsOf(import);
  const OrganWallMap& map = *import.organ.wallMap;
  EXPECT_NEAR(static_cast<double>(map.seenPatches()) / static_cast<double>(map.seen.size()), 0.75, 0.08);
  const std::vector<double> filled = errorsOf_mm(import, false);
  ASSERT_GT(filled.size(), 100U);
  EXPECT_LT(filled[filled.size() * 9 / 10], kVoxel_mm);
  const auto told = std::find_if(import.findings.begin(), import.findings.end(), [](const OrganFinding& one) {
    return one.code == "D18" && one.what.str().find("filled in") != std::string::npos;
  });
  ASSERT_NE(told, import.findings.end());
  EXPECT_DOUBLE_EQ(told->value.value(),
                   static_cast<double>(map.seenPatches()) / static_cast<double>(map.seen.size()));
}

TEST(OrganWall, TakesNoThicknessThatIsNoNumber) {
  const OrganImport import = importOfCt(tubeInFat(false), ScanTissue::kGasLumen, "", "broken-ct");
  std::vector<WallRay> rays;
  for (const Vec3& vertex_m : import.organ.mesh.vertices_m) {
    rays.push_back({1000.0 * vertex_m, std::numeric_limits<double>::quiet_NaN()});
  }
  EXPECT_FALSE(
      wallMapOf(rays, import.organ.mesh, SectionLattice(import.organ.mesh, latticeFor(import.organ.ends))));
}

TEST(OrganWall, IsKeptInTheFileAndTakenByTheHollowModel) {
  const OrganImport import = importOfCt(tubeInFat(false), ScanTissue::kWall, "small-bowel-loop", "bowel-ct");
  ASSERT_TRUE(import.accepted) << findingsOf(import);
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "bowel-with-map.organ";
  writeOrganFile(file, import.organ);

  const OrganFile read = readOrganFile(file);
  ASSERT_TRUE(read.wallMap.has_value());
  EXPECT_EQ(read.wallMap->seen, import.organ.wallMap->seen);
  for (std::size_t n = 0; n < read.wallMap->thickness_m.size(); ++n) {
    ASSERT_NEAR(read.wallMap->thickness_m[n], import.organ.wallMap->thickness_m[n], 1e-6);
  }
  SceneRequest request = testing::shippedRequest();
  request.organFile = file;
  const Scene scene = loadScene(request);

  ASSERT_NE(scene.hollow, nullptr);
  const auto& along_m = scene.hollow->detorsion().wall.thickness_m;
  EXPECT_EQ(along_m, thicknessAlong_m(*read.wallMap));
  ASSERT_EQ(along_m.size(), static_cast<std::size_t>(read.wallMap->bands));
  EXPECT_NEAR(along_m[4][1], 0.001 * wall_mm(Vec3{0, 0, (2.0 * along_m[4][0] - 1.0) * kHalfLength_mm}),
              0.0006);
  EXPECT_NEAR(along_m[19][1], 0.001 * wall_mm(Vec3{0, 0, (2.0 * along_m[19][0] - 1.0) * kHalfLength_mm}),
              0.0006);
}

TEST(OrganWall, CarriesTheShearOfAThinPlaceRoundTheSection) {
  OrganWallMap map{1, 4, {0.002, 0.002, 0.006, 0.006}, {1, 1, 1, 1}};

  const auto along_m = thicknessAlong_m(map);

  ASSERT_EQ(along_m.size(), 1U);
  EXPECT_DOUBLE_EQ(along_m[0][0], 0.5);
  EXPECT_NEAR(along_m[0][1], 0.003, 1e-12);  // the harmonic mean
}

}  // namespace
}  // namespace torsio
