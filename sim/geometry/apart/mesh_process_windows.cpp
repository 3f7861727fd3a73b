// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/geometry/apart/mesh_process.h"

namespace torsio {

RawMesh readMeshApart(const std::filesystem::path& file, double scale_m, const MeshReadLimits&) {
  return readMesh(file, scale_m);
}

}  // namespace torsio
