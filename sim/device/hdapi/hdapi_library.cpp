// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/hdapi/hdapi_library.h"

#include <cstdlib>

#include "sim/device/hdapi/dynamic_library.h"

namespace torsio {

namespace {

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) {
    text.append(text.empty() ? "" : ", ").append(name);
  }
  return text;
}

/// The loader's refusal in plain words. Old driver packages want ncurses 5, which Debian 12 still has.
void describeRefusal(const LoadedLibrary& loaded, HdapiLibrary& result) {
  result.status = HdapiLoadStatus::kDependencyMissing;
  if (loaded.missingDependency.empty()) {
    result.sentence = Text::tr("the vendor's library %1 is there, but the system refused to load it: %2",
                               result.path, loaded.systemText);
    result.remedy = Text::tr("Install the driver package that belongs to it, for this kind of processor");
    return;
  }
  result.sentence = Text::tr("the vendor's library %1 is there, but it needs %2, which is missing",
                             result.path, loaded.missingDependency);
  const bool terminal = loaded.missingDependency.rfind("libncurses.so.5", 0) == 0 ||
                        loaded.missingDependency.rfind("libtinfo.so.5", 0) == 0;
  const bool driver = loaded.missingDependency.rfind("libPhantomIOLib", 0) == 0 ||
                      loaded.missingDependency.rfind("libPHANToMIO", 0) == 0;
  result.remedy = terminal ? Text::tr("Install the packages libncurses5 and libtinfo5")
                  : driver ? Text::tr("Install the device's driver package; OpenHaptics alone is not enough")
                           : Text::tr("Install the package that contains %1", loaded.missingDependency);
}

HdapiLibrary resolveLoaded(const LoadedLibrary& loaded, const std::string& name,
                           const std::vector<std::string>& searched) {
  HdapiLibrary result =
      resolveHdapi([&loaded](const char* symbol) { return librarySymbol(loaded.handle, symbol); });
  result.path = name;
  result.searched = searched;
  if (result.status == HdapiLoadStatus::kSymbolMissing) {
    result.sentence = Text::tr("%1 lacks %2", name, joined(result.missingSymbols));
    result.remedy =
        Text::tr("Install OpenHaptics 3.0 to 3.5; this file is another library or an incomplete one");
  } else {
    result.sentence = Text::tr("the vendor's library %1 is loaded", name);
  }
  return result;
}

}  // namespace

std::vector<std::string> hdapiLibraryNames() {
#if defined(_WIN32)
  return {"HD.dll"};
#else
  return {"libHD.so", "libHD.so.3.4", "libHD.so.3.0"};
#endif
}

HdapiLibrary resolveHdapi(const std::function<void*(const char*)>& symbol) {
  HdapiLibrary result;
#define TORSIO_HD_NEEDED(returns, name, parameters)                             \
  result.api.name = reinterpret_cast<decltype(result.api.name)>(symbol(#name)); \
  if (result.api.name == nullptr) result.missingSymbols.emplace_back(#name);
#define TORSIO_HD_WELCOME(returns, name, parameters)                            \
  result.api.name = reinterpret_cast<decltype(result.api.name)>(symbol(#name)); \
  if (result.api.name == nullptr) result.absentOptionals.emplace_back(#name);
  using namespace hd;
  TORSIO_HD_MANDATORY(TORSIO_HD_NEEDED)
  TORSIO_HD_OPTIONAL(TORSIO_HD_WELCOME)
#undef TORSIO_HD_NEEDED
#undef TORSIO_HD_WELCOME
  result.status = result.missingSymbols.empty() ? HdapiLoadStatus::kLoaded : HdapiLoadStatus::kSymbolMissing;
  return result;
}

HdapiLibrary loadHdapi(const std::string& explicitName) {
  std::vector<std::string> names = hdapiLibraryNames();
  const char* const fromEnvironment = std::getenv("TORSIO_HDAPI_LIBRARY");
  if (!explicitName.empty()) {
    names = {explicitName};
  } else if (fromEnvironment != nullptr && *fromEnvironment != '\0') {
    names = {fromEnvironment};
  }
  HdapiLibrary result;
  for (const std::string& name : names) {
    result.searched.push_back(name);
    const LoadedLibrary loaded = loadLibrary(name);
    if (loaded.handle != nullptr) {
      return resolveLoaded(loaded, name, result.searched);
    }
    // A library that is there but broken is worth more to the user than "not found"; the next name may work.
    if (loaded.found && result.status == HdapiLoadStatus::kNotFound) {
      result.path = name;
      describeRefusal(loaded, result);
    }
  }
  if (result.status == HdapiLoadStatus::kNotFound) {
    result.sentence =
        Text::tr("the vendor's library is not installed; looked for %1", joined(result.searched));
    result.remedy = Text::tr(
        "Install the device's driver and the OpenHaptics run time (docs/devices.md), or name the library "
        "with "
        "--library");
  }
  return result;
}

}  // namespace torsio
