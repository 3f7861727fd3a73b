// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace torsio {

/// Result of loading a shared library at run time; dynamic_library_posix.cpp or dynamic_library_windows.cpp.
struct LoadedLibrary {
  void* handle = nullptr;         ///< null: not loaded
  bool found = false;             ///< the library itself exists
  std::string missingDependency;  ///< it exists, but needs this file, which does not; may be unknown ("")
  std::string systemText;         ///< what the system's loader said
};

/// Loads `name` (a path, or a file name that the system searches) with all its references resolved and
/// without showing its symbols to others. The library stays loaded until the process ends: the vendor's
/// driver fails when it is loaded a second time after having been unloaded.
[[nodiscard]] LoadedLibrary loadLibrary(const std::string& name);

/// Returns the address of a function of a loaded library; null when the library has none of that name.
[[nodiscard]] void* librarySymbol(void* handle, const char* name) noexcept;

}  // namespace torsio
