// SPDX-License-Identifier: GPL-3.0-or-later
// write_seeds FOLDER PARQUET_FILES: writes small valid inputs, one folder per target.
#include <filesystem>
#include <iostream>
#include <string>

#include "sim/core/file_io.h"
#include "sim/geometry/mesh/mesh_export.h"
#include "sim/imaging/apart/scan_mail.h"
#include "sim/scene/organ_file.h"
#include "tests/support/procedural_mesh.h"
#include "tests/support/scan_files.h"

namespace {

namespace fs = std::filesystem;
using namespace torsio;

void write(const fs::path& folder, const std::string& name, const std::string& bytes) {
  fs::create_directories(folder);
  writeFileAtomically(folder / name, bytes);
}

void writeNifti(const fs::path& folder) {
  const ScanVolume scan = torsio::testing::blankScan({4, 3, 2}, {1, 2, 3}, {-1, -2, -3}, 40);
  for (const std::int16_t type : {2, 4, 8, 16, 64, 256, 512, 768}) {
    const std::string name = "type" + std::to_string(type);
    write(folder, name, '\0' + torsio::testing::niftiBytes(scan, {.datatype = type}));
    write(folder, name + "swapped",
          '\0' + torsio::testing::niftiBytes(scan, {.datatype = type, .swapped = true, .qform = true}));
  }
  write(folder, "packed", '\1' + torsio::testing::gzipped(torsio::testing::niftiBytes(scan)));
}

void writeOrgan(const fs::path& folder) {
  OrganFile organ;
  organ.mesh = torsio::testing::capsule(0.02, 0.06, 8, 3);
  organ.ends.fixedEnd_m = Vec3{0, 0, 0};
  organ.ends.freeEnd_m = Vec3{0, 0, 0.06};
  organ.anatomy = "stomach";
  organ.wall_m = 0.004;
  organ.source = "a mesh";
  organ.warnings = {{"M20", Text::verbatim("a warning")}};
  fs::create_directories(folder);
  const fs::path file = folder / "bar.organ";
  writeOrganFile(file, organ);
  constexpr std::size_t kDigestLength = 64;
  std::string bytes = readFile(file);
  bytes.resize(bytes.size() - kDigestLength);  // the target adds the correct one
  write(folder, "bar.organ", bytes);
}

void writeMeshes(const fs::path& folder) {
  const TriangleMesh bar = torsio::testing::capsule(0.02, 0.06, 6, 2);
  write(folder, "binary.ply", '\0' + plyBytes(bar));
  write(folder, "text.ply", '\0' + plyBytes(bar, {.format = PlyFormat::kAscii}));
  write(folder, "text.obj", '\6' + objText(bar));
  write(folder, "tetra.off",
        "\1OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
  write(folder, "text.stl",
        "\2solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
        "0\nendloop\nendfacet\n"
        "endsolid a\n");
  write(folder, "head.glb", std::string("\3glTF\2\0\0\0\x14\0\0\0", 13));
}

void writeMails(const fs::path& folder) {
  ScanSurface surface;
  surface.mesh = torsio::testing::capsule(0.02, 0.06, 6, 2);
  surface.kind = "CT";
  surface.remarks = {{"D10", true, Text::verbatim("a remark"), 1.0, ""}};
  write(folder, "surface", '\0' + mailOf(surface));
  ScanPreview preview;
  preview.volume = torsio::testing::blankScan({3, 3, 2}, {1, 1, 1}, {0, 0, 0});
  preview.within.assign(18, 1);
  write(folder, "preview", '\1' + mailOf(preview));
  ToolSurface tool;
  tool.shaft = tool.upperJaw = tool.lowerJaw = surface.mesh;
  write(folder, "tool", '\2' + mailOf(tool));
}

/// Each file, to be read for the columns of marks, of motion, and of text with motion.
void writeParquetSeeds(const fs::path& from, const fs::path& folder) {
  for (const auto& entry : fs::directory_iterator(from)) {
    if (entry.path().extension() == ".parquet") {
      for (const char columns : {'\0', '\1', '\2'}) {
        write(folder, entry.path().filename().string() + std::to_string(columns),
              columns + readFile(entry.path()));
      }
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "write_seeds FOLDER PARQUET_FILES\n";
    return 1;
  }
  const fs::path folder = argv[1];
  writeNifti(folder / "nifti");
  writeOrgan(folder / "organ_file");
  writeMeshes(folder / "mesh_head");
  writeMails(folder / "scan_mail");
  writeParquetSeeds(argv[2], folder / "parquet");
  return 0;
}
