// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/core/text.h"
#include "sim/device/hdapi/hdapi_abi.h"

namespace torsio {

enum class HdapiLoadStatus {
  kLoaded,
  kNotFound,           ///< no library of any of the names
  kDependencyMissing,  ///< it exists, the system refused to load it
  kSymbolMissing,      ///< it loaded, but a function that the driver cannot do without is absent
};

/// What came of looking for the vendor's library, in words that a technician of a centre can use.
struct HdapiLibrary {
  HdapiLoadStatus status = HdapiLoadStatus::kNotFound;
  hd::Api api;                               ///< complete only when status is kLoaded
  std::string path;                          ///< the name that was loaded or refused
  std::vector<std::string> searched;         ///< every name tried, in order
  std::vector<std::string> missingSymbols;   ///< of those that the driver needs
  std::vector<std::string> absentOptionals;  ///< of those that it can do without
  Text sentence;                             ///< what happened; no full stop
  Text remedy;                               ///< what to do; "" when loaded
};

/// Lists the names of the vendor's library on this system, most current first.
[[nodiscard]] std::vector<std::string> hdapiLibraryNames();

/// Fills the table through `symbol` (name to address or null) and lists what is absent.
[[nodiscard]] HdapiLibrary resolveHdapi(const std::function<void*(const char*)>& symbol);

/// Looks for the vendor's library, loads it and never unloads it. `explicitName`: path or file name of the
/// one to use; empty: the environment variable TORSIO_HDAPI_LIBRARY, then hdapiLibraryNames().
[[nodiscard]] HdapiLibrary loadHdapi(const std::string& explicitName);

}  // namespace torsio
