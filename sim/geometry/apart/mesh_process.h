// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "sim/geometry/apart/helper_process.h"
#include "sim/geometry/mesh/mesh_import.h"

namespace torsio {

/// What reading a mesh file may cost.
using MeshReadLimits = HelperLimits;

/// Reads a mesh file of a user as readMesh() does, in a process of its own (`torsio-mesh`, beside the running
/// program, or the one that TORSIO_MESH_PROGRAM names): a file that takes the importer down, hangs it or asks
/// for all memory ends that process only. Throws as readMesh; M05 where the process ended without an answer.
/// On Windows the file is read in this process.
[[nodiscard]] RawMesh readMeshApart(const std::filesystem::path& file, double scale_m,
                                    const MeshReadLimits& limits = {});

}  // namespace torsio
