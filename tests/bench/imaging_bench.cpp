// SPDX-License-Identifier: GPL-3.0-or-later
// Converts a CT of 275 slices of 512 x 512 pixels (a trunk with lungs, a table and noise) into an organ:
// processor time, and memory of the process that reads it (docs/organs.md). `torsio_bench_imaging [FOLDER]`
// keeps the series there.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <random>
#include <string>
#include <unistd.h>

#include "sim/imaging/apart/scan_process.h"
#include "tests/support/dicom_files.h"
#include "tests/support/scan_files.h"

namespace {

using torsio::ScanVolume;
using torsio::Vec3;

/// Returns less than 1 within an ellipsoid.
double within(const Vec3& p, const Vec3& centre, const Vec3& half) {
  const Vec3 q = p - centre;
  return (q.x / half.x) * (q.x / half.x) + (q.y / half.y) * (q.y / half.y) + (q.z / half.z) * (q.z / half.z);
}

std::int16_t valueOfTrunk(const Vec3& p, double noise_HU) {
  const double waist = 1.0 - 0.12 * std::sin(p.z / 70.0);
  const double skin = std::hypot(p.x / (175.0 * waist), p.y / (120.0 * waist));
  double value_HU = -1000.0;
  if (p.y > 140.0 && p.y < 148.0 && std::abs(p.x) < 200.0) {
    value_HU = -200.0;  // the table
  }
  if (skin < 1.0) {
    value_HU = skin > 0.88 ? -100.0 : 40.0;
  }
  for (const double side : {-1.0, 1.0}) {
    if (within(p, {side * 75.0, 0.0, 330.0}, {50.0, 75.0, 130.0}) < 1.0) {
      const double vessels = std::sin(p.x / 4.0) * std::sin(p.y / 5.0) * std::sin(p.z / 6.0);
      value_HU = vessels > 0.6 ? 30.0 : -850.0;
    }
  }
  if (within(p, {70.0, -30.0, 130.0}, {45.0, 40.0, 75.0}) < 1.0) {
    value_HU = within(p, {70.0, -30.0, 130.0}, {41.0, 36.0, 71.0}) < 1.0 ? -990.0 : 40.0;  // the stomach
  }
  if (within(p, {0.0, 75.0, p.z}, {18.0, 18.0, 1.0}) < 1.0) {
    value_HU = 400.0;  // the spine
  }
  return static_cast<std::int16_t>(std::lround(value_HU + noise_HU));
}

ScanVolume trunk() {
  ScanVolume scan = torsio::testing::blankScan({512, 512, 275}, {0.78, 0.78, 1.5}, {-199.5, -180.0, 0.0});
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0.0, 15.0);
  for (std::size_t k = 0; k < scan.count[2]; ++k) {
    for (std::size_t j = 0; j < scan.count[1]; ++j) {
      for (std::size_t i = 0; i < scan.count[0]; ++i) {
        const Vec3 p =
            scan.place_mm({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
        scan.values[scan.index(i, j, k)] = std::max<std::int16_t>(-1024, valueOfTrunk(p, noise(random)));
      }
    }
  }
  return scan;
}

void time(const std::filesystem::path& folder, torsio::ScanTissue tissue, const std::string& name) {
  torsio::ScanRequest request{.source = folder, .tissue = tissue};
  if (tissue != torsio::ScanTissue::kSkin) {
    request.seed_mm = Vec3{70.0, -30.0, 130.0};
  }
  const torsio::ScanApart made = torsio::scanApart(request);
  std::cout << name << ": " << made.processor_s << " s, " << made.peak_MB << " MB, "
            << made.surface.rawTriangles << " triangles at " << made.surface.step_mm << " mm, thinned to "
            << made.surface.mesh.triangles.size() << '\n';
}

}  // namespace

int main(int argc, char** argv) {
  const std::filesystem::path folder = argc > 1 ? std::filesystem::path(argv[1])
                                                : std::filesystem::temp_directory_path() /
                                                      ("torsio-bench-imaging-" + std::to_string(getpid()));
  setenv("TORSIO_SCAN_PROGRAM", TORSIO_SCAN_PROGRAM, 0);
  try {
    if (!std::filesystem::exists(folder)) {
      torsio::testing::writeDicomSeries(folder, trunk());
    }
    time(folder, torsio::ScanTissue::kSkin, "skin");
    time(folder, torsio::ScanTissue::kGasLumen, "gas in the stomach");
    time(folder, torsio::ScanTissue::kWall, "the stomach with its wall");
    if (argc == 1) {
      std::filesystem::remove_all(folder);
    }
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "torsio_bench_imaging: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
