// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/devices/device_readiness.h"

#include <algorithm>
#include <utility>

namespace torsio {

Light DeviceReadiness::light() const noexcept {
  if (findings.empty()) {
    return Light::kRed;
  }
  return std::max_element(
             findings.begin(), findings.end(),
             [](const ReadinessFinding& a, const ReadinessFinding& b) { return a.light < b.light; })
      ->light;
}

DeviceReadiness pointerReadiness(bool gradedWithoutForce) {
  DeviceReadiness readiness;
  readiness.device = Text::tr("Mouse and keyboard");
  readiness.findings.push_back({"connected", Light::kGreen, readiness.device, ""});
  return judgedByForce(std::move(readiness), gradedWithoutForce);
}

DeviceReadiness judgedByForce(DeviceReadiness readiness, bool gradedWithoutForce) {
  if (readiness.haptic || readiness.light() == Light::kRed) {
    return readiness;
  }
  const ReadinessFinding force =
      gradedWithoutForce ? ReadinessFinding{"force", Light::kGreen, Text::tr("shown, not felt"), ""}
                         : ReadinessFinding{"force", Light::kAmber, Text::tr("shown, not felt"),
                                            Text::tr("Connect the haptic device for a graded run")};
  const auto present = std::find_if(readiness.findings.begin(), readiness.findings.end(),
                                    [](const ReadinessFinding& finding) { return finding.code == "force"; });
  if (present == readiness.findings.end()) {
    readiness.findings.push_back(force);
  } else {
    *present = force;
  }
  return readiness;
}

}  // namespace torsio
