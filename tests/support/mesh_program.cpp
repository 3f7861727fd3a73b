// SPDX-License-Identifier: GPL-3.0-or-later
// Tells a test program where the process that reads meshes lies, whoever starts the test.
#include <cstdlib>

namespace {

[[maybe_unused]] const int kMeshProgramSet = setenv("TORSIO_MESH_PROGRAM", TORSIO_MESH_PROGRAM, 0);

}  // namespace
