// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/device/hdapi/hdapi_device.h"
#include "sim/device/process/device_process.h"

namespace torsio {

StylusOpening openStylus(const StylusRequest& request) {
  StylusOpening opening{loadHdapi(request.library), nullptr};
  if (opening.library.status == HdapiLoadStatus::kLoaded && !request.onlyLibrary) {
    opening.driver = std::make_unique<HdapiDevice>(opening.library.api, request.options);
  }
  return opening;
}

DeviceDriver hosted(const DeviceDriver& driver) {
  return driver;
}

}  // namespace torsio
