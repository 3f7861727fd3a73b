// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/haptic_station.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "sim/base/error.h"
#include "sim/device/hdapi/hdapi_device.h"
#include "sim/servo/hand_task.h"

namespace torsio {

namespace {

constexpr const char* kHapticDriver = "hdapi";

/// Subject of the check -> line of the trainee's device check; what is not listed belongs to "connected".
constexpr std::array<std::pair<const char*, const char*>, 6> kLines{{{"Calibration", "calibrated"},
                                                                     {"Roll", "docked"},
                                                                     {"Rate", "rate"},
                                                                     {"Jitter", "rate"},
                                                                     {"Force", "force"},
                                                                     {"Motors", "force"}}};

const char* lineOf(const std::string& subject) {
  const auto found =
      std::find_if(kLines.begin(), kLines.end(), [&](const auto& line) { return subject == line.first; });
  return found == kLines.end() ? "connected" : found->second;
}

Light lightOf(FindingGrade grade) {
  return grade == FindingGrade::kBad ? Light::kRed
                                     : (grade == FindingGrade::kNote ? Light::kAmber : Light::kGreen);
}

DeviceDriver driverOf(const DeviceChoice& choice) {
  for (const DeviceDriver& driver : deviceDrivers(choice.library)) {
    if (driver.id == kHapticDriver) {
      return driver;
    }
  }
  throw Error(ErrorCode::kDevice, Text::tr("this build has no driver for haptic devices"), "",
              Text::tr("Use mouse and keyboard"));
}

}  // namespace

bool hapticLibraryInstalled(const DeviceChoice& choice) {
  return driverOf(choice).available;
}

DeviceReadiness hapticReadiness(const DeviceCheckResult& check) {
  DeviceReadiness readiness;
  readiness.device =
      check.capabilities.model.empty() ? Text::tr("Haptic device") : Text(check.capabilities.model);
  readiness.haptic = true;
  for (const DeviceFinding& finding : check.findings) {
    const char* line = lineOf(finding.subject);
    const auto present = std::find_if(readiness.findings.begin(), readiness.findings.end(),
                                      [&](const ReadinessFinding& other) { return other.code == line; });
    const ReadinessFinding now{line, lightOf(finding.grade), finding.sentence, finding.remedy};
    if (present == readiness.findings.end()) {
      readiness.findings.push_back(now);
    } else if (now.light > present->light) {
      *present = now;
    }
  }
  return readiness;
}

DeviceProbe hapticProbe(const DeviceChoice& choice) {
  DeviceCheckRequest request;
  request.choice = choice;
  return [request] { return hapticReadiness(checkDevice(request)); };
}

std::unique_ptr<HapticDevice> openHapticDevice(const Scene& scene, const DeviceChoice& choice) {
  DeviceRequest request;
  request.hdapi.deviceName = choice.name;
  request.hdapi.workspaceCentre_m = handTask(scene).graspPoint_m;
  std::unique_ptr<HapticDevice> device = driverOf(choice).open(request);
  auto& haptic = dynamic_cast<HdapiDevice&>(*device);
  haptic.start();
  haptic.enableForce(true);
  return device;
}

}  // namespace torsio
