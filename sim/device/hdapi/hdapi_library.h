// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/core/text.h"
#include "sim/device/hdapi/hdapi_abi.h"

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

/// What an error of the vendor's library means for us, from harmless to the end of the connection.
enum class HdapiErrorClass : std::uint8_t {
  kNone,
  kCall,     ///< a wrong or unsupported call: counted, nothing else
  kFrame,    ///< no frame could be opened or closed: this tick sends nothing
  kForce,    ///< the device's protection tripped (force, impulse, velocity): engage anew
  kWarm,     ///< motors warm: no force until they have cooled
  kLicence,  ///< the library refuses to work without a licence
  kFatal,    ///< device, communication, timer or scheduler: the servo loop cannot go on
};

[[nodiscard]] HdapiErrorClass hdapiErrorClass(hd::ErrorCode code) noexcept;

/// Says an error code in plain words: "the connection to the device broke off".
[[nodiscard]] Text hdapiErrorText(hd::ErrorCode code);

/// Most errors that are taken in one tick, so that the library cannot hold up a tick.
inline constexpr std::size_t kMaxErrorsAtOnce = 16;

/// The errors that one emptying of the stack brought, in the order in which they happened.
struct HdapiErrors {
  std::array<hd::ErrorInfo, kMaxErrorsAtOnce> entries{};
  std::size_t count = 0;
  HdapiErrorClass worst = HdapiErrorClass::kNone;

  [[nodiscard]] bool any(HdapiErrorClass wanted) const noexcept;
  /// Returns the code of the first entry of the worst class; kSuccess when there is none.
  [[nodiscard]] hd::ErrorCode worstCode() const noexcept;
};

/// Empties the library's error stack, which gives the most recent error first and is shared by all threads:
/// only the thread that owns the session at that time may call this. No allocation.
[[nodiscard]] HdapiErrors drainHdapiErrors(const hd::Api& api) noexcept;

}  // namespace torsio
