// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/hdapi/hdapi_library.h"

#include <algorithm>
#include <cstdlib>

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

HdapiErrorClass hdapiErrorClass(hd::ErrorCode code) noexcept {
  switch (code) {
    case hd::kSuccess:
      return HdapiErrorClass::kNone;
    case hd::kWarmMotors:
      return HdapiErrorClass::kWarm;
    case hd::kExceededMaxForce:
    case hd::kExceededMaxForceImpulse:
    case hd::kExceededMaxVelocity:
    case hd::kForceError:
      return HdapiErrorClass::kForce;
    case hd::kIllegalBegin:
    case hd::kIllegalEnd:
    case hd::kFrameError:
      return HdapiErrorClass::kFrame;
    case hd::kDeviceFault:
    case hd::kCommError:
    case hd::kCommConfigError:
    case hd::kTimerError:
    case hd::kInvalidPriority:
    case hd::kSchedulerFull:
      return HdapiErrorClass::kFatal;
    case hd::kInvalidLicense:
      return HdapiErrorClass::kLicence;
    default:
      return HdapiErrorClass::kCall;
  }
}

Text hdapiErrorText(hd::ErrorCode code) {
  switch (code) {
    case hd::kWarmMotors:
      return Text::tr("the motors are warm");
    case hd::kExceededMaxForce:
      return Text::tr("the device's force limit was exceeded");
    case hd::kExceededMaxForceImpulse:
      return Text::tr("the force changed faster than the device allows");
    case hd::kExceededMaxVelocity:
      return Text::tr("the stylus moved faster than the device allows");
    case hd::kForceError:
      return Text::tr("the library refused a force");
    case hd::kDeviceFault:
      return Text::tr("the device does not answer");
    case hd::kDeviceAlreadyInitiated:
      return Text::tr("the device is in use already");
    case hd::kCommError:
      return Text::tr("the connection to the device broke off");
    case hd::kCommConfigError:
      return Text::tr("the connection to the device is set up wrongly");
    case hd::kTimerError:
      return Text::tr("the library's servo timer does not work");
    case hd::kInvalidPriority:
    case hd::kSchedulerFull:
      return Text::tr("the library's servo loop accepts no further task");
    case hd::kIllegalBegin:
    case hd::kIllegalEnd:
    case hd::kFrameError:
      return Text::tr("a servo frame could not be opened or closed");
    case hd::kInvalidLicense:
      return Text::tr("the library has no valid licence");
    default:
      return Text::tr("the library refused a call");
  }
}

bool HdapiErrors::any(HdapiErrorClass wanted) const noexcept {
  return std::any_of(entries.begin(), entries.begin() + static_cast<std::ptrdiff_t>(count),
                     [wanted](const hd::ErrorInfo& e) { return hdapiErrorClass(e.error) == wanted; });
}

hd::ErrorCode HdapiErrors::worstCode() const noexcept {
  for (std::size_t i = 0; i < count; ++i) {
    if (hdapiErrorClass(entries[i].error) == worst) {
      return entries[i].error;
    }
  }
  return hd::kSuccess;
}

HdapiErrors drainHdapiErrors(const hd::Api& api) noexcept {
  HdapiErrors errors;
  while (errors.count < kMaxErrorsAtOnce) {
    const hd::ErrorInfo info = api.hdGetError();
    if (info.error == hd::kSuccess) {
      break;
    }
    errors.entries[errors.count++] = info;
    errors.worst = std::max(errors.worst, hdapiErrorClass(info.error));
  }
  std::reverse(errors.entries.begin(), errors.entries.begin() + static_cast<std::ptrdiff_t>(errors.count));
  return errors;
}

}  // namespace torsio
