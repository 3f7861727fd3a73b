// SPDX-License-Identifier: GPL-3.0-or-later
// Sets the path of the mesh reading process for a test program, however it is started.
#include <cstdlib>

namespace {

[[maybe_unused]] const int kMeshProgramSet = setenv("TORSIO_MESH_PROGRAM", TORSIO_MESH_PROGRAM, 0);

}  // namespace
