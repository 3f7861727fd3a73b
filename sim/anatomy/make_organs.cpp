// SPDX-License-Identifier: GPL-3.0-or-later
// torsio_make_organs ASSETS: writes the shipped organs and instruments below the folder ASSETS.
// torsio_make_organs --fine FOLDER: writes the organs in about a hundred thousand triangles each.
// Each organ is read again and checked: closed, of genus 0, crossing itself nowhere.
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string_view>

#include "sim/anatomy/shipped_files.h"
#include "sim/core/error.h"
#include "sim/core/file_io.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_crossings.h"
#include "sim/geometry/mesh/mesh_import.h"

namespace {

/// Prints the measures of an organ's file. Throws Error{kBadMesh} when it is not a sound surface.
void tellOrgan(const std::filesystem::path& file) {
  const torsio::TriangleMesh mesh = torsio::importMesh(file);
  const torsio::MeshReport report = torsio::checkMesh(mesh);
  const std::size_t crossings = torsio::crossingTriangles(mesh).size();
  const bool sound = report.closed() && report.manifold() && report.oriented() && report.components == 1;
  std::cout << "  " << report.triangles << " triangles, " << 1e6 * report.volume_m3 << " ml, Euler number "
            << 2 - 2 * report.genus() << ", " << crossings << " crossings\n";
  if (!sound || report.genus() != 0 || crossings != 0) {
    throw torsio::Error(torsio::ErrorCode::kBadMesh,
                        torsio::Text::verbatim("the organ drawn is not a sound surface"), file.string(),
                        torsio::Text::verbatim("Change its edges"));
  }
}

}  // namespace

int main(int argc, char** argv) {
  using torsio::ErrorCode;
  try {
    const bool fine = argc == 3 && std::string_view(argv[1]) == "--fine";
    if (!fine && (argc != 2 || argv[1][0] == '-')) {
      throw torsio::Error(
          ErrorCode::kUsage, torsio::Text::verbatim("usage: torsio_make_organs ASSETS, or --fine FOLDER"), "",
          torsio::Text::verbatim("Name the assets folder of the source tree, or any other for "
                                 "fine organs"));
    }
    for (const torsio::ShippedFile& file : fine ? torsio::fineOrgans() : torsio::shippedFiles()) {
      const std::filesystem::path path = std::filesystem::path(argv[argc - 1]) / file.path;
      torsio::ensureFolder(path.parent_path());
      torsio::writeFileAtomically(path, file.bytes);
      std::cout << path.string() << ": " << file.bytes.size() << " bytes\n";
      const bool organ = fine || std::string_view(file.path).starts_with("organs/");
      if (organ && path.extension() == ".ply") {
        tellOrgan(path);
      }
    }
    return EXIT_SUCCESS;
  } catch (const torsio::Error& error) {
    std::cerr << "torsio_make_organs: " << error.what() << '\n';
    return static_cast<int>(error.code());
  } catch (const std::exception& error) {
    std::cerr << "torsio_make_organs: " << error.what() << '\n';
    return static_cast<int>(ErrorCode::kInternal);
  }
}
