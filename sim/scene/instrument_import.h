// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "sim/geometry/apart/mesh_process.h"
#include "sim/imaging/surface/tool_surface.h"

namespace torsio {

/// What is known of a mesh that is to become an instrument. The places are in the axes of the file, in
/// millimetres.
struct InstrumentImportRequest : ToolPlaces {
  std::filesystem::path file;
  double scale_m = 0.001;      ///< one file unit in metres
  double drawnOpen_deg = 0.0;  ///< how far each jaw stands open in the file, 0 to 90; it is closed
  MeshReadLimits reading;
};

/// Reads a mesh of an instrument in a process of its own, checks it and finds tip, shaft, hinge and jaws in
/// it. It may be open and of several pieces: a piece that lies before the hinge is a jaw, one behind it is of
/// the shaft, and only a piece that reaches from the jaws far behind the hinge is cut there. Jaws that hang
/// together are cut apart. Throws Error{kFileMissing, kFileUnreadable, kBadMesh} with the code of the rule
/// (M01 to M09, M18; M20 for what has no shaft or no jaws), {kBadParameter} for a request out of range.
[[nodiscard]] ToolSurface importInstrument(const InstrumentImportRequest& request);

/// Makes an instrument of a surface that was read, in metres, as importInstrument() does of a file.
[[nodiscard]] ToolSurface toolOfMesh(RawMesh raw, const InstrumentImportRequest& request);

}  // namespace torsio
