// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "sim/core/error.h"
#include "sim/geometry/mesh/mesh_import.h"

namespace torsio {

/// Writes a surface, or a refusal, as bytes for a process of the same build on this machine.
[[nodiscard]] std::string mailOf(const RawMesh& mesh);
[[nodiscard]] std::string mailOf(const Error& refusal);

/// Reads a surface back; throws the Error that was written in place of one. Sizes are checked; bytes that are
/// neither throw Error{kFileUnreadable} at `where`.
[[nodiscard]] RawMesh meshOfMail(std::span<const char> bytes, const std::string& where);

}  // namespace torsio
