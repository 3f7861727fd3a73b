// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/haptic_station.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "sim/base/error.h"
#include "sim/device/process/device_process.h"
#include "sim/servo/hand_task.h"

namespace torsio {

namespace {

/// Subject of the check -> line of the trainee's device check; what is not listed belongs to "connected".
constexpr std::array<std::pair<const char*, const char*>, 7> kLines{{{"Calibration", "calibrated"},
                                                                     {"Roll", "docked"},
                                                                     {"Rate", "rate"},
                                                                     {"Jitter", "rate"},
                                                                     {"Scheduling", "rate"},
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

}  // namespace

bool hapticLibraryInstalled(const DeviceChoice& choice) {
  try {
    return openStylus(stylusRequest(choice, {}, true)).library.status == HdapiLoadStatus::kLoaded;
  } catch (const Error&) {
    return false;  // `torsio device check` says why
  }
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
  StylusRequest request = stylusRequest(choice, {});
  request.options.workspaceCentre_m = handTask(scene).graspPoint_m;
  StylusOpening opening = openStylus(request);
  if (opening.driver == nullptr) {
    throw Error(ErrorCode::kDevice, opening.library.sentence, Text::tr("haptic device"),
                opening.library.remedy);
  }
  opening.driver->serve();
  opening.driver->enableForce(true);
  return std::move(opening.driver);
}

}  // namespace torsio
