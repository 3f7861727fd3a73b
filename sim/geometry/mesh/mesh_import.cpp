// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/mesh/mesh_import.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_check.h"
#include "sim/geometry/mesh/mesh_reader.h"

namespace torsio {

namespace fs = std::filesystem;

namespace {

constexpr double kWeldShare = 1e-6;  // of the largest side

double largestSide_m(const TriangleMesh& mesh) {
  Vec3 low = mesh.vertices_m.front();
  Vec3 high = low;
  for (const Vec3& v : mesh.vertices_m) {
    low = {std::min(low.x, v.x), std::min(low.y, v.y), std::min(low.z, v.z)};
    high = {std::max(high.x, v.x), std::max(high.y, v.y), std::max(high.z, v.z)};
  }
  return std::max({high.x - low.x, high.y - low.y, high.z - low.z});
}

}  // namespace

double lengthUnit_m(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, double>, 4> kUnits{
      {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"um", 1e-6}}};
  for (const auto& [known, metres] : kUnits) {
    if (name == known) {
      return metres;
    }
  }
  throw Error(ErrorCode::kBadParameter, Text::tr("unknown unit \"%1\"", printable(std::string(name))), "",
              Text::tr("Use m, cm, mm or um"));
}

void requireUnit(double scale_m, const std::string& where) {
  if (!(scale_m >= 1e-9 && scale_m <= 1e3)) {
    throw Error(ErrorCode::kBadParameter, Text::tr("the file unit must lie between 1e-9 and 1000 m"), where,
                Text::tr("Use m, cm, mm or um"));
  }
}

TriangleMesh checkedMesh(TriangleMesh mesh, const std::string& where, const MeshImportOptions& options,
                         MeshRepairs* repairs) {
  requireSound(mesh, where);
  MeshRepairs done;
  weldVertices(mesh, kWeldShare * largestSide_m(mesh), done);
  done = {};  // the importer gives every face its own corners: that is no fault of the file
  if (options.organ) {
    mesh = requireOrgan(std::move(mesh), where, options.scale_m, &done);
  } else {
    requireNearOrigin(mesh, where);
    removeDegenerateFaces(mesh, done);
    requireSound(mesh, where);
  }
  if (repairs != nullptr) {
    *repairs = done;
  }
  return mesh;
}

TriangleMesh importMesh(const fs::path& file, const MeshImportOptions& options, MeshRepairs* repairs) {
  requireUnit(options.scale_m, file.string());
  return checkedMesh(readMesh(file, options.scale_m).mesh, file.string(), options, repairs);
}

}  // namespace torsio
