// SPDX-License-Identifier: GPL-3.0-or-later
// torsio_make_organs ASSETS: writes the shipped organs and instruments below the folder ASSETS.
// torsio_make_organs --fine FOLDER: writes the organs in about a hundred thousand triangles each.
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iostream>
#include <string_view>

#include "sim/base/error.h"
#include "sim/base/file_io.h"
#include "tools/organs/shipped_files.h"

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
