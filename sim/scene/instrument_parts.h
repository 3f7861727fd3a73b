// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "sim/geometry/mesh/triangle_mesh.h"
#include "sim/imaging/surface/tool_surface.h"

namespace torsio {

/// Each connected piece of a surface as a mesh of its own.
[[nodiscard]] std::vector<TriangleMesh> piecesOf(const TriangleMesh& mesh);

/// Tells whether a surface is closed and manifold, without flat triangles.
[[nodiscard]] bool isClosedBody(const TriangleMesh& mesh);

/// Adds a piece, which lies in the instrument's own frame (ToolSurface), to the shaft or to a jaw, or cuts it
/// between them at the hinge and between the jaws; what is cut is closed there when the piece was `closed`.
void addPiece(ToolSurface& tool, const TriangleMesh& piece, bool closed);

/// Turns jaws that were drawn open, each by an angle of 0 to 90 degrees, about the hinge until they are
/// closed; tip, hinge and length change with that.
void closeJaws(ToolSurface& tool, double drawnOpen_deg);

}  // namespace torsio
