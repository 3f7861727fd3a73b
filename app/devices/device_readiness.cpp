// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/devices/device_readiness.h"

#include <algorithm>

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

DeviceReadiness pointerReadiness(bool gradedWithMouse) {
  DeviceReadiness readiness;
  readiness.device = Text::tr("Mouse and keyboard");
  readiness.findings.push_back({"connected", Light::kGreen, readiness.device, ""});
  readiness.findings.push_back(
      gradedWithMouse ? ReadinessFinding{"force", Light::kGreen, Text::tr("shown, not felt"), ""}
                      : ReadinessFinding{"force", Light::kAmber, Text::tr("shown, not felt"),
                                         Text::tr("Connect the haptic device for a graded run")});
  return readiness;
}

}  // namespace torsio
