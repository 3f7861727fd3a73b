// SPDX-License-Identifier: GPL-3.0-or-later
#define WIN32_LEAN_AND_MEAN
#define NOMINMAX
#include <windows.h>

#include "sim/device/hdapi/hdapi_library.h"

namespace torsio {

LoadedLibrary loadLibrary(const std::string& name) {
  LoadedLibrary library;
  const HMODULE module = LoadLibraryA(name.c_str());
  library.handle = static_cast<void*>(module);
  if (module != nullptr) {
    library.found = true;
    return library;
  }
  const DWORD error = GetLastError();
  library.systemText = "Windows error " + std::to_string(error);
  // Windows says "module not found" for the library and for what it needs alike, and never names the latter.
  library.found =
      error != ERROR_MOD_NOT_FOUND || SearchPathA(nullptr, name.c_str(), ".dll", 0, nullptr, nullptr) > 0;
  return library;
}

void* librarySymbol(void* handle, const char* name) noexcept {
  return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(handle), name));
}

}  // namespace torsio
