// SPDX-License-Identifier: GPL-3.0-or-later
// From voxels to the surface of an organ: shipped organs there and back, and what cannot become one.
// Fluid that stands below the gas of a lumen, and a body that lies on a flat table.

#include "sim/imaging/surface/scan_surface.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_crossings.h"
#include "sim/geometry/mesh/mesh_import.h"
#include "sim/geometry/query/collision_mesh.h"
#include "sim/imaging/surface/voxel_mask.h"
#include "tests/support/dicom_files.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/refusal.h"
#include "tests/support/scan_files.h"

namespace torsio {

namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr std::int16_t kTissue_HU = 40;
constexpr std::int16_t kFat_HU = -100;
constexpr std::int16_t kGas_HU = -1000;

TriangleMesh shippedOrgan(const std::string& name) {
  return importMesh(std::filesystem::path(TORSIO_SOURCE_DIR) / "assets/organs" / (name + ".ply"));
}

ScanSurface reconstructed(ScanVolume scan, const ScanRequest& request) {
  ScanRead read;
  read.volume = std::move(scan);
  return surfaceOfScan(std::move(read), request, "scan");
}

std::string refusalOfScan(ScanVolume scan, const ScanRequest& request) {
  return testing::refusalText([&] { return reconstructed(std::move(scan), request); });
}

const ScanRemark* remark(const ScanSurface& surface, const std::string& code) {
  const auto at = std::find_if(surface.remarks.begin(), surface.remarks.end(),
                               [&code](const ScanRemark& one) { return one.code == code; });
  return at == surface.remarks.end() ? nullptr : &*at;
}

/// The distance that 95 % of the vertices keep from a surface, either way round.
double p95Distance_mm(const TriangleMesh& a, const TriangleMesh& b) {
  std::vector<double> distances_mm;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const CollisionMesh surface(*to);
    for (std::size_t v = 0; v < from->vertices_m.size(); v += 7) {
      distances_mm.push_back(1000.0 * std::abs(surface.closest(from->vertices_m[v]).distance_m));
    }
  }
  std::sort(distances_mm.begin(), distances_mm.end());
  return distances_mm[distances_mm.size() * 95 / 100];
}

void expectRoundTrip(const ScanSurface& made, const TriangleMesh& organ, double voxel_mm) {
  const MeshReport report = checkMesh(made.mesh);
  EXPECT_EQ(report.euler, 2);
  EXPECT_EQ(report.components, 1U);
  EXPECT_TRUE(report.closed() && report.manifold() && report.oriented());
  EXPECT_TRUE(crossingTriangles(made.mesh).empty());
  EXPECT_NEAR(report.volume_m3 / signedVolume_m3(organ), 1.0, 0.01);
  const double p95_mm = p95Distance_mm(made.mesh, organ);
  EXPECT_LT(p95_mm, voxel_mm);
  ::testing::Test::RecordProperty("p95_um", static_cast<int>(1000.0 * p95_mm));
  ::testing::Test::RecordProperty("volume_ppm",
                                  static_cast<int>(1e6 * report.volume_m3 / signedVolume_m3(organ)));
  // A mirror image would lie elsewhere.
  EXPECT_GT(p95Distance_mm(made.mesh, testing::mirroredX(organ)), voxel_mm);
}

ScanVolume scanOf(const TriangleMesh& organ, const Vec3& voxel_mm, std::int16_t value, std::int16_t around) {
  ScanVolume scan = testing::blankScanAround(organ, voxel_mm);
  std::fill(scan.values.begin(), scan.values.end(), around);
  testing::fillWith(scan, organ, value);
  return scan;
}

std::filesystem::path surfaceFile(const std::string& name) {
  return std::filesystem::path(::testing::TempDir()) / ("surface-" + std::to_string(getpid()) + "-" + name);
}

TEST(ScanSurface, BringsTheArmBackFromADicomSeries) {
  const TriangleMesh arm = shippedOrgan("forearm");
  ScanVolume upright = scanOf(arm, {2.0, 2.0, 2.5}, kTissue_HU, kGas_HU);
  ScanRequest request{.source = surfaceFile("arm")};
  testing::writeDicomSeries(request.source, upright, {.syntax = "jpeg-ls"});
  const ScanSurface made = surfaceOfScan(request);
  expectRoundTrip(made, arm, 2.0);
  EXPECT_LE(made.mesh.triangles.size(), kKeptTriangles);
  EXPECT_NEAR(made.level_HU.value(), -480.0, 5.0);
  EXPECT_TRUE(made.remarks.empty());
  EXPECT_EQ(made.kind, "CT, " + std::to_string(upright.count[2]) + " slices, skin");
}

TEST(ScanSurface, IsWhereTheOrganIsThoughTheGantryWasTilted) {
  // Slices that lie 1 mm higher up the back each: a bar that stands upright leans in its voxels.
  const TriangleMesh bar = testing::shifted(testing::capsule(0.02, 0.06, 36, 12), {0.01, 0.03, 0.04});
  ScanVolume scan = testing::blankScan({36, 60, 36}, {2, 2, 4}, {-30, -40, 4}, kGas_HU);
  scan.step_mm[2] = {0, 1, 4};
  for (std::size_t k = 0; k < scan.count[2]; ++k) {
    ScanVolume slice =
        testing::blankScan({36, 60, 1}, {2, 2, 4}, scan.place_mm({0, 0, static_cast<double>(k)}));
    testing::fillWith(slice, bar, kTissue_HU);
    std::copy(slice.values.begin(), slice.values.end(),
              scan.values.begin() + static_cast<std::ptrdiff_t>(scan.index(0, 0, k)));
  }
  ScanRequest request{.source = surfaceFile("tilted")};
  testing::writeDicomSeries(request.source, scan);
  const ScanSurface made = surfaceOfScan(request);
  ASSERT_NE(remark(made, "D10"), nullptr);
  EXPECT_LT(p95Distance_mm(made.mesh, bar), 1.0);
  EXPECT_NEAR(signedVolume_m3(made.mesh) / signedVolume_m3(bar), 1.0, 0.01);
}

TEST(ScanSurface, BringsTheStomachBackAsALabelAndAsGas) {
  const TriangleMesh stomach = shippedOrgan("stomach");
  const Vec3 voxel_mm{3.0, 3.0, 4.0};
  ScanRequest label{.tissue = ScanTissue::kLabel, .label = 6};
  ScanVolume mask = scanOf(stomach, voxel_mm, 1000, 0);
  for (std::int16_t& value : mask.values) {
    value = value >= 500 ? 6 : 1;
  }
  label.source = surfaceFile("stomach.nii.gz");
  writeFileAtomically(label.source, testing::gzipped(testing::niftiBytes(mask, {.datatype = 2})));
  expectRoundTrip(surfaceOfScan(label), stomach, 3.0);
  // The same with voxels that run the other way: left-handed, as most NIfTI files are.
  ScanVolume turned = mask;
  turned.origin_mm = mask.place_mm({static_cast<double>(mask.count[0] - 1), 0, 0});
  turned.step_mm[0] *= -1.0;
  for (std::size_t row = 0; row < turned.values.size(); row += turned.count[0]) {
    const auto first = turned.values.begin() + static_cast<std::ptrdiff_t>(row);
    std::reverse(first, first + static_cast<std::ptrdiff_t>(turned.count[0]));
  }
  expectRoundTrip(reconstructed(turned, label), stomach, 3.0);

  ScanRequest gas{.tissue = ScanTissue::kGasLumen};
  const ScanSurface made = reconstructed(scanOf(stomach, voxel_mm, kGas_HU, kTissue_HU), gas);
  expectRoundTrip(made, stomach, 3.0);
  EXPECT_FALSE(made.wall.has_value());  // tissue all round: no end of the wall is seen
}

TEST(ScanSurface, MeasuresAWallWhereTheScanShowsItsEnd) {
  // A tube of gas, 40 mm wide, in a wall of 4 mm, in fat; a liver lies against its upper half.
  const TriangleMesh lumen = testing::shifted(testing::capsule(0.020, 0.06, 48, 12), {0, 0, 0.05});
  const TriangleMesh outer = testing::shifted(testing::capsule(0.024, 0.06, 48, 12), {0, 0, 0.05});
  ScanVolume scan = scanOf(outer, {1.5, 1.5, 2.0}, kTissue_HU, kFat_HU);
  for (std::size_t k = 0; k < scan.count[2]; ++k) {
    for (std::size_t j = 0; j < scan.count[1]; ++j) {
      for (std::size_t i = 0; i < scan.count[0]; ++i) {
        const bool liver = scan.place_mm({0, static_cast<double>(j), 0}).y > 0.0;
        auto& value = scan.values[scan.index(i, j, k)];
        value = liver ? std::max(value, kTissue_HU) : value;
      }
    }
  }
  testing::fillWith(scan, lumen, kGas_HU);
  ScanRequest request{.tissue = ScanTissue::kGasLumen};
  const ScanSurface inside = reconstructed(scan, request);
  ASSERT_TRUE(inside.wall.has_value());
  EXPECT_NEAR(inside.wall->median_mm, 4.0, 0.3);
  EXPECT_NEAR(inside.wall->seen, 0.5, 0.1);
  EXPECT_LT(inside.wall->tenth_mm, inside.wall->ninety_mm);
  EXPECT_NEAR(signedVolume_m3(inside.mesh) / signedVolume_m3(lumen), 1.0, 0.02);

  request.tissue = ScanTissue::kWall;
  const ScanSurface whole = reconstructed(scan, request);
  EXPECT_NEAR(signedVolume_m3(whole.mesh) / signedVolume_m3(outer), 1.0, 0.03);
  EXPECT_EQ(checkMesh(whole.mesh).euler, 2);
  ASSERT_NE(remark(whole, "D18"), nullptr);
  EXPECT_EQ(whole.ownWall_mm, whole.wall->median_mm);
  EXPECT_FALSE(inside.ownWall_mm.has_value());
  request.wall_mm = 8.0;  // said to be thicker: but fat is none of it
  const double thick_m3 = signedVolume_m3(reconstructed(scan, request).mesh);
  EXPECT_GT(thick_m3, 1.05 * signedVolume_m3(whole.mesh));
}

TEST(ScanSurface, AssumesAWallThatTheScanDoesNotShowAndWarns) {
  const TriangleMesh lumen = testing::capsule(0.020, 0.06, 36, 8);
  ScanVolume scan = testing::blankScanAround(lumen, {3, 3, 4}, 20.0);
  std::fill(scan.values.begin(), scan.values.end(), kTissue_HU);
  testing::fillWith(scan, lumen, kGas_HU);
  const ScanSurface made = reconstructed(scan, ScanRequest{.tissue = ScanTissue::kWall});
  ASSERT_NE(remark(made, "D18"), nullptr);
  EXPECT_TRUE(remark(made, "D18")->warning);
  EXPECT_DOUBLE_EQ(made.ownWall_mm.value(), 3.0);
  const TriangleMesh outer = testing::capsule(0.023, 0.06, 36, 8);
  EXPECT_NEAR(signedVolume_m3(made.mesh) / signedVolume_m3(outer), 1.0, 0.04);
}

TEST(ScanSurface, PutsALidWhereTheScanCutsTheOrgan) {
  const TriangleMesh bar = testing::prism(testing::circleOutline(0.03, 48), 0.2, 12);
  ScanVolume scan = testing::blankScan({48, 48, 30}, {2, 2, 4}, {-47, -47, 40});  // 38 to 158 mm of 200
  testing::fillWith(scan, bar, kTissue_HU);
  testing::fillWith(scan, testing::prism(testing::circleOutline(0.01, 24), 0.2, 12),
                    kGas_HU);  // a pipe in it
  const ScanSurface made = reconstructed(scan, {});
  const MeshReport report = checkMesh(made.mesh);
  EXPECT_EQ(report.euler, 2);
  EXPECT_NEAR(report.boxMin_m.z, 0.038, 2e-4);
  EXPECT_NEAR(report.boxMax_m.z, 0.158, 2e-4);
  EXPECT_NEAR(report.volume_m3, 0.12 * testing::areaOf(testing::circleOutline(0.03, 48)), 4e-6);
  ASSERT_NE(remark(made, "D17"), nullptr);
  EXPECT_THAT(remark(made, "D17")->what.str(),
              HasSubstr("cuts off the organ (towards the feet, towards the head)"));
}

TEST(ScanSurface, TakesThePieceOfTheSeedAndTheBox) {
  const TriangleMesh small = testing::shifted(testing::capsule(0.02, 0.05, 24, 8), {0.05, 0, 0.06});
  const TriangleMesh large = testing::shifted(testing::capsule(0.03, 0.05, 24, 8), {-0.05, 0, 0.06});
  ScanVolume scan = testing::blankScan({90, 45, 70}, {2.5, 2.5, 2.5}, {-110, -55, -10});
  testing::fillWith(scan, small, kTissue_HU);
  testing::fillWith(scan, large, kTissue_HU);

  const ScanSurface first = reconstructed(scan, {});
  EXPECT_NEAR(signedVolume_m3(first.mesh) / signedVolume_m3(large), 1.0, 0.01);
  ASSERT_NE(remark(first, "D16"), nullptr);
  ScanRequest request{.seed_mm = Vec3{50, 0, 80}};
  EXPECT_NEAR(signedVolume_m3(reconstructed(scan, request).mesh) / signedVolume_m3(small), 1.0, 0.015);
  request.seed_mm.reset();
  request.box_mm = ScanBox{Vec3{10, -60, -20}, Vec3{100, 60, 200}};
  EXPECT_NEAR(signedVolume_m3(reconstructed(scan, request).mesh) / signedVolume_m3(small), 1.0, 0.015);

  request.box_mm = ScanBox{Vec3{500, 0, 0}, Vec3{600, 10, 10}};
  EXPECT_THAT(refusalOfScan(scan, request), StartsWith("D16 the box"));
  request.box_mm.reset();
  request.seed_mm = Vec3{0, 0, 80};
  EXPECT_THAT(refusalOfScan(scan, request), HasSubstr("-1000"));
  request.seed_mm = Vec3{0, 900, 80};
  EXPECT_THAT(refusalOfScan(scan, request), HasSubstr("outside the scan"));
}

TEST(ScanSurface, RefusesGasThatIsNotOneOrgan) {
  ScanRequest gas{.tissue = ScanTissue::kGasLumen};
  ScanVolume scan = testing::blankScan({60, 40, 40}, {3, 3, 3}, {-88, -58, 0}, kTissue_HU);
  EXPECT_THAT(refusalOfScan(scan, gas), StartsWith("D13"));
  ScanVolume open = scan;
  testing::fillWith(
      open, testing::shifted(testing::prism(testing::circleOutline(0.03, 24), 0.3, 8), {0, 0.06, -0.1}),
      kGas_HU);  // out over the side
  EXPECT_THAT(refusalOfScan(open, gas), StartsWith("D16 no gas is enclosed"));
  gas.seed_mm = Vec3{0, 50, 60};
  EXPECT_EQ(refusalOfScan(open, gas), "accepted");  // two ends and a side
  gas.seed_mm.reset();
  testing::fillWith(scan, testing::shifted(testing::capsule(0.02, 0.02, 24, 4), {0.04, 0, 0.05}), kGas_HU);
  testing::fillWith(scan, testing::shifted(testing::capsule(0.02, 0.03, 24, 4), {-0.04, 0, 0.05}), kGas_HU);
  EXPECT_THAT(refusalOfScan(scan, gas), StartsWith("D16 several spaces are filled with gas"));
}

TEST(ScanSurface, RefusesALabelThatIsNotThereWithThoseThatAre) {
  ScanRequest label{.tissue = ScanTissue::kLabel, .label = 9};
  ScanVolume mask = testing::blankScan({20, 20, 20}, {5, 5, 5}, {0, 0, 0}, 0);
  EXPECT_THAT(refusalOfScan(mask, label), StartsWith("N07 the file has no label at all"));
  mask.values[400] = 6;
  mask.values[401] = 6;
  EXPECT_THAT(refusalOfScan(mask, label), HasSubstr("no label 9; it has 6 (0.25 ml)"));
}

/// Noise of a scanner, the same each time: triangular, `most_HU` at most.
void addNoise(ScanVolume& scan, int most_HU) {
  std::uint32_t seed = 12345;
  const auto next = [&seed, most_HU] {
    seed = seed * 1664525U + 1013904223U;
    return static_cast<int>((seed >> 16U) % static_cast<unsigned>(most_HU + 1));
  };
  for (std::int16_t& value : scan.values) {
    value = static_cast<std::int16_t>(value + next() - next());
  }
}

/// A stomach of 40 mm across and 100 mm long in its wall of 4 mm, in fat, in a body in air; filled to
/// `level_mm` of the back with gas and behind with a fluid.
ScanRead halfFull(std::int16_t fluid_HU, double level_mm) {
  const TriangleMesh lumen = testing::shifted(testing::capsule(0.020, 0.06, 48, 12), {0, 0, -0.03});
  const TriangleMesh outer = testing::shifted(testing::capsule(0.024, 0.06, 48, 12), {0, 0, -0.03});
  ScanRead read;
  read.volume = testing::blankScanAround(outer, {1.5, 1.5, 2.0}, 24.0);
  std::fill(read.volume.values.begin(), read.volume.values.end(), static_cast<std::int16_t>(-100));
  testing::fillWith(read.volume, outer, 45);
  testing::fillWith(read.volume, lumen, fluid_HU);
  ScanVolume gas = read.volume;
  testing::fillWith(gas, lumen, -1000);
  ScanVolume& volume = read.volume;
  for (std::size_t n = 0; n < volume.values.size(); ++n) {
    const double y = volume.place_mm({0, static_cast<double>(n / volume.count[0] % volume.count[1]), 0}).y;
    if (y < level_mm) {
      volume.values[n] = gas.values[n];
    }
  }
  addNoise(volume, 20);
  return read;
}

const double kLumen_ml = 1e6 * signedVolume_m3(testing::capsule(0.020, 0.06, 48, 12));

ScanSurface drawnWith(const ScanRead& scan, ScanTissue tissue, bool fluid) {
  return surfaceOfScan(scan, ScanRequest{.tissue = tissue, .fluid = fluid}, "scan");
}

std::string refusalWithFluid(const ScanRead& scan) {
  return testing::refusalText([&] { return drawnWith(scan, ScanTissue::kGasLumen, true); });
}

TEST(ScanFluid, JoinsTheFluidBelowTheGasToTheLumen) {
  for (const std::int16_t fluid_HU : {std::int16_t{5}, std::int16_t{300}}) {
    const ScanRead scan = halfFull(fluid_HU, 3.0);
    const ScanSurface gas = drawnWith(scan, ScanTissue::kGasLumen, false);
    EXPECT_LT(1e6 * signedVolume_m3(gas.mesh), 0.7 * kLumen_ml) << fluid_HU;
    const ScanSurface all = drawnWith(scan, ScanTissue::kGasLumen, true);
    EXPECT_NEAR(1e6 * signedVolume_m3(all.mesh) / kLumen_ml, 1.0, 0.05) << fluid_HU;
    EXPECT_EQ(checkMesh(all.mesh).euler, 2);
    const auto told = std::find_if(all.remarks.begin(), all.remarks.end(),
                                   [](const ScanRemark& remark) { return remark.code == "D20"; });
    ASSERT_NE(told, all.remarks.end());
    EXPECT_TRUE(told->warning);
    EXPECT_THAT(told->what.str(), HasSubstr("towards the back"));
  }
}

TEST(ScanFluid, TakesTheWallRoundGasAndFluid) {
  const ScanSurface whole = drawnWith(halfFull(5, 3.0), ScanTissue::kWall, true);
  const double outer_ml = 1e6 * signedVolume_m3(testing::capsule(0.024, 0.06, 48, 12));
  EXPECT_NEAR(1e6 * signedVolume_m3(whole.mesh) / outer_ml, 1.0, 0.06);
}

TEST(ScanFluid, RefusesFluidThatCannotBeToldFromTheWallOrIsNotThere) {
  EXPECT_THAT(refusalWithFluid(halfFull(40, 3.0)), HasSubstr("as dense as the wall"));
  EXPECT_THAT(refusalWithFluid(halfFull(5, 100.0)), HasSubstr("D16"));  // full of gas: no level
  EXPECT_THROW(requireScanRequest(ScanRequest{.fluid = true}), Error);
}

/// A trunk that lies broadly on a table which goes from side to side of the scan.
ScanRead onTable() {
  ScanRead read;
  read.volume = testing::blankScan({100, 80, 30}, {4, 4, 5}, {-200, -160, 0}, -1000);
  ScanVolume& scan = read.volume;
  for (std::size_t n = 0; n < scan.values.size(); ++n) {
    const double x = scan.place_mm({static_cast<double>(n % 100), 0, 0}).x;
    const double y = scan.place_mm({0, static_cast<double>(n / 100 % 80), 0}).y;
    if (y > 80.0 && y < 100.0) {
      scan.values[n] = -150;  // the table
    } else if (y <= 80.0 && (x * x) / (130.0 * 130.0) + (y - 20.0) * (y - 20.0) / (90.0 * 90.0) < 1.0) {
      scan.values[n] = 40;
    }
  }
  return read;
}

TEST(ScanTable, TakesABodyOffTheTableThatItLiesOn) {
  const ScanSurface body = drawnWith(onTable(), ScanTissue::kSkin, false);
  double back_mm = 0.0;
  double side_mm = 0.0;
  for (const Vec3& v : body.mesh.vertices_m) {
    back_mm = std::max(back_mm, 1000.0 * v.y);
    side_mm = std::max(side_mm, 1000.0 * std::abs(v.x));
  }
  EXPECT_NEAR(back_mm, 80.0, 3.0);
  EXPECT_NEAR(side_mm, 130.0, 3.0);
  const auto told = std::find_if(body.remarks.begin(), body.remarks.end(),
                                 [](const ScanRemark& remark) { return remark.code == "D21"; });
  ASSERT_NE(told, body.remarks.end());
  EXPECT_NEAR(told->value.value(), 80.0, 3.0);
}

TEST(ScanTable, RefusesTissueThatFillsTheScan) {
  ScanRead read = onTable();
  for (std::size_t n = 0; n < read.volume.values.size(); ++n) {
    read.volume.values[n] = n % 7919 == 0 || n < 4000 ? -1000 : 40;
  }
  ScanRequest request;
  EXPECT_THROW(static_cast<void>(surfaceOfScan(read, request, "scan")), Error);
}

}  // namespace

namespace {

constexpr VoxelMask::Count kCount{70, 9, 8};  // a row of more than one word

VoxelMask scattered(unsigned perThousand) {
  std::mt19937 random(3);
  VoxelMask mask(kCount);
  for (std::size_t z = 0; z < kCount[2]; ++z) {
    for (std::size_t y = 0; y < kCount[1]; ++y) {
      for (std::size_t x = 0; x < kCount[0]; ++x) {
        if (random() % 1000 < perThousand) {
          mask.set(x, y, z);
        }
      }
    }
  }
  return mask;
}

/// Whether a voxel or one of its neighbours is set: those over faces, or over corners too.
bool nearSet(const VoxelMask& mask, std::size_t x, std::size_t y, std::size_t z, bool corners) {
  for (int dz = -1; dz <= 1; ++dz) {
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const long px = static_cast<long>(x) + dx;
        const long py = static_cast<long>(y) + dy;
        const long pz = static_cast<long>(z) + dz;
        const bool inGrid = px >= 0 && py >= 0 && pz >= 0 && px < 70 && py < 9 && pz < 8;
        if (inGrid && (corners || std::abs(dx) + std::abs(dy) + std::abs(dz) <= 1) &&
            mask.at(static_cast<std::size_t>(px), static_cast<std::size_t>(py),
                    static_cast<std::size_t>(pz))) {
          return true;
        }
      }
    }
  }
  return false;
}

TEST(VoxelMask, GrowsOverFacesThenOverCorners) {
  const VoxelMask mask = scattered(20);
  const VoxelMask once = mask.grown(1);
  const VoxelMask twice = mask.grown(2);
  for (std::size_t z = 0; z < kCount[2]; ++z) {
    for (std::size_t y = 0; y < kCount[1]; ++y) {
      for (std::size_t x = 0; x < kCount[0]; ++x) {
        ASSERT_EQ(once.at(x, y, z), nearSet(mask, x, y, z, false));
        ASSERT_EQ(twice.at(x, y, z), nearSet(once, x, y, z, true));
      }
    }
  }
}

TEST(VoxelMask, ShrinksAsItsBackgroundGrows) {
  const VoxelMask mask = scattered(900);
  const VoxelMask less = mask.shrunk(1);
  EXPECT_GT(less.voxels(), 0U);
  for (std::size_t z = 1; z + 1 < kCount[2]; ++z) {
    for (std::size_t y = 1; y + 1 < kCount[1]; ++y) {
      for (std::size_t x = 1; x + 1 < kCount[0]; ++x) {
        ASSERT_EQ(less.at(x, y, z), mask.at(x, y, z) && mask.at(x - 1, y, z) && mask.at(x + 1, y, z) &&
                                        mask.at(x, y - 1, z) && mask.at(x, y + 1, z) &&
                                        mask.at(x, y, z - 1) && mask.at(x, y, z + 1));
      }
    }
  }
}

TEST(VoxelMask, ListsItsPiecesTheLargestFirst) {
  VoxelMask mask(kCount);
  for (std::size_t x = 10; x < 68; ++x) {
    mask.set(x, 4, 4);
  }
  mask.set(68, 5, 4);  // touches the row over an edge only: a piece of its own
  mask.set(20, 5, 4);
  mask.set(20, 6, 4);
  mask.set(0, 0, 0);
  mask.set(0, 0, 1);
  const MaskPieces pieces(mask, {0, 0, 0}, kCount);
  ASSERT_EQ(pieces.list().size(), 3U);
  EXPECT_EQ(pieces.list()[0].voxels, 60U);
  EXPECT_EQ(pieces.list()[1].voxels, 2U);
  EXPECT_EQ(pieces.at(20, 6, 4), 0U);
  EXPECT_EQ(pieces.at(68, 5, 4), 2U);
  EXPECT_EQ(pieces.at(30, 5, 4), 3U);
  EXPECT_DOUBLE_EQ(pieces.list()[1].middle[2], 0.5);
  EXPECT_TRUE(pieces.list()[1].atBorder[0] && pieces.list()[1].atBorder[2] && pieces.list()[1].atBorder[4]);
  EXPECT_FALSE(pieces.list()[0].atBorder[1]);
  EXPECT_EQ(pieces.mask(0).voxels(), 60U);
}

TEST(VoxelMask, FillsWhatIsEnclosedAndPutsLidsOnCutEnds) {
  VoxelMask tube({20, 20, 20});  // open at z = 3, closed at z = 16
  for (std::size_t z = 3; z < 17; ++z) {
    for (std::size_t y = 5; y < 15; ++y) {
      for (std::size_t x = 5; x < 15; ++x) {
        const bool wall = x == 5 || x == 14 || y == 5 || y == 14 || z == 16;
        if (wall) {
          tube.set(x, y, z);
        }
      }
    }
  }
  EXPECT_EQ(tube.filled().voxels(), tube.voxels());
  fillLids(tube, {3, 3, 3}, {17, 17, 17});
  EXPECT_EQ(tube.filled().voxels(), 10U * 10U * 14U);
}

}  // namespace

}  // namespace torsio
