// SPDX-License-Identifier: GPL-3.0-or-later

#include <utility>

#include "sim/core/error.h"
#include "sim/device/process/device_process.h"

namespace torsio {

namespace {

StylusRequest stylusRequest(const DeviceRequest& request, bool onlyLibrary) {
  StylusRequest stylus;
  stylus.library = request.library;
  stylus.options.deviceName = request.name;
  stylus.options.workspaceCentre_m = request.workspaceCentre_m;
  stylus.onlyLibrary = onlyLibrary;
  stylus.inThisProcess = request.inThisProcess;
  stylus.cancelled = request.cancelled;
  return stylus;
}

/// Looks at the vendor's library where it can do no harm: it may hang, or be cut off in the middle.
DriverFinding lookForLibrary(const DeviceRequest& request) {
  try {
    const HdapiLibrary library = openStylus(stylusRequest(request, true)).library;
    DriverFinding finding{library.status == HdapiLoadStatus::kLoaded, library.sentence, library.remedy, {}};
    if (finding.available && !library.absentOptionals.empty()) {
      std::string absent;
      for (const std::string& symbol : library.absentOptionals) {
        absent.append(absent.empty() ? "" : ", ").append(symbol);
      }
      finding.notes.push_back(Text::tr("it lacks %1, which Torsio can do without", absent));
    }
    return finding;
  } catch (const Error& error) {
    return {false, error.happenedText(), error.remedyText(), {}};
  }
}

std::unique_ptr<HapticDevice> openStylusDevice(const DeviceRequest& request) {
  StylusOpening opening = openStylus(stylusRequest(request, false));
  if (opening.driver == nullptr) {
    throw Error(ErrorCode::kDevice, opening.library.sentence, Text::tr("haptic device"),
                opening.library.remedy);
  }
  return std::move(opening.driver);
}

}  // namespace

DeviceDriver stylusDeviceDriver() {
  return {.id = "hdapi",
          .name = "PHANTOM Omni or Touch",
          .needs = Text::tr("the vendor's driver and OpenHaptics"),
          .use = DriverUse::kStation,
          .rendersForce = true,
          .takesLibrary = true,
          .look = lookForLibrary,
          .open = openStylusDevice};
}

}  // namespace torsio
