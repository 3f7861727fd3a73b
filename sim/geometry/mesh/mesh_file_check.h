// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "sim/core/text.h"

namespace torsio {

/// Checks a mesh file before a library reads it. The content must match `extension` (lower case, without
/// dot) and the counts that a header declares must fit in the file, because importers reserve memory for
/// what a header promises. PLY and OFF files are walked to the end: assimp 5.2 crashes on damaged ones.
/// Throws Error{kFileUnreadable} (M02, M04, M05) or Error{kBadMesh} (M06, M08).
void requirePlausibleFile(const std::filesystem::path& file, std::string_view extension);

/// Checks a whole PLY file; `where` names it. Throws as requirePlausibleFile.
void requirePlausiblePly(std::string_view bytes, const std::string& where);
/// Checks a whole OFF file; `where` names it. Throws as requirePlausibleFile.
void requirePlausibleOff(std::string_view bytes, const std::string& where);

/// Checks the first bytes of a file of `size` bytes: STL, GLB, glTF, COLLADA, OBJ.
void requirePlausibleHead(std::string_view head, std::uint64_t size, std::string_view extension,
                          const std::string& where);

/// Refuses a file whose content is not of the format.
[[noreturn]] void refuseFormat(const std::string& where, std::string_view format, const Text& why);
/// Refuses a file that is shorter than its header promises.
[[noreturn]] void refuseShort(const std::string& where, const std::string& promised, std::uint64_t size);
/// Refuses a file with a broken line or row.
[[noreturn]] void refuseRow(const std::string& where, const std::string& row, const Text& why);
/// Refuses a file in which a face uses a vertex that is not there.
[[noreturn]] void refuseIndex(const std::string& where, const std::string& row, std::int64_t index,
                              std::uint64_t vertices);

}  // namespace torsio
