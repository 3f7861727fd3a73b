// SPDX-License-Identifier: GPL-3.0-or-later
#include <dlfcn.h>

#include "sim/device/hdapi/dynamic_library.h"

namespace torsio {

LoadedLibrary loadLibrary(const std::string& name) {
  LoadedLibrary library;
  // Local: libHD exports hundreds of internals and Windows-like names that must not meet ours.
  library.handle = dlopen(name.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library.handle != nullptr) {
    library.found = true;
    return library;
  }
  const char* text = dlerror();
  library.systemText = text != nullptr ? text : "";
  // "FILE: cannot open shared object file: ..." names the file that is missing: ours or one it needs.
  const std::size_t colon = library.systemText.find(": cannot open shared object file");
  const std::string missing = library.systemText.substr(0, colon);
  const bool isMissing = colon != std::string::npos;
  library.found = !isMissing || missing != name;
  if (isMissing && library.found) {
    library.missingDependency = missing;
  }
  return library;
}

void* librarySymbol(void* handle, const char* name) noexcept {
  return dlsym(handle, name);
}

}  // namespace torsio
