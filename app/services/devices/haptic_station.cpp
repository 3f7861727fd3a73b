// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/devices/haptic_station.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "sim/core/error.h"
#include "sim/servo/hand_task.h"

namespace torsio {

namespace {

/// Subject of the check -> line of the trainee's device check; others belong to "connected".
constexpr std::array<std::pair<const char*, const char*>, 7> kLines{{{"Calibration", "calibrated"},
                                                                     {"Roll", "docked"},
                                                                     {"Rate", "rate"},
                                                                     {"Jitter", "rate"},
                                                                     {"Scheduling", "rate"},
                                                                     {"Force", "force"},
                                                                     {"Motors", "force"}}};

thread_local std::function<bool()> unwantedHere;

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

DeviceChoice stationChoice() {
  DeviceChoice choice = rememberedDevice();
  choice.driver = chosenDriver(choice).id;
  return choice;
}

bool deviceInstalled(const DeviceChoice& choice) {
  return chosenDriver(choice).look(deviceRequest(choice)).available;
}

DeviceReadiness hapticReadiness(const DeviceCheckResult& check) {
  DeviceReadiness readiness;
  readiness.device =
      check.capabilities.model.empty() ? Text::tr("Haptic device") : Text(check.capabilities.model);
  readiness.haptic = check.capabilities.rendersForce;
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

WhileWanted::WhileWanted(std::function<bool()> unwanted) {
  unwantedHere = std::move(unwanted);
}

WhileWanted::~WhileWanted() {
  unwantedHere = nullptr;
}

std::unique_ptr<HapticDevice> openHapticDevice(const Scene& scene, const DeviceChoice& choice) {
  DeviceRequest request = deviceRequest(choice, unwantedHere);
  const HandTask task = handTask(scene);
  request.workspaceCentre_m = task.graspPoint_m;
  request.start.position_m = task.start_m;
  std::unique_ptr<HapticDevice> device = chosenDriver(choice).open(request);
  device->serve();
  device->enableForce(true);
  return device;
}

}  // namespace torsio
