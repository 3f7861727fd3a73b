// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/drivers/device_driver.h"

#include "sim/base/error.h"
#include "sim/device/hdapi/hdapi_library.h"
#include "sim/device/virtual/idle_device.h"
#include "sim/device/virtual/pointer_device.h"
#include "sim/device/virtual/replay_device.h"

namespace torsio {

namespace {

using Device = std::unique_ptr<HapticDevice>;

Device openHdapi(const HdapiLibrary& library, const DeviceRequest& request) {
  if (library.status != HdapiLoadStatus::kLoaded) {
    throw Error(ErrorCode::kDevice, library.sentence, Text::tr("haptic device"), library.remedy);
  }
  return std::make_unique<HdapiDevice>(library.api, request.hdapi);
}

}  // namespace

std::vector<DeviceDriver> deviceDrivers(const std::string& library) {
  const HdapiLibrary vendor = loadHdapi(library);
  return {
      {"hdapi", "PHANTOM Omni or Touch", "the vendor's driver and OpenHaptics",
       vendor.status == HdapiLoadStatus::kLoaded, vendor.sentence, vendor.remedy,
       [vendor](const DeviceRequest& request) { return openHdapi(vendor, request); }},
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
