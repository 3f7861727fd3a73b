// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/organs/generate/shipped_files.h"

#include "assets/organs/generate/stomach.h"
#include "sim/geometry/mesh_export.h"

namespace torsio {

namespace {

std::string organPly(const TriangleMesh& mesh, const std::string& what, const std::string& dimensions) {
  MeshExportOptions options;
  options.comments = {"Torsio: " + what,
                      "synthetic: drawn by torsio_make_organs (assets/organs/generate), no patient data",
                      "dimensions: " + dimensions, "licence: CC0-1.0 or GPL-3.0-or-later, as you like"};
  return plyBytes(mesh, options);
}

}  // namespace

std::vector<ShippedFile> shippedFiles() {
  std::vector<ShippedFile> files;
  files.push_back(
      {"organs/stomach.ply",
       organPly(makeStomach().surface, "J-shaped stomach, moderately full",
                "centreline 267 mm, 0.71 l, section widths after the BodyParts3D stomach and MRI of "
                "fed adults")});
  files.push_back({"organs/intestine.ply", organPly(makeIntestine().surface, "loop of small intestine",
                                                    "200 mm long, 26 mm wide, typical of adults")});
  return files;
}

}  // namespace torsio
