// SPDX-License-Identifier: GPL-3.0-or-later
// Fluid that stands below the gas of a lumen, and a body that lies on a flat table.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/imaging/surface/scan_surface.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/scan_files.h"

namespace torsio {
namespace {

using ::testing::HasSubstr;

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
  ScanRequest request;
  request.tissue = tissue;
  request.fluid = fluid;
  return surfaceOfScan(scan, request, "scan");
}

std::string refusalWithFluid(const ScanRead& scan) {
  try {
    static_cast<void>(drawnWith(scan, ScanTissue::kGasLumen, true));
  } catch (const Error& error) {
    EXPECT_FALSE(error.remedy().empty());
    return error.happened();
  }
  return "accepted";
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
  ScanRequest skin;
  skin.fluid = true;
  EXPECT_THROW(requireScanRequest(skin), Error);
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
}  // namespace torsio
