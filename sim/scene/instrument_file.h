// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "sim/imaging/surface/tool_surface.h"

namespace torsio {

/// Where an instrument comes from, as its file says.
inline constexpr const char* kInstrumentOfScan = "from a scan, by torsio instrument reconstruct";
inline constexpr const char* kInstrumentOfMesh = "from a mesh, by torsio instrument import";

/// What neither a scan nor a mesh says of an instrument.
struct InstrumentFacts {
  std::string title{};  ///< empty: the name of the file
  double opening_deg = 25.0;
  double gripReach_mm = 4.0;
  double tipRadius_mm = 0.0;  ///< 0: as the scan or mesh shows it
  const char* provenance = kInstrumentOfScan;
};

/// Writes an instrument in the form of assets/instruments: `file` (NAME.json) and beside it NAME_shaft.ply,
/// NAME_jaw_upper.ply and NAME_jaw_lower.ply, each whole or not at all, the JSON last. Throws
/// Error{kBadParameter} for measures that no instrument has, Error{kFileUnwritable}.
void writeInstrument(const std::filesystem::path& file, const ToolSurface& tool,
                     const InstrumentFacts& facts);

}  // namespace torsio
