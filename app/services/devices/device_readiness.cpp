// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/devices/device_readiness.h"

#include <algorithm>
#include <array>
#include <utility>

#include "app/services/base/stored_sentence.h"

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

Text refusedToServo(bool priority, bool memory) {
  if (priority && memory) {
    return {};
  }
  if (memory) {
    return Text::tr("the system refuses real-time priority");
  }
  return priority ? Text::tr("the system refuses to keep the servo in memory")
                  : Text::tr("the system refuses real-time priority and to keep the servo in memory");
}

Text grantRealTime() {
  return Text::tr("Copy assets/system/torsio-limits.conf to /etc/security/limits.d and log in again");
}

Text servoTrouble(const ServoHealth& health, std::int64_t ticks) {
  const bool skipped =
      static_cast<double>(health.skippedTicks) > kSkippedForgiven * static_cast<double>(ticks);
  if (health.forceCuts == 0 && !skipped) {
    return {};
  }
  const Text what = Text::tr(
      "the machine was too busy: the force was cut %1 {time|times}, %2 of %3 {tick was|ticks were} skipped",
      health.forceCuts, health.skippedTicks, ticks + health.skippedTicks);
  const Text refused = refusedToServo(health.priority, health.memory);
  return refused.empty() ? what : Text::verbatim("%1; %2", what, refused);
}

Text servoRemedy(const ServoHealth& health) {
  return health.priority && health.memory ? Text::tr("Close other programs at this station")
                                          : grantRealTime();
}

namespace {

constexpr std::array<std::pair<Light, const char*>, 3> kLights{
    {{Light::kGreen, "green"}, {Light::kAmber, "amber"}, {Light::kRed, "red"}}};

}  // namespace

StationDevice stationDevice(const DeviceReadiness& readiness, std::int64_t checkedUtc_us) {
  StationDevice device{.device = readiness.device,
                       .haptic = readiness.haptic,
                       .light = readiness.light(),
                       .checkedUtc_us = checkedUtc_us};
  if (*device.light == Light::kGreen) {
    return device;
  }
  const auto worst =
      std::find_if(readiness.findings.begin(), readiness.findings.end(),
                   [&](const ReadinessFinding& finding) { return finding.light == device.light; });
  if (worst != readiness.findings.end()) {
    device.problem = worst->detail;
  }
  if (!readiness.haptic && *device.light == Light::kAmber) {
    device.problem = Text::tr("the force is not felt");
  }
  return device;
}

StationDevice uncheckedDevice(const Text& device, bool haptic) {
  return {.device = device.empty() ? Text::tr("Mouse and keyboard") : device, .haptic = haptic};
}

void storeDevice(const StationDevice& device, StationState& state) {
  state.deviceJson = storedSentence(device.device);
  state.deviceHaptic = device.haptic;
  state.deviceProblemJson = storedSentence(device.problem);
  state.deviceCheckedUtc_us = device.checkedUtc_us;
  state.deviceLight.clear();
  for (const auto& [light, code] : kLights) {
    if (device.light == light) {
      state.deviceLight = code;
    }
  }
}

StationDevice storedDevice(const StationState& state) {
  StationDevice device{.device = readSentence(state.deviceJson),
                       .haptic = state.deviceHaptic,
                       .problem = readSentence(state.deviceProblemJson),
                       .checkedUtc_us = state.deviceCheckedUtc_us};
  for (const auto& [light, code] : kLights) {
    if (state.deviceLight == code) {
      device.light = light;
    }
  }
  return device;
}

}  // namespace torsio
