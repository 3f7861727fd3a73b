// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace torsio {

/// Looks at the first bytes of a mesh file before a library sees it: the content must match `extension`
/// (lower case, without dot) and the counts that the header declares must fit in the file, because importers
/// reserve memory for what a header promises. Throws Error{kFileUnreadable} with M02 or M04.
void requirePlausibleHeader(const std::filesystem::path& file, std::string_view extension);

/// The same on the first bytes of a file of `size` bytes; `where` names it.
void requirePlausibleHeader(std::string_view head, std::uint64_t size, std::string_view extension,
                            const std::string& where);

}  // namespace torsio
