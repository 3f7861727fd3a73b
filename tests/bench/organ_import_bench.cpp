// SPDX-License-Identifier: GPL-3.0-or-later
// Import of a user's mesh: a bent tube of 200 000 and of a million triangles, read in a separate process,
// checked and judged. Processor time of both processes (docs/organs.md; targets 5 s and 30 s).
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <sys/resource.h>
#include <unistd.h>

#include "sim/geometry/mesh/mesh_export.h"
#include "sim/scene/organ_import.h"
#include "tests/support/procedural_mesh.h"

namespace {

/// Returns the processor time of this process and its ended children.
double processor_s() {
  double sum_s = 0.0;
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    getrusage(who, &used);
    sum_s += static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
             1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
  }
  return sum_s;
}

double peak_MB(int who) {
  rusage used{};
  getrusage(who, &used);
  return static_cast<double>(used.ru_maxrss) / 1024.0;
}

void time(const std::filesystem::path& folder, int points, int rings) {
  const torsio::TriangleMesh mesh = torsio::testing::bentTube(0.030, 0.090, 2.2, points, rings);
  const std::filesystem::path file = folder / "organ.ply";
  torsio::writePly(file, mesh);
  torsio::OrganImportRequest request;
  request.assets = std::filesystem::path(TORSIO_SOURCE_DIR) / "assets";
  request.file = file;
  const double before_s = processor_s();
  const torsio::OrganImport import = torsio::importOrgan(request);
  std::cout << mesh.triangles.size() << " triangles: " << processor_s() - before_s << " s, reader "
            << peak_MB(RUSAGE_CHILDREN) << " MB, judge " << peak_MB(RUSAGE_SELF) << " MB, "
            << (import.accepted ? "accepted" : "refused") << '\n';
  for (const torsio::OrganFinding& finding : import.findings) {
    std::cout << "  " << finding.code << ' ' << finding.what.str() << '\n';
  }
}

}  // namespace

int main() {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("torsio-bench-import-" + std::to_string(getpid()));
  setenv("TORSIO_MESH_PROGRAM", TORSIO_MESH_PROGRAM, 0);
  try {
    std::filesystem::create_directories(folder);
    time(folder, 250, 400);
    time(folder, 500, 1000);
    std::filesystem::remove_all(folder);
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::cerr << "torsio_bench_organ_import: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
}
