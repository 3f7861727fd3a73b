// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/drivers/device_driver.h"

#include <utility>

#include "sim/base/error.h"
#include "sim/device/process/device_process.h"
#include "sim/device/virtual/idle_device.h"
#include "sim/device/virtual/pointer_device.h"
#include "sim/device/virtual/replay_device.h"

namespace torsio {

namespace {

using Device = std::unique_ptr<HapticDevice>;

struct VendorLibrary {
  bool loaded = false;
  Text sentence;
  Text remedy;
};

/// Looks at the vendor's library where it can do no harm: it may hang, or be cut off in the middle.
VendorLibrary lookAt(const std::string& library) {
  try {
    StylusRequest request;
    request.library = library;
    request.onlyLibrary = true;
    const HdapiLibrary found = openStylus(request).library;
    return {found.status == HdapiLoadStatus::kLoaded, found.sentence, found.remedy};
  } catch (const Error& error) {
    return {false, error.happenedText(), error.remedyText()};
  }
}

Device openHdapi(const std::string& library, const DeviceRequest& request) {
  StylusRequest stylus;
  stylus.library = library;
  stylus.options = request.hdapi;
  StylusOpening opening = openStylus(stylus);
  if (opening.driver == nullptr) {
    throw Error(ErrorCode::kDevice, opening.library.sentence, Text::tr("haptic device"),
                opening.library.remedy);
  }
  return std::move(opening.driver);
}

}  // namespace

std::vector<DeviceDriver> deviceDrivers(const std::string& library) {
  const VendorLibrary vendor = lookAt(library);
  return {
      {"hdapi", "PHANTOM Omni or Touch", "the vendor's driver and OpenHaptics", vendor.loaded,
       vendor.sentence, vendor.remedy,
       [library](const DeviceRequest& request) { return openHdapi(library, request); }},
      {"pointer", "Mouse and keyboard", "", true,
       Text::tr("always there; shows forces, does not render them"), "",
       [](const DeviceRequest& request) -> Device { return std::make_unique<PointerDevice>(request.start); }},
      {"scripted", "Scripted hand", "", true, Text::tr("always there; a simulated hand with a seed"), "",
       [](const DeviceRequest& request) -> Device { return std::make_unique<ScriptedHand>(request.hand); }},
      {"replay", "Recorded trial", "a recorded trial", true,
       Text::tr("always there; repeats a recording tick by tick"), "",
       [](const DeviceRequest& request) -> Device {
         return std::make_unique<ReplayDevice>(request.recorded, request.recordedWith);
       }},
      {"idle", "Nobody's hand", "", true, Text::tr("always there; the instrument stays where it was put"), "",
       [](const DeviceRequest& request) -> Device { return std::make_unique<IdleDevice>(request.start); }},
  };
}

}  // namespace torsio
